//! A slider-crank and a four-bar that turn by themselves: closures and energies in equation files against both reduced by
//! hand.

use std::hint::black_box;

use assur::model::{Bound, Flow};
use assur::ode::{Explicit, Options, Workspace, integrate};
use assur::problem::Scene;

use crate::count::{Case, measure};
use crate::hand_bars::{self, Bars};
use crate::hand_freedom::Run;
use crate::table::{Table, number, power, ratio, verdict};

mod slider_crank {
    assur::mechanism! {
        SliderCrank from "made up";
        parameter r = 40 mm, l = 140 mm, J = 2e-3 [kg m^2], J_r = 1e-3 [kg m^2], m = 0.5 kg, T = 0.5 [N m];
        coordinate theta: rad = 0.3 rad, rate = 10 [rad/s];
        dependent psi ~ -10 deg, x ~ 170 mm;
        closure pin: r*dir(theta) + l*dir(psi) = [x, 0];
        kinetic J*dot(theta)^2/2 + m*dot(x)^2/2 + J_r*dot(psi)^2/2;
        force T on theta;
        scene turns { run time 0 s .. 1 s; }
    }
}

mod four_bar {
    assur::mechanism! {
        FourBar from "made up";
        parameter a = 50 mm, b = 150 mm, c = 120 mm, d = 160 mm, g = 9.81 [m/s^2];
        parameter J_1 = 4e-4 [kg m^2], m = 0.8 kg, J_2 = 2.5e-3 [kg m^2], J_3 = 3e-3 [kg m^2];
        coordinate phi: rad = 0.3 rad, rate = 20 [rad/s];
        dependent psi ~ 40 deg, chi ~ 80 deg;
        closure pin: a*dir(phi) + b*dir(psi) = [d, 0] + c*dir(chi);
        let C = a*dir(phi) + b/2*dir(psi);
        kinetic J_1*dot(phi)^2/2 + m*inner(dot(C), dot(C))/2 + J_2*dot(psi)^2/2 + J_3*dot(chi)^2/2;
        potential m*g*C.y;
        scene turns { run time 0 s .. 1 s; }
    }
}

/// Relative tolerance of the comparison, and the one of what counts as exact.
const RTOL: [f64; 2] = [1e-6, 1e-13];
/// Absolute tolerance per unit of the relative one.
const SCALE: f64 = 1e-3;
/// End, in seconds.
const END: f64 = 1.0;
/// Largest ratio of the emitted code to the hand-written one.
const GOAL: f64 = 1.1;

/// The emitted code by DOP853.
#[inline(never)]
fn emitted<C: Scene>(scene: &C, rtol: f64) -> Run {
    let bound = Bound::new(scene);
    let flow = Flow::new(&bound, 0);
    let options = Options::scaled(rtol, C::shape().scales);
    let mut workspace = Workspace::new(Explicit::Dop853, &flow);
    let done = integrate(&flow, (0.0, END), &scene.start(), &options, &mut workspace, &mut ());
    let mut end = [f64::NAN; 2];
    end.copy_from_slice(workspace.state());
    Run { end, evaluations: done.map_or(0, |statistics| statistics.evaluations) }
}

/// A code with its name.
type Kind = (&'static str, fn(f64) -> Run);

/// In pairs.
const KINDS: [Kind; 4] = [
    ("slider-crank by hand, fused", |rtol| {
        hand_bars::run(Bars::Slider, [0.3, 10.0], END, (rtol, SCALE))
    }),
    ("slider-crank, emitted", |rtol| emitted(&slider_crank::Turns::default(), rtol)),
    ("four-bar by hand, fused", |rtol| {
        hand_bars::run(Bars::FourBar, [0.3, 20.0], END, (rtol, SCALE))
    }),
    ("four-bar, emitted", |rtol| emitted(&four_bar::Turns::default(), rtol)),
];

/// Everything that is measured.
pub fn cases() -> Vec<Case<'static>> {
    let names = ["slider-hand", "slider", "four-bar-hand", "four-bar"];
    let all = names.into_iter().zip(KINDS).map(|(name, (_, code))| {
        Case::new(name, 1, move || {
            black_box(code(RTOL[0]));
        })
    });
    all.collect()
}

/// Relative error of the angle and the speed at the end.
fn error(run: &Run, exact: &Run) -> f64 {
    let pairs = run.end.iter().zip(exact.end);
    pairs.map(|(one, exact)| (one / exact - 1.0).abs()).fold(0.0, f64::max)
}

/// Measures and prints.
pub fn report() {
    let measures = measure("bars", &mut cases(), 300);
    let columns = [
        "code",
        "evaluations",
        "error",
        "instructions",
        "ratio",
        "per evaluation",
        "time, us",
        "ratio",
    ];
    let mut table = Table::new("Linkages with masses over 1 s, DOP853 with rtol 1e-6", &columns);
    for (index, ((kind, code), one)) in KINDS.into_iter().zip(&measures).enumerate() {
        let (run, hand) = (code(RTOL[0]), &measures[index - index % 2]);
        table.row([
            kind.to_owned(),
            run.evaluations.to_string(),
            power(error(&run, &KINDS[index - index % 2].1(RTOL[1]))),
            number(one.instructions),
            ratio(one.instructions, hand.instructions),
            number(one.instructions.map(|all| all / run.evaluations as f64)),
            number(one.microseconds()),
            ratio(one.microseconds(), hand.microseconds()),
        ]);
    }
    table.print();
    for (index, what) in [(0, "slider-crank"), (2, "four-bar")] {
        let (hand, ours) = (&measures[index], &measures[index + 1]);
        let title = |unit| format!("{what}, emitted / reduced by hand, {unit}");
        verdict(&title("instructions"), ours.instructions, hand.instructions, GOAL);
        verdict(&title("time"), ours.microseconds(), hand.microseconds(), GOAL);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_give_the_same_end() {
        for pair in KINDS.chunks(2) {
            let [hand, ours] = [&pair[0], &pair[1]].map(|(_, code)| code(RTOL[1]));
            assert!(error(&ours, &hand) < 1e-9, "{hand:?} {ours:?}");
        }
    }
}
