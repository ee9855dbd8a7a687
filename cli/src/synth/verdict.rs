//! What is the matter with designs, in words.

use assur::study::{Design, Unmeasured};

use super::Found;
use crate::ask::constants::Constants;
use crate::linkage::wording;
use crate::show::number;
use crate::{linkage, motion};

/// The measures of a design with their errors.
///
/// # Errors
/// Why it has none, in the names and units of the file.
pub fn measures(
    design: &Design<'_>,
    constants: &Constants,
    values: &[f64],
) -> Result<Vec<(f64, f64)>, String> {
    design.measures(values).map_err(|error| {
        let constants = constants.with_values(&design.values(values));
        let told = match &error {
            Unmeasured::Stuck(error) => {
                linkage::case::Case::new(constants).ok().map(|case| case.tell(error))
            }
            Unmeasured::Still(error) => {
                motion::case::Case::new(constants).ok().map(|case| case.tell(error))
            }
            _ => None,
        };
        told.map_or_else(|| error.to_string(), |told| told.reason)
    })
}

/// That a design is put together far from its start values; none if it is not.
pub fn contradiction(design: &Design<'_>, constants: &Constants, values: &[f64]) -> Option<String> {
    constants.scene.linkage?;
    let case = linkage::case::Case::new(constants.with_values(&design.values(values))).ok()?;
    wording::contradiction(&case.constants, case.run())
}

impl Found {
    /// What the best design misses first, and by how much.
    pub(super) fn hardest(&self) -> String {
        let Some(best) = self.designs.first() else {
            return "none was judged".to_owned();
        };
        if let Err(reason) = &best.measures {
            return format!("the best one does not get through its task: {reason}");
        }
        let missed = self.synthesis.conditions.iter().find_map(|index| {
            let (value, quantity) = (best.measure(*index).0, self.measure(*index));
            (value < 0.0 || value.is_nan()).then(|| {
                let by = number::significant(-value / quantity.factor, 4);
                format!("`{}` is missed by {by} {}", quantity.name, quantity.unit)
            })
        });
        missed.unwrap_or_else(|| "its measures are no numbers".to_owned())
    }
}
