//! Forces on the fabric, and what they leave of the stitch.

use super::foot::{Drive, Foot, Foot::*};
use super::print_speeds;

/// Forces on the paths.
pub fn comparison() {
    println!(
        "forces on the working stroke, contact, and feed of a stitch of 4 mm at forces above 5 N"
    );
    println!("{:24}  speed   turns  largest  smallest    mean   free  lift-offs   feed", "");
    println!("{:24}    1/s               N         N       N      %   per turn     mm", "");
    let paths = [
        Ellipse(1.0),
        Ellipse(0.5),
        Ellipse(0.2),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
        Harmonics(5),
        Machine,
        Progressive,
        HuntCrossley,
    ];
    for foot in paths {
        for omega in [200.0, 300.0, 400.0, 500.0] {
            print_outcome(foot, omega);
        }
    }
    let at = |foot: Foot| foot.outcome(Drive::at(300.0));
    let (ellipse, straight, low) = (at(Ellipse(1.0)), at(Straight(0.5, 60.0)), at(Ellipse(0.5)));
    assert!(straight.mean > 1.2 * ellipse.mean && straight.smallest > ellipse.smallest);
    assert!(low.smallest > straight.smallest && (low.mean / straight.mean - 1.0).abs() < 0.05);
}

/// A row of the table.
fn print_outcome(foot: Foot, omega: f64) {
    let one = foot.outcome(Drive::at(omega));
    let turns = one.turns.map_or("-".into(), |turns| turns.to_string());
    println!(
        "{:24}  {omega:5}  {turns:>6}  {:7.2}   {:7.2} {:7.2} {:6.1}  {:9.2}  {:5.2}",
        foot.name(),
        one.largest,
        one.smallest,
        one.mean,
        100.0 * one.free,
        one.lift_offs,
        one.feed
    );
}

/// The recommended shapes. How far the rack drops on its way back (3 to 6 mm) does not matter to a foot that lies on a rigid
/// plate then; on one that yields see [`plates`].
pub fn recommendations() {
    println!("\nsmallest and mean force on the working stroke, N, by rise and straight part");
    let speeds = [200.0, 250.0, 300.0, 350.0, 400.0, 500.0];
    print_speeds(&speeds, 15);
    for rise in [0.2, 0.35, 0.5] {
        for angle in [40.0, 60.0, 80.0] {
            let row = speeds.map(|omega| {
                let one = Straight(rise, angle).outcome(Drive::at(omega));
                format!("{:8.2}{:7.2}", one.smallest, one.mean)
            });
            println!("{:24}{}", format!("{rise} mm, {angle} deg"), row.concat());
        }
    }
}

/// The feed of a stitch of 4 mm: in contact, at more than 5 N, which is also where friction of 0.4 bears a drag of 2 N.
pub fn stitch() {
    println!(
        "\nfeed of a turn while the foot touches the fabric, and while it presses with more than 5 N, mm"
    );
    let speeds = [200.0, 250.0, 300.0, 350.0, 400.0, 500.0];
    print_speeds(&speeds, 12);
    for foot in [Ellipse(1.0), Ellipse(0.5), Straight(0.5, 60.0), Straight(0.2, 60.0)] {
        let row = speeds.map(|omega| {
            let feed = |hold: f64| {
                let drive = Drive { hold, ..Drive::at(omega) };
                foot.outcome(drive).feed
            };
            let [touching, held] = [0.0, 5.0].map(feed);
            assert!(held <= touching + 1e-9 && touching < 4.0 + 1e-6);
            format!("{touching:7.2}{held:5.2}")
        });
        println!("{:24}{}", foot.name(), row.concat());
    }
}

/// Plates that yield: how stiff, and how far the rack drops below one.
pub fn plates() {
    println!(
        "\nover a needle plate that yields: the ellipse of 1 mm, and the straight path of 0.5 mm over 1e6 N/m"
    );
    println!("{:24}  speed   turns  largest  smallest    mean   free  lift-offs   feed", "");
    for omega in [200.0, 300.0, 400.0, 500.0] {
        for foot in [Plate(2e5), Plate(1e6), Plate(1e7), Ellipse(1.0)] {
            print_outcome(foot, omega);
        }
    }
    for omega in [200.0, 300.0, 400.0, 500.0] {
        let drops = [3.0, 6.0].map(|drop| {
            print_outcome(PlateDrop(drop), omega);
            PlateDrop(drop).outcome(Drive::at(omega))
        });
        // The rack passes the level of the plate more steeply.
        let mean = drops[0].mean / drops[1].mean;
        assert!((mean - 1.0).abs() < 0.01, "{mean}");
    }
}
