//! What is found of functions of numbers that are no plain `f64`: the algorithms look at values, and are compiled once.

use super::{Bounded, Dual, Interval, Scalar};
use assur_functions::fault::{Why, keep};
use assur_functions::table::derivative;
use assur_functions::{End, Mean, POINTS, Root, Table, highest, mean, root, sign_changes};

/// The value of a function at a place. Outlined, so that it is compiled for the instructions of its numbers.
#[inline(always)]
pub(super) fn value<S: Scalar>(function: &impl Fn(S) -> S, place: f64) -> f64 {
    S::outline(
        #[inline(always)]
        || function(S::from_f64(place)).to_f64(),
    )
}

/// The root of the values of a function; NaN where there is none, which is kept as a fault.
pub(super) fn root_or_fault(what: &str, value: &mut dyn FnMut(f64) -> f64) -> f64 {
    /// Parts in which changes of the sign are looked for.
    const PARTS: usize = 64;
    let found = root(value);
    if !matches!(found, Root::At(_)) {
        keep(what, Why::Root(found, sign_changes(value, PARTS)));
    }
    found.place()
}

/// The mean of the values of a function.
#[inline(always)]
pub(super) fn mean_of_values<S: Scalar>(near: &impl Fn(S) -> S, far: &impl Fn(S) -> S) -> Mean {
    mean(&mut |part, values| {
        S::outline(
            #[inline(always)]
            || {
                for (index, value) in values.iter_mut().enumerate() {
                    *value = match part.point(index) {
                        (End::Near, distance) => near(S::from_f64(distance)).to_f64(),
                        (End::Far, distance) => far(S::from_f64(distance)).to_f64(),
                    };
                }
            },
        );
    })
}

/// The mean of something of the values of a function.
fn mean_of<S>(near: &dyn Fn(f64) -> S, far: &dyn Fn(f64) -> S, of: &dyn Fn(S) -> f64) -> Mean {
    mean(&mut |part, values: &mut [f64; POINTS]| {
        for (index, value) in values.iter_mut().enumerate() {
            *value = of(match part.point(index) {
                (End::Near, distance) => near(distance),
                (End::Far, distance) => far(distance),
            });
        }
    })
}

impl Dual {
    pub(super) fn mean_along(near: &dyn Fn(Self) -> Self, far: &dyn Fn(Self) -> Self) -> Self {
        let (near, far) = (|place| near(Self::constant(place)), |place| far(Self::constant(place)));
        Self {
            value: mean_of(&near, &far, &|dual| dual.value).value,
            slope: mean_of(&near, &far, &|dual| dual.slope).value,
        }
    }

    /// By the implicit function theorem.
    pub(super) fn root_along(function: &dyn Fn(Self) -> Self) -> Self {
        let place = root(&mut |place| function(Self::constant(place)).value).place();
        let fixed = function(Self::constant(place)).slope;
        Self { value: place, slope: -fixed / Self::along(function, place, fixed) }
    }

    /// The slope by the place alone, where the other one is given. Their sum is what is found: so the place moves as far as makes
    /// both alike, and neither is lost beside the other.
    fn along(function: &dyn Fn(Self) -> Self, place: f64, fixed: f64) -> f64 {
        let by =
            |weight: f64| (function(Self { value: place, slope: weight }).slope - fixed) / weight;
        let rough = by(1.0);
        let weight = (fixed / rough).abs();
        if weight > 0.0 && weight.is_finite() { by(weight) } else { rough }
    }

    /// The place does not count where the slope is zero; at an end it stays.
    pub(super) fn highest_along(function: &dyn Fn(Self) -> Self) -> Self {
        let top = highest(&mut |place| function(Self::constant(place)).value);
        Self { value: top.value, slope: function(Self::constant(top.place)).slope }
    }

