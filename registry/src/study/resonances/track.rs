//! Multipliers over a range of values, each known again from one value to the next.

use super::{Meets, Spectrum};
use crate::study::each;
use assur_solvers::periodic::Multiplier;

/// Farthest that a multiplier moves from one value to the next.
const MOVE: f64 = 0.2;
/// Part of the first step, and of the last, of what is taken beside the ends.
const BESIDE: f64 = 1e-6;
/// Halvings of a step of the range at most.
const HALVINGS: usize = 14;

/// What was followed.
pub(super) struct Track {
    /// The multipliers in the order of the values; those of each known again from the one before keep their place.
    pub spectra: Vec<Spectrum>,
    /// For each but the last, whether those of the next are known again.
    known: Vec<bool>,
    /// Values between which they are not.
    pub gaps: Vec<(f64, f64)>,
    /// Why there are none at a value.
    pub lost: Vec<(f64, String)>,
}

/// Three neighbouring values of which the middle one is where a pair of multipliers is nearest to what it meets.
pub(super) struct Section<'a> {
    pub meets: Meets,
    /// The pair of conjugates, or what became of them, by their places; twice the same of one that is real throughout.
    pub pair: [usize; 2],
    /// The other pair, where two meet.
    pub other: [usize; 2],
    pub around: [&'a Spectrum; 3],
}

type At<'a> = &'a (dyn Fn(f64) -> Result<Spectrum, String> + Sync);

impl Track {
    /// Follows the multipliers through some values.
    pub fn follow(
        at: At<'_>,
        values: &[f64],
        threads: usize,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Self {
        let values = &with_ends(values);
        let ends = each(values.len(), threads, progress, &|index| at(values[index]));
        let steps = values.len().saturating_sub(1);
        let between = each(steps, threads, progress, &|index| {
            let mut lost = Vec::new();
            let mut inside = Vec::new();
            if let (Ok(from), Ok(to)) = (&ends[index], &ends[index + 1]) {
                // A turn of a multiplier within a step would not be seen at its ends.
                halve(at, (from, to), HALVINGS, true, &mut inside, &mut lost);
            }
            (inside, lost)
        });
        let mut track =
            Self { spectra: Vec::new(), known: Vec::new(), gaps: Vec::new(), lost: Vec::new() };
        let mut between = between.into_iter();
        for (end, value) in ends.into_iter().zip(values) {
            match end {
                Ok(spectrum) => track.take(spectrum),
                Err(reason) => track.lost.push((*value, reason)),
            }
            if let Some((inside, lost)) = between.next() {
                inside.into_iter().for_each(|one| track.take(one));
                track.lost.extend(lost);
            }
        }
        track
    }

    /// Goes on with the multipliers at the next value.
    fn take(&mut self, mut spectrum: Spectrum) {
        if let Some(last) = self.spectra.last() {
            let known = matched(last, &spectrum);
            if let Some((order, _)) = &known {
                spectrum.multipliers = order.iter().map(|at| spectrum.multipliers[*at]).collect();
            }
            let is_known = known.is_some_and(|(_, farthest)| farthest <= MOVE);
            if !is_known {
                self.gaps.push((last.value, spectrum.value));
            }
            self.known.push(is_known);
        }
        self.spectra.push(spectrum);
    }

    /// Where multipliers come nearest to what they meet.
    pub fn sections(&self) -> Vec<Section<'_>> {
        let mut sections = Vec::new();
        for (index, three) in self.spectra.windows(3).enumerate() {
            let [before, here, after] = three else { continue };
            if !(self.known[index] && self.known[index + 1]) {
                continue;
            }
            let around = [before, here, after];
            let pairs = pairs(around);
            let mut put = |meets, pair, other| {
                let section = Section { meets, pair, other, around };
                let [before, here, after] = around.map(|one| section.square(one));
                // Of two that are equal the second, of which one is the nearest.
                if before > here && here <= after {
                    sections.push(section);
                }
            };
            // What dies out soon does not grow, whatever it meets.
            let lasts = |pair: &&[usize; 2]| here.multipliers[pair[0]].modulus() > 1.0 - MOVE;
            let pairs: Vec<_> = pairs.iter().filter(lasts).collect();
            for (place, pair) in pairs.iter().enumerate() {
                put(Meets::One, **pair, **pair);
                put(Meets::MinusOne, **pair, **pair);
                for other in &pairs[place + 1..] {
                    if pair[0] != pair[1] && other[0] != other[1] {
                        put(Meets::Another, **pair, **other);
                    }
                }
            }
        }
        sections
    }
}

