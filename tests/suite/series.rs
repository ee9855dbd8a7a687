//! The method of Taylor series beside the method of Dormand and Prince: two ways from the same equations.

use crate::solved::bind;
use assur::answer::{Method, Settings, Solve};
use assur::hybrid::{self, HybridError};
use assur::ode::{self, OdeError, Statistics};
use assur::problem::Scene;
use assur_equations::REGISTRY;

/// Every scene that moves ends where the other method ends, with the same events on the way.
#[test]
fn every_scene_moves_as_with_the_other_method() {
    let mut compared = 0;
    for mechanism in REGISTRY {
        for scene in mechanism.scenes.iter().filter(|scene| !scene.states.is_empty()) {
            let name = format!("{} {}", mechanism.name, scene.name);
            let run = bind(scene, &[]).expect("its values are good");
            // What comes to a dead point goes on with all positions as coordinates.
            let (scene, run) = match (scene.unreduced, run.unreduced()) {
                (Some(scene), Some(run)) => (scene, run),
                _ => (scene, run),
            };
            let times = match run.span() {
                // Where closures depend on each other for an instant there is no room for so many digits: up to there.
                assur::problem::Span::Run(from, _) if name.starts_with("four_bar_") => (from, 0.5),
                assur::problem::Span::Run(from, to) => (from, to),
                assur::problem::Span::Periodic(period) => (0.0, 0.1 * period),
                assur::problem::Span::Autonomous => (0.0, 0.5),
                assur::problem::Span::Rest => continue,
                other => panic!("{name}: {other:?}"),
            };
            let by = |method, rtol| {
                let settings = Settings::new(method).rtol(rtol);
                run.follow(times, &run.start(), &settings)
            };
            // At 1e-12 the other method is itself off by 4e-8 where a foot without damping bounces.
            let (one, other) = match (by(Method::Dop853, 1e-14), by(Method::Taylor, 1e-12)) {
                (Ok(one), Ok(other)) => (one, other),
                // What closes several loops is too long for a series, and says so.
                (
                    Ok(_),
                    Err(HybridError::Ode { error: OdeError::BadOption { reason, .. }, .. }),
                ) if reason.contains("too long") => {
                    continue;
                }
                (one, other) => panic!("{name}: {:?} {:?}", one.err(), other.err()),
            };
            compared += 1;
            assert_eq!(one.events.len(), other.events.len(), "{name}");
            let ends = one.end.iter().zip(&other.end).zip(scene.states);
            for ((one, other), state) in ends {
                let off = (one - other).abs();
                assert!(
                    off <= 1e-9 * (one.abs() + state.factor),
                    "{name}: {} ends at {one:e} or {other:e}",
                    state.name
                );
            }
        }
    }
    assert!(compared > 50, "{compared}");
}

mod functions {
    assur::mechanism! {
        /// Rates that call every function.
        Functions from "made up";
        parameter c = 0.3;
        state a: 1 = 0.2;
        state b: 1 = 0.5;
        state d: 1 = 0.1;
        state e: 1 = 0.7;
        let turn = 2[1/s]*time;
        let slow = 0.3[1/s];
        motion first: dot(a) = (sin(turn) + cos(b)*a - tan(a) + asin(a/2) + acos(b/3)/4 - atan(d)) / (1 + a^2) * slow;
        motion second: dot(b) = (atan2(a + 1, b) - sinh(d)/3 + cosh(a)/4 - tanh(b) + hypot(a, c) - b) * slow;
        motion third: dot(d) = (exp(-a) - ln(1 + b^2) + log10(2 + d^2) - sqrt(1 + d^2) + (1 + a^2)^0.7 - 2^b/3) * slow;
        motion fourth: dot(e) = (erf(d) - normal_cdf(a) + abs(b - 4) - max(a, -3)*min(b, 5)/9 + c*sin(e)) * slow;
        output a, b, d, e;
        scene go { run time 0 s .. 2 s; }
    }
}

#[test]
fn all_functions_have_their_series() {
    let go = functions::Go::default();
    let start = [0.2, 0.5, 0.1, 0.7];
    let by = |method, rtol| {
        let settings = Settings::new(method).rtol(rtol);
        hybrid::march(&go, (0.0, 2.0), &start, &settings).expect("it goes on")
    };
    let exact = by(Method::Dop853, 1e-14);
    for rtol in [1e-6, 1e-9, 1e-13] {
        let motion = by(Method::Taylor, rtol);
        for (one, other) in exact.end.iter().zip(&motion.end) {
            let off = (one - other).abs();
            assert!(off < 20.0 * rtol, "{rtol:e}: {one} {other}");
        }
    }
}

