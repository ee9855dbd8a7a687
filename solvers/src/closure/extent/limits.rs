//! How far a driver can go.

use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::problem::Linkage;
use crate::closure::position::guide::Guide;

/// How far one independent variable can go without leaving the mode, the others at their start.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// The end below.
    pub low: End,
    /// The end above.
    pub high: End,
}

/// One end of a stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// The independent variable there.
    pub at: f64,
    /// The group that has a dead point there; none if the end is the one that was asked for.
    pub dead: Option<usize>,
    /// The outputs there.
    pub outputs: Vec<f64>,
    /// The dependent coordinates there.
    pub dependents: Vec<f64>,
}

impl End {
    /// An output, or behind all of them a dependent coordinate.
    pub(super) fn value(&self, channel: usize) -> f64 {
        let behind = |index| self.dependents.get(index).copied();
        let value = match channel.checked_sub(self.outputs.len()) {
            Some(index) => behind(index),
            None => self.outputs.get(channel).copied(),
        };
        value.unwrap_or(f64::NAN)
    }
}

/// Finds how far one independent variable can go within bounds.
///
/// # Errors
/// [`ClosureError`] if the linkage does not assemble at its start, or a mode is lost without a dead point.
pub fn stretch<L: Linkage>(
    linkage: &L,
    variable: usize,
    bounds: (f64, f64),
) -> Result<Stretch, ClosureError> {
    stretch_of(linkage, variable, bounds)
}

/// [`stretch()`] of a linkage behind a pointer.
pub(crate) fn stretch_of(
    linkage: &dyn AnyLinkage,
    variable: usize,
    bounds: (f64, f64),
) -> Result<Stretch, ClosureError> {
    let drivers = linkage.shape().drivers.len();
    if variable >= drivers || !(bounds.0 < bounds.1 && (bounds.1 - bounds.0).is_finite()) {
        let reason = format!(
            "bounds {bounds:?} of independent variable {variable}: expected a finite stretch"
        );
        return Err(ClosureError::BadRange { reason });
    }
    Ok(Stretch { low: end(linkage, variable, bounds.0)?, high: end(linkage, variable, bounds.1)? })
}

/// Goes from the start as far as possible.
fn end(linkage: &dyn AnyLinkage, variable: usize, bound: f64) -> Result<End, ClosureError> {
    let mut assembly = linkage.assemble();
    assembly.guide().start()?;
    let mut place = assembly.guide().independents.to_vec();
    place[variable] = bound;
    let outcome = assembly.travel(&place);
    let mut guide = assembly.guide();
    match outcome {
        Ok(()) => {
            let mut outputs = vec![0.0; linkage.shape().outputs.len()];
            guide.outputs(&mut outputs);
            Ok(End { at: bound, dead: None, outputs, dependents: guide.coordinates() })
        }
        Err(ClosureError::DeadPoint { group, at, wanted, .. }) => {
            let (outputs, dependents) = guide.at_dead_point(&wanted);
            Ok(End { at: at[variable], dead: Some(group), outputs, dependents })
        }
        Err(error) => Err(error),
    }
}

impl Guide<'_, f64> {
    /// The outputs and the dependent coordinates at the dead point on the way to these independent variables.
    fn at_dead_point(&mut self, wanted: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut outputs = vec![f64::NAN; self.loops.shape().outputs.len()];
        let dependents = self.entry.dependents.len();
        let Some((at, coordinates)) = self.dead_position(wanted) else {
            return (outputs, vec![f64::NAN; dependents]);
        };
        let instant = self.instant_at(&at);
        self.trial.copy_from_slice(self.position);
        self.trial[..dependents].copy_from_slice(&coordinates);
        for group in 0..self.entry.groups.len() {
            self.newton.sine(self.loops, group, &instant, self.trial);
        }
        self.loops.outputs(&instant, self.trial, &mut outputs);
        (outputs, coordinates)
    }
}
