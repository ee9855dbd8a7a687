//! What attracts the foot when the speed rises slowly and when it falls.

use super::foot::{Drive, Foot, Foot::*, Place};
use super::print_speeds;
use std::fmt::Write;

/// What a slow change of the speed leads to at one speed.
pub struct Walked {
    /// Heights at the bottoms of the last turns.
    places: Vec<f64>,
    /// Mode and state at the end.
    pub end: Place,
    /// Largest Lyapunov exponent from there, per turn.
    exponent: f64,
}

/// Speed after speed, from where the last one ended.
pub fn walk(foot: Foot, speeds: &[f64]) -> Vec<Walked> {
    let mut from: Option<Place> = None;
    let at = |omega: &f64| {
        let walked = strobe(foot, *omega, from.take());
        from = Some(walked.end.clone());
        walked
    };
    speeds.iter().map(at).collect()
}

/// 36 turns after 150, and the growth of disturbances in the 100 after these.
fn strobe(foot: Foot, omega: f64, from: Option<Place>) -> Walked {
    let drive = Drive::at(omega);
    let (scene, period) = (foot.driven(drive), drive.period());
    let motion = scene.march(from.as_ref(), 186.0 * period);
    let places = (150..186).map(|turn| motion.at(f64::from(turn) * period).1[0]);
    let places = places.collect();
    let end = (motion.mode, motion.end);
    Walked { exponent: scene.exponent(&end, period, 100) * period, places, end }
}

impl Walked {
    /// After how many turns the heights repeat, up to twelve.
    fn period(&self) -> Option<usize> {
        let shifted = |turns: usize| self.places.iter().zip(&self.places[turns..]);
        (1..=12).find(|turns| shifted(*turns).all(|(a, b)| (a - b).abs() < 1e-6))
    }

    /// Whether some height of one motion is none of the other.
    fn is_apart(&self, other: &Self) -> bool {
        let is_missing = |a: &f64| other.places.iter().all(|b| (a - b).abs() > 1e-5);
        self.places.iter().any(is_missing)
    }

    /// Turns until the motion repeats, or by what factor disturbances grow in a turn.
    fn text(&self) -> String {
        match self.period() {
            Some(turns) => turns.to_string(),
            None => format!("x{:.2}", self.exponent.exp()),
        }
    }
}

/// The states at the bottom of each turn, when the speed rises slowly and when it falls, drawn over the speed.
pub fn attractors() -> std::io::Result<()> {
    println!(
        "\nturns until the motion repeats, after a slow run-up/after a run-down; x: none up to 12, growth of disturbances in a turn"
    );
    let speeds: Vec<f64> = (0..=70).map(|k| 200.0 + 10.0 * f64::from(k)).collect();
    let shown: Vec<f64> = speeds.iter().copied().step_by(5).collect();
    print_speeds(&shown, 12);
    let mut drawn = String::from(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 820 940' font-family='sans-serif' font-size='12'>\n\
         <rect width='820' height='940' fill='white'/>\n",
    );
    let feet = [Ellipse(1.0), Progressive, Stiff, Straight(0.5, 60.0)];
    for (row, foot) in feet.into_iter().enumerate() {
        let up = walk(foot, &speeds);
        let mut down = walk(foot, &speeds.iter().rev().copied().collect::<Vec<f64>>());
        down.reverse();
        print_row(foot, &speeds, &up, &down);
        draw_row(&mut drawn, row, foot, &speeds, [&up, &down]);
    }
    super::write("presser_foot.svg", &(drawn + "</svg>\n"))
}

/// A row of the table, and where the two ways end in different motions.
fn print_row(foot: Foot, speeds: &[f64], up: &[Walked], down: &[Walked]) {
    let cells = (0..speeds.len()).step_by(5).map(|k| {
        let both = format!("{}/{}", up[k].text(), down[k].text());
        format!("{both:>12}")
    });
    println!("{:24}{}", foot.name(), cells.collect::<String>());
    let repeats = |k: &usize| up[*k].period().is_some() && down[*k].period().is_some();
    let apart: Vec<String> = (0..speeds.len())
        .filter(|k| repeats(k) && up[*k].is_apart(&down[*k]))
        .map(|k| speeds[k].to_string())
        .collect();
    if !apart.is_empty() {
        let list = apart.join(", ");
        println!("{:24}  the two end in different motions at {list} 1/s", "");
    }
    let irregular = |all: &[Walked]| {
        let count = all.iter().filter(|one| one.period().is_none() && one.exponent > 0.01);
        100 * count.count() / all.len()
    };
    println!(
        "{:24}  irregular, exponent above zero: {} % of the speeds on the way up, {} % on the way down",
        "",
        irregular(up),
        irregular(down)
    );
    // What repeats is stable: where the period is told, disturbances do not grow.
    for one in up.iter().chain(down).filter(|one| one.period() == Some(1)) {
        assert!(one.exponent < 0.01, "{}", one.exponent);
    }
}

/// Heights over the speed, and the exponents below them with a line at zero.
fn draw_row(svg: &mut String, row: usize, foot: Foot, speeds: &[f64], ways: [&[Walked]; 2]) {
    let top = 20.0 + 230.0 * row as f64;
    let mut line = |text: String| writeln!(svg, "{text}").expect("a string takes all");
    line(format!(
        "<text x='50' y='{top}'>{}: height of the sole at the bottom of each turn, -1.5 to 5 mm; grey up, blue down</text>\n\
         <text x='50' y='{}'>Lyapunov exponent per turn, -1 to 1</text>",
        foot.name(),
        top + 215.0
    ));
    let zero = top + 180.0;
    line(format!("<path d='M50 {zero} H750' stroke='#ccc' fill='none'/>"));
    for (all, colour) in ways.into_iter().zip(["#999", "#06c"]) {
        let mut curve = String::new();
        for (omega, walked) in speeds.iter().zip(all) {
            let x = omega - 150.0;
            for place in &walked.places {
                let y = top + 155.0 - 23.0 * (1e3 * place + 1.5).min(6.5);
                line(format!("<circle cx='{x:.0}' cy='{y:.1}' r='1' fill='{colour}'/>"));
            }
            let y = zero - 25.0 * walked.exponent.clamp(-1.0, 1.0);
            write!(curve, "{x:.0},{y:.1} ").expect("a string takes all");
        }
        line(format!("<polyline points='{curve}' stroke='{colour}' fill='none'/>"));
    }
}
