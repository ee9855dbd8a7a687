//! What the best design does, as figures.

use crate::answer::Answer;
use crate::arguments::Rows;
use crate::ask::constants::Constants;
use crate::draw;
use crate::error::Failure;
use crate::plot::Selection;
use crate::run::Shown;
use crate::{linkage, motion};
use assur::answer::Settings;

/// Its outputs, over what drives it or in time.
///
/// # Errors
/// Why it does not get through its task.
pub fn curves(constants: Constants, settings: &Settings) -> Result<Option<String>, Failure> {
    let shown = Shown { curves: Selection::default(), rows: Rows::Positions };
    match constants.scene.linkage {
        Some(_) => {
            let case = linkage::case::Case::new(constants)?;
            let grid = linkage::line::Grid::fine(&case);
            Ok(linkage::report::collect(case, &grid, Vec::new(), shown)?.figure())
        }
        None => {
            let case = motion::case::Case::new(constants)?;
            Ok(motion::report::collect(case, settings, &[], shown)?.figure())
        }
    }
}

/// It at some positions.
///
/// # Errors
/// As above; or that nothing of it can be drawn.
pub fn positions(constants: Constants) -> Result<String, Failure> {
    draw::still(constants)
}
