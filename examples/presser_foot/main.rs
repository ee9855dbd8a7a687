//! A sprung presser foot holds the fabric on the rack that moves it. From which speed on does the foot jump, does a path
//! with a straight part hold the fabric better than an ellipse, and what is left of the stitch? The paper gives one
//! speed and the shapes of the paths; masses, springs and fabric are ours. What it says, and what comes out:
//!
//! | the paper | here |
//! |---|---|
//! | at 300 1/s the straight path of 0.5 mm presses more than the ellipse of 1 mm | it does, in the mean and at its smallest: on the ellipse the foot jumps; at 400 1/s it presses less in the mean |
//! | because it is straight | because it is lower: an ellipse of 0.5 mm presses 4 % less in the mean and more at its smallest |
//! | rise of 0.2 to 0.5 mm | 0.2 mm keeps contact up to 500 1/s; 0.5 mm loses it in two windows of speed, 167 to 204 1/s and from 348 1/s on |
//! | straight during 60 degrees | 40 degrees press more at their smallest, at every speed and rise, and up to 5 % less in the mean |
//! | drop of 3 mm | does not matter to a foot that lies on the plate meanwhile; over a plate that yields it changes forces by a thousandth |
//! | its new mechanism by five harmonics | the speed at which the foot leaves the fabric first is right to 0.3 % (ellipse: 1.1 %), contact to 1.3 degrees, forces to 27 N where the rack passes the plate: the kinks are gone. With one harmonic or two the foot does not leave at all at 300 1/s |
//! | the transition to the straight part is not told | ours without jumps presses with 6.4 N at least, an ellipse of that rise with 7.7 N, the best transition with 15.0 N: it leaves the straight part soon and then falls evenly |
//! | the plate is rigid | with 1e6 N/m, ten times the fabric, the foot leaves from 220 1/s on in place of 226; with 1e7 N/m forces change by one or two in a hundred |
//!
//! Beyond that: the states at the bottom of each turn over the speed, with Lyapunov exponents, are drawn in
//! `target/presser_foot.svg`; at 500 1/s two motions attract, and from where they do in `target/presser_foot_basins.svg`.
//!
//! | file | what it answers |
//! |---|---|
//! | `foot` | a foot on a path and a fabric, its steady motion |
//! | `forces` | forces on the working stroke and the feed of a stitch; recommended shapes; plates that yield |
//! | `limits` | speeds and preloads at which the foot begins to leave the fabric |
//! | `harmonics` | what is lost by few harmonics |
//! | `transition` | the shape that presses most at its least |
//! | `attractors` | what a slow run-up and a run-down come to; irregular motion |
//! | `basins` | from where two motions at one speed are reached |
//!
//! V. O. Polotebnov, abstract of a dissertation, St Petersburg 2010.
//!
//!     cargo run --release --example presser_foot

mod attractors;
mod basins;
mod foot;
mod forces;
mod harmonics;
mod limits;
mod transition;

fn main() -> std::io::Result<()> {
    forces::comparison();
    limits::windows();
    limits::preloads();
    forces::recommendations();
    forces::stitch();
    limits::maps();
    forces::plates();
    harmonics::harmonics();
    transition::transition();
    attractors::attractors()?;
    basins::basins()
}

/// The first line of a table over the speed, with columns of a width.
fn print_speeds(speeds: &[f64], width: usize) {
    let all = speeds.iter().map(|omega| format!("{omega:>width$}"));
    println!("{:24}{}", "speed, 1/s", all.collect::<String>());
}

/// Writes a drawing into `target`.
fn write(name: &str, drawing: &str) -> std::io::Result<()> {
    let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/target");
    std::fs::create_dir_all(directory)?;
    std::fs::write(format!("{directory}/{name}"), drawing)?;
    println!("target/{name}");
    Ok(())
}