    /// Where the slope is zero, whose own slopes are differences.
    pub(super) fn highest_place_along(function: &dyn Fn(Self) -> Self) -> Self {
        /// Share of the range, whose fourth power is rounding.
        const STEP: f64 = 1e-4;
        /// What is left of the change of a slope over half a step, if it jumps; else it is a half.
        const JUMPS: f64 = 0.75;
        let place = highest(&mut |place| function(Self::constant(place)).value).place;
        if place <= 0.0 || place >= 1.0 {
            return Self::constant(place);
        }
        let step = STEP.min(0.5 * place).min(0.5 * (1.0 - place));
        let fixed = |place: f64| function(Self::constant(place)).slope;
        let steepness = |place: f64| Self::along(function, place, fixed(place));
        // Differences of fourth order.
        let change = |of: &dyn Fn(f64) -> f64, step: f64| {
            let between = |steps: f64| of(place + steps * step) - of(place - steps * step);
            8.0 * between(1.0) - between(2.0)
        };
        let (across, along) = (change(&fixed, step), change(&steepness, step));
        // At a kink the slope jumps, over whatever step, and the place stays.
        if change(&steepness, 0.5 * step).abs() > JUMPS * along.abs() {
            return Self::constant(place);
        }
        Self { value: place, slope: -across / along }
    }
}

impl Bounded {
    pub(super) fn mean_within(near: &dyn Fn(Self) -> Self, far: &dyn Fn(Self) -> Self) -> Self {
        let (near, far) = (|place| near(Self::exact(place)), |place| far(Self::exact(place)));
        let found = mean_of(&near, &far, &|one| one.value);
        let bound = mean_of(&near, &far, &|one| one.bound);
        // The bound need not be known well, as long as it is not missed.
        let carried = bound.value + if bound.fault.is_some() { f64::INFINITY } else { bound.error };
        Self { value: found.value, bound: found.error + carried }
    }

    pub(super) fn root_within(function: &dyn Fn(Self) -> Self) -> Self {
        let at = |place: f64| function(Self::exact(place));
        let place = root(&mut |place| at(place).value).place();
        let dual = |place: f64, step: f64| {
            (at(place + step).value - at(place - step).value) / (2.0 * step)
        };
        let step = 1e-5 * place.abs().max(1e-3);
        let steepness = dual(place, step).abs();
        Self { value: place, bound: at(place).bound / steepness + 4.0 * f64::EPSILON * place.abs() }
    }

    pub(super) fn highest_within(function: &dyn Fn(Self) -> Self) -> Self {
        let top = highest(&mut |place| function(Self::exact(place)).value);
        function(Self::exact(top.place))
    }

    pub(super) fn highest_place_within(function: &dyn Fn(Self) -> Self) -> Self {
        let top = highest(&mut |place| function(Self::exact(place)).value);
        Self { value: top.place, bound: top.blur }
    }
}

/// Parts of a range that intervals are evaluated on.
const PARTS: usize = 64;

/// The part of the range with a number.
fn part(index: usize, parts: usize, length: f64) -> Interval {
    let end = |index: usize| length * index as f64 / parts as f64;
    Interval::new(end(index), end(index + 1))
}

impl Interval {
    pub(super) fn mean_over(near: &dyn Fn(Self) -> Self, far: &dyn Fn(Self) -> Self) -> Self {
        let share = Self::point(1.0 / PARTS as f64);
        let parts = (0..PARTS / 2).map(|index| part(index, PARTS / 2, 0.5));
        parts.fold(Self::point(0.0), |sum, one| sum + (near(one) + far(one)) * share)
    }

    /// The hull of the parts in which the function may be zero.
    pub(super) fn root_over(function: &dyn Fn(Self) -> Self) -> Self {
        let parts = (0..PARTS).map(|index| part(index, PARTS, 1.0));
        let may_be_zero = |one: &Self| {
            let value = function(*one);
            value.low.is_nan() || value.contains(0.0)
        };
        let hull = parts.filter(may_be_zero).reduce(Self::hull);
        hull.unwrap_or(Self::new(f64::NAN, f64::NAN))
    }

    pub(super) fn highest_over(function: &dyn Fn(Self) -> Self) -> Self {
        let values = (0..PARTS).map(|index| function(part(index, PARTS, 1.0)));
        let above = |a: Self, b: Self| Self::new(a.low.max(b.low), a.high.max(b.high));
        values.reduce(above).unwrap_or(Self::ENTIRE)
    }