mod chain {
    assur::mechanism! {
        /// A double pendulum: the masses depend on where it is.
        Chain from "made up";
        parameter g = 9.81 [m/s^2];
        coordinate p: rad = 2;
        coordinate q: rad = 1;
        kinetic 1[kg*m^2]*dot(p)^2 + 0.5[kg*m^2]*dot(q)^2 + 1[kg*m^2]*dot(p)*dot(q)*cos(p - q);
        potential -2[kg*m]*g*cos(p) - 1[kg*m]*g*cos(q);
        output p, q;
        scene go { run time 0 s .. 3 s; }
    }
}

#[test]
fn masses_that_move_have_their_series() {
    let go = chain::Go::default();
    let by = |method| {
        let settings = Settings::new(method).rtol(1e-12);
        ode::march(&go, (0.0, 3.0), &[2.0, 1.0, 0.0, 0.0], &settings).expect("it swings")
    };
    let (one, other) = (by(Method::Dop853), by(Method::Taylor));
    for time in [0.5, 1.7, 3.0] {
        for (one, other) in one.at(time).iter().zip(other.at(time)) {
            assert!((one - other).abs() < 1e-9, "{time}: {one} {other}");
        }
    }
    let steps = [one, other].map(|motion| motion.statistics.steps);
    assert!(2 * steps[1] < steps[0], "{steps:?}");
}

#[test]
fn tolerances_that_make_no_sense_are_refused() {
    let go = chain::Go::default();
    for rtol in [0.0, -1.0, 1e-40, 1e40, f64::INFINITY, f64::NAN] {
        let method = Method::Taylor;
        let settings = Settings::new(method).rtol(rtol);
        let ended = ode::march(&go, (0.0, 3.0), &[2.0, 1.0, 0.0, 0.0], &settings);
        let message = ended.expect_err("no such tolerance").to_string();
        assert!(message.contains("rtol"), "{rtol}: {message}");
    }
}

mod rubbing {
    assur::mechanism! {
        /// A body that is pushed to and fro, and rubs: its series does not feel that the friction turns round with the speed.
        Rubbing from "made up";
        parameter c = 1.9, F = 0.05, v_s = 1e-4;
        state v: 1 = 1;
        let turn = 1[1/s]*time;
        motion push: dot(v) = -(sin(turn) + F*tanh((v - 1 + c)/v_s))*1[1/s];
        output v;
        scene go { run time 0 s .. 20 s; }
    }
}

/// The ends of a step say nothing of a friction that has turned round and back within it: by its ends alone the series for
/// `c = 1.9` came out wrong by 0.08 at `rtol` 1e-9 and 1e-12.
#[test]
fn what_turns_round_within_a_step_is_felt() {
    for c in [1.2, 1.5, 1.8, 1.85, 1.9, 1.95, 1.98] {
        let go = rubbing::Go { c, ..rubbing::Go::default() };
        let by = |method, rtol| {
            let settings = Settings::new(method).rtol(rtol);
            let motion = hybrid::march(&go, (0.0, 20.0), &[1.0], &settings).expect("it goes on");
            (motion.end[0], motion.statistics.steps)
        };
        let (exact, _) = by(Method::Dop853, 1e-13);
        for rtol in [1e-6, 1e-9, 1e-12] {
            let (own, steps) = by(Method::Taylor, rtol);
            assert!(
                (own - exact).abs() < 10.0 * rtol + 1e-10,
                "{c} {rtol:e}: {own} {exact}, {steps} steps"
            );
        }
    }
}

mod relaxation {
    assur::mechanism! {
        /// An oscillator that goes to and fro between two states, at once.
        VanDerPol from "Hairer, Wanner: Solving ordinary differential equations II, (IV.10.3)";
        parameter T = 1 s, epsilon = 1e-6;
        state x: 1 = 2, v: 1 = 0;
        motion T*dot(x) = v;
        motion epsilon*T*dot(v) = (1 - x^2)*v - x;
        output x, v;
        scene relaxation "a good period" { run time 0 s .. 2 s; }
    }
}

