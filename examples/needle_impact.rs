//! The butt of a knitting needle is pushed down by a wedge, overruns, and may strike a limiting cam. Up to which speed does
//! it not, how hard is the blow, and how long does the needle last? What the paper says of it, and what comes out:
//!
//! | the paper | here |
//! |---|---|
//! | needles that rebound strike first, from 1.71 m/s on | from 1.60 to 1.68 m/s, as the wedge is described; needles that slide from 1.83 m/s on |
//! | eq (12) is the peak force | it is too small by up to `P_C`, and negative below 0.91 m/s at the cam |
//! | the gap is what the drawing says | the butt leaves the wedge bent: a gap of 0.25 mm is one of 0.45 mm for a needle that slides |
//! | a needle that rebounds flies on to the cam | unless the wedge catches it again: with a wedge of 4 mm it strikes between 2.1 and 2.65 m/s and not above |
//! | friction keeps needles from the cam | it does, but the wedge has to overcome it: its blow grows |
//!
//! What the butt bears is assumed, and so is the life; only how it changes is a result. The blow of the wedge decides up to
//! 2.4 m/s, that of the limiting cam above.
//!
//! Published by L. M. Berezin, 2011.
//!
//!     cargo run --example needle_impact

use assur::closure::{Assembly, Linkage};
use assur::hybrid::{Motion, march};
use assur::measure;
use assur::prelude::*;
use assur::shape::Quantity;
use assur_equations::needle_impact::*;

const RPM: f64 = std::f64::consts::TAU / 60.0;
const MM: f64 = 1e-3;
const MPA: f64 = 1e6;
const HOUR: f64 = 3600.0;
/// Inclination of the wedge.
const INCLINATION: f64 = 47.5 * std::f64::consts::PI / 180.0;

fn main() {
    thresholds();
    gaps();
    forces();
    friction();
    formula_12();
    life();
    chances();
}

/// Names of what a scene reports.
fn names(scene: &str) -> (&'static [Quantity], &'static [Quantity]) {
    let mut scenes = MECHANISM.scenes.iter();
    let entry = scenes.find(|entry| entry.name == scene).unwrap();
    (entry.outputs, entry.measures)
}

fn place(list: &[Quantity], name: &str) -> usize {
    list.iter().position(|one| one.name == name).unwrap()
}

/// Outputs of closed forms, by name.
struct Formula {
    names: &'static [Quantity],
    values: Vec<f64>,
}

impl Formula {
    fn of<L: Linkage>(scene: &str, needle: &L, at: f64) -> Self {
        let mut assembly = Assembly::<L, f64>::new(needle);
        assembly.start().unwrap();
        assembly.travel(&[at]).unwrap();
        let mut values = vec![0.0; needle.shape().outputs.len()];
        assembly.outputs(&mut values);
        Self { names: names(scene).0, values }
    }

    fn get(&self, name: &str) -> f64 {
        self.values[place(self.names, name)]
    }
}

/// Measures of a run, by name.
struct Run {
    names: &'static [Quantity],
    values: Vec<f64>,
    motion: Motion,
}

impl Run {
    fn of<C: Scene>(scene: &str, needle: &C, end: f64) -> Self {
        let settings = Settings::new(Method::Dop853).rtol(1e-11);
        let motion = march(needle, (0.0, end), &needle.start(), &settings).unwrap();
        let values = measure::of(needle, &motion);
        Self {
            names: names(scene).1,
            values: values.into_iter().map(Result::unwrap).collect(),
            motion,
        }
    }

    fn get(&self, name: &str) -> f64 {
        self.values[place(self.names, name)]
    }
}

/// Question 1: speeds of the cylinder below which no needle strikes the limiting cam.
fn thresholds() {
    println!("speed of the cylinder below which a needle does not strike, m/s and rpm");
    println!("  gap, mm      slides       rebounds (sin cos)   rebounds (cos^2)");
    let mut last = 0.0;
    for gap in [0.20, 0.25, 0.30] {
        let width = gap * MM;
        let slides = Formula::of("sliding", &Sliding { Delta: width, ..Sliding::default() }, 2.0);
        let slides = slides.get("limit");
        let rebounds =
            Formula::of("reach", &Reach { Delta: width, ..Reach::default() }, INCLINATION);
        let other = Formula::of(
            "reach_cos2",
            &ReachCos2 { Delta: width, ..ReachCos2::default() },
            INCLINATION,
        );
        // A needle that does not rebound at the speed at which one that slides strikes is one that slides.
        let [rebounds, other] = [rebounds, other].map(|one| {
            let is_ahead = one.get("V_0") > one.get("V_c") * INCLINATION.tan();
            if is_ahead { one.get("V_c") } else { slides }
        });
        let rpm = |speed: f64| 2.0 * speed / Sliding::default().D / RPM;
        println!(
            "  {gap:7.2} {slides:8.3} {:6.1} {rebounds:12.3} {:6.1} {other:12.3} {:6.1}",
            rpm(slides),
            rpm(rebounds),
            rpm(other)
        );
        assert!(rebounds <= slides && other < slides, "who rebounds strikes no later");
        assert!(slides > last);
        last = slides;
    }
    println!("  the paper: 1.71 m/s for a gap of 0.25 mm\n");
}