    /// The values of a derivative of a sampled curve: on each piece they lie between the factors of its Bernstein form.
    pub(super) fn over_pieces(self, table: &Table<'_>, order: u32) -> Self {
        let (first, last) = table.range();
        let largest = self.magnitude().max(first.abs()).max(last.abs());
        // Rounding of the distance from a knot, whole periods away.
        let slack = 4.0 * f64::EPSILON * largest;
        let piece = |(factors, low, high): ([f64; 4], f64, f64)| {
            let (low, high) = (low - slack, high + slack);
            let [a, b, c, d] = derivative(factors, order).map(Self::point);
            let (t, width) = (Self::point(low), Self::point(high) - Self::point(low));
            let third = |value: Self| value * Self::new(1.0 / 3.0, (1.0_f64 / 3.0).next_up());
            // The powers of the part of the piece that is meant.
            let value = ((d * t + c) * t + b) * t + a;
            let slope = ((Self::point(3.0) * d * t + Self::point(2.0) * c) * t + b) * width;
            let bend = (Self::point(3.0) * d * t + c) * width * width;
            let twist = d * width * width * width;
            let second = value + third(slope);
            let last = second + third(slope) + third(bend);
            let end = value + slope + bend + twist;
            [value, second, last, end].into_iter().reduce(Self::hull).unwrap_or(value)
        };
        let hull = table.parts(self.low, self.high).map(piece).reduce(Self::hull);
        hull.unwrap_or(Self::new(f64::NAN, f64::NAN))
    }

