//! Two motions at one speed: from where on the fabric and above it does the foot come to which?

use super::attractors::walk;
use super::foot::{Drive, Driven, Foot::*, Place};
use std::fmt::Write;

const SPEED: f64 = 500.0;
/// Starts in each direction.
const SIDE: usize = 60;
const COLOURS: [&str; 3] = ["#e9c46a", "#2a6f97", "#444"];

/// A motion that repeats, by its places at the bottoms of its turns.
type Attractor = Vec<Place>;

/// The attractor that is reached from a place; none within 400 turns if it is none of these.
fn reached(scene: &dyn Driven, from: Place, period: f64, all: &[Attractor]) -> Option<usize> {
    let mut place = from;
    for _ in 0..40 {
        let motion = scene.march(Some(&place), 10.0 * period);
        place = (motion.mode, motion.end);
        let is_near = |other: &Place| {
            let [w, v] = [0, 1].map(|k| (other.1[k] - place.1[k]).abs());
            other.0 == place.0 && w < 1e-6 && v < 1e-6 * SPEED
        };
        let found = all.iter().position(|one| one.iter().any(is_near));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// The two motions at 500 1/s on the ellipse: one that begins on the fabric and one that is let fall.
fn both(scene: &dyn Driven, period: f64) -> Vec<Attractor> {
    let starts = [None, Some((1, vec![2e-3, 0.0]))];
    let attractor = |start: Option<Place>| {
        let cycle = scene.cycle(start.as_ref(), period).unwrap();
        assert!(cycle.is_stable());
        let turns = 0..cycle.multiple;
        turns.map(|turn| cycle.motion.at(turn as f64 * period)).collect()
    };
    starts.map(attractor).into()
}

/// Whether a foot with this height and speed presses the fabric when the rack is low.
fn begins([w, v]: [f64; 2]) -> usize {
    let (c2, mu2) = (1e5, 30.0);
    let presses = w < 0.0 && -c2 * w - mu2 * v > 0.0;
    usize::from(!presses)
}

/// Shares of the starts, drawn in `target/presser_foot_basins.svg`.
pub fn basins() -> std::io::Result<()> {
    let drive = Drive::at(SPEED);
    let (scene, period) = (Ellipse(1.0).driven(drive), drive.period());
    let scene = scene.as_ref();
    let all = both(scene, period);
    println!("\nellipse 1 mm at {SPEED} 1/s: two motions, each of one turn");
    let up: Vec<f64> = (20..=50).map(|k| 10.0 * f64::from(k)).collect();
    let down: Vec<f64> = (50..=90).rev().map(|k| 10.0 * f64::from(k)).collect();
    let [up, down] = [up, down].map(|speeds| {
        let last = walk(Ellipse(1.0), &speeds).pop().expect("some speeds");
        reached(scene, last.end, period, &all).expect("one of the two")
    });
    let mut counts = [0usize; 3];
    let mut drawn = String::new();
    for row in 0..SIDE {
        for column in 0..SIDE {
            let part = |k: usize| (k as f64 + 0.5) / SIDE as f64;
            let start = [1e-3 * (5.0 * part(column) - 1.5), 2.0 * (1.0 - part(row)) - 1.0];
            let from = (begins(start), start.to_vec());
            let found = reached(scene, from, period, &all).unwrap_or(2);
            counts[found] += 1;
            let (x, y) = (50 + 8 * column, 30 + 8 * row);
            writeln!(
                drawn,
                "<rect x='{x}' y='{y}' width='8' height='8' fill='{}'/>",
                COLOURS[found]
            )
            .expect("a string takes all");
        }
    }
    let share = |k: usize| 100.0 * counts[k] as f64 / (SIDE * SIDE) as f64;
    for (k, name) in ["one", "other"].into_iter().enumerate() {
        let (mode, state) = &all[k][0];
        let way = [(up, "a slow run-up"), (down, "a run-down")].map(|(found, way)| {
            let is_reached = found == k;
            if is_reached { format!("; {way} comes to it") } else { String::new() }
        });
        println!(
            "  the {name}: sole at {:6.3} mm at the bottom, {}, from {:4.1} % of the starts{}",
            1e3 * state[0],
            if *mode == 0 { "in contact" } else { "in flight" },
            share(k),
            way.concat()
        );
    }
    println!(
        "  neither: {:.1} % of {} starts from -1.5 to 3.5 mm and -1 to 1 m/s",
        share(2),
        SIDE * SIDE
    );
    assert!(share(0) > 5.0 && share(1) > 5.0);
    draw(&drawn, &all)
}

/// The map with the two motions as dots.
fn draw(cells: &str, all: &[Attractor]) -> std::io::Result<()> {
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 580 560' font-family='sans-serif' font-size='12'>\n\
         <rect width='580' height='560' fill='white'/>\n\
         <text x='50' y='20'>ellipse 1 mm at {SPEED} 1/s: where the foot begins and to which motion it comes</text>\n{cells}"
    );
    for (mode, state) in all.iter().flatten() {
        let x = 50.0 + 480.0 * (1e3 * state[0] + 1.5) / 5.0;
        let y = 30.0 + 480.0 * (1.0 - state[1]) / 2.0;
        let fill = if *mode == 0 { "black" } else { "white" };
        writeln!(svg, "<circle cx='{x:.1}' cy='{y:.1}' r='4' fill='{fill}' stroke='red'/>")
            .expect("a string takes all");
    }
    svg += "<text x='50' y='530'>height of the sole at the bottom, -1.5 to 3.5 mm; upwards its speed, -1 to 1 m/s</text>\n</svg>\n";
    super::write("presser_foot_basins.svg", &svg)
}