/// Question 1: the gap that a needle just does not cross.
fn gaps() {
    println!("gap that is just not crossed, mm");
    println!("  speed, m/s     slides   rebounds (fitted)   rebounds (sin cos)");
    for speed in [1.6, 1.7, 1.75, 1.8, 2.0] {
        let gap = |formula: Formula| formula.get("gap_needed") / MM;
        let slides = gap(Formula::of("sliding", &Sliding::default(), speed));
        let fitted = gap(Formula::of("struck_fitted", &StruckFitted::default(), speed));
        let rebounds =
            (speed > 1.67).then(|| gap(Formula::of("struck", &Struck::default(), speed)));
        let rebounds = rebounds.map_or("none".to_string(), |gap| format!("{gap:.3}"));
        println!("  {speed:10.2} {slides:10.3} {fitted:19.3} {rebounds:>20}");
    }
    println!();
}

/// Question 2: forces over the speed.
fn forces() {
    println!("largest forces, N: of the wedge, of the limiting cam; all effects, and the paper's");
    println!("  speed, m/s    all effects       struck once       slides, all effects   slides");
    for step in 0..=30 {
        let speed = 1.5 + 0.05 * f64::from(step);
        let full = Run::of(
            "unselected_full",
            &UnselectedFull { V_c: speed, ..UnselectedFull::default() },
            4e-3,
        );
        let once = Run::of("unselected", &Unselected { V_c: speed, ..Unselected::default() }, 4e-3);
        let slides =
            Run::of("selected_full", &SelectedFull { V_c: speed, ..SelectedFull::default() }, 4e-3);
        let plain = Run::of("selected", &Selected { V_c: speed, ..Selected::default() }, 2e-3);
        let both = |run: &Run| [run.get("F_wedge_max"), run.get("F_cam_max")];
        let [[a, b], [c, d], [_, f], [_, h]] = [&full, &once, &slides, &plain].map(both);
        let events = full.motion.events.iter();
        let contacts =
            events.filter(|event| UnselectedFull::shape().modes[event.to].name == "press").count();
        println!(
            "  {speed:10.2} {a:8.2} {b:7.2} {c:9.2} {d:7.2} {f:18.2} {h:12.2}   {contacts} contacts with the wedge"
        );
    }
    println!(
        "  with all effects the wedge, caught up with, keeps the needle from the limiting cam up to 2.1 m/s\n"
    );
    println!(
        "height of the wedge, mm: speeds at which the limiting cam is struck, m/s, all effects"
    );
    for height in [0.8, 1.5, 2.0, 4.0, 8.0] {
        let force = |step: u32| {
            let needle = UnselectedFull {
                V_c: 1.5 + 0.025 * f64::from(step),
                H_w: height * MM,
                ..UnselectedFull::default()
            };
            Run::of("unselected_full", &needle, 12e-3).get("F_cam_max")
        };
        let forces: Vec<f64> = (0..=60).map(force).collect();
        let mut bands = Vec::new();
        for (step, pair) in forces.windows(2).enumerate() {
            let speed = 1.5 + 0.025 * (step as f64 + 1.0);
            match (pair[0] > 0.0, pair[1] > 0.0) {
                (false, true) => bands.push(format!("from {speed:.2}")),
                (true, false) => bands.push(format!("to {speed:.2}")),
                _ => {}
            }
        }
        let falls = forces.windows(2).filter(|pair| pair[1] < pair[0]);
        let greatest = forces.iter().fold(0.0_f64, |most, one| most.max(*one));
        println!(
            "  {height:4.1} {:32} up to {greatest:6.2} N, falls with the speed in {} of 60 steps",
            bands.join(" "),
            falls.clone().count()
        );
        let in_bands = height >= 4.0;
        assert_eq!(falls.count() > 0, in_bands, "a wedge of {height} mm");
    }
    println!();
}