mod fourth {
    assur::mechanism! {
        /// What grows by a power of a sine of whose changes the terms tell.
        Fourth from "made up";
        state v: 1 = 0;
        let turn = 1[1/s]*time;
        motion push: dot(v) = sin(turn + 0.1)^4*1[1/s];
        output v;
        scene go { run time 0 s .. 20 s; }
    }
}

mod fortieth {
    assur::mechanism! {
        /// What grows by a power of a sine that is next to nothing for most of a turn.
        Fortieth from "made up";
        state v: 1 = 0;
        let turn = 1[1/s]*time;
        motion push: dot(v) = sin(turn + 0.1)^40*1[1/s];
        output v;
        scene go { run time 0 s .. 20 s; }
    }
}

/// Where the terms tell all, steps are looked at at their ends alone, and lose nothing by it; where they do not, also in between.
#[test]
fn steps_are_looked_at_where_the_terms_may_not_tell() {
    fn check(go: &impl Scene, power: i32, looks: usize) {
        let rate = |time: f64| (time + 0.1).sin().powi(power);
        // By Simpson's rule, to rounding.
        let parts = 20_000;
        let h = 20.0 / f64::from(parts);
        let sum: f64 = (0..parts)
            .map(|k| {
                let from = f64::from(k) * h;
                rate(from) + 4.0 * rate(from + h / 2.0) + rate(from + h)
            })
            .sum();
        let exact = sum * h / 6.0;
        for rtol in [1e-4, 1e-6, 1e-9, 1e-12] {
            let settings = Settings::new(Method::Taylor).rtol(rtol);
            let motion = hybrid::march(go, (0.0, 20.0), &[0.0], &settings).expect("it goes on");
            let Statistics { steps, rejected, evaluations, .. } = motion.statistics;
            assert!(
                (motion.end[0] - exact).abs() < 1e2 * rtol,
                "{power} {rtol:e}: {:?}",
                motion.end
            );
            assert_eq!(evaluations, (steps + rejected) * looks + steps, "{power} {rtol:e}");
        }
    }
    check(&fourth::Go::default(), 4, 1);
    check(&fortieth::Go::default(), 40, 4);
}

/// Currents that build up in a motor: what `auto` chooses takes less than a tenth of the steps of the explicit method, and is accurate
/// between them too, where polynomials of several methods stand in one motion.
#[test]
fn the_series_is_chosen_where_it_goes_further() {
    let scene = assur_equations::table_drive::Transient::default();
    let by = |method, rtol| scene.solve(&Settings::new(method).rtol(rtol)).expect("a motion");
    let (exact, auto) = (by(Method::Taylor, 1e-14), by(Method::Auto, 1e-10));
    let explicit = by(Method::Dop853, 1e-10);
    assert_eq!(auto.switches().first().map(|one| one.to), Some(Method::Taylor));
    let [ours, naive] = [&auto, &explicit].map(|motion| motion.statistics().steps);
    assert!(10 * ours < naive, "{ours} {naive}");
    for part in 0..500 {
        let time = 0.1 * (f64::from(part) + 0.37) / 500.0;
        for (own, known) in auto.at(time).state.iter().zip(exact.at(time).state) {
            assert!((own - known).abs() <= 1e-10 * (1.0 + known.abs()), "{time}: {own} {known}");
        }
    }
}

/// Where something is far too stiff for it, the series alone does not get through in 20 000 steps, and `auto` changes to Radau, however
/// little its steps cost.
#[test]
fn the_series_is_left_where_stability_holds_it_back() {
    let scene = relaxation::Relaxation::default();
    for rtol in [1e-5, 1e-8, 1e-11] {
        let by = |method| {
            let settings = Settings { max_steps: Some(20_000), ..Settings::new(method).rtol(rtol) };
            scene.solve(&settings)
        };
        assert!(by(Method::Taylor).is_err());
        let auto = by(Method::Auto).expect("a motion");
        assert!(auto.switches().iter().any(|one| one.to == Method::Radau), "{rtol:e}");
        // The published end.
        let off = (auto.at(2.0).state[0] - 1.706_167_732_170_483).abs();
        assert!(off < 100.0 * rtol + 1e-11, "{rtol:e} {off:e}");
        assert!(auto.statistics().steps < 6_000, "{rtol:e} {:?}", auto.statistics());
    }
}
