//! Masses on springs that are ever stiffer, beside the explicit method.

use super::{Hand, Implicit, STIFF, march, tolerances};
use crate::model::{Flow, Model};
use crate::ode::{self, Explicit, Trajectory};

/// A mass of 1 kg that a spring `c` and a damper `1e-3 c` s tie to a support, which moves by `sin t`; the state is its
/// position and speed. Without inertia it follows its support.
fn tied(c: f64) -> impl Model {
    let rates = move |time: f64, [place, speed]: [f64; 2]| {
        let (sine, cosine) = time.sin_cos();
        let force = c * (sine - place) + 1e-3 * c * (cosine - speed);
        [speed, force]
    };
    Hand::new(rates, move |_, _| [[0.0, 1.0], [-c, -1e-3 * c]])
}

fn stiffly(c: f64, method: Implicit) -> Trajectory {
    let options = tolerances(1e-6, 1e-6);
    march(&tied(c), method, (0.0, 10.0), [0.0, 1.0], &options).unwrap()
}

/// Evaluations that the explicit method needs; none if so many steps are not enough.
fn explicitly(c: f64, max_steps: usize) -> Option<usize> {
    let tied = tied(c);
    let flow = Flow::new(&tied, 0);
    let mut workspace = ode::Workspace::new(Explicit::Dop853, &flow);
    let options = ode::Options { max_steps, ..tolerances(1e-6, 1e-6) };
    let done = ode::integrate(&flow, (0.0, 10.0), &[0.0, 1.0], &options, &mut workspace, &mut ());
    done.ok().map(|statistics| statistics.evaluations)
}

#[test]
fn a_spring_may_be_as_stiff_as_it_likes() {
    for c in [1e3, 1e5, 1e7, 1e9] {
        let naive = explicitly(c, 20_000);
        for method in STIFF.into_iter().chain([Implicit::Automatic]) {
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
