//! What the paper loses by the harmonics: of the ellipse, and of the feed mechanism.

use super::foot::{Drive, Foot, Foot::*};
use super::limits::borders;
use std::f64::consts::PI;

/// How far a path by its harmonics is from the path itself.
struct Off {
    /// Root mean square of the level over a turn, in µm.
    level: f64,
    /// Root mean square and largest difference of the force on the fabric over a turn, in N.
    force: (f64, f64),
    /// Largest difference of the angles of contact lost and regained, in degrees; none if there are more or fewer.
    contact: Option<f64>,
}

/// Compares two paths at a speed at which both repeat after a turn.
fn compare(exact: Foot, series: Foot, omega: f64) -> Off {
    let drive = Drive::at(omega);
    let period = drive.period();
    let [(one, own), (other, found)] = [exact, series].map(|foot| {
        let scene = foot.driven(drive);
        let cycle = scene.cycle(None, period).unwrap();
        assert_eq!(cycle.multiple, 1, "{} at {omega} 1/s", foot.name());
        (scene, cycle.motion)
    });
    let count = 4000;
    let times = || (0..count).map(|k| period * (f64::from(k) + 0.5) / f64::from(count));
    let differences = |name: &str| -> Vec<f64> {
        let of = |time| other.output(name, &found, time) - one.output(name, &own, time);
        times().map(of).collect()
    };
    let rms = |all: &[f64]| (all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64).sqrt();
    let force = differences("F2");
    let [a, b] = [&own, &found].map(|motion| {
        let events = motion.events.iter().filter(|one| one.from != one.to);
        events.map(|one| (one.time, one.to)).collect::<Vec<(f64, usize)>>()
    });
    let pairs = a.iter().zip(&b);
    let is_alike = a.len() == b.len() && pairs.clone().all(|(a, b)| a.1 == b.1);
    let turned = |time: f64| (omega * time * 180.0 / PI).abs();
    Off {
        level: 1e6 * rms(&differences("s")),
        force: (rms(&force), force.iter().fold(0.0, |most: f64, x| most.max(x.abs()))),
        contact: is_alike.then(|| pairs.map(|(a, b)| turned(a.0 - b.0)).fold(0.0, f64::max)),
    }
}

/// Errors of forces, instants of contact, and the speed of first separation by the number of harmonics.
pub fn harmonics() {
    println!("\nharmonics in place of the path: what they change");
    println!("{:24}  level      force, rms and largest          contact   leaves the", "");
    println!("{:24}    rms     at 200 1/s      at 300 1/s   at 300 1/s  fabric from", "");
    println!("{:24}     um        N       N       N       N         deg         1/s", "");
    let table = |exact: Foot, by: fn(u8) -> Foot| {
        let first = borders(exact)[0];
        println!("{:72}{first:12.3}", exact.name());
        let last = (1..=5).fold(None, |_, order| row(exact, by(order)));
        last.expect("the foot leaves") / first - 1.0
    };
    let firsts = [table(Ellipse(1.0), Harmonics), table(Machine, MachineHarmonics)];
    // 1.1 % and 0.3 %, tests/reference/presser_foot.json.
    assert!((firsts[0] - 0.01134).abs() < 1e-4 && (firsts[1] - 0.00303).abs() < 1e-4);
}

/// A row of the table; gives the speed of first separation up to 420 1/s.
fn row(exact: Foot, series: Foot) -> Option<f64> {
    let (slow, fast) = (compare(exact, series, 200.0), compare(exact, series, 300.0));
    let contact = fast.contact.map_or("other".into(), |angle| format!("{angle:.2}"));
    let first = borders(series).first().copied();
    let border = first.map_or("none".into(), |omega| format!("{omega:.3}"));
    println!(
        "{:24}{:7.1}  {:7.2} {:7.2} {:7.2} {:7.2}  {contact:>10}{border:>12}",
        series.name(),
        slow.level,
        slow.force.0,
        slow.force.1,
        fast.force.0,
        fast.force.1,
    );
    first
}
