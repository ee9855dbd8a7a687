//! The method of Taylor series: a step is the series of the motion, cut off.
//!
//! À. Jorba, M. Zou: *A software package for the numerical integration of ODEs by means of high-order Taylor methods*,
//! Experimental Mathematics 14 (2005): the order follows from the tolerance, the length of a step from the last two terms.
//! They say nothing of what the series does not feel, a jump of the rates or a branch that is left. So the rates at the end of
//! the step are compared with those of the series there, whose difference is the derivative of the first term that was left
//! out: that is the error of the step. What changes and changes back meanwhile, as the sign of a friction that a steep `tanh` smooths,
//! is looked for in between, unless the equations are made of what cannot.

use crate::model::Flow;
use crate::ode::{
    Basis, Clock, Doubt, Observer, OdeError, Options, SHORTEST, Statistics, Step, bad, bad_start,
};
use crate::series::TERMS;

/// Part of the length that the last terms permit.
const SAFETY: f64 = 0.9;
/// Smallest part of a step that is tried after it.
const SMALLEST: f64 = 0.1;
/// Largest factor from one step to the next: what is known of one step is to say something of the next.
const LARGEST: f64 = 10.0;
/// Largest part of the whole time that a first step takes.
const FIRST: f64 = 1e-3;
/// What a length is divided by where the terms are too large for numbers.
const SHORTER: f64 = 1e6;
/// Slopes of slopes by which the fastest rate of change is estimated.
const POWERS: usize = 4;
/// Whoever wants to know the stiffness hears of it once in so many steps.
const FELT: usize = 16;
/// Those where something may change and change back: multiples of the golden section, which keep out of step with whatever swings.
const BETWEEN: [f64; 3] = [0.236, 0.472, 0.708];
/// How often a shorter length is tried.
const ATTEMPTS: usize = 60;

/// The order for a tolerance: a third more than the digits asked for, and even.
pub(crate) fn order(rtol: f64) -> usize {
    let digits = -rtol.log10();
    let order = 2.0 * (2.0 + 2.0 / 3.0 * digits).round();
    order.max(8.0).min(TERMS as f64) as usize
}

/// The memory of an integration.
#[derive(Clone, Debug)]
pub(crate) struct Taylor {
    order: usize,
    before: Vec<f64>,
    after: Vec<f64>,
    /// The terms of the series, `1 + order` rows.
    terms: Vec<f64>,
    /// Those of the step, `order` rows.
    polynomial: Vec<f64>,
    /// Derivatives of the polynomial at its end, by the part of the step.
    slopes: Vec<f64>,
    /// Rates there.
    rate: Vec<f64>,
}

impl Taylor {
    /// Room for so many states.
    pub fn new(states: usize, rtol: f64) -> Self {
        let order = order(rtol);
        Self {
            order,
            before: vec![0.0; states],
            after: vec![0.0; states],
            terms: vec![0.0; (1 + order) * states],
            polynomial: vec![0.0; order * states],
            slopes: vec![0.0; states],
            rate: vec![0.0; states],
        }
    }

    /// The state where the last integration ended, or failed.
    pub fn state(&self) -> &[f64] {
        &self.before
    }

    /// The length of the step that the series permits at a state, where about a length would be usual; none where there is
    /// no series.
    pub fn reach(
        &mut self,
        flow: &Flow<'_>,
        (time, usual): (f64, f64),
        state: &[f64],
        options: &Options,
    ) -> Option<f64> {
        self.before.copy_from_slice(state);
        let mut unit = usual;
        self.begin(flow, time, &mut unit).ok()?;
        Some(self.permitted(unit, f64::INFINITY, options))
    }

