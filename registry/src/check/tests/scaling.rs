//! A scene with a hidden number that has a unit.

use super::*;
use crate::check::{Failed, scaling};
use assur_solvers::shape::Shape;
use assur_solvers::shape::{Constant, Distribution};

/// A mass on a spring, pushed by what `HIDDEN` says.
#[derive(Clone)]
struct Spring<const HIDDEN: u8> {
    mass: f64,
    stiffness: f64,
    root: f64,
}

/// A constant acceleration, `root^2`, whose dimension has fractions.
const NOTHING: u8 = 0;
/// The same and 1e-9 m/s².
const ACCELERATION: u8 = 1;
/// The same and 1 N: in g mm/ms² it is 1 as well.
const FORCE: u8 = 2;

impl<const HIDDEN: u8> Spring<HIDDEN> {
    fn from_values(&[mass, stiffness, root]: &[f64; 3]) -> Self {
        Self { mass, stiffness, root }
    }
}

/// A spring on a scalar type.
struct Prepared<S, const HIDDEN: u8>([S; 3]);

impl<S: Scalar, const HIDDEN: u8> Equations<S> for Prepared<S, HIDDEN> {
    fn states(&self) -> usize {
        2
    }

    fn rates(&self, _phase: Phase<'_, S>, _instant: &[S], state: &[S], rates: &mut [S]) {
        let [mass, stiffness, root] = self.0;
        let hidden = match HIDDEN {
            ACCELERATION => S::from_f64(1e-9),
            FORCE => S::ONE / mass,
            _ => S::ZERO,
        };
        rates[0] = state[1];
        rates[1] = root * root + hidden - stiffness / mass * state[0];
    }

    fn variation(&self, _: Phase<'_, S>, _: &[S], _: &[S], _: &mut [S], _: &[S], _: &mut [S]) {}

    fn jacobian(&self, _: Phase<'_, S>, _: &[S], _: &[S], _: &mut [S]) {}
}

impl<S: Scalar, const HIDDEN: u8> Reports<S> for Prepared<S, HIDDEN> {
    fn outputs(&self, _phase: Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
        values[0] = self.0[0] * state[1];
        values[1] = state[0] / time;
    }

    fn drivers(&self, time: S, values: &mut [S]) {
        values[0] = time;
    }
}

impl<const HIDDEN: u8> Scene for Spring<HIDDEN> {
    type Equations<S: Scalar> = Prepared<S, HIDDEN>;

    type Unreduced = Self;
    const SMOOTH: bool = true;

    fn shape(&self) -> &'static Shape {
        const NAMES: &[Quantity] = &[quantity("x", SPEED), quantity("dot(x)", SPEED)];
        const OUTPUTS: &[Quantity] = &[quantity("momentum", SPEED), quantity("mean", SPEED)];
        const {
            &Shape::named("spring")
                .drivers(&[LENGTH])
                .states(NAMES, &[1e-3, 1e-3])
                .outputs(OUTPUTS)
                .linear()
        }
    }

    fn prepare<S: Scalar>(&self) -> Self::Equations<S> {
        Prepared([self.mass, self.stiffness, self.root].map(S::from_f64))
    }
    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }
    fn span(&self) -> Span {
        Span::Run(0.0, 5.0)
    }
    fn start(&self) -> Vec<f64> {
        vec![0.1, 0.0]
    }
}

/// A quantity with exponents of m, kg and s.
const fn quantity(name: &'static str, [length, mass, time]: [(i8, i8); 3]) -> Quantity {
    Quantity { name, dimension: [length, mass, time, (0, 1), (0, 1), (0, 1), (0, 1)], ..LENGTH }
}

const SPEED: [(i8, i8); 3] = [(1, 1), (0, 1), (-1, 1)];

/// Checks a spring whose stiffness has a unit with these exponents.
fn check<const HIDDEN: u8>(stiffness: [(i8, i8); 3]) -> Result<(), Failed> {
    let constant = |name, exponents, default| Constant {
        quantity: quantity(name, exponents),
        is_dimension: false,
        default,
        tolerance: 0.0,
        distribution: Distribution::Normal,
        range: (0.0, 10.0),
    };
    let constants = Box::leak(Box::new([
        constant("mass", [(0, 1), (1, 1), (0, 1)], 0.3),
        constant("stiffness", stiffness, 7.0),
        constant("root", [(1, 2), (0, 1), (-1, 1)], 1.7),
    ]));
    let [length, speed, momentum, mean, time] = [
        quantity("x", [(1, 1), (0, 1), (0, 1)]),
        quantity("dot(x)", SPEED),
        quantity("momentum", [(1, 1), (1, 1), (-1, 1)]),
        quantity("mean", SPEED),
        quantity("time", [(0, 1), (0, 1), (1, 1)]),
    ];
    let shape = Shape {
        constants,
        drivers: Box::leak(Box::new([time])),
        states: Box::leak(Box::new([length, speed])),
        outputs: Box::leak(Box::new([momentum, mean])),
        ..FREE_SHAPE
    };
    let scenes = Box::leak(Box::new([SceneEntry { shape: Box::leak(Box::new(shape)), ..FREE }]));
    let mechanism = Mechanism { scenes, ..OSCILLATOR };
    scaling(&mechanism, "free", &|values| {
        Some(Spring::<HIDDEN>::from_values(values.try_into().ok()?))
    })
}

const STIFFNESS: [(i8, i8); 3] = [(0, 1), (1, 1), (-2, 1)];

#[test]
fn other_units_give_the_same_motion() {
    assert_eq!(check::<NOTHING>(STIFFNESS), Ok(()));
}

#[test]
fn a_hidden_acceleration_is_found() {
    let failed = check::<ACCELERATION>(STIFFNESS).unwrap_err().0;
    // 1e-9 m/s^2 are 1e-12 mm/ms^2, and 1e-9 remains.
    for part in [
        "rate of dot(x) in mm, g, ms, at time 685 ms, state [",
        " mm/ms^2 as in SI units; off by 9.99",
        "e-10 mm/ms^2, of which rounding explains ",
    ] {
        assert!(failed.contains(part), "no {part:?}: {failed}");
    }
    assert!(failed.contains("e-17 mm/ms^2"), "{failed}");
}

#[test]
fn a_hidden_force_is_found_although_it_is_the_same_in_mm_g_ms() {
    let failed = check::<FORCE>(STIFFNESS).unwrap_err().0;
    assert!(failed.starts_with("rate of dot(x) in cm, g, s, at time 0.685 s"), "{failed}");
}

#[test]
fn a_wrong_unit_in_the_table_is_found() {
    let failed = check::<NOTHING>([(0, 1), (1, 1), (-1, 1)]).unwrap_err().0;
    assert!(failed.starts_with("rate of dot(x) in mm, g, ms"), "{failed}");
}
