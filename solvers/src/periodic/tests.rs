//! Tests of the periodic solver against closed forms and known facts.

use super::{Orbit, PeriodicError, solve};
use crate::problem::{Equations, Refused, Scene, Span};
use crate::registry::{Method, Settings};
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// `x'' + 2 d x' + (w² + m cos t) x + c x³ = f cos t` in state `x` and `x'`.
#[derive(Clone, Copy)]
struct Oscillator<const LINEAR: bool> {
    damping: f64,
    frequency: f64,
    modulation: f64,
    cubic: f64,
    force: f64,
    start: f64,
}

impl<const LINEAR: bool> Oscillator<LINEAR> {
    const FORCED: Self = Self {
        damping: 0.05,
        frequency: 1.7,
        modulation: 0.0,
        cubic: 0.0,
        force: 2.0,
        start: 0.0,
    };
}

impl<const LINEAR: bool> Scene for Oscillator<LINEAR> {
    type Equations<S: Scalar> = Self;
    const LINEAR: bool = LINEAR;
    const STATES: usize = 2;
    const OUTPUTS: usize = 0;
    const DRIVERS: usize = 0;
    const SCALES: &'static [f64] = &[1e-3, 1.0];
    const STATE_NAMES: &'static [&'static str] = &["x", "dot(x)"];
    const OUTPUT_NAMES: &'static [&'static str] = &[];

    fn prepare<S: Scalar>(&self) -> Self {
        *self
    }

    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }

    fn span(&self) -> Span {
        Span::Periodic(TAU)
    }

    fn start(&self) -> Vec<f64> {
        vec![self.start, 0.0]
    }
}

impl<S: Scalar, const LINEAR: bool> Equations<S> for Oscillator<LINEAR> {
    type State = [S; 2];
    type Instant = S;

    fn states(&self) -> usize {
        2
    }

    fn instant(&self, time: S) -> S {
        S::from_f64(time.to_f64().cos())
    }

    fn instants<const K: usize>(&self, times: [S; K]) -> [S; K] {
        times.map(|time| S::from_f64(time.to_f64().cos()))
    }

    fn derivative(&self, cosine: &S, state: &[S; 2], rate: &mut [S; 2]) {
        self.variation(cosine, state, rate, &[], &mut []);
    }

    fn variation(
        &self,
        cosine: &S,
        state: &[S; 2],
        rate: &mut [S; 2],
        columns: &[[S; 2]],
        products: &mut [[S; 2]],
    ) {
        let n = S::from_f64;
        let stiffness = n(self.frequency * self.frequency) + n(self.modulation) * *cosine;
        let square = n(self.cubic) * state[0] * state[0];
        let damping = n(2.0 * self.damping);
        rate[0] = state[1];
        rate[1] = n(self.force) * *cosine - damping * state[1] - (stiffness + square) * state[0];
        for (column, product) in columns.iter().zip(products) {
            product[0] = column[1];
            product[1] = -(damping * column[1]) - (stiffness + n(3.0) * square) * column[0];
        }
    }

    fn jacobian(&self, _cosine: &S, _state: &[S; 2], _columns: &mut [[S; 2]]) {}

    fn outputs(&self, _time: S, _state: &[S; 2], _values: &mut [S]) {}

    fn drivers(&self, _time: S, _values: &mut [S]) {}
}

const SETTINGS: Settings = Settings {
    method: Method::Dop853,
    rtol: 1e-12,
};

/// Largest error of an orbit against the closed form of the damped linear oscillator.
fn error<const LINEAR: bool>(scene: &Oscillator<LINEAR>, orbit: &Orbit) -> f64 {
    let (a, b) = (scene.frequency * scene.frequency - 1.0, 2.0 * scene.damping);
    let (even, odd) = (
        scene.force * a / (a * a + b * b),
        scene.force * b / (a * a + b * b),
    );
    let times = (0..=200).map(|number| f64::from(number) * TAU / 100.0);
    times
        .map(|time| (orbit.at(time)[0] - even * time.cos() - odd * time.sin()).abs())
        .fold(0.0, f64::max)
}

