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
//! | drop of 3 mm | does not matter to a foot that lies on the plate meanwhile |
//!
//! The states at the bottom of each turn over the speed are drawn in `target/presser_foot.svg`.
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
