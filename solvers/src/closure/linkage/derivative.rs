//! Positions of neighbouring linkages, by dual numbers.

use super::loops::{Answers, Square};
use crate::dense::{Lu, Singular};
use crate::scalar::Dual;

/// Numbers that stand still, but for one that varies.
pub(crate) fn duals(list: &[f64], varied: Option<usize>) -> Vec<Dual> {
    let one = |(index, value): (usize, &f64)| match Some(index) == varied {
        true => Dual::variable(*value),
        false => Dual::constant(*value),
    };
    list.iter().enumerate().map(one).collect()
}

/// Gives a closed position the derivatives that keep all its loops closed.
///
/// # Errors
/// Where the Jacobian of a group is singular there are none.
pub(crate) fn keep_closed(
    loops: &dyn Answers<Dual>,
    instant: &[Dual],
    position: &mut [Dual],
) -> Result<(), Singular> {
    let mut square = Square::of(loops.shape());
    for (index, group) in loops.shape().loops().groups.iter().enumerate() {
        square.look(loops, index, instant, position);
        let count = group.unknowns.len();
        let entries = square.jacobian[..count * count].iter();
        let factors = Lu::new(entries.map(|one| one.value).collect(), count)?;
        let rows = square.residual[..count].iter();
        let mut right: Vec<f64> = rows.map(|one| -one.slope).collect();
        factors.solve(&mut right);
        for (unknown, slope) in group.unknowns.iter().zip(right) {
            position[*unknown].slope = slope;
        }
        // Sines and cosines follow.
        square.look(loops, index, instant, position);
    }
    Ok(())
}
