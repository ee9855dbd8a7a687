//! A step of an explicit method: all its stages, on numbers of any kind, in one function.
//!
//! This is what is hot, and it is compiled for each scene ([`Bound`](crate::model::Bound)); around it all is compiled once.

use super::combine::combine;
use super::tableau::{Explicit, Row, Tableau};
use crate::problem::Staged;
use crate::scalar::Real;

/// No method has more stages, or times of stages, than this.
const MOST: usize = 16;

/// The memory of a step, on plain numbers.
#[derive(Clone, Debug)]
pub struct Room {
    /// Time at the begin of the step.
    pub(crate) time: f64,
    /// Its length.
    pub(crate) step: f64,
    /// State at its begin.
    pub(crate) state: Vec<f64>,
    /// State at its end.
    pub(crate) trial: Vec<f64>,
    /// State of an inner stage.
    pub(crate) stage: Vec<f64>,
    /// The error estimate.
    pub(crate) error: Vec<f64>,
    /// The second error estimate.
    pub(crate) second: Vec<f64>,
    /// The slopes, one behind the other.
    pub(crate) slopes: Vec<f64>,
    /// The coefficients of the continuous solution, one behind the other.
    pub(crate) polynomial: Vec<f64>,
    /// What depends on the time alone, for each stage.
    instants: Vec<f64>,
    /// Whether the step was tried one evaluation after the other, of which the instants are the times.
    pub(crate) is_apart: bool,
}

impl Room {
    /// Room for states of a length.
    pub(super) fn new(method: &Tableau, length: usize) -> Self {
        let zeros = || vec![0.0; length];
        Self {
            time: 0.0,
            step: 0.0,
            state: zeros(),
            trial: zeros(),
            stage: zeros(),
            error: zeros(),
            second: zeros(),
            slopes: vec![0.0; method.slopes() * length],
            polynomial: vec![0.0; method.degree() * length],
            instants: Vec::new(),
            is_apart: false,
        }
    }

    /// Keeps the time at the end where that is all that is kept of an instant.
    pub(super) fn keep_end(&mut self, method: &Tableau) {
        self.grow(1);
        self.instants[method.stages - 2] = self.time + self.step;
    }

    /// Makes room for what depends on the time alone, so many numbers an instant.
    #[inline(always)]
    fn grow(&mut self, instant: usize) {
        if self.instants.len() < MOST * instant {
            self.instants.resize(MOST * instant, 0.0);
        }
    }
}

/// A method as a type, so that its coefficients are constants where steps are compiled.
pub(crate) trait Coefficients {
    const TABLEAU: &'static Tableau;
}

/// [`Explicit::Tsit5`].
pub(crate) struct Tsit5;

impl Coefficients for Tsit5 {
    const TABLEAU: &'static Tableau = Explicit::Tsit5.tableau();
}

/// [`Explicit::Dop853`].
pub(crate) struct Dop853;

impl Coefficients for Dop853 {
    const TABLEAU: &'static Tableau = Explicit::Dop853.tableau();
}

/// The row for the state of a stage; none beyond the last.
const fn row(method: &Tableau, stage: usize) -> Row {
    if stage < method.stages { method.rows[stage - 1] } else { &[] }
}

