//! Tests of the periodic solver against closed forms and known facts.

mod attracted;

use super::{Orbit, PeriodicError, solve};
use crate::problem::{Equations, Phase, Refused, Reports, Scene, Smooth, Span};
use crate::scalar::Scalar;
use crate::settings::{Method, Settings};
use crate::shape::{Quantity, Shape, Unit};
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
    const FORCED: Self =
        Self { damping: 0.05, frequency: 1.7, modulation: 0.0, cubic: 0.0, force: 2.0, start: 0.0 };
}

impl<const LINEAR: bool> Scene for Oscillator<LINEAR> {
    type Equations<S: Scalar> = Self;

    type Unreduced = Self;
    const SMOOTH: bool = true;

    fn shape(&self) -> &'static Shape {
        const STATES: &[Quantity] =
            &[Quantity::new("x", "", Unit::NONE), Quantity::new("dot(x)", "", Unit::NONE)];
        const { &Shape { is_linear: LINEAR, ..Shape::named("oscillator").states(STATES, &[1e-3, 1.0]) } }
    }

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

impl<const LINEAR: bool> Smooth for Oscillator<LINEAR> {}

impl<S: Scalar, const LINEAR: bool> Reports<S> for Oscillator<LINEAR> {}

impl<S: Scalar, const LINEAR: bool> Equations<S> for Oscillator<LINEAR> {
    fn states(&self) -> usize {
        2
    }

    /// The cosine.
    fn instant(&self) -> usize {
        1
    }

    fn instants(&self, _phase: Phase<'_, S>, times: &[S], cosines: &mut [S]) {
        for (cosine, time) in cosines.iter_mut().zip(times) {
            *cosine = S::from_f64(time.to_f64().cos());
        }
    }

    fn rates(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], rates: &mut [S]) {
        self.variation(phase, instant, state, rates, &[], &mut []);
    }

    fn variation(
        &self,
        _phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        let (n, cosine) = (S::from_f64, instant[0]);
        let stiffness = n(self.frequency * self.frequency) + n(self.modulation) * cosine;
        let square = n(self.cubic) * state[0] * state[0];
        let damping = n(2.0 * self.damping);
        rates[0] = state[1];
        rates[1] = n(self.force) * cosine - damping * state[1] - (stiffness + square) * state[0];
        for (column, product) in columns.chunks(2).zip(products.chunks_mut(2)) {
            product[0] = column[1];
            product[1] = -(damping * column[1]) - (stiffness + n(3.0) * square) * column[0];
        }
    }

    fn jacobian(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], columns: &mut [S]) {
        let unit = [S::ONE, S::ZERO, S::ZERO, S::ONE];
        self.variation(phase, instant, state, &mut [S::ZERO; 2], &unit, columns);
    }
}

const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-12);

/// Largest error of an orbit against the closed form of the damped linear oscillator.
fn error<const LINEAR: bool>(scene: &Oscillator<LINEAR>, orbit: &Orbit) -> f64 {
    let (a, b) = (scene.frequency * scene.frequency - 1.0, 2.0 * scene.damping);
    let (even, odd) = (scene.force * a / (a * a + b * b), scene.force * b / (a * a + b * b));
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
    let orbit = solve(&scene, TAU, &Settings::new(Method::Tsit5).rtol(1e-8)).unwrap();
    let found = error(&scene, &orbit);
    assert!(
        found < 1e-6 && found < 3.0 * orbit.estimated_error[0],
        "{found:e} {:?}",
        orbit.estimated_error
    );
}

#[test]
fn every_method_finds_it() {
    let scene = Oscillator::<true>::FORCED;
    for method in [Method::Radau, Method::Rosenbrock, Method::Auto, Method::Taylor] {
        let settings = Settings::new(method).rtol(1e-10);
        match solve(&scene, TAU, &settings) {
            Ok(orbit) => {
                // The automatic choice is the explicit method of order 8 here, the others are of order 5.
                let bound = if method == Method::Auto { 1e-8 } else { 1e-7 };
                assert!(error(&scene, &orbit) < bound, "{method:?}");
            }
            Err(failure) => {
                assert_eq!(method, Method::Taylor);
                let message = failure.to_string();
                assert!(message.contains("too long for their Taylor"), "{message}");
            }
        }
    }
}