#[test]
fn a_forced_oscillator_has_its_closed_form() {
    let scene = Oscillator::<true>::FORCED;
    let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
    let found = error(&scene, &orbit);
    assert!(found < 3e-12, "{found:e}");
    assert!(
        found < 10.0 * orbit.estimated_error[0] + 1e-13,
        "{found:e} {:?}",
        orbit.estimated_error
    );
    assert!(
        orbit.residual < 1e-9 && orbit.condition < 1e5,
        "{} {}",
        orbit.residual,
        orbit.condition
    );
    assert_eq!(orbit.iterations, 2);
    // Product of the multipliers and determinant from the free motion.
    let decay = (-TAU * scene.damping).exp();
    let angle = TAU * (scene.frequency.powi(2) - scene.damping.powi(2)).sqrt();
    assert!((orbit.multipliers[0].modulus() - decay).abs() < 1e-11);
    assert!((orbit.determinant - (1.0 - 2.0 * decay * angle.cos() + decay * decay)).abs() < 1e-10);
}

#[test]
fn tsit5_finds_the_same_within_its_tolerance() {
    let scene = Oscillator::<true>::FORCED;
    let orbit = solve(
        &scene,
        TAU,
        &Settings {
            method: Method::Tsit5,
            rtol: 1e-8,
        },
    )
    .unwrap();
    let found = error(&scene, &orbit);
    assert!(
        found < 1e-6 && found < 3.0 * orbit.estimated_error[0],
        "{found:e} {:?}",
        orbit.estimated_error
    );
}

#[test]
fn methods_without_variations_are_refused_and_the_choice_is_an_explicit_one() {
    let scene = Oscillator::<true>::FORCED;
    let solved = |method| {
        solve(
            &scene,
            TAU,
            &Settings {
                method,
                rtol: 1e-10,
            },
        )
    };
    for method in [Method::Radau, Method::Rosenbrock, Method::Taylor] {
        let message = solved(method).unwrap_err().to_string();
        assert!(
            message.contains("which dop853 and tsit5 integrate"),
            "{message}"
        );
    }
    let orbit = solved(Method::Auto).unwrap();
    assert!(error(&scene, &orbit) < 1e-8);
}

#[test]
fn shooting_agrees_with_superposition() {
    let scene = Oscillator::<true>::FORCED;
    let orbit = solve(
        &Oscillator::<false>::FORCED,
        TAU,
        &Settings {
            method: Method::Dop853,
            rtol: 1e-12,
        },
    )
    .unwrap();
    assert!(error(&scene, &orbit) < 3e-12, "{:e}", error(&scene, &orbit));
    assert!(orbit.iterations <= 6, "{}", orbit.iterations);
}

#[test]
fn a_resonance_is_reported() {
    for frequency in [1.0, 1.0 + 1e-12] {
        let scene = Oscillator::<true> {
            damping: 0.0,
            frequency,
            ..Oscillator::FORCED
        };
        match solve(&scene, TAU, &SETTINGS) {
            Err(PeriodicError::Resonance {
                distance,
                condition,
                ..
            }) => {
                assert!(
                    distance < 1e-9 && condition > 1e9,
                    "{distance:e} {condition:e}"
                );
            }
            other => panic!("{other:?}"),
        }
    }
    // Over a long time the integration knows the free motion less well than its tolerance says.
    let scene = Oscillator::<true> {
        damping: 0.0,
        frequency: 1.0,
        ..Oscillator::FORCED
    };
    let long = solve(
        &scene,
        200.0 * TAU,
        &Settings {
            method: Method::Dop853,
            rtol: 1e-8,
        },
    );
    assert!(matches!(long, Err(PeriodicError::Resonance { .. })));
    assert!(long.unwrap_err().to_string().starts_with("resonance"));
}

#[test]
fn a_free_motion_that_nothing_drives_is_left_out() {
    // Force at the frequency 1, free motion at the frequency 3: both repeat, and neither sees the other.
    let scene = Oscillator::<true> {
        damping: 0.0,
        frequency: 3.0,
        ..Oscillator::FORCED
    };
    let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
    assert!(orbit.condition > 1e9, "{:e}", orbit.condition);
    assert!(orbit.residual < 1e-7);
    // The solution with the least start: here the forced motion less its own free part.
    assert!((orbit.at(TAU)[0] - orbit.start[0]).abs() < 1e-10);
}