/// The values, and one more beside each end: so what is nearest within the first step, or the last, lies between two others.
fn with_ends(values: &[f64]) -> Vec<f64> {
    let [first, second, ..] = *values else { return values.to_vec() };
    let [.., other, last] = *values else { return values.to_vec() };
    let mut all = values.to_vec();
    all.insert(1, first + BESIDE * (second - first));
    all.insert(values.len(), last + BESIDE * (other - last));
    all
}

/// The pairs of conjugates, known at a value at which they are not real.
fn pairs(around: [&Spectrum; 3]) -> Vec<[usize; 2]> {
    let mut pairs: Vec<[usize; 2]> = Vec::new();
    for which in 0..around[1].multipliers.len() {
        if pairs.iter().flatten().any(|one| *one == which) {
            continue;
        }
        let conjugate = around.iter().find_map(|spectrum| {
            let own = spectrum.multipliers[which];
            let is_conjugate = |other: &Multiplier| (other.re, other.im) == (own.re, -own.im);
            (own.im != 0.0).then(|| spectrum.multipliers.iter().position(is_conjugate))?
        });
        pairs.push([which, conjugate.unwrap_or(which)]);
    }
    pairs
}

impl Section<'_> {
    /// The square of how far the pair is from what it meets, of multipliers in the order of the section. It is a symmetric
    /// function of the pair, so it is smooth, and below zero where the pair has become real or two have left the circle.
    pub fn square(&self, of: &Spectrum) -> f64 {
        let at = |place: usize| of.multipliers[place];
        let [one, other] = self.pair.map(at);
        let product = |by: f64| {
            let (a, b) = (one.re - by, other.re - by);
            a * b - one.im * other.im
        };
        match self.meets {
            Meets::One => product(1.0),
            Meets::MinusOne => product(-1.0),
            Meets::Another => {
                let two = at(self.other[0]);
                // `-(u - v)^2/(u v)` of the two in the upper half.
                let (u, v) = ((one.re, one.im.abs()), (two.re, two.im.abs()));
                let (a, b) = (u.0 - v.0, u.1 - v.1);
                let (re, im) = (u.0 * v.0 - u.1 * v.1, u.0 * v.1 + u.1 * v.0);
                let size = (re * re + im * im).max(f64::MIN_POSITIVE);
                -((a * a - b * b) * re + 2.0 * a * b * im) / size
            }
        }
    }
}

/// Multipliers between two values, in steps in which each is known again.
fn halve(
    at: At<'_>,
    (from, to): (&Spectrum, &Spectrum),
    halvings: usize,
    is_first: bool,
    inside: &mut Vec<Spectrum>,
    lost: &mut Vec<(f64, String)>,
) {
    let moved = matched(from, to).map_or(f64::INFINITY, |(_, farthest)| farthest);
    if halvings == 0 || (moved <= MOVE && !is_first) {
        return;
    }
    let value = 0.5 * (from.value + to.value);
    match at(value) {
        Ok(middle) => {
            halve(at, (from, &middle), halvings - 1, false, inside, lost);
            inside.push(middle.clone());
            halve(at, (&middle, to), halvings - 1, false, inside, lost);
        }
        Err(reason) => lost.push((value, reason)),
    }
}

/// Which multipliers are those of before, in their order, and how far the one moved that moved farthest; none where there are
/// not as many, or over other periods. The nearest two are taken first.
pub(super) fn matched(before: &Spectrum, after: &Spectrum) -> Option<(Vec<usize>, f64)> {
    let (from, to) = (&before.multipliers, &after.multipliers);
    if from.len() != to.len() || before.periods != after.periods {
        return None;
    }
    let off = |a: &Multiplier, b: &Multiplier| (a.re - b.re).hypot(a.im - b.im);
    let pairs = from.iter().enumerate().flat_map(|(place, one)| {
        to.iter().enumerate().map(move |(other, two)| (off(one, two), place, other))
    });
    let mut pairs: Vec<_> = pairs.collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut order, mut taken) = (vec![usize::MAX; from.len()], vec![false; to.len()]);
    let mut farthest = 0.0;
    for (distance, place, other) in pairs {
        if order[place] == usize::MAX && !taken[other] {
            (order[place], taken[other]) = (other, true);
            farthest = f64::max(farthest, distance);
        }
    }
    Some((order, farthest))
}
