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

use assur::hybrid::{self, CycleError, Hybrid, Sensitive};
use assur::measure;
use assur::prelude::*;
use assur_equations::presser_foot::*;
use std::f64::consts::TAU;
use std::fmt::Write;

const SETTINGS: Settings = Settings {
    method: Method::Dop853,
    rtol: 1e-9,
};

/// The rack and the fabric.
#[derive(Clone, Copy)]
enum Foot {
    /// Rise in mm.
    Ellipse(f64),
    /// Rise in mm, straight part in degrees.
    Straight(f64, f64),
    Harmonics,
    Progressive,
    Stiff,
    HuntCrossley,
}
use Foot::*;

impl Foot {
    fn name(self) -> String {
        match self {
            Ellipse(rise) => format!("ellipse {rise} mm"),
            Straight(rise, 60.0) => format!("straight {rise} mm"),
            Straight(rise, angle) => format!("straight {rise} mm {angle} deg"),
            Harmonics => "five harmonics 1 mm".into(),
            Progressive => "ellipse, progressive".into(),
            Stiff => "ellipse, stiff".into(),
            HuntCrossley => "ellipse, Hunt-Crossley".into(),
        }
    }
}

/// Evaluates an expression with the scene of a foot.
macro_rules! with_scene {
    ($foot:expr, $drive:expr, |$scene:ident| $value:expr) => {{
        let Drive {
            omega,
            preload,
            hold,
        } = $drive;
        match $foot {
            Ellipse(rise) => {
                let $scene = Elliptic {
                    omega,
                    F10: preload,
                    F_min: hold,
                    rise: 1e-3 * rise,
                    ..Elliptic::default()
                };
                $value
            }
            Straight(rise, angle) => {
                let (rise, phi_v) = (1e-3 * rise, angle.to_radians());
                let $scene = assur_equations::presser_foot::Straight {
                    omega,
                    F10: preload,
                    F_min: hold,
                    rise,
                    phi_v,
                    ..Default::default()
                };
                $value
            }
            Harmonics => {
                let $scene = FiveHarmonics {
                    omega,
                    F10: preload,
                    F_min: hold,
                    ..Default::default()
                };
                $value
            }
            Progressive => {
                let $scene = assur_equations::presser_foot::Progressive {
                    omega,
                    F10: preload,
                    F_min: hold,
                    ..Default::default()
                };
                $value
            }
            Stiff => {
                let $scene = Elliptic {
                    omega,
                    F10: preload,
                    F_min: hold,
                    c2: 4e5,
                    mu2: 40.0,
                    ..Default::default()
                };
                $value
            }
            HuntCrossley => {
                let $scene = assur_equations::presser_foot::HuntCrossley {
                    omega,
                    F10: preload,
                    F_min: hold,
                    ..Default::default()
                };
                $value
            }
        }
    }};
}

/// How the foot is driven.
#[derive(Clone, Copy)]
struct Drive {
    /// Speed of the shaft in 1/s.
    omega: f64,
    /// Preload in N.
    preload: f64,
    /// Force from which on the foot holds the fabric, in N.
    hold: f64,
}

impl Drive {
    fn at(omega: f64) -> Self {
        Self {
            omega,
            preload: 40.0,
            hold: 5.0,
        }
    }
}

/// What a motion comes to.
#[derive(Clone, Copy)]
struct Outcome {
    /// Turns until it repeats; none if nothing that repeats is stable.
    turns: Option<usize>,
    /// Forces on the working stroke and of all, in N.
    largest: f64,
    smallest: f64,
    mean: f64,
    least: f64,
    /// Part of the time without contact.
    free: f64,
    lift_offs: f64,
    /// Feed of a turn while the foot holds the fabric, in mm.
    feed: f64,
}

fn outcome(foot: Foot, drive: Drive) -> Outcome {
    with_scene!(foot, drive, |scene| solve(&scene, TAU / drive.omega))
}

