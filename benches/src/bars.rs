//! A slider-crank and a four-bar that turn by themselves: closures and energies in equation files against both reduced by
//! hand.

use std::hint::black_box;

use assur::ode::Explicit::Dop853;

use crate::count::{Case, measure};
use crate::freedom::{self, Kind, emitted};
use crate::hand_bars::{self, Bars};
use crate::hand_freedom::Run;

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

/// Relative tolerance of the comparison, at which both codes are as accurate, and the one of what counts as exact.
const RTOL: f64 = 1e-9;
const EXACT: f64 = 1e-13;
/// Absolute tolerance per unit of the relative one.
const SCALE: f64 = 1e-3;
/// End, in seconds.
const END: f64 = 1.0;
/// Largest ratio of the emitted code to the hand-written one.
const GOAL: f64 = 1.1;

/// A mechanism by hand.
fn by_hand(which: Bars, rtol: f64) -> Run {
    let speed = if which == Bars::Slider { 10.0 } else { 20.0 };
    hand_bars::run(which, [0.3, speed], END, (rtol, SCALE))
}

/// Each by hand and emitted.
const SLIDER: [Kind; 2] = [
    ("slider-crank by hand, fused", || by_hand(Bars::Slider, RTOL)),
    ("slider-crank, emitted", || emitted(&slider_crank::Turns::default(), Dop853, (END, RTOL))),
];
const FOUR_BAR: [Kind; 2] = [
    ("four-bar by hand, fused", || by_hand(Bars::FourBar, RTOL)),
    ("four-bar, emitted", || emitted(&four_bar::Turns::default(), Dop853, (END, RTOL))),
];

/// Everything that is measured.
pub fn cases() -> Vec<Case<'static>> {
    let names = ["slider-hand", "slider", "four-bar-hand", "four-bar"];
    let all = names.into_iter().zip([SLIDER, FOUR_BAR].concat()).map(|(name, (_, code))| {
        Case::new(name, 1, move || {
            black_box(code());
        })
    });
    all.collect()
}

/// Measures and prints.
pub fn report() {
    let measures = measure("bars", &mut cases(), 300);
    let (slider, four_bar) = measures.split_at(2);
    for (what, which, kinds, measures) in [
        ("slider-crank", Bars::Slider, SLIDER, slider),
        ("four-bar", Bars::FourBar, FOUR_BAR, four_bar),
    ] {
        let title = format!("A {what} with masses over 1 s, DOP853 with rtol 1e-9");
        freedom::print(&title, by_hand(which, EXACT).end, &kinds, measures);
        freedom::judge(what, measures, GOAL);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_give_the_same_end() {
        let ours = [
            emitted(&slider_crank::Turns::default(), Dop853, (END, EXACT)),
            emitted(&four_bar::Turns::default(), Dop853, (END, EXACT)),
        ];
        for (which, ours) in [Bars::Slider, Bars::FourBar].into_iter().zip(ours) {
            let hand = by_hand(which, EXACT);
            assert!(freedom::error(&ours, hand.end) < 1e-9, "{hand:?} {ours:?}");
        }
    }
}
