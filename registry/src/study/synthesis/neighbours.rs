//! The neighbours of a design, as polishing sees them.

use std::f64::consts::SQRT_2;

use super::Design;
use crate::registry::Bind;
use assur_solvers::closure::{AnyLinkage, Facet, Facets};
use assur_solvers::measure::Sense;
use assur_solvers::synthesis::{Aim, Local, Look, Sought};

/// Conditions are kept by so much more than they have to be, over what they change by within the ranges: what a measure says of
/// them is not exact either.
pub(super) const INWARD: f64 = 1e-9;
/// Part of its range by which a value is varied to see how a motion changes.
const BESIDE: f64 = 1e-4;

/// The neighbours of a design: those with the same choices.
///
/// What a preference is missed by is a number of its own, not below zero nor below what is missed at any place: so the corner
/// where it begins to be missed is one of conditions.
pub(super) struct Neighbours<'a> {
    design: &'a Design<'a>,
    /// Whether what is made small is known by the squares that it is the sum of.
    squares: bool,
    /// The design that they are neighbours of.
    from: Vec<f64>,
    /// The numbers that may have any value, by their places among those that are varied.
    moved: Vec<usize>,
    /// These numbers, then what each preference is missed by.
    sought: Vec<Sought>,
    /// Of a linkage, once one is known.
    facets: Option<Facets>,
    /// What each condition, then each preference changes by within the ranges, where polishing begins.
    scales: Vec<f64>,
    is_stopped: &'a dyn Fn() -> bool,
}

impl<'a> Neighbours<'a> {
    /// Those of a design, and the numbers of that; none where it cannot be judged.
    pub(super) fn of(
        design: &'a Design<'a>,
        squares: bool,
        from: &[f64],
        is_stopped: &'a dyn Fn() -> bool,
    ) -> Option<(Self, Vec<f64>)> {
        let all = design.synthesis.varied.iter().enumerate();
        let moved = all.filter(|(_, one)| one.values.is_empty()).map(|(index, _)| index);
        let moved: Vec<usize> = moved.collect();
        let sought = moved.iter().map(|index| design.sought[*index]).collect();
        let (from, facets, scales) = (from.to_vec(), None, Vec::new());
        let mut own = Self { design, squares, from, moved, sought, facets, scales, is_stopped };
        let mut numbers: Vec<f64> = own.moved.iter().map(|index| own.from[*index]).collect();
        let all = own.facets_of(&numbers)?;
        let others = &all[own.small().len()..];
        own.scales = others.iter().map(|facets| own.reach(facets)).collect();
        for (facets, reach) in others.iter().zip(&own.scales).skip(own.conditions()) {
            let missed = missed(facets);
            own.sought.push(Sought::between(0.0, missed + reach));
            numbers.push(missed);
        }
        Some((own, numbers))
    }