    /// Integrates from one time to another, forwards or backwards.
    pub fn integrate(
        &mut self,
        flow: &Flow<'_>,
        times: (f64, f64),
        start: &[f64],
        options: &Options,
        observe: &mut dyn Observer,
    ) -> Result<Statistics, OdeError> {
        options.check(times, self.before.len())?;
        if start.len() != self.before.len() {
            return Err(bad_start(start.len(), self.before.len()));
        }
        let strange = start.iter().position(|value| !value.is_finite());
        if let Some(component) = strange {
            return bad("start", format!("state {component} is not a finite number"));
        }
        let mut statistics = Statistics::default();
        self.before.copy_from_slice(start);
        if times.0 == times.1 {
            return Ok(statistics);
        }
        let mut clock = Clock::new(times, options);
        let (span, longest) = (times.1 - times.0, options.max_step.unwrap_or(f64::INFINITY));
        let first = options.fixed_step.or(options.first_step).unwrap_or(span.abs());
        // The length on which the terms are based: any would do, were numbers not limited.
        let mut unit = first.min(span.abs()).copysign(span);
        statistics.evaluations += self.begin(flow, clock.now, &mut unit)?;
        let (is_fixed, between) = (clock.fixed.is_some(), between(flow));
        let mut doubt = Doubt::new(options.max_steps);
        // A step that the time does not feel would lead nowhere.
        let shortest = SHORTEST * f64::EPSILON * times.0.abs().max(times.1.abs());
        let mut wanted = match (options.fixed_step, options.first_step) {
            (Some(_), _) => unit,
            (None, Some(first)) => self.permitted(unit, LARGEST * first.max(shortest), options),
            (None, None) => self.permitted(unit, FIRST * span.abs(), options),
        };
        loop {
            let tried = statistics.steps + statistics.rejected;
            if tried >= options.max_steps {
                return Err(OdeError::TooManySteps { time: clock.now, steps: tried });
            }
            let limited = wanted.abs().min(longest).copysign(span);
            if !is_fixed && clock.is_lost(limited) {
                let component = self.steepest(options);
                return Err(self.failure(clock.now, limited, 0.0, component));
            }
            let to = clock.target(limited, statistics.steps);
            let length = to - clock.now;
            let (error, component) = self.look(flow, ((clock.now, to), between), unit, options);
            statistics.evaluations += 1 + between.len();
            let is_good = error <= 1.0 || is_fixed && error.is_finite();
            if !is_good {
                statistics.rejected += 1;
                let factor = SAFETY * error.powf(-1.0 / (1 + self.order) as f64);
                wanted = length * factor.max(SMALLEST);
                if is_fixed || clock.is_lost(wanted) {
                    return Err(self.failure(clock.now, wanted, error, component));
                }
                continue;
            }
            flow.correct(to, &mut self.after)?;
            observe.step(&Step {
                from: clock.now,
                to,
                before: &self.before,
                after: &self.after,
                polynomial: &self.polynomial,
                basis: Basis::Powers,
            });
            let counted = if is_fixed { 0.0 } else { error };
            statistics.count(length, counted, to == times.1);
            statistics.series_steps += 1;
            clock.now = to;
            std::mem::swap(&mut self.before, &mut self.after);
            if observe.has_enough() || to == times.1 {
                break;
            }
            if statistics.steps % FELT == FELT / 2 && observe.wants_stiffness() {
                observe.stiffness(length, self.fastest_rate(flow, to, options));
                if observe.has_enough() {
                    break;
                }
            }
            if doubt.is_due(statistics.steps) && !is_fixed {
                let rate = self.fastest_rate(flow, to, options);
                doubt.judge((times.1 - to) / length, (to, length, rate))?;
            }
            unit = length;
            statistics.evaluations += self.begin(flow, clock.now, &mut unit)?;
            if !is_fixed {
                wanted = self.permitted(unit, LARGEST * length.abs(), options);
            }
        }
        Ok(statistics)
    }

