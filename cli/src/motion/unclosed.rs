//! A loop that a motion carries along and that does not close, or comes to a dead point, in words.

use assur::hybrid::Motion;
use assur::model::Model;
use assur::registry::SceneEntry;
use assur::shape::Loop;

use crate::error::Told;
use crate::linkage::wording;
use crate::show::number;

/// Parts of a task at whose ends the loops are looked at. One that opens for less than a part is overlooked there.
const PARTS: usize = 2048;
/// Halvings of a part until the time at which a loop opens is known to the digits that are said.
const HALVINGS: usize = 40;
/// A motion that ends where a loop closes by less than this part of the most by which it did has come to a dead point.
const DEAD: f64 = 1e-3;

/// Why a motion that was followed so far could not be followed further, if a loop is the reason.
pub fn tell(scene: &SceneEntry, run: &dyn Model, motion: Option<&Motion>) -> Option<Told> {
    if scene.carried.is_empty() {
        return None;
    }
    opens(scene, run).or_else(|| comes_to_rest(scene, run, motion?))
}

/// Which loop that drivers alone move opens first in the task of a scene, when, and how large the gap becomes; nothing
/// where all stay closed.
fn opens(scene: &SceneEntry, run: &dyn Model) -> Option<Told> {
    let (mode, start) = (run.shape().first, run.start());
    let moved: Vec<f64> =
        start.iter().zip(run.shape().scales).map(|(one, scale)| one + 10.0 * scale).collect();
    let margin = |index: usize, time: f64| run.margins_in(mode, time, &start)[index];
    let (from, to) = run.span().limits();
    // What depends on the state is known only where the motion has been.
    let driven: Vec<usize> = (0..scene.carried.len())
        .filter(|&index| margin(index, from) == run.margins_in(mode, from, &moved)[index])
        .collect();
    let times = (0..=PARTS).map(|part| from + (to - from) * part as f64 / PARTS as f64);
    let times: Vec<f64> = times.collect();
    let is_open = |index: &usize, time: f64| margin(*index, time) < 0.0;
    let opens = |time: f64| driven.iter().copied().find(|index| is_open(index, time));
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

/// Which loop comes to a dead point where a motion ended.
fn comes_to_rest(scene: &SceneEntry, run: &dyn Model, motion: &Motion) -> Option<Told> {
    let piece = motion.pieces.last()?;
    let last = run.margins_in(piece.mode, motion.time, piece.trajectory.end());
    let mut most = vec![0.0_f64; last.len()];
    for piece in &motion.pieces {
        for time in piece.trajectory.times() {
            let margins = run.margins_in(piece.mode, *time, &piece.trajectory.at(*time));
            for (most, margin) in most.iter_mut().zip(margins) {
                *most = most.max(margin);
            }
        }
    }
    // A margin that is no number is beyond its end.
    let is_dead = |index: &usize| last[*index].is_nan() || last[*index] <= DEAD * most[*index];
    let index = (0..last.len()).find(is_dead)?;
    let Loop { name, unit, factor, .. } = scene.carried[index];
    let reason = format!(
        "at time = {} s {name} comes to a dead point: it closes by {} there, by up to {} before",
        number::short(number::rounded(motion.time, 6)),
        wording::gap(last[index].max(0.0), unit, factor),
        wording::gap(most[index], unit, factor),
    );
    Some(Told::new(
        reason,
        "choose another coordinate as the independent one, which does not come to rest there, or end the run before",
    ))
}
