//! The method of Taylor series against closed forms, and where there are no series.

use super::super::march::march_by_series as march;
use super::super::{Expand, OdeError, Options};
use super::tolerance;
use std::f64::consts::TAU;

/// A free oscillator of this frequency.
struct Oscillator(f64);

impl Expand for Oscillator {
    fn rate(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        rate[0] = state[1];
        rate[1] = -self.0 * self.0 * state[0];
    }

    fn series(&self, _time: f64, length: f64, rows: &mut [f64]) -> bool {
        let (rows, _) = rows.as_chunks_mut::<2>();
        for k in 1..rows.len() {
            let factor = length / k as f64;
            let [place, speed] = rows[k - 1];
            rows[k] = [factor * speed, -factor * self.0 * self.0 * place];
        }
        true
    }
}

/// `y' = y²`, which is infinite after `1/y`.
struct Pole;

impl Expand for Pole {
    fn rate(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        rate[0] = state[0] * state[0];
    }

    fn series(&self, _time: f64, length: f64, rows: &mut [f64]) -> bool {
        for k in 1..rows.len() {
            let product: f64 = (0..k).map(|j| rows[j] * rows[k - 1 - j]).sum();
            rows[k] = length * product / k as f64;
        }
        true
    }
}

/// A rate that jumps from 1 to 3 after a second.
struct Jump;

impl Jump {
    fn at(time: f64) -> f64 {
        if time < 1.0 { 1.0 } else { 3.0 }
    }
}

impl Expand for Jump {
    fn rate(&self, time: f64, _state: &[f64], rate: &mut [f64]) {
        rate[0] = Self::at(time);
    }

    /// A series feels the side alone on which it begins.
    fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool {
        rows[1..].fill(0.0);
        rows[1] = length * Self::at(time);
        true
    }
}

/// `y' = √(-t)`
struct Root;

impl Expand for Root {
    fn rate(&self, time: f64, _state: &[f64], rate: &mut [f64]) {
        rate[0] = (-time).sqrt();
    }

    fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool {
        rows[1..].fill((-time).sqrt() * length);
        true
    }
}

#[test]
fn an_oscillator_is_followed_over_many_periods_and_back() {
    for rtol in [1e-6, 1e-10, 1e-14] {
        let end = 1000.0 * TAU;
        let there = march(&Oscillator(1.0), (0.0, end), &[1.0, 0.0], &tolerance(rtol)).unwrap();
        let back = march(&Oscillator(1.0), (end, 0.0), there.end(), &tolerance(rtol)).unwrap();
        let limit = 4e3 * rtol + 2e-12;
        assert!((there.end()[0] - 1.0).abs() < limit, "{:?}", there.end());
        assert!((back.end()[0] - 1.0).abs() < 2.0 * limit && back.end()[1].abs() < 2.0 * limit);
        assert!(there.statistics.steps < 6000, "{:?}", there.statistics);
    }
}

#[test]
fn the_continuous_solution_is_as_accurate_as_the_steps() {
    let motion = march(
        &Oscillator(1.0),
        (0.0, 20.0),
        &[0.0, 1.0],
        &tolerance(1e-12),
    )
    .unwrap();
    for number in 0..=1000 {
        let time = 0.02 * f64::from(number);
        let (state, rate) = (motion.at(time), motion.derivative_at(time));
        assert!((state[0] - time.sin()).abs() < 1e-11, "{time} {state:?}");
        assert!((rate[0] - time.cos()).abs() < 1e-10, "{time} {rate:?}");
    }
}

/// The last terms grow without end towards the pole, and the steps shrink with them.
#[test]
fn a_pole_is_approached_and_not_passed() {
    let near = march(&Pole, (0.0, 0.999), &[1.0], &tolerance(1e-10)).unwrap();
    assert!(
        (near.end()[0] / 1000.0 - 1.0).abs() < 1e-6,
        "{:?}",
        near.end()
    );
    match march(&Pole, (0.0, 2.0), &[1.0], &tolerance(1e-10)) {
        Err(OdeError::StepTooSmall { time, .. } | OdeError::NotFinite { time, .. }) => {
            assert!((time - 1.0).abs() < 1e-9, "{time}");
        }
        other => panic!("{other:?}"),
    }
}

/// The terms alone would go on with the old rate, to 2: the rates at the end of the step tell.
#[test]
fn a_jump_that_the_series_does_not_feel_is_seen() {
    let motion = march(&Jump, (0.0, 2.0), &[0.0], &tolerance(1e-9)).unwrap();
    assert!((motion.end()[0] - 4.0).abs() < 1e-7, "{:?}", motion.end());
    assert!(motion.statistics.rejected > 0);
}

#[test]
fn rates_that_are_no_numbers_are_reported_with_their_time() {
    let ended = march(&Root, (-1.0, 1.0), &[0.0], &tolerance(1e-6));
    match ended {
        Err(OdeError::NotFinite { time, component }) => {
            assert!(component == 0 && (-1.0..=0.0).contains(&time), "{time}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn options_are_kept() {
    let check = |options: &Options| march(&Oscillator(1.0), (0.0, 10.0), &[1.0, 0.0], options);
    let short = Options {
        max_step: Some(0.05),
        ..tolerance(1e-9)
    };
    assert!(check(&short).unwrap().statistics.largest_step <= 0.0505 + 1e-15);
    let fixed = Options {
        fixed_step: Some(0.1),
        ..tolerance(1e-9)
    };
    let motion = check(&fixed).unwrap();
    assert_eq!(
        (motion.statistics.steps, motion.statistics.rejected),
        (100, 0)
    );
    assert!((motion.end()[0] - 10f64.cos()).abs() < 1e-12);
    let few = Options {
        max_steps: 3,
        ..tolerance(1e-9)
    };
    assert!(matches!(
        check(&few),
        Err(OdeError::TooManySteps { steps: 3, .. })
    ));
    let wrong = Options {
        rtol: f64::NAN,
        ..tolerance(1e-9)
    };
    assert!(matches!(
        check(&wrong),
        Err(OdeError::BadOption { name: "rtol", .. })
    ));
    let still = march(&Oscillator(1.0), (3.0, 3.0), &[1.0, 0.5], &tolerance(1e-9)).unwrap();
    assert_eq!(still.at(3.0), [1.0, 0.5]);
}

/// On the whole time the terms would be larger than any number.
#[test]
fn terms_too_large_for_numbers_are_based_on_a_shorter_length() {
    let fast = Oscillator(1e12);
    let options = Options {
        max_steps: 50,
        ..tolerance(1e-9)
    };
    match march(&fast, (0.0, 1e9), &[1.0, 0.0], &options) {
        Err(OdeError::TooManySteps { time, steps: 50 }) => assert!(time < 1e-9, "{time}"),
        other => panic!("{other:?}"),
    }
}
