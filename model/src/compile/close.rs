//! The second phase: the loops in the order in which they are closed.

use super::Here;
use crate::checked::EquationInfo;
use crate::linkage::{self, Linkage, Loops};
use crate::lower::Lowering;

/// Reads the loops, which give their texts, and orders them unless there is a mistake.
pub fn close(
    here: Here<'_>,
    low: &mut Lowering<'_>,
    is_complete: impl Fn(&Lowering<'_>) -> bool,
) -> (Vec<EquationInfo>, Option<Linkage>) {
    let loops = Loops::read(&here.phase().statements, low);
    let texts = loops.texts.clone();
    let linkage = match is_complete(low) {
        true => Linkage::of(loops, low.names, &here.place(), low),
        false => None,
    };
    low.loops_are_wrong = linkage.is_none();
    linkage::follow(low);
    (texts, linkage)
}