/// Question 3: friction in the groove.
fn friction() {
    println!("friction in the groove, V_c = 1.9 m/s");
    println!(
        "  P_C, N   slides up to   rebounds from   reaches from    wedge   cam, struck   cam, slides"
    );
    for force in [2.0, 3.0, 4.0, 4.8, 6.0, 8.0] {
        let limit = Formula::of("sliding", &Sliding { P_C: force, ..Sliding::default() }, 1.9);
        let graze = Formula::of("graze", &Graze { P_C: force, ..Graze::default() }, INCLINATION);
        let run = Run::of(
            "unselected",
            &Unselected { P_C: force, V_c: 1.9, ..Unselected::default() },
            4e-3,
        );
        let [slides, blow] = ["limit", "F"].map(|name| limit.get(name));
        let graze = graze.get("V_c");
        let reached = reach_by_runs(force);
        println!(
            "  {force:6.1} {slides:10.3} m/s {graze:11.3} m/s {reached:10.3} m/s {:8.2} N {:9.2} N {blow:10.2} N",
            run.get("F_wedge_max"),
            run.get("F_cam_max")
        );
        assert!(
            (graze / force - 1.6634 / 4.8).abs() < 1e-5,
            "the first rebound is proportional to the friction"
        );
    }
    println!("  more friction means later blows, but the wedge has to overcome it\n");
}

/// The least speed at which a struck needle reaches the limiting cam, by runs.
fn reach_by_runs(force: f64) -> f64 {
    let strikes = |speed: f64| {
        let needle = Unselected { P_C: force, V_c: speed, ..Unselected::default() };
        Run::of("unselected", &needle, 6e-3).get("blows") > 0.0
    };
    let (mut low, mut high) = (0.3, 4.0);
    for _ in 0..30 {
        let middle = (low + high) / 2.0;
        match strikes(middle) {
            true => high = middle,
            false => low = middle,
        }
    }
    high
}

/// Question 4: eq (12) against the exact force.
fn formula_12() {
    println!("force of the limiting cam over the speed at it, N");
    println!("  V_tau, m/s    exact   eq (12)   missing   with the dashpot");
    for speed in [0.1, 0.3, 0.5, 0.9, 1.0, 1.5, 2.0, 3.0, 5.0] {
        macro_rules! blow {
            ($name:literal, $scene:ident) => {
                Formula::of($name, &$scene { V_given: speed, Delta: 0.0, ..$scene::default() }, 2.0)
                    .get("F")
            };
        }
        let exact = blow!("blow", Blow);
        let paper = blow!("blow_paper", BlowPaper);
        let total = blow!("blow_total", BlowTotal);
        println!("  {speed:10.1} {exact:8.3} {paper:9.3} {:9.3} {total:18.3}", exact - paper);
        assert!(paper < exact && exact - paper < 4.8);
        assert_eq!(paper < 0.0, speed < 0.908);
    }
    println!();
}

/// Question 5: the life, and which impact decides.
fn life() {
    println!("stress and life of needles that are struck, assumed strength");
    println!("  speed, m/s   wedge, MPa   cam, MPa   share of the wedge   life, h");
    for speed in [1.7, 1.8, 2.0, 2.2, 2.5, 3.0] {
        let here = Formula::of("struck", &Struck::default(), speed);
        let [wedge, cam] = ["damage_wedge", "damage_cam"].map(|name| here.get(name));
        let used = here.get("used");
        let share = match wedge + cam > 0.0 {
            true => format!("{:.0} %", 100.0 * wedge / (wedge + cam)),
            false => "-".to_string(),
        };
        let life = match used > 0.0 {
            true => format!("{:.3e}", 1.0 / used / HOUR),
            false => "infinite".to_string(),
        };
        println!(
            "  {speed:10.2} {:12.1} {:10.1} {share:>20} {life:>9}",
            here.get("stress_wedge") / MPA,
            here.get("stress_cam") / MPA
        );
    }
    println!();
}

/// Question 5: the probability that a needle breaks in time.
fn chances() {
    println!(
        "probability that a needle that is struck breaks, the fatigue limit scattering by 20 %, V_c = 1.8 m/s"
    );
    println!("    time, h   limiting cam     both cams");
    let mut last = 0.0;
    for hours in [1.0, 10.0, 100.0, 1e3, 1e4] {
        let needle =
            ChanceStruck { V_c: 1.8, s_ln: 0.2, t_life: hours * HOUR, ..ChanceStruck::default() };
        let settings = Settings::new(Method::Dop853).rtol(1e-11);
        let motion = march(&needle, (0.0, 1.0), &needle.start(), &settings).unwrap();
        let [cam, both] = [motion.end[0], motion.end[1]];
        println!("  {hours:9.0} {cam:14.3e} {both:13.6}");
        assert!(both > last && cam <= both && both <= 1.0);
        last = both;
    }
}