fn solve<C: Hybrid>(scene: &C, period: f64) -> Outcome
where
    C::Modal<f64>: Sensitive<f64>,
{
    let (turns, motion) = match hybrid::cycle(scene, period, &SETTINGS) {
        Ok(cycle) => (Some(cycle.multiple), cycle.motion),
        Err(CycleError::NoneStable { .. }) => {
            let motion = hybrid::march(scene, (0.0, 200.0 * period), &scene.start(), &SETTINGS);
            (None, motion.unwrap())
        }
        Err(error) => panic!("{error}"),
    };
    let measures = MECHANISM.scenes[0].measures;
    let values = measure::of(scene, &motion);
    let value = |name: &str| {
        let place = measures.iter().position(|one| one.name == name).unwrap();
        values[place].unwrap_or(f64::NAN)
    };
    Outcome {
        turns,
        largest: value("F_largest"),
        smallest: value("F_smallest").max(0.0),
        mean: value("F_mean"),
        least: value("F_least").max(0.0),
        free: value("free"),
        lift_offs: value("flights") / value("turns"),
        feed: 1e3 * value("real_feed"),
    }
}

fn main() -> std::io::Result<()> {
    comparison();
    windows();
    preloads();
    recommendations();
    stitch();
    lift_off();
    attractors()
}