    /// What is made small: one measure, or those of whose squares it is the sum.
    pub(super) fn small(&self) -> &'a [usize] {
        let synthesis = &self.design.synthesis;
        match self.squares {
            true => synthesis.squares,
            false => std::slice::from_ref(&synthesis.objective),
        }
    }

    /// How it is made of them.
    pub(super) fn aim(&self) -> Aim {
        Aim { squares: if self.squares { self.small().len() } else { 0 } }
    }

    /// What is made small, then the conditions and the preferences, each with the sense in which it is good; squares have
    /// none.
    pub(super) fn wanted(&self) -> Vec<(usize, Option<Sense>)> {
        let synthesis = self.design.synthesis;
        let preferences = synthesis.preferences.iter().map(|one| &one.0);
        let margins = synthesis.conditions.iter().chain(preferences);
        let sense = (!self.squares).then_some(Sense::Smallest);
        let first = self.small().iter().map(|one| (*one, sense));
        first.chain(margins.map(|one| (*one, Some(Sense::Largest)))).collect()
    }

    fn conditions(&self) -> usize {
        self.design.synthesis.conditions.len()
    }

    /// All that is varied, with these numbers in the places of those that may have any value.
    pub(super) fn whole(&self, numbers: &[f64]) -> Vec<f64> {
        let mut whole = self.from.clone();
        for (index, number) in self.moved.iter().zip(numbers) {
            whole[*index] = *number;
        }
        whole
    }

    /// The place of a number among those that are varied; none of what a preference is missed by.
    pub(super) fn varied(&self, number: usize) -> Option<usize> {
        self.moved.get(number).copied()
    }

    /// What a condition, then what a preference changes by within the ranges.
    pub(super) fn scale(&self, condition: usize) -> f64 {
        self.scales[condition]
    }

    /// The facets of what is made small, then of the conditions, then of the preferences.
    pub(super) fn facets_of(&mut self, numbers: &[f64]) -> Option<Vec<Vec<Facet>>> {
        match self.design.bind {
            Bind::Linkage(bind) => {
                let linkage = bind(&self.design.values(&self.whole(numbers))).ok()?;
                self.of_linkage(&*linkage)
            }
            Bind::Motion(_) => self.compared(&numbers[..self.moved.len()]),
        }
    }

    fn of_linkage(&mut self, linkage: &dyn AnyLinkage) -> Option<Vec<Vec<Facet>>> {
        let way = linkage.way()?;
        let (design, wanted) = (self.design, self.wanted());
        let facets = match &mut self.facets {
            Some(facets) => facets,
            none => {
                let varied = self.moved.iter().map(|index| &design.synthesis.varied[*index]);
                let constants = varied.map(|one| (one.constant, one.to - one.from)).collect();
                none.insert(linkage.facets(way, constants, &wanted).ok()?)
            }
        };
        facets.of(linkage).ok()
    }

    /// The measures as they are, beside those of neighbours within the bounds.
    fn compared(&self, numbers: &[f64]) -> Option<Vec<Vec<Facet>>> {
        let measures = |numbers: &[f64]| -> Option<Vec<f64>> {
            let all = self.design.found(&self.whole(numbers))?;
            Some(all.into_iter().map(|one| one.unwrap_or(f64::NAN)).collect())
        };
        let here = measures(numbers)?;
        let beside = self.sought.iter().take(numbers.len()).enumerate().map(|(index, one)| {
            let [behind, ahead] = [-BESIDE, BESIDE].map(|part| {
                let mut other = numbers.to_vec();
                other[index] += part * one.width();
                if !one.is_turn {
                    other[index] = other[index].clamp(one.low, one.high);
                }
                other
            });
            let way = ahead[index] - behind[index];
            let (behind, ahead) = (measures(&behind)?, measures(&ahead)?);
            Some(ahead.iter().zip(behind).map(|(a, b)| (a - b) / way).collect::<Vec<f64>>())
        });
        let slopes: Vec<Vec<f64>> = beside.collect::<Option<_>>()?;
        let facet = |(measure, _): (usize, Option<Sense>)| {
            let slopes = slopes.iter().map(|all| all[measure]).collect();
            vec![Facet { at: None, value: here[measure], slopes }]
        };
        Some(self.wanted().into_iter().map(facet).collect())
    }

    /// The slopes of the steepest facet in units of the ranges, all together; one where there are none.
    fn reach(&self, facets: &[Facet]) -> f64 {
        let each = facets.iter().map(|facet| {
            let slopes = facet.slopes.iter().zip(&self.sought);
            slopes.map(|(slope, one)| slope.abs() * one.width()).sum::<f64>()
        });
        let most = each.fold(0.0, f64::max);
        if most > 0.0 && most.is_finite() { most } else { 1.0 }
    }
}

/// By how much a preference is missed.
fn missed(facets: &[Facet]) -> f64 {
    facets.iter().fold(0.0, |most, facet| f64::max(most, -facet.value))
}

impl Local for Neighbours<'_> {
    fn sought(&self) -> &[Sought] {
        &self.sought
    }

    fn is_stopped(&self) -> bool {
        (self.is_stopped)()
    }

    fn look(&mut self, numbers: &[f64]) -> Option<Look> {
        let all = self.facets_of(numbers)?;
        let (first, others) = all.split_at(self.small().len());
        let preferences = self.design.synthesis.preferences;
        let missed = &numbers[self.moved.len()..];
        let costs: Vec<f64> = preferences.iter().map(|one| one.1).collect();
        let cost: f64 = costs.iter().zip(missed).map(|(cost, missed)| cost * missed).sum();
        let mut look = Look::default();
        if !self.squares {
            for facet in first.concat() {
                look.values.push(facet.value + cost);
                look.slopes.extend(facet.slopes.iter().chain(&costs));
            }
        } else {
            if !costs.is_empty() {
                look.values.push(cost);
                look.slopes.extend(std::iter::repeat_n(&0.0, self.moved.len()).chain(&costs));
            }
            // Half their squares count.
            for facet in first.concat() {
                look.values.push(SQRT_2 * facet.value);
                look.slopes.extend(facet.slopes.iter().map(|slope| SQRT_2 * slope));
                look.slopes.extend(costs.iter().map(|_| 0.0));
            }
        }
        for (index, (facets, scale)) in others.iter().zip(&self.scales).enumerate() {
            let preference = index.checked_sub(self.conditions());
            let room = preference.map_or(-INWARD * scale, |preference| missed[preference]);
            let is_own =
                (0..missed.len()).map(|other| f64::from(u8::from(Some(other) == preference)));
            let is_own: Vec<f64> = is_own.collect();
            for facet in facets {
                look.conditions.push((facet.value + room) / scale);
                let slopes = facet.slopes.iter().chain(&is_own);
                look.slopes.extend(slopes.map(|slope| slope / scale));
            }
        }
        Some(look)
    }
}
