//! Masses on springs that are ever stiffer, beside the explicit method.

use super::super::Emitted;
use super::super::march::record;
use super::{Method, STIFF, tolerances};
use crate::ode::{self, Dop853, Plain, Trajectory};
use crate::problem::Equations;

/// A mass of 1 kg that a spring `c` and a damper `1e-3 c` s tie to a support, which moves by `sin t`; the state is its
/// position and speed. Without inertia it follows its support.
#[derive(Clone, Copy)]
struct Tied {
    c: f64,
}

impl Equations<f64> for Tied {
    type State = [f64; 2];
    type Instant = (f64, f64);

    fn states(&self) -> usize {
        2
    }

    fn instant(&self, time: f64) -> (f64, f64) {
        time.sin_cos()
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [(f64, f64); K] {
        times.map(f64::sin_cos)
    }

    fn derivative(&self, (sine, cosine): &(f64, f64), state: &[f64; 2], rate: &mut [f64; 2]) {
        let force = self.c * (sine - state[0]) + 1e-3 * self.c * (cosine - state[1]);
        *rate = [state[1], force];
    }

    fn variation(
        &self,
        instant: &(f64, f64),
        state: &[f64; 2],
        rate: &mut [f64; 2],
        _columns: &[[f64; 2]],
        products: &mut [[f64; 2]],
    ) {
        self.derivative(instant, state, rate);
        products.fill([f64::NAN; 2]);
    }

    fn jacobian(&self, _instant: &(f64, f64), _state: &[f64; 2], columns: &mut [[f64; 2]]) {
        columns.copy_from_slice(&[[0.0, -self.c], [1.0, -1e-3 * self.c]]);
    }

    fn outputs(&self, _time: f64, _state: &[f64; 2], _values: &mut [f64]) {}

    fn drivers(&self, _time: f64, _values: &mut [f64]) {}
}

fn stiffly(c: f64, method: Method) -> Trajectory {
    let options = tolerances(1e-6, 1e-6);
    let tied = Tied { c };
    record(
        &mut Emitted::new(&tied),
        (0.0, 10.0),
        &[0.0, 1.0],
        &options,
        method,
    )
    .unwrap()
}

/// Evaluations that the explicit method needs; none if so many steps are not enough.
fn explicitly(c: f64, max_steps: usize) -> Option<usize> {
    let tied = Tied { c };
    let system = Plain(&tied);
    let mut workspace = ode::Workspace::<_, Dop853>::new::<f64, _>(&system);
    let options = ode::Options {
        max_steps,
        ..tolerances(1e-6, 1e-6)
    };
    let done = ode::integrate(
        &system,
        (0.0, 10.0),
        &[0.0, 1.0],
        &options,
        &mut workspace,
        &mut (),
    );
    done.ok().map(|statistics| statistics.evaluations)
}

#[test]
fn a_spring_may_be_as_stiff_as_it_likes() {
    for c in [1e3, 1e5, 1e7, 1e9] {
        let naive = explicitly(c, 20_000);
        for method in STIFF.into_iter().chain([Method::Automatic]) {
            let motion = stiffly(c, method);
            let took = motion.statistics;
            println!("c = {c:e}: explicit {naive:?}, {method:?} {took:?}");
            // What inertia leaves of the distance to the support is at most 1/c.
            let error = (motion.end()[0] - 10.0_f64.sin()).abs();
            assert!(error < 1.5 / c + 1e-5, "{c:e} {method:?} {error:e}");
            assert!(took.evaluations < 4_000, "{c:e} {method:?} {took:?}");
        }
        match c {
            1e9 => assert_eq!(naive, None, "more than 240 000 evaluations"),
            1e7 => assert!(naive.is_some_and(|evaluations| evaluations > 100_000)),
            _ => assert!(naive.is_some()),
        }
    }
}

/// The steps do not shrink as the spring gets stiffer.
#[test]
fn work_does_not_grow_with_the_stiffness() {
    for method in STIFF {
        let work = [1e5, 1e7, 1e9].map(|c| stiffly(c, method).statistics.evaluations);
        assert!(work[2] < 2 * work[0], "{method:?} {work:?}");
    }
}