    /// The series at the begin, on a shorter length if the terms are too large for numbers. Gives how often it was
    /// computed.
    fn begin(&mut self, flow: &Flow<'_>, time: f64, unit: &mut f64) -> Result<usize, OdeError> {
        let states = self.before.len();
        for attempt in 1..=ATTEMPTS {
            self.terms[..states].copy_from_slice(&self.before);
            if !flow.series(time, *unit, &mut self.terms) {
                return bad(
                    "method",
                    "these equations are too long for their Taylor series; take dop853".to_owned(),
                );
            }
            // Zero, unless one is infinite or not a number.
            if self.terms.iter().fold(0.0, |sum, term| sum + 0.0 * term) == 0.0 {
                return Ok(attempt);
            }
            *unit /= SHORTER;
        }
        let strange = self.terms.iter().position(|term| !term.is_finite());
        let component = strange.unwrap_or(0) % states.max(1);
        Err(OdeError::NotFinite { time, component })
    }

    /// About the fastest rate of change that the equations know where the motion stands: by their slopes along its rates,
    /// and along what those give, and so on.
    #[cold]
    pub fn fastest_rate(&mut self, flow: &Flow<'_>, time: f64, options: &Options) -> f64 {
        let Self { before: state, after: shifted, slopes: along, rate: first, .. } = self;
        let weight = |index: usize| options.atol.of(index) + options.rtol * state[index].abs();
        let size = |values: &[f64]| {
            let terms = values.iter().enumerate();
            terms.map(|(index, value)| (value / weight(index)).abs()).fold(0.0, f64::max)
        };
        flow.rates(time, state, first);
        along.copy_from_slice(first);
        let mut fastest = 0.0;
        for _ in 0..POWERS {
            // Far above rounding and far below the state.
            let before = size(along);
            let part = 1.0 / (options.rtol.sqrt() * before).max(f64::MIN_POSITIVE);
            for (index, value) in shifted.iter_mut().enumerate() {
                *value = state[index] + part * along[index];
            }
            flow.rates(time, shifted, along);
            for (value, first) in along.iter_mut().zip(&*first) {
                *value = (*value - first) / part;
            }
            fastest = size(along) / before;
        }
        fastest
    }

    /// The length of a step that the last two terms permit, and a limit.
    #[inline(always)]
    fn permitted(&self, unit: f64, limit: f64, options: &Options) -> f64 {
        let states = self.before.len();
        let mut sizes = [0.0f64; 2];
        let last = self.terms[(self.order - 1) * states..].chunks_exact(states.max(1));
        for (size, terms) in sizes.iter_mut().zip(last) {
            for ((index, term), value) in terms.iter().enumerate().zip(&self.before) {
                let tolerance = options.atol.of(index) + options.rtol * value.abs();
                *size = size.max(term.abs() / tolerance);
            }
        }
        let [other, last] = sizes;
        let factor = SAFETY * root(other, self.order - 1).min(root(last, self.order));
        (unit.abs() * factor).min(limit).copysign(unit)
    }

    /// The error of a step in tolerances, and the state that has it: at its end, where the polynomial is left that leads there, or,
    /// if it is larger, on the way.
    #[inline(always)]
    fn look(
        &mut self,
        flow: &Flow<'_>,
        ((from, to), between): ((f64, f64), &[f64]),
        unit: f64,
        options: &Options,
    ) -> (f64, usize) {
        let mut worst = (0.0, 0);
        for part in between.iter().copied().chain([1.0]) {
            let length = part * (to - from);
            self.cut_off(length / unit);
            flow.rates(if part == 1.0 { to } else { from + length }, &self.after, &mut self.rate);
            let own = self.error(length, options);
            if own.0.is_nan() || own.0 > worst.0 {
                worst = own;
            }
        }
        worst
    }

    /// The polynomial of a step that is so many times as long as what the terms are based on, the state and the slopes at
    /// its end.
    #[inline(always)]
    fn cut_off(&mut self, part: f64) {
        // States of one to three coordinates stay in registers.
        match self.before.len() {
            2 => self.cut_off_known::<2>(part),
            4 => self.cut_off_known::<4>(part),
            6 => self.cut_off_known::<6>(part),
            _ => self.cut_off_any(part),
        }
    }