#[test]
fn near_a_resonance_the_motion_is_large_but_found() {
    let scene = Oscillator::<true> {
        damping: 0.0,
        frequency: 1.0 + 1e-4,
        ..Oscillator::FORCED
    };
    let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
    let amplitude = scene.force / (scene.frequency.powi(2) - 1.0);
    assert!(
        error(&scene, &orbit) < 1e-6 * amplitude,
        "{:e}",
        error(&scene, &orbit) / amplitude
    );
}

#[test]
fn multipliers_of_the_mathieu_equation_multiply_to_one() {
    for (frequency, modulation) in [(0.7, 0.2), (0.5, 0.3), (1.3, 0.9)] {
        let scene = Oscillator::<true> {
            damping: 0.0,
            frequency,
            modulation,
            cubic: 0.0,
            force: 0.0,
            start: 0.0,
        };
        let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
        let [first, second] = [orbit.multipliers[0], orbit.multipliers[1]];
        let (re, im) = (
            first.re * second.re - first.im * second.im,
            first.re * second.im + first.im * second.re,
        );
        assert!((re - 1.0).abs() < 1e-11 && im.abs() < 1e-11, "{re} {im}");
        assert!(orbit.start.iter().all(|value| *value == 0.0));
        // At half the frequency of the modulation the rest position is unstable.
        assert_eq!(first.modulus() > 1.1, frequency == 0.5);
    }
}

#[test]
fn a_duffing_oscillator_is_found_by_shooting() {
    for frequency in [1.0, 1.7] {
        let scene = Oscillator::<false> {
            damping: 0.1,
            frequency,
            modulation: 0.0,
            cubic: 0.8,
            force: 1.5,
            start: 0.0,
        };
        let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
        assert!(orbit.residual < 1e-7, "{:e}", orbit.residual);
        // Harmonic balance of the energy: the work of the force is that of the damping.
        let (mut work, mut loss) = (0.0, 0.0);
        for number in 0..2000 {
            let time = f64::from(number) * TAU / 2000.0;
            let speed = orbit.at(time)[1];
            work += scene.force * time.cos() * speed;
            loss += 2.0 * scene.damping * speed * speed;
        }
        assert!((work / loss - 1.0).abs() < 1e-9, "{work} {loss}");
        let decay = (-2.0 * scene.damping * TAU).exp();
        let [first, second] = [orbit.multipliers[0], orbit.multipliers[1]];
        assert!((first.re * second.re - first.im * second.im - decay).abs() < 1e-9);
    }
}

#[test]
fn an_undamped_duffing_oscillator_is_found_at_its_linear_resonance() {
    let scene = Oscillator::<false> {
        damping: 0.0,
        frequency: 1.0,
        modulation: 0.0,
        cubic: 0.8,
        force: 0.3,
        start: 0.7,
    };
    let orbit = solve(
        &scene,
        TAU,
        &Settings {
            method: Method::Dop853,
            rtol: 1e-10,
        },
    )
    .unwrap();
    assert!(orbit.residual < 1e-5, "{:e}", orbit.residual);
    assert!(
        (orbit.start[0] - 0.79).abs() < 0.05 && orbit.start[1].abs() < 1e-6,
        "{:?}",
        orbit.start
    );
}

#[test]
fn a_search_that_fails_says_so() {
    // From rest, Newton's method stays near a motion that almost repeats.
    let scene = Oscillator::<false> {
        damping: 0.0,
        frequency: 1.0,
        modulation: 0.0,
        cubic: 0.8,
        force: 0.3,
        start: 0.0,
    };
    match solve(
        &scene,
        TAU,
        &Settings {
            method: Method::Dop853,
            rtol: 1e-10,
        },
    ) {
        Err(PeriodicError::NotConverged { residual, .. }) => {
            assert!(residual > 1e-4, "{residual:e}")
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn periods_and_tolerances_are_checked() {
    let scene = Oscillator::<true>::FORCED;
    for period in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            solve(&scene, period, &SETTINGS),
            Err(PeriodicError::BadPeriod { .. })
        ));
    }
    let settings = Settings {
        method: Method::Tsit5,
        rtol: 0.0,
    };
    assert!(matches!(
        solve(&scene, TAU, &settings),
        Err(PeriodicError::Ode(_))
    ));
}