    /// The hull of the parts in which the function may be largest.
    pub(super) fn highest_place_over(function: &dyn Fn(Self) -> Self) -> Self {
        let least = Self::highest_over(function).low;
        let parts = (0..PARTS).map(|index| part(index, PARTS, 1.0));
        let may_be_largest = |one: &Self| {
            let high = function(*one).high;
            high.is_nan() || high >= least
        };
        let hull = parts.filter(may_be_largest).reduce(Self::hull);
        hull.unwrap_or(Self::new(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur_functions::fault;

    /// `∫ exp(a x) dx` over 0..1, `a = 0.7`.
    fn mean<S: Scalar>(a: S) -> S {
        S::mean("", |t| (a * t).exp(), |t| (a * (S::ONE - t)).exp())
    }

    /// `x² = a`.
    fn root<S: Scalar>(a: S) -> S {
        S::root("", |x| x * x - a)
    }

    /// `x (a - x)`, largest at `a/2`.
    fn highest<S: Scalar>(a: S) -> (S, S) {
        (S::highest(|x| x * (a - x)), S::highest_place(|x| x * (a - x)))
    }

    const A: f64 = 0.7;

    fn exact() -> [f64; 4] {
        [A.exp_m1() / A, A.sqrt(), 0.25 * A * A, 0.5 * A]
    }

    fn found<S: Scalar>(a: S) -> [S; 4] {
        let (top, place) = highest(a);
        [mean(a), root(a), top, place]
    }

    #[test]
    fn plain_and_fused_numbers_agree() {
        let fused = crate::dispatch::dispatch(Fused(A));
        for ((plain, fused), exact) in found(A).into_iter().zip(fused).zip(exact()) {
            assert!((plain - exact).abs() < 1e-13 && (fused - plain).abs() < 1e-13);
        }
    }

    /// Finds all of it on fused numbers.
    struct Fused(f64);

    impl crate::dispatch::Task for Fused {
        type Output = [f64; 4];
        fn run<S: Scalar>(self) -> [f64; 4] {
            found(S::from_f64(self.0)).map(S::to_f64)
        }
    }

    #[test]
    fn dual_numbers_have_the_derivatives() {
        let slopes = [A.exp() / A - A.exp_m1() / (A * A), 0.5 / A.sqrt(), 0.5 * A, 0.5];
        for (index, found) in found(Dual::variable(A)).into_iter().enumerate() {
            let (value, slope) = (exact()[index], slopes[index]);
            assert!((found.value - value).abs() < 1e-13, "{index}: {found:?}");
            assert!((found.slope - slope).abs() < 1e-8, "{index}: {found:?}, slope {slope}");
        }
    }

    #[test]
    fn bounds_hold() {
        let a = Bounded { value: A, bound: 1e-6 };
        let moved = found(A + 1e-6);
        for (found, moved) in found(a).into_iter().zip(moved).take(3) {
            // To first order.
            assert!((found.value - moved).abs() <= 1.001 * found.bound, "{found:?}, {moved}");
            assert!(found.bound < 3e-6, "{found:?}");
        }
    }

    #[test]
    fn what_is_not_found_is_kept_with_its_words() {
        fault::take();
        assert!(f64::root("x^2 = -1", |x| x * x + 1.0).is_nan());
        let told = fault::take().map(|fault| fault.to_string()).unwrap_or_default();
        assert!(told.starts_with("`x^2 = -1` has one sign at both ends"), "{told}");
        assert!(f64::mean("1/x", |t| 1.0 / t, |t| 1.0 / (1.0 - t)).is_nan());
        let told = fault::take().map(|fault| fault.to_string()).unwrap_or_default();
        assert!(told.starts_with("`1/x` does not settle"), "{told}");
        assert!(found(A).iter().all(|value| value.is_finite()) && fault::take().is_none());
    }

    #[test]
    fn intervals_enclose() {
        for (found, exact) in found(Interval::new(A, A)).into_iter().zip(exact()) {
            assert!(found.low <= exact && exact <= found.high, "{found:?}, {exact}");
            assert!(found.width() < 0.25, "{found:?}");
        }
    }

    /// A wave over its own length, knots unevenly apart.
    fn spline(ends: assur_functions::Ends) -> assur_functions::Spline {
        let at = (0..40).map(|i| 0.15 * f64::from(i) + 0.02 * (2.0 * f64::from(i)).sin());
        let at: Vec<f64> = at.collect();
        let wave = std::f64::consts::TAU / at[39];
        let mut points: Vec<_> = at.iter().map(|x| (*x, (wave * x).sin())).collect();
        points[39].1 = points[0].1;
        assur_functions::Spline::new("", &points, ends, None).unwrap()
    }

    #[test]
    fn all_numbers_read_a_table_alike() {
        use assur_functions::Ends::{Open, Periodic};
        for (ends, shift) in [(Open, 0.0), (Periodic, 0.0), (Periodic, -100.0), (Periodic, 31.4)] {
            let spline = spline(ends);
            let table = spline.table();
            for place in [0.1, 1.7, 3.3, 5.8] {
                let x = place + shift;
                let value = x.table(&table)[0];
                let (slope, bend) = (x.table(&table)[1], x.table(&table)[2]);
                let dual = Dual { value: x, slope: 2.0 }.table(&table)[0];
                assert!((dual.value - value).abs() < 1e-15);
                assert!((dual.slope - 2.0 * slope).abs() < 1e-13);
                let along = Dual { value: x, slope: 2.0 }.table(&table)[1];
                assert!((along.slope - 2.0 * bend).abs() < 1e-12);
                let bounded = Bounded { value: x, bound: 1e-6 }.table(&table)[0];
                let moved = (x + 1e-6).table(&table)[0];
                assert!((moved - value).abs() <= 1.001 * bounded.bound + 1e-12, "{bounded:?}");
                assert!(bounded.bound < 3e-6);
            }
        }
    }

    /// Enclosures hold the values at many places, over the ends of periods as well, and are not much wider.
    #[test]
    fn intervals_enclose_a_table() {
        use assur_functions::Ends::{Open, Periodic};
        for ends in [Open, Periodic] {
            let spline = spline(ends);
            let table = spline.table();
            let (begin, end) = if ends == Open { (0.0, 5.8) } else { (-9.0, 17.0) };
            for low in (0..20).map(|i| begin + (end - begin) * f64::from(i) / 20.0) {
                for width in [0.0, 0.03, 0.4, 2.0, 9.0] {
                    let high: f64 = (low + width).min(end);
                    let found = Interval::new(low, high).table(&table)[0];
                    let places = (0..=200).map(|i| low + (high - low) * f64::from(i) / 200.0);
                    let values = places.map(|x| x.min(high).table(&table)[0]);
                    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
                    for value in values {
                        assert!(found.low <= value && value <= found.high, "{low} {high} {value}");
                        (least, most) = (least.min(value), most.max(value));
                    }
                    assert!(found.width() < most - least + 0.02, "{low} {high} {found:?}");
                }
            }
        }
    }

    /// A top at a kink stays where it is; that of a hill moves.
    #[test]
    fn tops_at_kinks_stay() {
        let top = |a: Dual| Dual::highest_place(|x| a * x - (x - Dual::constant(0.4)).abs());
        let found = top(Dual::variable(0.3));
        assert!((found.value - 0.4).abs() < 1e-7 && found.slope == 0.0, "{found:?}");
        let hill = Dual::highest_place(|x| x * (Dual::variable(0.7) - x));
        assert!((hill.slope - 0.5).abs() < 1e-8, "{hill:?}");
    }
}
