//! The checks find mistakes: each is shown one.

mod scaling;

use super::{energy, fact, jacobian};
use crate::registry::{Bind, Mechanism, SceneEntry, bind};
use assur_solvers::problem::{Equations, Phase, Refused, Reports, Scene, Smooth, Span};
use assur_solvers::scalar::Scalar;
use assur_solvers::shape::Shape;
use assur_solvers::shape::{At, Expectation, Quantity, Subject};

/// An oscillator of unit frequency whose spring hardens; with a mistake in its Jacobian or a leak in its energy.
#[derive(Clone, Default)]
struct Oscillator<const MISTAKE: u8>;

const RIGHT: u8 = 0;
const WRONG_SLOPE: u8 = 1;
const LOSS: u8 = 2;

struct Prepared<const MISTAKE: u8>;

impl<S: Scalar, const MISTAKE: u8> Equations<S> for Prepared<MISTAKE> {
    fn states(&self) -> usize {
        2
    }

    fn rates(&self, _phase: Phase<'_, S>, _instant: &[S], state: &[S], rates: &mut [S]) {
        let (x, v) = (state[0], state[1]);
        let loss = S::from_f64(if MISTAKE == LOSS { 1e-6 } else { 0.0 });
        rates.copy_from_slice(&[v, -x - x * x * x - loss * v]);
    }

    fn variation(
        &self,
        phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        let mut slopes = [S::ZERO; 4];
        self.rates(phase, instant, state, rates);
        self.jacobian(phase, instant, state, &mut slopes);
        let states = slopes.len().isqrt();
        for (place, product) in products.iter_mut().enumerate() {
            let (row, column) = (place % states, place / states);
            let terms =
                (0..states).map(|j| slopes[j * states + row] * columns[column * states + j]);
            *product = terms.fold(S::ZERO, |sum, term| sum + term);
        }
    }

    fn jacobian(&self, _phase: Phase<'_, S>, _instant: &[S], state: &[S], columns: &mut [S]) {
        let factor = S::from_f64(if MISTAKE == WRONG_SLOPE { 2.0 } else { 3.0 });
        let loss = S::from_f64(if MISTAKE == LOSS { 1e-6 } else { 0.0 });
        let stiffness = -S::ONE - factor * state[0] * state[0];
        columns.copy_from_slice(&[S::ZERO, stiffness, S::ONE, -loss]);
    }
}

impl<S: Scalar, const MISTAKE: u8> Reports<S> for Prepared<MISTAKE> {
    fn drivers(&self, time: S, values: &mut [S]) {
        values[0] = time + time;
    }

    fn energy(&self, _phase: Phase<'_, S>, _time: S, state: &[S]) -> Option<(S, S)> {
        let (x, v) = (state[0], state[1]);
        let part = S::from_f64;
        let potential = x * x * part(0.5) + x * x * x * x * part(0.25);
        Some((v * v * part(0.5), potential))
    }
}

impl<const MISTAKE: u8> Smooth for Oscillator<MISTAKE> {}

impl<const MISTAKE: u8> Scene for Oscillator<MISTAKE> {
    type Equations<S: Scalar> = Prepared<MISTAKE>;

    type Unreduced = Self;
    const SMOOTH: bool = true;

    fn shape(&self) -> &'static Shape {
        &FREE_SHAPE
    }

    fn prepare<S: Scalar>(&self) -> Prepared<MISTAKE> {
        Prepared
    }
    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }
    fn span(&self) -> Span {
        Span::Run(0.0, 5.0)
    }
    fn start(&self) -> Vec<f64> {
        vec![1.0, 0.0]
    }
}

const LENGTH: Quantity =
    Quantity { name: "x", summary: "", unit: "mm", factor: 1e-3, dimension: [(0, 1); 7] };

const SPEED: Quantity = Quantity { name: "dot(x)", ..LENGTH };

const FREE_SHAPE: Shape =
    Shape::named("free").drivers(&[LENGTH]).states(&[LENGTH, SPEED], &[1.0, 1.0]);

const FREE: SceneEntry = SceneEntry {
    shape: &FREE_SHAPE,
    bind: Bind::Motion(&|_| bind(Oscillator::<RIGHT>)),
    unreduced: None,
};

const OSCILLATOR: Mechanism = Mechanism {
    name: "oscillator",
    title: "",
    summary: "",
    source: "",
    file: "oscillator.eqn",
    text: "",
    effects: &[],
    choices: &[],
    presets: &[],
    parts: &[],
    scenes: &[FREE],
};

/// Checks that `x` has this value, in metres.
fn fact_about(at: At, value: f64) -> Result<(), super::Failed> {
    let expected = Expectation::new(7, Subject::State(0), at, value, 1e-9);
    let expectations = Box::leak(Box::new([expected]));
    let shape = Box::leak(Box::new(FREE_SHAPE.expectations(expectations)));
    let scenes = Box::leak(Box::new([SceneEntry { shape, ..FREE }]));
    let mechanism = Mechanism { scenes, ..OSCILLATOR };
    fact(&mechanism, "free", 0)
}

#[test]
fn a_wrong_slope_is_found() {
    assert_eq!(jacobian(&Oscillator::<RIGHT>), Ok(()));
    let failed = jacobian(&Oscillator::<WRONG_SLOPE>).unwrap_err().0;
    assert!(failed.starts_with("Jacobian, rate of dot(x) with respect to x"), "{failed}");
}

#[test]
fn a_leak_of_energy_is_found() {
    assert_eq!(energy(&Oscillator::<RIGHT>), Ok(()));
    let failed = energy(&Oscillator::<LOSS>).unwrap_err().0;
    assert!(failed.contains("the energy has changed by -"), "{failed}");
}

#[test]
fn facts_have_their_places() {
    for place in [At::Time(0.0), At::Driver(0, 0.0), At::Maximum, At::Amplitude] {
        assert_eq!(fact_about(place, 1.0), Ok(()), "{place:?}");
    }
    assert_eq!(fact_about(At::Minimum, -1.0), Ok(()));
}

#[test]
fn a_driver_has_a_position_when_it_is_there() {
    let run = bind(Oscillator::<RIGHT>).expect("it has no values");
    assert_eq!(run.time_of(0, 3.0), Ok(1.5));
    assert_eq!(run.time_of(0, 11.0), Err((0.0, 10.0)));
    let nowhere = run.time_of(1, 3.0).expect_err("there is one driver");
    assert!(nowhere.0.is_nan() && nowhere.1.is_nan());
}

#[test]
fn a_fact_that_does_not_hold_is_named() {
    let failed = fact_about(At::Maximum, 0.75).unwrap_err().0;
    assert!(
        failed.starts_with("x at Maximum: computed 1000 mm, published 750 mm ± 0.000001 mm, deviation 250 mm (oscillator.eqn:7)"),
        "{failed}"
    );
    let failed = fact_about(At::Time(6.0), 1.0).unwrap_err().0;
    assert_eq!(failed, "the motion does not get to Time(6.0)");
}
