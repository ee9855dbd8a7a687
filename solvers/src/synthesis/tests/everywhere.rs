//! The search of all designs, on functions whose best is known.

use super::super::*;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

/// A function of a design.
struct Problem<F> {
    sought: Vec<Sought>,
    worth: F,
}

impl<F: Fn(&[f64]) -> Score + Sync> Judge for Problem<F> {
    fn sought(&self) -> &[Sought] {
        &self.sought
    }

    fn judge(&self, designs: &[f64], scores: &mut [Score]) {
        for (design, score) in designs.chunks_exact(self.sought.len()).zip(scores) {
            *score = (self.worth)(design);
        }
    }
}

fn best(judge: &dyn Judge, effort: &Effort) -> Found {
    search(judge, effort, None, &mut |_| ControlFlow::Continue(())).expect("it is well posed")
}

fn effort(evaluations: u64) -> Effort {
    Effort { evaluations, threads: 1, ..Effort::default() }
}

/// Rastrigin's function: of 11 valleys along each number the search finds the deepest.
fn rastrigin() -> Problem<impl Fn(&[f64]) -> Score + Sync> {
    let worth = |x: &[f64]| {
        let one = |x: &f64| x * x - 10.0 * (TAU * x).cos() + 10.0;
        Score::kept(x.iter().map(one).sum())
    };
    Problem { sought: vec![Sought::between(-5.12, 5.12); 6], worth }
}

#[test]
fn the_deepest_of_many_valleys() {
    for seed in 1..6 {
        let found = best(&rastrigin(), &Effort { seed, ..effort(60_000) });
        assert!(found.score.value < 1e-9, "{found:?}");
    }
}

/// Problem G06 of Michalewicz: what is feasible is a sliver of 7e-5 of the square.
#[test]
fn conditions_come_first() {
    let worth = |x: &[f64]| {
        let first = (x[0] - 5.0).powi(2) + (x[1] - 5.0).powi(2) - 100.0;
        let second = 82.81 - (x[0] - 6.0).powi(2) - (x[1] - 5.0).powi(2);
        match first.min(second) {
            least if least < 0.0 => Score::missing(-least),
            _ => Score::kept((x[0] - 10.0).powi(3) + (x[1] - 20.0).powi(3)),
        }
    };
    let sought = vec![Sought::between(13.0, 100.0), Sought::between(0.0, 100.0)];
    let found = best(&Problem { sought, worth }, &effort(20_000));
    assert!((found.score.value / -6_961.813_875_58 - 1.0).abs() < 1e-6, "{found:?}");
}

#[test]
fn the_condition_that_cannot_be_kept_is_missed_least() {
    let worth = |x: &[f64]| match x[0] * x[0] + x[1] * x[1] + 0.25 {
        missed if missed > 0.0 => Score::missing(missed),
        _ => Score::kept(0.0),
    };
    let sought = vec![Sought::between(-1.0, 2.0); 2];
    let found = best(&Problem { sought, worth }, &effort(4_000));
    assert!(!found.score.is_kept() && (found.score.missed - 0.25).abs() < 1e-9, "{found:?}");
}

/// The best angle lies where the circle is cut, and what cuts it does not show.
#[test]
fn a_turn_has_no_ends() {
    let worth = |x: &[f64]| Score::kept(2.0 - x[0].cos() - (x[1] - PI).cos());
    let sought = vec![Sought::around(0.0, TAU), Sought::around(-PI, PI)];
    let found = best(&Problem { sought, worth }, &effort(4_000));
    assert!(found.score.value < 1e-12, "{found:?}");
    assert!((0.0..=TAU).contains(&found.design[0]) && (-PI..=PI).contains(&found.design[1]));
}

#[test]
fn threads_and_interruptions_change_nothing() {
    let (problem, whole) = (rastrigin(), effort(20_000));
    let alone = best(&problem, &whole);
    assert_eq!(alone, best(&problem, &Effort { threads: 3, ..whole.clone() }));
    let mut generations = 0;
    let mut until = |_: &Population| {
        generations += 1;
        if generations == 40 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let broken = search(&problem, &whole, None, &mut until).expect("it is well posed");
    assert!(broken.population.evaluations < alone.population.evaluations);
    let rest =
        search(&problem, &whole, Some(broken.population), &mut |_| ControlFlow::Continue(()));
    assert_eq!(alone, rest.expect("it goes on"));
    assert_ne!(alone.design, best(&problem, &Effort { seed: 2, ..whole }).design);
}

#[test]
fn what_is_no_number_is_worst() {
    let worth = |x: &[f64]| Score::kept(if x[0] < 0.3 { f64::NAN } else { x[0] });
    let found = best(&Problem { sought: vec![Sought::between(0.0, 1.0)], worth }, &effort(3_000));
    assert!((found.score.value - 0.3).abs() < 1e-9, "{found:?}");
    assert!(!Score::kept(f64::NAN).is_as_good_as(&Score::missing(7.0)));
}

#[test]
fn wrong_problems_are_refused() {
    let asked = |sought: Vec<Sought>, population, from: Option<Population>| {
        let problem = Problem { sought, worth: |x: &[f64]| Score::kept(x[0]) };
        let effort = Effort { population, ..effort(100) };
        search(&problem, &effort, from, &mut |_| ControlFlow::Continue(()))
    };
    let two = vec![Sought::between(0.0, 1.0); 2];
    assert_eq!(asked(vec![], None, None).unwrap_err(), SynthesisError::Nothing);
    for (low, high) in [(1.0, 0.0), (1.0, 1.0), (0.0, f64::INFINITY), (f64::NAN, 1.0)] {
        let found = asked(vec![Sought::between(low, high)], None, None).unwrap_err();
        assert!(matches!(found, SynthesisError::BadBounds { sought: 0, .. }), "{found}");
    }
    let found = asked(two.clone(), Some(0), None).unwrap_err();
    assert_eq!(found.to_string(), "a population of 0 cannot be crossed; choose at least 4");
    let other = asked(two, None, None).expect("it is well posed").population;
    let found = asked(vec![Sought::between(0.0, 1.0)], None, Some(other)).unwrap_err();
    assert_eq!(found, SynthesisError::OtherProblem { found: 2, expected: 1 });
}
