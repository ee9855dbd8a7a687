//! Where the foot begins to leave the fabric: speeds and preloads.

use super::foot::{Drive, Foot, Foot::*};
use super::print_speeds;

/// Speeds from 120 to 420 1/s at which the foot begins to leave the fabric and ceases to, by turns.
pub fn borders(foot: Foot) -> Vec<f64> {
    let flies = |omega: f64| foot.outcome(Drive::at(omega)).free > 0.0;
    let speeds: Vec<f64> = (0..=60).map(|k| 120.0 + 5.0 * f64::from(k)).collect();
    let states: Vec<bool> = speeds.iter().map(|omega| flies(*omega)).collect();
    let changes = (1..speeds.len()).filter(|k| states[k - 1] != states[*k]);
    let border = |k: usize| {
        let (mut low, mut high) = (speeds[k - 1], speeds[k]);
        while high - low > 1e-4 {
            let middle = (low + high) / 2.0;
            match flies(middle) == states[k - 1] {
                true => low = middle,
                false => high = middle,
            }
        }
        low
    };
    changes.map(border).collect()
}

/// Speeds between 120 and 420 1/s at which the foot leaves the fabric.
pub fn windows() {
    println!("\nspeeds at which the foot leaves the fabric, 120 to 420 1/s");
    let paths = [
        Ellipse(1.0),
        Ellipse(0.5),
        Ellipse(0.2),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
        Progressive,
        HuntCrossley,
        Plate(1e6),
    ];
    let all = paths.map(|foot| {
        let found = borders(foot);
        let windows = found.chunks(2).map(|window| match window {
            [from, to] => format!("{from:.3} to {to:.3} 1/s"),
            _ => format!("from {:.3} 1/s on", window[0]),
        });
        let text = windows.collect::<Vec<String>>().join(", ");
        println!("{:24}  {}", foot.name(), if text.is_empty() { "none" } else { &text });
        found
    });
    // The closed form of the linear fabric, tests/reference/presser_foot.json.
    assert!((all[0][0] - 226.03618).abs() < 1e-3);
    for (found, expected) in all[3].iter().zip([167.18523, 203.80554, 348.05705]) {
        assert!((found - expected).abs() < 1e-3, "{found} {expected}");
    }
}

/// The force of the linear fabric moves with the preload as it does at rest, so one motion without separation is enough.
pub fn preloads() {
    println!("\nsmallest preload that keeps contact, N");
    let speeds = [150.0, 200.0, 250.0, 300.0, 350.0, 400.0, 500.0];
    print_speeds(&speeds, 8);
    // Rates of the spring and the fabric.
    let (c1, c2) = (2000.0, 1e5);
    for foot in [
        Ellipse(1.0),
        Ellipse(0.5),
        Ellipse(0.2),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
        Harmonics(5),
        Machine,
    ] {
        let row = speeds.map(|omega| {
            let preload = 1000.0;
            let drive = Drive { preload, ..Drive::at(omega) };
            let least = foot.outcome(drive).least;
            format!("{:8.2}", preload - least * (c1 + c2) / c2)
        });
        println!("{:24}{}", foot.name(), row.concat());
    }
}

/// Maps of the time without contact.
pub fn maps() {
    for foot in [Ellipse(1.0), Straight(0.5, 60.0)] {
        println!(
            "\n{}: time without contact in %, by preload and speed (~: nothing that repeats is stable)",
            foot.name()
        );
        let speeds = [150.0, 200.0, 250.0, 300.0, 350.0, 400.0, 450.0, 500.0];
        print_speeds(&speeds, 8);
        for preload in [10.0, 20.0, 30.0, 40.0, 60.0, 80.0, 120.0] {
            let row = speeds.map(|omega| {
                let drive = Drive { preload, ..Drive::at(omega) };
                let one = foot.outcome(drive);
                let mark = if one.turns.is_some() { ' ' } else { '~' };
                format!("{:7.1}{mark}", 100.0 * one.free)
            });
            println!("{:24}{}", format!("{preload} N"), row.concat());
        }
    }
}