/// Evaluates the stages of a step, the state at its end and the error estimates.
///
/// With `WRITTEN` each stage is written out, with its coefficients as constants: 17 % less time, and more to compile.
#[inline(always)]
pub(crate) fn attempt<S: Real, C: Coefficients, E: Staged<S> + ?Sized, const WRITTEN: bool>(
    staged: &mut E,
    room: &mut Room,
) {
    let (length, width) = (staged.length(), staged.instant());
    let method = const { C::TABLEAU };
    room.grow(width);
    let (time, step) = (S::from_f64(room.time), S::from_f64(room.step));
    let state = &S::of(&room.state)[..length];
    let stage = &mut S::of_mut(&mut room.stage)[..length];
    let slopes = &mut S::of_mut(&mut room.slopes)[..method.slopes() * length];
    let instants = &mut S::of_mut(&mut room.instants)[..MOST * width];
    let mut times = [time; MOST];
    for (target, node) in times.iter_mut().zip(method.nodes) {
        *target = S::from_f64(*node).mul_add(step, time);
    }
    let count = method.nodes.len();
    staged.instants(&times[..count], &mut instants[..count * width]);
    if WRITTEN {
        macro_rules! stages {
            ($($number:literal)*) => {$(
                if $number < C::TABLEAU.stages {
                    combine(stage, Some(state), step, const { row(C::TABLEAU, $number) }, slopes);
                    staged.rates(
                        &instants[($number - 1) * width..][..width],
                        stage,
                        &mut slopes[$number * length..][..length],
                    );
                }
            )*};
        }
        stages!(1 2 3 4 5 6 7 8 9 10 11);
    } else {
        for (number, row) in method.rows.iter().enumerate() {
            combine(stage, Some(state), step, row, slopes);
            let instant = &instants[number * width..][..width];
            staged.rates(instant, stage, &mut slopes[(number + 1) * length..][..length]);
        }
    }
    let trial = &mut S::of_mut(&mut room.trial)[..length];
    combine(trial, Some(state), step, method.weights, slopes);
    if method.error_uses_last {
        let last = &instants[(method.stages - 2) * width..][..width];
        staged.rates(last, trial, &mut slopes[method.stages * length..][..length]);
    }
    let error = &mut S::of_mut(&mut room.error)[..length];
    combine(error, None, step, method.error, slopes);
    if !method.second_error.is_empty() {
        let second = &mut S::of_mut(&mut room.second)[..length];
        combine(second, None, step, method.second_error, slopes);
    }
}

/// Evaluates what is still missing of a step that is accepted: the slope at its end and, if asked for, the stages and the
/// coefficients of the continuous solution.
#[inline(always)]
pub(crate) fn finish<S: Real, C: Coefficients, E: Staged<S> + ?Sized>(
    staged: &mut E,
    room: &mut Room,
    dense: bool,
) {
    let (length, width) = (staged.length(), staged.instant());
    let method = const { C::TABLEAU };
    let (time, step) = (S::from_f64(room.time), S::from_f64(room.step));
    let state = &S::of(&room.state)[..length];
    let trial = &S::of(&room.trial)[..length];
    let stage = &mut S::of_mut(&mut room.stage)[..length];
    let slopes = &mut S::of_mut(&mut room.slopes)[..method.slopes() * length];
    let instants = &mut S::of_mut(&mut room.instants)[..MOST * width];
    if !method.error_uses_last {
        // The last inner stage lies at the end of the step too.
        let last = &instants[(method.stages - 2) * width..][..width];
        staged.rates(last, trial, &mut slopes[method.stages * length..][..length]);
    }
    if !dense {
        return;
    }
    let mut times = [time; MOST];
    for (target, node) in times.iter_mut().zip(method.extra_nodes) {
        *target = S::from_f64(*node).mul_add(step, time);
    }
    let count = method.extra_nodes.len();
    staged.instants(&times[..count], &mut instants[..count * width]);
    for (number, row) in method.extra_rows.iter().enumerate() {
        combine(stage, Some(state), step, row, slopes);
        let (instant, slope) = (number * width, (method.stages + 1 + number) * length);
        staged.rates(&instants[instant..][..width], stage, &mut slopes[slope..][..length]);
    }
    let polynomial = &mut S::of_mut(&mut room.polynomial)[..method.degree() * length];
    for index in 0..length {
        let change = trial[index] - state[index];
        let begin = step * slopes[index] - change;
        let end = change - step * slopes[method.stages * length + index];
        polynomial[index] = change;
        polynomial[length + index] = begin;
        polynomial[2 * length + index] = end - begin;
    }
    for (number, row) in method.dense_rows.iter().enumerate() {
        let target = &mut polynomial[(3 + number) * length..][..length];
        combine(target, None, step, row, slopes);
    }
}