#[test]
fn shooting_agrees_with_superposition() {
    let scene = Oscillator::<true>::FORCED;
    let orbit =
        solve(&Oscillator::<false>::FORCED, TAU, &Settings::new(Method::Dop853).rtol(1e-12))
            .unwrap();
    assert!(error(&scene, &orbit) < 3e-12, "{:e}", error(&scene, &orbit));
    assert!(orbit.iterations <= 6, "{}", orbit.iterations);
}

#[test]
fn a_resonance_is_reported() {
    for frequency in [1.0, 1.0 + 1e-12] {
        let scene = Oscillator::<true> { damping: 0.0, frequency, ..Oscillator::FORCED };
        match solve(&scene, TAU, &SETTINGS) {
            Err(PeriodicError::Resonance { distance, condition, .. }) => {
                assert!(distance < 1e-9 && condition > 1e9, "{distance:e} {condition:e}");
            }
            other => panic!("{other:?}"),
        }
    }
    // Over a long time the integration knows the free motion less well than its tolerance says.
    let scene = Oscillator::<true> { damping: 0.0, frequency: 1.0, ..Oscillator::FORCED };
    let long = solve(&scene, 200.0 * TAU, &Settings::new(Method::Dop853).rtol(1e-8));
    assert!(matches!(long, Err(PeriodicError::Resonance { .. })));
    assert!(long.unwrap_err().to_string().starts_with("resonance"));
}

#[test]
fn a_free_motion_that_nothing_drives_is_left_out() {
    // Force at the frequency 1, free motion at the frequency 3: both repeat, and neither sees the other.
    let scene = Oscillator::<true> { damping: 0.0, frequency: 3.0, ..Oscillator::FORCED };
    let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
    assert!(orbit.condition > 1e9, "{:e}", orbit.condition);
    assert!(orbit.residual < 1e-7);
    // The solution with the least start: here the forced motion less its own free part.
    assert!((orbit.at(TAU)[0] - orbit.start[0]).abs() < 1e-10);
}

#[test]
fn near_a_resonance_the_motion_is_large_but_found() {
    let scene = Oscillator::<true> { damping: 0.0, frequency: 1.0 + 1e-4, ..Oscillator::FORCED };
    let orbit = solve(&scene, TAU, &SETTINGS).unwrap();
    let amplitude = scene.force / (scene.frequency.powi(2) - 1.0);
    assert!(error(&scene, &orbit) < 1e-6 * amplitude, "{:e}", error(&scene, &orbit) / amplitude);
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
fn a_double_multiplier_is_known_to_the_square_root_of_the_error() {
    // On the boundary of the first tongue of Mathieu's equation both are −1 (DLMF 28.6.2); within it none.
    let of = |frequency: f64, modulation: f64| {
        let scene = Oscillator::<true> {
            damping: 0.0,
            frequency,
            modulation,
            cubic: 0.0,
            force: 0.0,
            start: 0.0,
        };
        solve(&scene, TAU, &SETTINGS).expect("at rest").multipliers
    };
    let terms = [1.0, 1.0, -1.0 / 8.0, -1.0 / 64.0, -1.0 / 1536.0, 11.0 / 36864.0];
    let more = [49.0 / 589_824.0, 55.0 / 9_437_184.0, -83.0 / 35_389_440.0];
    let boundary = terms.iter().chain(&more).rev().fold(0.0, |sum, term| sum * 0.2 + term);
    for one in of(f64::sqrt(boundary / 4.0), 0.1) {
        let off = (one.re + 1.0).hypot(one.im);
        assert!(off <= 3.0 * one.error + 3e-6, "{one} {off:e} {:e}", one.error);
        assert!(one.error > 1e-8 && one.error < 1e-4, "{:e}", one.error);
    }
    let within = of(0.5, 0.3);
    assert!(within.iter().all(|one| one.error < 1e-9), "{within:?}");
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
    let orbit = solve(&scene, TAU, &Settings::new(Method::Dop853).rtol(1e-10)).unwrap();
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
    match solve(&scene, TAU, &Settings::new(Method::Dop853).rtol(1e-10)) {
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
        assert!(matches!(solve(&scene, period, &SETTINGS), Err(PeriodicError::BadPeriod { .. })));
    }
    let settings = Settings::new(Method::Tsit5).rtol(0.0);
    assert!(matches!(solve(&scene, TAU, &settings), Err(PeriodicError::Ode(_))));
}
