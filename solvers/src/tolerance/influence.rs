//! The influence of all variables on one output along places.

use super::error::ToleranceError;
use crate::closure::{Assembly, Closure, ClosureError, Linkage};

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
        Self {
            values,
            variables: rows.first().map_or(0, Vec::len),
            coefficients: rows.concat(),
        }
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
    let mut assembly = Assembly::<L, f64>::new(linkage);
    assembly.start()?;
    let mut found = Influences {
        values: Vec::with_capacity(places.len()),
        variables: L::VARIABLES.len(),
        coefficients: Vec::with_capacity(places.len() * L::VARIABLES.len()),
    };
    for (index, place) in places.iter().enumerate() {
        let (value, row) = influence_at(&mut assembly, output, place)?;
        if !value.is_finite() || row.iter().any(|one| !one.is_finite()) {
            return Err(ToleranceError::NotFinite {
                place: index,
                at: place.clone(),
            });
        }
        found.values.push(value);
        found.coefficients.extend(row);
    }
    Ok(found)
}

/// Moves an assembled linkage to a place: an output and its influence coefficients there.
pub(super) fn influence_at<L: Linkage>(
    assembly: &mut Assembly<L, f64>,
    output: usize,
    place: &[f64],
) -> Result<(f64, Vec<f64>), ClosureError> {
    let (drivers, motion) = split::<L>(place)?;
    assembly.move_to(drivers)?;
    let closure = assembly.closure();
    let instant = match motion.is_empty() {
        true => closure.instant(drivers),
        false => closure.moving(drivers, motion),
    };
    let mut values = vec![0.0; L::OUTPUTS];
    closure.outputs(&instant, assembly.position(), &mut values);
    let count = L::VARIABLES.len();
    let mut all = vec![0.0; L::OUTPUTS * count];
    closure.influence(&instant, assembly.position(), &mut all);
    Ok((
        values[output],
        all[output * count..(output + 1) * count].to_vec(),
    ))
}

/// The positions of the drivers at a place, and how they move there.
pub(super) fn split<L: Linkage>(place: &[f64]) -> Result<(&[f64], &[f64]), ClosureError> {
    let all = L::INDEPENDENTS + L::MOTION;
    if (place.len() != L::INDEPENDENTS && place.len() != all)
        || place.iter().any(|value| !value.is_finite())
    {
        return Err(ClosureError::BadRange {
            reason: format!(
                "a place {place:?}: expected {} finite values, or {all} with how the drivers move",
                L::INDEPENDENTS
            ),
        });
    }
    Ok(place.split_at(L::INDEPENDENTS))
}
