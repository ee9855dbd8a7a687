//! The method of Taylor series against closed forms, and where there are no series.

use super::Taylor;
use crate::model::hand::Hand;
use crate::model::{Flow, Model};
use crate::ode::{AbsoluteTolerance, OdeError, Options, Recorder, Trajectory};
use std::f64::consts::TAU;

/// Options with one tolerance.
fn tolerance(tolerance: f64) -> Options {
    Options { rtol: tolerance, atol: AbsoluteTolerance::Same(tolerance), ..Options::default() }
}

/// A free oscillator of this frequency.
fn oscillator(frequency: f64) -> impl Model {
    let rates = move |_, [place, speed]: [f64; 2]| [speed, -frequency * frequency * place];
    Hand::without_jacobian(rates).expanded(move |_, length, rows| {
        let (rows, _) = rows.as_chunks_mut::<2>();
        for k in 1..rows.len() {
            let factor = length / k as f64;
            let [place, speed] = rows[k - 1];
            rows[k] = [factor * speed, -factor * frequency * frequency * place];
        }
        true
    })
}

/// `y' = y²`, which is infinite after `1/y`.
fn pole() -> impl Model {
    Hand::without_jacobian(|_, [y]| [y * y]).expanded(|_, length, rows| {
        for k in 1..rows.len() {
            let product: f64 = (0..k).map(|j| rows[j] * rows[k - 1 - j]).sum();
            rows[k] = length * product / k as f64;
        }
        true
    })
}

/// A rate that jumps from 1 to 3 after a second. A series feels the side alone on which it begins.
fn jump() -> impl Model {
    let rate = |time: f64| if time < 1.0 { 1.0 } else { 3.0 };
    Hand::without_jacobian(move |time, [_]| [rate(time)]).expanded(move |time, length, rows| {
        rows[1..].fill(0.0);
        rows[1] = length * rate(time);
        true
    })
}

/// `y' = √(-t)`
fn root() -> impl Model {
    Hand::without_jacobian(|time, [_]| [(-time).sqrt()]).expanded(|time, length, rows| {
        rows[1..].fill((-time).sqrt() * length);
        true
    })
}

/// The motion from a start by its Taylor series.
fn march(
    model: &dyn Model,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
) -> Result<Trajectory, OdeError> {
    let mut taylor = Taylor::new(start.len(), options.rtol);
    let mut recorder = Recorder::new(times.0, start);
    let flow = Flow::new(model, 0);
    let statistics = taylor.integrate(&flow, times, start, options, &mut recorder)?;
    Ok(recorder.finish(statistics))
}

#[test]
fn an_oscillator_is_followed_over_many_periods_and_back() {
    for rtol in [1e-6, 1e-10, 1e-14] {
        let end = 1000.0 * TAU;
        let there = march(&oscillator(1.0), (0.0, end), &[1.0, 0.0], &tolerance(rtol)).unwrap();
        let back = march(&oscillator(1.0), (end, 0.0), there.end(), &tolerance(rtol)).unwrap();
        let limit = 4e3 * rtol + 2e-12;
        assert!((there.end()[0] - 1.0).abs() < limit, "{:?}", there.end());
        assert!((back.end()[0] - 1.0).abs() < 2.0 * limit && back.end()[1].abs() < 2.0 * limit);
        assert!(there.statistics.steps < 6000, "{:?}", there.statistics);
    }
}

#[test]
fn the_continuous_solution_is_as_accurate_as_the_steps() {
    let motion = march(&oscillator(1.0), (0.0, 20.0), &[0.0, 1.0], &tolerance(1e-12)).unwrap();
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
    let near = march(&pole(), (0.0, 0.999), &[1.0], &tolerance(1e-10)).unwrap();
    assert!((near.end()[0] / 1000.0 - 1.0).abs() < 1e-6, "{:?}", near.end());
    match march(&pole(), (0.0, 2.0), &[1.0], &tolerance(1e-10)) {
        Err(OdeError::StepTooSmall { time, .. } | OdeError::NotFinite { time, .. }) => {
            assert!((time - 1.0).abs() < 1e-9, "{time}");
        }
        other => panic!("{other:?}"),
    }
}

/// The terms alone would go on with the old rate, to 2: the rates at the end of the step tell.
#[test]
fn a_jump_that_the_series_does_not_feel_is_seen() {
    let motion = march(&jump(), (0.0, 2.0), &[0.0], &tolerance(1e-9)).unwrap();
    assert!((motion.end()[0] - 4.0).abs() < 1e-7, "{:?}", motion.end());
    assert!(motion.statistics.rejected > 0);
}

#[test]
fn rates_that_are_no_numbers_are_reported_with_their_time() {
    let ended = march(&root(), (-1.0, 1.0), &[0.0], &tolerance(1e-6));
    match ended {
        Err(OdeError::NotFinite { time, component }) => {
            assert!(component == 0 && (-1.0..=0.0).contains(&time), "{time}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn options_are_kept() {
    let check = |options: &Options| march(&oscillator(1.0), (0.0, 10.0), &[1.0, 0.0], options);
    let short = Options { max_step: Some(0.05), ..tolerance(1e-9) };
    assert!(check(&short).unwrap().statistics.largest_step <= 0.0505 + 1e-15);
    let fixed = Options { fixed_step: Some(0.1), ..tolerance(1e-9) };
    let motion = check(&fixed).unwrap();
    assert_eq!((motion.statistics.steps, motion.statistics.rejected), (100, 0));
    assert!((motion.end()[0] - 10f64.cos()).abs() < 1e-12);
    let few = Options { max_steps: 3, ..tolerance(1e-9) };
    assert!(matches!(check(&few), Err(OdeError::TooManySteps { steps: 3, .. })));
    let wrong = Options { rtol: f64::NAN, ..tolerance(1e-9) };
    assert!(matches!(check(&wrong), Err(OdeError::BadOption { name: "rtol", .. })));
    let still = march(&oscillator(1.0), (3.0, 3.0), &[1.0, 0.5], &tolerance(1e-9)).unwrap();
    assert_eq!(still.at(3.0), [1.0, 0.5]);
}

/// On the whole time the terms would be larger than any number.
#[test]
fn terms_too_large_for_numbers_are_based_on_a_shorter_length() {
    let fast = oscillator(1e12);
    let options = Options { max_steps: 50, ..tolerance(1e-9) };
    match march(&fast, (0.0, 1e9), &[1.0, 0.0], &options) {
        Err(OdeError::TooManySteps { time, steps: 50 }) => assert!(time < 1e-9, "{time}"),
        other => panic!("{other:?}"),
    }
}
