//! How a linkage can be assembled, and how far it goes; whole runs, as everything behind `dyn`.

use std::f64::consts::TAU;

use super::linkage::Bound;
use crate::closure::{
    self, Along, Closure, ClosureError, Linkage, Newton, Search, Stretch, Stroke,
};

/// Solutions nearer to each other than this are the same, in radians, metres or whatever a coordinate is in.
const SAME: f64 = 1e-6;

/// All assembly modes at one place, each with what it amounts to.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The modes.
    pub modes: Vec<Listed>,
    /// Whether there are certainly no others (but for displacements beyond the bound of the search).
    pub complete: bool,
    /// Boxes of unknowns that could not be decided: two modes may meet there, or nearly.
    pub undecided: usize,
    /// Boxes that were looked at.
    pub boxes: usize,
    /// Which of the modes the start values pick.
    pub declared: Option<usize>,
    /// Why the linkage does not get to the place in that mode.
    pub stopped: Option<ClosureError>,
}

/// One assembly mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The dependent coordinates, angles within `±π`.
    pub dependents: Vec<f64>,
    /// The outputs.
    pub outputs: Vec<f64>,
    /// Sine of the transmission angle of each group: its determinant over the lengths of its columns.
    pub sines: Vec<f64>,
    /// What is left of each loop equation.
    pub residuals: Vec<f64>,
}

/// A linkage whose dimensions are fixed, as far as its assembly modes and limits go.
pub trait RunLimits {
    /// All assembly modes at a place, and which one the start values pick; see [`fn@closure::modes`]. The place is the
    /// positions of the drivers, and behind them how these move where that is known.
    ///
    /// # Errors
    /// [`ClosureError::BadRange`] if the place makes no sense.
    fn modes(&self, place: &[f64], search: &Search) -> Result<Listing, ClosureError>;
    /// How far one driver goes within bounds, see [`fn@closure::stretch`].
    ///
    /// # Errors
    /// As there.
    fn stretch(&self, driver: usize, bounds: (f64, f64)) -> Result<Stretch, ClosureError>;
    /// Limit positions and strokes of the outputs, and behind them of the dependent coordinates, see
    /// [`fn@closure::strokes`].
    ///
    /// # Errors
    /// As there.
    fn strokes(&self, along: Along) -> Result<Vec<Stroke>, ClosureError>;
}

impl<L: Linkage + 'static, const MADE: bool> RunLimits for Bound<L, MADE> {
    fn modes(&self, place: &[f64], search: &Search) -> Result<Listing, ClosureError> {
        let (drivers, motion) = place.split_at(place.len().min(L::INDEPENDENTS));
        let found = closure::modes(&self.linkage, drivers, search)?;
        let modes: Vec<_> = found
            .modes
            .into_iter()
            .map(|mode| listed(&self.linkage, (drivers, motion), mode))
            .collect();
        let (declared, stopped) = match there(&self.linkage, drivers) {
            Ok(dependents) => {
                let same = |mode: &Listed| is_same::<L>(&mode.dependents, &dependents);
                (modes.iter().position(same), None)
            }
            Err(error) => (None, Some(error)),
        };
        Ok(Listing {
            modes,
            complete: found.complete,
            undecided: found.undecided,
            boxes: found.boxes,
            declared,
            stopped,
        })
    }

    fn stretch(&self, driver: usize, bounds: (f64, f64)) -> Result<Stretch, ClosureError> {
        closure::stretch(&self.linkage, driver, bounds)
    }

    fn strokes(&self, along: Along) -> Result<Vec<Stroke>, ClosureError> {
        closure::strokes(&self.linkage, along)
    }
}

/// A mode with its outputs and what is left of its equations.
fn listed<L: Linkage>(
    linkage: &L,
    (drivers, motion): (&[f64], &[f64]),
    mode: closure::Mode,
) -> Listed {
    let closure = L::prepare::<f64>(&linkage.values());
    let instant = match motion.len() == L::MOTION {
        true => closure.moving(drivers, motion),
        false => closure.instant(drivers),
    };
    let mut position = closure.zeros();
    position.as_mut()[..L::DEPENDENTS].copy_from_slice(&mode.coordinates);
    // What the position holds beside the coordinates follows from them.
    let mut newton = Newton::<L, f64>::new();
    for group in 0..L::GROUPS.len() {
        newton.sine(&closure, group, &instant, &mut position);
    }
    let mut outputs = vec![0.0; L::OUTPUTS];
    closure.outputs(&instant, &position, &mut outputs);
    let mut residuals = vec![0.0; L::DEPENDENTS];
    closure.residual(&instant, &position, &mut residuals);
    Listed {
        dependents: mode.coordinates,
        outputs,
        sines: mode.sines,
        residuals,
    }
}

/// The dependent coordinates at a place in the mode that the start values pick.
fn there<L: Linkage>(linkage: &L, place: &[f64]) -> Result<Vec<f64>, ClosureError> {
    let mut assembly = closure::Assembly::<L, f64>::new(linkage);
    assembly.start()?;
    assembly.travel(place)?;
    Ok(assembly.position().as_ref()[..L::DEPENDENTS].to_vec())
}

/// Whether two positions are one, angles but for whole turns.
fn is_same<L: Linkage>(a: &[f64], b: &[f64]) -> bool {
    let mut pairs = a.iter().zip(b).zip(L::ANGLES);
    pairs.all(|((a, b), is_angle)| {
        let apart = match is_angle {
            true => (a - b) - TAU * ((a - b) / TAU).round(),
            false => a - b,
        };
        apart.abs() < SAME
    })
}
