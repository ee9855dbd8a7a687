//! Errors of the output with the loops closed again.

use super::lead::Lead;
use super::nominal::Nominal;
use crate::closure::AnyLinkage;
use crate::tolerance::source::Study;

/// The errors of the output at all places for errors of the sources; no number where the linkage does not assemble in its
/// mode.
pub(in crate::tolerance) fn errors(
    linkage: &dyn AnyLinkage,
    study: &Study,
    nominals: &[Nominal],
    errors: &[f64],
    found: &mut [f64],
) {
    let is_iterated = linkage.shape().loops().is_iterated();
    for (nominal, slot) in nominals.iter().zip(found) {
        let lead = Lead::new(linkage, study, nominal);
        let error = match is_iterated {
            true => lead.error(errors),
            false => lead.at_once(errors),
        };
        *slot = error.unwrap_or(f64::NAN);
    }
}
