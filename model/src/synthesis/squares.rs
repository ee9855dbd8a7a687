//! What is made small as a sum of squares.

use super::sought;
use crate::declare::quantity;
use crate::lower::{Kind, Lowering};
use crate::measures::Measures;
use crate::syntax::tree::{Scene, SceneItem};
use crate::unit::Unit;

/// Adds the measures of whose squares what a scene makes small is the sum, and says which they are; none if it is no sum of
/// squares. Polishing then knows each of them, where the sum alone hides how they change.
pub fn read(scene: &Scene, measures: &mut Measures, low: &mut Lowering<'_>) -> Vec<usize> {
    let mut all = scene.items.iter().filter_map(|item| match item {
        SceneItem::Minimise { what } => Some(what),
        _ => None,
    });
    let Some(what) = all.next() else { return Vec::new() };
    let (objective, is_named) = (sought(what), what.name.is_some());
    let mut quantities = measures.quantities.iter();
    let Some(index) = quantities.position(|one| one.name == objective) else { return Vec::new() };
    let dimension = measures.kinds[index].dimension().pow(1, 2);
    let terms = low.graph.squares(measures.values[index]);
    let (Some(terms), Some(dimension)) = (terms, dimension) else { return Vec::new() };
    let (unit, first) = (Unit::for_dimension(&dimension), measures.values.len());
    let what = if is_named { objective.as_str() } else { "misfit" };
    for (index, term) in terms.into_iter().enumerate() {
        let text = format!("one of the numbers of whose squares {objective} is the sum");
        let quantity = quantity(&format!("{what} {}", index + 1), &text, &dimension, &unit);
        measures.add(quantity, Kind::Of(dimension), term, low);
    }
    (first..measures.values.len()).collect()
}
