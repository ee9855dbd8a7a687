//! The influence of all variables on one output along places.

use crate::closure::{AnyLinkage, ClosureError, Linkage, Moves};
use crate::shape::Shape;
use crate::tolerance::error::ToleranceError;

/// An output and its influence coefficients along places.
#[derive(Clone, Debug, PartialEq)]
pub struct Influences {
    /// The output at each place.
    pub values: Vec<f64>,
    /// Number of variables.
    pub variables: usize,
    /// The coefficients, place by place.
    coefficients: Vec<f64>,
}

impl Influences {
    /// Coefficients given as rows, one a place.
    pub fn new(values: Vec<f64>, rows: &[Vec<f64>]) -> Self {
        Self { values, variables: rows.first().map_or(0, Vec::len), coefficients: rows.concat() }
    }

    /// Number of places.
    pub fn places(&self) -> usize {
        self.values.len()
    }

    /// The coefficients at a place: the derivatives of the output by the variables.
    pub fn at(&self, place: usize) -> &[f64] {
        &self.coefficients[place * self.variables..(place + 1) * self.variables]
    }
}

/// Moves a linkage through places and asks for the influence of its variables there.
///
/// # Errors
/// Why it does not get to one of them, or that something is not finite there.
pub fn influences<L: Linkage>(
    linkage: &L,
    output: usize,
    places: &[Vec<f64>],
) -> Result<Influences, ToleranceError> {
    influences_of(linkage, output, places)
}

/// [`influences`] of a linkage behind a pointer.
pub(crate) fn influences_of(
    linkage: &dyn AnyLinkage,
    output: usize,
    places: &[Vec<f64>],
) -> Result<Influences, ToleranceError> {
    let mut assembly = linkage.assemble();
    assembly.guide().start()?;
    let variables = linkage.shape().loops().variables.len();
    let mut found = Influences {
        values: Vec::with_capacity(places.len()),
        variables,
        coefficients: Vec::with_capacity(places.len() * variables),
    };
    for (index, place) in places.iter().enumerate() {
        let (value, row) = influence_at(&mut *assembly, output, place)?;
        if !value.is_finite() || row.iter().any(|one| !one.is_finite()) {
            return Err(ToleranceError::NotFinite { place: index, at: place.clone() });
        }
        found.values.push(value);
        found.coefficients.extend(row);
    }
    Ok(found)
}

/// Moves an assembled linkage to a place: an output and its influence coefficients there.
pub(in crate::tolerance) fn influence_at(
    assembly: &mut dyn Moves,
    output: usize,
    place: &[f64],
) -> Result<(f64, Vec<f64>), ClosureError> {
    let shape = assembly.guide().loops.shape();
    let (drivers, motion) = split(shape, place)?;
    assembly.move_to(drivers)?;
    let guide = assembly.guide();
    let instant = guide.loops.instant_row(drivers, motion);
    let mut values = vec![0.0; shape.outputs.len()];
    guide.loops.outputs(&instant, guide.position, &mut values);
    let count = shape.loops().variables.len();
    let mut all = vec![0.0; shape.outputs.len() * count];
    guide.loops.influence(&instant, guide.position, &mut all);
    Ok((values[output], all[output * count..(output + 1) * count].to_vec()))
}

/// The positions of the drivers at a place, and how they move there.
pub(in crate::tolerance) fn split<'a>(
    shape: &Shape,
    place: &'a [f64],
) -> Result<(&'a [f64], &'a [f64]), ClosureError> {
    let drivers = shape.drivers.len();
    let all = drivers + shape.loops().motion;
    if (place.len() != drivers && place.len() != all)
        || place.iter().any(|value| !value.is_finite())
    {
        return Err(ClosureError::BadRange {
            reason: format!(
                "a place {place:?}: expected {drivers} finite values, or {all} with how the drivers move"
            ),
        });
    }
    Ok(place.split_at(drivers))
}
