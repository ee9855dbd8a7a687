//! What is known of a way: what measures find of it, and how that changes with constants.

use std::collections::BTreeMap;

use super::course::Course;
use super::facets::{FEW, Facet, Facets};
use super::walk::Walk;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::Answers;
use crate::scalar::{Dual, Scalar};

/// Part of its range by which a constant is varied for a difference.
const STEP: f64 = 1e-6;

/// What is known of a way.
pub(super) struct Known {
    /// What is found of it.
    pub found: Vec<f64>,
    /// How that changes with each constant.
    pub slopes: Vec<Vec<f64>>,
    /// Of each extreme its value at each place.
    pub places: Vec<Vec<Place>>,
    /// The loops for each constant.
    pub loops: Vec<Box<dyn Answers<Dual>>>,
}

/// A quantity at a place.
pub(super) struct Place {
    pub at: f64,
    pub value: f64,
    pub slopes: Vec<f64>,
}

impl Facets {
    /// Looks at all that measures use.
    ///
    /// # Errors
    /// Why the linkage does not get through its way.
    pub(super) fn look(&self, linkage: &dyn AnyLinkage) -> Result<Known, ClosureError> {
        let shape = linkage.shape();
        let count = shape.primitives.len();
        let mut known = Known {
            found: vec![f64::NAN; count],
            slopes: vec![vec![f64::NAN; self.constants.len()]; count],
            places: (0..count).map(|_| Vec::new()).collect(),
            loops: self.loops(linkage),
        };
        let used: Vec<usize> = (0..count)
            .filter(|index| self.measures.iter().any(|one| shape.uses[*one].contains(index)))
            .collect();
        let (extremes, others): (Vec<usize>, Vec<usize>) =
            used.iter().partition(|index| self.extreme(shape, **index).is_some());
        let (passages, others): (Vec<usize>, Vec<usize>) =
            others.iter().partition(|index| self.passage(shape, **index).is_some());
        let mut course = Course::new(linkage, self.along)?;
        self.look_at_extremes((linkage, &mut course), &extremes, &mut known)?;
        self.look_at_passages((linkage, &mut course), &passages, &mut known)?;
        if !others.is_empty() {
            self.compare(linkage, &others, &mut known)?;
        }
        Ok(known)
    }

    /// Finds extremes, and how quantities change at all places where they may lie.
    fn look_at_extremes(
        &self,
        (linkage, course): (&dyn AnyLinkage, &mut Course<'_>),
        extremes: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let shape = linkage.shape();
        for index in extremes {
            let primitive = &shape.primitives[*index];
            let Some((sense, stretches)) =
                self.extreme(shape, *index).zip(self.stretches[*index].as_ref())
            else {
                continue;
            };
            let tops = course.tops(primitive.argument, stretches, sense)?;
            let mut places = Vec::with_capacity(tops.len());
            for at in tops {
                let (values, slopes) = course.at(at, &known.loops)?;
                let value = values[primitive.argument];
                let slopes = slopes.iter().map(|all| all[primitive.argument]).collect();
                places.push(Place { at, value, slopes });
            }
            let best = places.iter().reduce(|best, place| {
                if sense.better(place.value, best.value) { place } else { best }
            });
            if let Some(best) = best {
                (known.found[*index], known.slopes[*index]) = (best.value, best.slopes.clone());
            }
            known.places[*index] = places;
        }
        Ok(())
    }

    /// Finds values where something passes zero, and how they change with the place.
    fn look_at_passages(
        &self,
        (linkage, course): (&dyn AnyLinkage, &mut Course<'_>),
        passages: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let shape = linkage.shape();
        let mut places = BTreeMap::new();
        for index in passages {
            let Some((guard, is_last)) = self.passage(shape, *index) else { continue };
            let ends = match places.get(&guard) {
                Some(ends) => *ends,
                None => {
                    let ends = Walk::new(linkage, self.along)?.passages(FEW, guard)?;
                    places.insert(guard, ends);
                    ends
                }
            };
            let Some((first, last)) = ends else { continue };
            let at = if is_last { last } else { first };
            let quantity = shape.primitives[*index].argument;
            (known.found[*index], known.slopes[*index]) =
                course.passing(at, (quantity, guard), &known.loops)?;
        }
        Ok(())
    }

    /// Compares what is found with that of linkages nearby.
    fn compare(
        &self,
        linkage: &dyn AnyLinkage,
        others: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let values = linkage.values();
        let found = |values: &[f64]| -> Result<Vec<f64>, ClosureError> {
            let linkage = linkage.with_values(values);
            let found =
                Walk::new(&*linkage, self.along)?.find(FEW, &|index| others.contains(&index))?;
            Ok(found.into_iter().map(|one| one.unwrap_or(f64::NAN)).collect())
        };
        let here = found(&values)?;
        for index in others {
            known.found[*index] = here[*index];
        }
        for (column, (constant, width)) in self.constants.iter().enumerate() {
            let beside = |way: f64| {
                let mut values = values.clone();
                values[*constant] += way * STEP * width;
                found(&values)
            };
            let (behind, ahead) = (beside(-1.0)?, beside(1.0)?);
            for index in others {
                known.slopes[*index][column] =
                    (ahead[*index] - behind[*index]) / (2.0 * STEP * width);
            }
        }
        Ok(())
    }
}

/// All measures, with how they change: for each constant.
pub(super) struct Measured(Vec<Vec<Dual>>);

impl Measured {
    /// One of them, at a place of its extreme.
    pub fn facet(&self, measure: usize, at: Option<f64>) -> Facet {
        let value = self.0.first().map_or(f64::NAN, |all| all[measure].value);
        Facet { at, value, slopes: self.0.iter().map(|all| all[measure].slope).collect() }
    }
}

impl Known {
    /// The measures, as if an extreme lay at a place.
    pub fn measures(&self, extreme: Option<(usize, &Place)>) -> Measured {
        let each = self.loops.iter().enumerate().map(|(column, loops)| {
            let all = self.found.iter().zip(&self.slopes);
            let mut found: Vec<Dual> =
                all.map(|(value, slopes)| Dual { value: *value, slope: slopes[column] }).collect();
            if let Some((index, place)) = extreme {
                found[index] = Dual { value: place.value, slope: place.slopes[column] };
            }
            let mut measures = vec![Dual::ZERO; loops.shape().measures.len()];
            loops.measures(&found, &mut measures);
            measures
        });
        Measured(each.collect())
    }
}
