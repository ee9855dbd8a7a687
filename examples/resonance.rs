//! The batten of a shuttle loom lags more at some speeds than at others: its shaft twists and its bar bends, and
//! whenever a free motion repeats with the crank the lag grows without bound. With losses in shaft and bar little of
//! that is left. The lag over the speed, without and with losses, as a table and as a drawing,
//! `target/resonance.svg`.
//!
//!     cargo run --release --example resonance

use assur::periodic;
use assur::prelude::*;
use assur_equations::batten::{Damped, Elastic};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Revolutions per minute: from, to, step.
const SPEEDS: (f64, f64, f64) = (150.0, 400.0, 0.25);
/// Revolutions per minute in radians per second.
const RPM: f64 = TAU / 60.0;

/// Largest lag over a revolution in milliradians; `None` in a resonance.
type Lag = Option<f64>;

fn main() -> std::io::Result<()> {
    let without = curve(|n| Elastic { n, ..Elastic::default() });
    let with = curve(|n| Damped { n, ..Damped::default() });

    println!("   speed   without losses   with losses");
    for (speed, without, with) in lines(&without, &with) {
        let shown = |lag: Lag| lag.map_or("resonance".into(), |lag| format!("{lag:.3} mrad"));
        println!("{speed:4} rpm   {:>14}   {:>11}", shown(without), shown(with));
    }
    println!("  (published: 3.7 mrad at 250 rpm)");
    check(&without, &with);

    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/target/resonance.svg");
    std::fs::create_dir_all(concat!(env!("CARGO_MANIFEST_DIR"), "/target"))?;
    std::fs::write(path, drawing(&without, &with))?;
    println!("{path}");
    Ok(())
}

/// Checks the curves against the published amplitude and against each other.
fn check(without: &[Lag], with: &[Lag]) {
    let at = |curve: &[Lag], speed: f64| curve[place(speed)].unwrap();
    assert!((at(without, 250.0) - 3.7744).abs() < 3e-3);
    assert!((at(with, 250.0) - 3.7535).abs() < 3e-3);
    let largest = |curve: &[Lag]| curve.iter().flatten().fold(0.0, |a: f64, b| a.max(*b));
    let near = without.iter().filter(|lag| lag.is_none()).count();
    println!("  {near} of {} speeds lie too near to a resonance without losses", without.len());
    assert!((10..100).contains(&near));
    assert!(with.iter().all(Option::is_some));
    assert!(largest(without) > 2.0 * largest(with));
}

/// Number of a speed.
fn place(speed: f64) -> usize {
    ((speed - SPEEDS.0) / SPEEDS.2).round() as usize
}

/// Speed of a number.
fn speed(place: usize) -> f64 {
    SPEEDS.0 + SPEEDS.2 * place as f64
}

/// The lag over the speed, on all processors.
fn curve<C: Smooth>(scene: impl Fn(f64) -> C + Sync) -> Vec<Lag> {
    let mut lags = vec![None; place(SPEEDS.1) + 1];
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let share = lags.len().div_ceil(workers);
    std::thread::scope(|scope| {
        for (worker, lags) in lags.chunks_mut(share).enumerate() {
            let scene = &scene;
            scope.spawn(move || {
                for (index, lag) in lags.iter_mut().enumerate() {
                    let n = speed(worker * share + index) * RPM;
                    *lag = largest_lag(&scene(n), TAU / n);
                }
            });
        }
    });
    lags
}

/// The largest lag of a scene in its steady state.
fn largest_lag<C: Smooth>(scene: &C, period: f64) -> Lag {
    let settings = Settings::new(Method::Dop853).rtol(1e-9);
    let orbit = periodic::solve(scene, period, &settings).ok()?;
    let lag = |index: u32| 1e3 * orbit.at(period * f64::from(index) / 256.0)[0].abs();
    Some((0..256).map(lag).fold(0.0, f64::max))
}

/// The lines of the table.
fn lines(without: &[Lag], with: &[Lag]) -> Vec<(f64, Lag, Lag)> {
    let places = (0..without.len()).step_by(place(SPEEDS.0 + 25.0));
    places.map(|it| (speed(it), without[it], with[it])).collect()
}

/// Both curves over the speed; above 15 mrad the drawing ends.
fn drawing(without: &[Lag], with: &[Lag]) -> String {
    let x = |speed: f64| 50.0 + (speed - SPEEDS.0) * 3.0;
    let y = |lag: f64| 320.0 - 20.0 * lag.min(15.0);
    let mut svg = String::from(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 830 370' font-family='sans-serif' font-size='12'>\n\
         <rect width='830' height='370' fill='white'/>\n",
    );
    let mut put = |text: String| svg += &text;
    for lag in (0..=15).step_by(3) {
        let y = y(f64::from(lag));
        put(format!(
            "<path d='M50 {y}H800' stroke='#ddd'/><text x='24' y='{}'>{lag}</text>\n",
            y + 4.0
        ));
    }
    for speed in (150..=400).step_by(50) {
        put(format!(
            "<text x='{}' y='340' text-anchor='middle'>{speed}</text>\n",
            x(f64::from(speed))
        ));
    }
    put("<text x='50' y='14'>largest lag, mrad: grey without, blue with losses</text>\n".into());
    put("<text x='800' y='360' text-anchor='end'>speed, rpm</text>\n".into());
    for (curve, colour) in [(without, "#999"), (with, "#06c")] {
        let mut path = String::new();
        for (index, lag) in curve.iter().enumerate() {
            let verb = if index == 0 { 'M' } else { 'L' };
            let lag = lag.unwrap_or(15.0);
            write!(path, "{verb}{:.1} {:.1}", x(speed(index)), y(lag)).expect("a string takes all");
        }
        put(format!("<path d='{path}' fill='none' stroke='{colour}'/>\n"));
    }
    svg + "</svg>\n"
}