/// Forces on the two paths.
fn comparison() {
    println!(
        "forces on the working stroke, contact, and feed of a stitch of 4 mm at forces above 5 N"
    );
    println!(
        "{:24}  speed   turns  largest  smallest    mean   free  lift-offs   feed",
        ""
    );
    println!(
        "{:24}    1/s               N         N       N      %   per turn     mm",
        ""
    );
    let paths = [
        Ellipse(1.0),
        Ellipse(0.5),
        Ellipse(0.2),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
        Harmonics,
        Progressive,
        HuntCrossley,
    ];
    for foot in paths {
        for omega in [200.0, 300.0, 400.0, 500.0] {
            let one = outcome(foot, Drive::at(omega));
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
    }
    let at = |foot| outcome(foot, Drive::at(300.0));
    let (ellipse, straight, low) = (at(Ellipse(1.0)), at(Straight(0.5, 60.0)), at(Ellipse(0.5)));
    assert!(straight.mean > 1.2 * ellipse.mean && straight.smallest > ellipse.smallest);
    assert!(low.smallest > straight.smallest && (low.mean / straight.mean - 1.0).abs() < 0.05);
}

/// Speeds between 120 and 420 1/s at which the foot leaves the fabric.
fn windows() {
    println!("\nspeeds at which the foot leaves the fabric, 120 to 420 1/s");
    let flies = |foot, omega| outcome(foot, Drive::at(omega)).free > 0.0;
    let paths = [
        Ellipse(1.0),
        Ellipse(0.5),
        Ellipse(0.2),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
        Harmonics,
        Progressive,
        HuntCrossley,
    ];
    let mut borders = Vec::new();
    for foot in paths {
        let speeds: Vec<f64> = (0..=60).map(|k| 120.0 + 5.0 * f64::from(k)).collect();
        let states: Vec<bool> = speeds.iter().map(|omega| flies(foot, *omega)).collect();
        let mut found = Vec::new();
        for (k, pair) in states.windows(2).enumerate() {
            if pair[0] == pair[1] {
                continue;
            }
            let (mut low, mut high) = (speeds[k], speeds[k + 1]);
            while high - low > 1e-4 {
                let middle = (low + high) / 2.0;
                match flies(foot, middle) == pair[0] {
                    true => low = middle,
                    false => high = middle,
                }
            }
            found.push(low);
        }
        let text: Vec<String> = found
            .chunks(2)
            .map(|window| match window {
                [from, to] => format!("{from:.3} to {to:.3} 1/s"),
                _ => format!("from {:.3} 1/s on", window[0]),
            })
            .collect();
        println!(
            "{:24}  {}",
            foot.name(),
            if text.is_empty() {
                "none".into()
            } else {
                text.join(", ")
            }
        );
        borders.push(found);
    }
    // The closed form of the linear fabric, tests/reference/presser_foot.json.
    assert!((borders[0][0] - 226.03618).abs() < 1e-3);
    for (found, expected) in borders[3].iter().zip([167.18523, 203.80554, 348.05705]) {
        assert!((found - expected).abs() < 1e-3, "{found} {expected}");
    }
}

/// The force of the linear fabric moves with the preload as it does at rest, so one motion without separation is enough.
fn preloads() {
    println!("\nsmallest preload that keeps contact, N");
    let speeds = [150.0, 200.0, 250.0, 300.0, 350.0, 400.0, 500.0];
    println!(
        "{:24}{}",
        "speed, 1/s",
        speeds.map(|omega| format!("{omega:8}")).concat()
    );
    let Elliptic { c1, c2, .. } = Elliptic::default();
    for foot in [
        Ellipse(1.0),
        Ellipse(0.5),
        Ellipse(0.2),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
        Harmonics,
    ] {
        let row = speeds.map(|omega| {
            let preload = 1000.0;
            let least = outcome(
                foot,
                Drive {
                    preload,
                    ..Drive::at(omega)
                },
            )
            .least;
            format!("{:8.2}", preload - least * (c1 + c2) / c2)
        });
        println!("{:24}{}", foot.name(), row.concat());
    }
}

/// The recommended shapes. How far the rack drops on its way back (3 to 6 mm) does not matter to a foot that lies on the
/// plate then.
fn recommendations() {
    println!("\nsmallest and mean force on the working stroke, N, by rise and straight part");
    let speeds = [200.0, 250.0, 300.0, 350.0, 400.0, 500.0];
    println!(
        "{:24}{}",
        "speed, 1/s",
        speeds.map(|omega| format!("{omega:>15}")).concat()
    );
    for rise in [0.2, 0.35, 0.5] {
        for angle in [40.0, 60.0, 80.0] {
            let row = speeds.map(|omega| {
                let one = outcome(Straight(rise, angle), Drive::at(omega));
                format!("{:8.2}{:7.2}", one.smallest, one.mean)
            });
            println!("{:24}{}", format!("{rise} mm, {angle} deg"), row.concat());
        }
    }
}

/// The feed of a stitch of 4 mm: in contact, at more than 5 N, which is also where friction of 0.4 bears a drag of 2 N.
fn stitch() {
    println!(
        "\nfeed of a turn while the foot touches the fabric, and while it presses with more than 5 N, mm"
    );
    let speeds = [200.0, 250.0, 300.0, 350.0, 400.0, 500.0];
    println!(
        "{:24}{}",
        "speed, 1/s",
        speeds.map(|omega| format!("{omega:>12}")).concat()
    );
    for foot in [
        Ellipse(1.0),
        Ellipse(0.5),
        Straight(0.5, 60.0),
        Straight(0.2, 60.0),
    ] {
        let row = speeds.map(|omega| {
            let [touching, held] = [0.0, 5.0].map(|hold| {
                outcome(
                    foot,
                    Drive {
                        hold,
                        ..Drive::at(omega)
                    },
                )
                .feed
            });
            assert!(held <= touching + 1e-9 && touching < 4.0 + 1e-6);
            format!("{touching:7.2}{held:5.2}")
        });
        println!("{:24}{}", foot.name(), row.concat());
    }
}

/// Maps of the time without contact.
fn lift_off() {
    for foot in [Ellipse(1.0), Straight(0.5, 60.0)] {
        println!(
            "\n{}: time without contact in %, by preload and speed (~: nothing that repeats is stable)",
            foot.name()
        );
        let speeds = [150.0, 200.0, 250.0, 300.0, 350.0, 400.0, 450.0, 500.0];
        println!(
            "{:24}{}",
            "speed, 1/s",
            speeds.map(|omega| format!("{omega:>8}")).concat()
        );
        for preload in [10.0, 20.0, 30.0, 40.0, 60.0, 80.0, 120.0] {
            let row = speeds.map(|omega| {
                let one = outcome(
                    foot,
                    Drive {
                        preload,
                        ..Drive::at(omega)
                    },
                );
                format!(
                    "{:7.1}{}",
                    100.0 * one.free,
                    if one.turns.is_some() { ' ' } else { '~' }
                )
            });
            println!("{:24}{}", format!("{preload} N"), row.concat());
        }
    }
}

/// The states at the bottom of each turn, when the speed rises slowly and when it falls.
fn attractors() -> std::io::Result<()> {
    let mut svg = String::from(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 820 880' font-family='sans-serif' font-size='12'>\n\
         <rect width='820' height='880' fill='white'/>\n",
    );
    println!(
        "\nturns until the motion repeats, after a slow run-up/after a run-down; x: none up to 12, growth of disturbances in a turn"
    );
    let speeds: Vec<f64> = (0..=70).map(|k| 200.0 + 10.0 * f64::from(k)).collect();
    let shown: Vec<&f64> = speeds.iter().step_by(5).collect();
    println!(
        "{:24}{}",
        "speed, 1/s",
        shown
            .iter()
            .map(|omega| format!("{omega:>12}"))
            .collect::<String>()
    );
    for (row, foot) in [Ellipse(1.0), Progressive, Stiff, Straight(0.5, 60.0)]
        .into_iter()
        .enumerate()
    {
        let up = walk(foot, &speeds);
        let mut down = walk(foot, &speeds.iter().rev().copied().collect::<Vec<f64>>());
        down.reverse();
        let cells = (0..speeds.len()).step_by(5).map(|k| {
            let [one, other] = [&up[k], &down[k]].map(|walked| walked.text(foot, speeds[k]));
            format!("{:>12}", format!("{one}/{other}"))
        });
        println!("{:24}{}", foot.name(), cells.collect::<String>());
        let repeats = |k: &usize| up[*k].period().is_some() && down[*k].period().is_some();
        let apart: Vec<String> = (0..speeds.len())
            .filter(|k| repeats(k) && up[*k].is_apart(&down[*k]))
            .map(|k| speeds[k].to_string())
            .collect();
        if !apart.is_empty() {
            println!(
                "{:24}  the two end in different motions at {} 1/s",
                "",
                apart.join(", ")
            );
        }
        let y0 = 20.0 + 215.0 * row as f64;
        let text = format!(
            "<text x='50' y='{}'>{}: height of the sole at the bottom of each turn, -1.5 to 5 mm; grey up, blue down</text>\n",
            y0,
            foot.name()
        );
        svg += &text;
        for (all, colour) in [(&up, "#999"), (&down, "#06c")] {
            for (omega, walked) in speeds.iter().zip(all) {
                for place in &walked.places {
                    let (x, y) = (
                        50.0 + omega - 200.0,
                        y0 + 195.0 - 29.0 * (1e3 * place + 1.5).min(6.5),
                    );
                    writeln!(
                        svg,
                        "<circle cx='{x:.0}' cy='{y:.1}' r='1' fill='{colour}'/>"
                    )
                    .expect("a string takes all");
                }
            }
        }
    }
    let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/target");
    std::fs::create_dir_all(directory)?;
    std::fs::write(format!("{directory}/presser_foot.svg"), svg + "</svg>\n")?;
    println!("target/presser_foot.svg");
    Ok(())
}

/// What a slow change of the speed leads to at one speed.
struct Walked {
    /// Heights at the bottoms of the last turns.
    places: Vec<f64>,
    /// Mode and state at the end.
    end: (usize, Vec<f64>),
}

/// Speed after speed, from where the last one ended.
fn walk(foot: Foot, speeds: &[f64]) -> Vec<Walked> {
    let mut from: Option<(usize, Vec<f64>)> = None;
    let at = |omega: &f64| {
        let walked = with_scene!(foot, Drive::at(*omega), |scene| strobe(
            &scene,
            TAU / omega,
            from.take()
        ));
        from = Some(walked.end.clone());
        walked
    };
    speeds.iter().map(at).collect()
}

/// 36 turns after 150.
fn strobe<C: Hybrid>(scene: &C, period: f64, from: Option<(usize, Vec<f64>)>) -> Walked {
    let (mode, start) = from.unwrap_or_else(|| (C::FIRST, scene.start().to_vec()));
    let motion = hybrid::march_in(scene, mode, (0.0, 186.0 * period), &start, &SETTINGS).unwrap();
    let places = (150..186).map(|turn| motion.at(f64::from(turn) * period).1[0]);
    Walked {
        places: places.collect(),
        end: (motion.mode, motion.end),
    }
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
    fn text(&self, foot: Foot, omega: f64) -> String {
        if let Some(turns) = self.period() {
            return turns.to_string();
        }
        let (mode, state) = &self.end;
        let found = with_scene!(foot, Drive::at(omega), |scene| {
            hybrid::cycle_from(&scene, (*mode, state), TAU / omega, &SETTINGS)
        });
        match found {
            Ok(cycle) => cycle.multiple.to_string(),
            Err(CycleError::NoneStable { growth, .. }) => format!("x{growth:.2}"),
            Err(error) => panic!("{error}"),
        }
    }
}