    #[inline(always)]
    fn cut_off_known<const N: usize>(&mut self, part: f64) {
        let (rows, _) = self.terms.as_chunks::<N>();
        let (polynomial, _) = self.polynomial.as_chunks_mut::<N>();
        let Some((before, rows)) = rows.split_first() else {
            return;
        };
        let (mut after, mut slope) = (*before, [0.0; N]);
        let (mut power, mut count) = (1.0, 1.0);
        for (row, terms) in polynomial.iter_mut().zip(rows) {
            power *= part;
            for index in 0..N {
                let value = power * terms[index];
                row[index] = value;
                after[index] += value;
                slope[index] += count * value;
            }
            count += 1.0;
        }
        self.after.copy_from_slice(&after);
        self.slopes.copy_from_slice(&slope);
    }

    fn cut_off_any(&mut self, part: f64) {
        let states = self.before.len();
        self.after.copy_from_slice(&self.before);
        self.slopes.fill(0.0);
        let (mut power, mut count) = (1.0, 1.0);
        let rows = self.terms.chunks_exact(states.max(1)).skip(1);
        let polynomial = self.polynomial.chunks_exact_mut(states.max(1));
        for (row, terms) in polynomial.zip(rows) {
            power *= part;
            for (index, term) in terms.iter().enumerate() {
                let value = power * term;
                row[index] = value;
                self.after[index] += value;
                self.slopes[index] += count * value;
            }
            count += 1.0;
        }
    }

    /// The error of the step in tolerances, and the state that has it.
    #[inline(always)]
    fn error(&self, length: f64, options: &Options) -> (f64, usize) {
        let (mut error, mut component) = (0.0, 0);
        for (index, rate) in self.rate.iter().enumerate() {
            let (before, after) = (self.before[index], self.after[index]);
            let tolerance = options.atol.of(index) + options.rtol * before.abs().max(after.abs());
            let difference = (self.slopes[index] - length * rate).abs();
            let own = difference / ((1 + self.order) as f64 * tolerance);
            if own.is_nan() {
                return (f64::NAN, index);
            }
            if own > error {
                (error, component) = (own, index);
            }
        }
        (error, component)
    }

    /// The state with the largest last term.
    #[cold]
    fn steepest(&self, options: &Options) -> usize {
        let states = self.before.len();
        let mut largest = (0.0, 0);
        let last = &self.terms[self.order * states..];
        for ((index, term), value) in last.iter().enumerate().zip(&self.before) {
            let size = term.abs() / (options.atol.of(index) + options.rtol * value.abs());
            if size > largest.0 {
                largest = (size, index);
            }
        }
        largest.1
    }

    /// Why no step is short enough.
    #[cold]
    fn failure(&self, time: f64, step: f64, error: f64, component: usize) -> OdeError {
        match error.is_finite() {
            true => OdeError::StepTooSmall { time, step, component },
            false => OdeError::NotFinite { time, component },
        }
    }
}

/// Parts of a step at which it is looked at beside its end.
fn between(flow: &Flow<'_>) -> &'static [f64] {
    match flow.shape().operations.unfelt {
        0 if !flow.is_loose() => &[],
        _ => &BETWEEN,
    }
}

/// `size^(-1/order)` within some percent, from the bits of the number, which are about its logarithm.
#[inline(always)]
fn root(size: f64, order: usize) -> f64 {
    const ONE: i64 = f64::to_bits(1.0) as i64;
    let logarithm = size.to_bits() as i64 - ONE;
    f64::from_bits((ONE - logarithm / order as i64) as u64)
}

#[cfg(test)]
mod tests {
    use super::root;

    #[test]
    fn a_root_is_about_that() {
        for size in [1e-300, 3e-17, 0.2, 1.0, 77.0, 1e200] {
            for order in [7, 16, 31] {
                let (about, exact) = (root(size, order), size.powf(-1.0 / order as f64));
                assert!((about / exact - 1.0).abs() < 0.1, "{size} {order}: {about} {exact}");
            }
        }
        assert!(root(0.0, 16) > 1e19);
    }
}
