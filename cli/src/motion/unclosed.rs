//! A loop that a motion carries along and that does not close, in words.

use assur::model::Model;
use assur::registry::SceneEntry;
use assur::shape::Loop;

use crate::error::Told;
use crate::linkage::wording;
use crate::show::number;

/// Parts of a task at whose ends the loops are looked at. One that opens for less than a part is overlooked.
const PARTS: usize = 2048;
/// Halvings of a part until the time at which a loop opens is known to the digits that are said.
const HALVINGS: usize = 40;

/// Which loop opens first in the task of a scene, when, and how large the gap becomes; nothing where all stay closed.
pub fn tell(scene: &SceneEntry, run: &dyn Model) -> Option<Told> {
    let start = run.start();
    let margin = |index: usize, time: f64| run.margins_in(run.shape().first, time, &start)[index];
    let (from, to) = run.span().limits();
    let times = (0..=PARTS).map(|part| from + (to - from) * part as f64 / PARTS as f64);
    let times: Vec<f64> = times.collect();
    let is_open = |index: &usize, time: f64| margin(*index, time) < 0.0;
    let opens = |time: f64| (0..scene.carried.len()).find(|index| is_open(index, time));
    let (part, index) = (0..times.len()).find_map(|part| Some((part, opens(times[part])?)))?;
    let gaps = times.iter().map(|time| (-margin(index, *time), *time));
    let (gap, at) = gaps.fold((0.0, from), |a, b| if b.0 > a.0 { b } else { a });
    let mut what = "the links do not meet".to_owned();
    if part > 0 {
        let (mut closed, mut open) = (times[part - 1], times[part]);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (closed + open);
            match is_open(&index, middle) {
                true => open = middle,
                false => closed = middle,
            }
        }
        let time = number::short(number::rounded(open, 6));
        what = format!("at time = {time} s the links part");
    }
    let Loop { name, unit, factor, .. } = scene.carried[index];
    let reason = format!(
        "{what}: a gap of up to {} (at time = {} s) is left in {name}",
        wording::gap(gap, unit, factor),
        number::short(number::rounded(at, 4)),
    );
    Some(Told::new(reason, "check the dimensions, those given with --set first"))
}
