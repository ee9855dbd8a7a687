//! What accuracy costs, against closed forms.

use assur::prelude::*;
use assur::shape::Subject;
use assur::study::cost::{Look, cost};
use std::sync::Arc;

mod swing {
    assur::mechanism! {
        /// A mass on a spring.
        Swing from "any textbook";
        parameter m = 1 kg, c = 4 [N/m];
        coordinate x: m = 1 m;
        kinetic m*dot(x)^2/2;
        potential c*x^2/2;
        output x;
        measure last_x = value(x, end);
        scene free { run time 0 s .. 10 s; }
    }
}

/// The errors that are told are those of the closed form, `cos 2t`.
#[test]
fn errors_are_those_of_the_closed_form() {
    let scene = swing::Free::default();
    let model: Arc<dyn Model> = Arc::new(Bound::new(&scene));
    let methods = [Method::Dop853, Method::Tsit5, Method::Radau];
    let settings: Vec<Settings> = { methods.iter() }
        .flat_map(|method| [1e-4, 1e-7].map(|rtol| Settings::new(*method).rtol(rtol)))
        .collect();
    let look = Look { settings: &settings, subjects: &[Subject::State(0)], seconds: 0.0 };
    let heard = std::cell::Cell::new(0);
    let found = cost(&model, &look, &|| {
        heard.set(heard.get() + 1);
        true
    });
    let found = found.expect("a reference");
    assert!(heard.get() >= settings.len());
    assert!(found.doubt.0[0] < 1e-12 && (found.sizes.0[0] - 1.0).abs() < 1e-4, "{:?}", found.doubt);
    for trial in &found.trials {
        let work = trial.outcome.as_ref().expect("a motion");
        let motion = scene.solve(&trial.settings).expect("a motion");
        let off = |part: usize| {
            let time = 10.0 * part as f64 / 240.0;
            (motion.at_exactly(time).state[0] - (2.0 * time).cos()).abs()
        };
        let expected = (0..=240).map(off).fold(0.0, f64::max);
        assert!((work.errors[0] - expected).abs() < 1e-11, "{:?} {expected}", trial);
        let end = (motion.measure("last_x").expect("an end") - 20f64.cos()).abs();
        assert!((work.measures[0] - end).abs() < 1e-11, "{:?} {end}", trial);
        assert!(
            work.times.quartiles.0 <= work.times.median
                && work.times.median <= work.times.quartiles.1
        );
    }
    // Of each method the smaller tolerance costs more and errs less.
    for pair in found.trials.chunks(2) {
        let [loose, tight] = [0, 1].map(|at| pair[at].outcome.as_ref().expect("a motion"));
        assert!(tight.errors[0] < 0.1 * loose.errors[0] && tight.evaluations > loose.evaluations);
    }
    let front = found.front(|work| work.errors[0]);
    let of = |at: &usize| found.trials[*at].outcome.as_ref().expect("a motion");
    assert!(front.windows(2).all(|pair| {
        let [a, b] = [of(&pair[0]), of(&pair[1])];
        a.times.median <= b.times.median && a.errors[0] > b.errors[0]
    }));
}

/// What stops is told, and what may go on goes on.
#[test]
fn a_task_that_fails_at_a_tolerance_is_told() {
    let model: Arc<dyn Model> = Arc::new(Bound::new(&swing::Free::default()));
    let few = Settings { max_steps: Some(10), ..Settings::new(Method::Dop853).rtol(1e-9) };
    let settings = [few, Settings::new(Method::Tsit5).rtol(1e-6)];
    let look = Look { settings: &settings, subjects: &[Subject::Output(0)], seconds: 0.0 };
    let found = cost(&model, &look, &|| true).expect("a reference");
    assert!(found.trials[0].outcome.as_ref().is_err_and(|reason| reason.contains("steps")));
    assert!(found.trials[1].outcome.is_ok());
    // Interrupted after the first: that is all there is.
    let found = cost(&model, &look, &|| false).expect("a reference");
    assert_eq!(found.trials.len(), 1);
}
