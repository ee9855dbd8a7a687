//! Linkages of one kind that are weighed against others, looked at side by side until each has shown that it is no good.
//!
//! What is furthest out at some places of a way is no further than the extreme of the whole way: it bounds measures, and mostly a
//! few places tell that a linkage loses. Only those that do not are worth the exact way, [`super::measures`].

use super::track::Along;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::{Apart, Loops, instant_at};
use crate::closure::linkage::problem::{Closure, Linkage};
use crate::dispatch::Task;
use crate::scalar::{Interval, Pack, WIDTH};
use crate::shape::{Kind, Shape};
use std::f64::consts::TAU;

/// Places of a way.
const PLACES: usize = 72;
/// How many of them have been looked at when linkages are left out that lose.
const ROUNDS: [usize; 4] = [4, 12, 32, PLACES];
/// From one place to that which is looked at next, so that few of them are spread over the way.
const NEXT: usize = 29;
/// Sine of a transmission angle below which a group may pass a dead point between two places, and change its mode.
const DEAD: f64 = 0.1;
/// Whole turns that angles make without changing quantities that count none.
const TURNS: [f64; 4] = [7.0, -19.0, 43.0, -91.0];
/// Part of a quantity that counts as none.
const NOTHING: f64 = 1e-9;

/// A linkage with what is known of it.
struct Side<'a> {
    linkage: &'a dyn AnyLinkage,
    /// Which one it is.
    index: usize,
    along: Along,
    values: Vec<f64>,
    /// Where the drivers stand that do not move.
    standing: Vec<f64>,
    /// Of each group.
    modes: Vec<f64>,
    /// Between which bounds each primitive lies.
    found: Vec<Interval>,
    /// Whether it does not close at a place.
    is_open: bool,
    /// Whether it has been so near to a dead point that its modes are not certain.
    is_unsure: bool,
}

impl<'a> Side<'a> {
    /// A linkage that has been put together.
    fn of(index: usize, linkage: &'a dyn AnyLinkage, along: Along) -> Result<Self, ClosureError> {
        let shape = linkage.shape();
        let mut assembly = linkage.assemble();
        let mut guide = assembly.guide();
        guide.start()?;
        let modes = (0..shape.loops().groups.len()).map(|group| guide.mode(group)).collect();
        Ok(Self {
            linkage,
            index,
            along,
            values: linkage.values(),
            standing: guide.independents.to_vec(),
            modes,
            found: vec![Interval::ENTIRE; shape.primitives.len()],
            is_open: false,
            is_unsure: false,
        })
    }

    /// The drivers at a place, and behind them how they move.
    fn place(&self, place: usize) -> Vec<f64> {
        let (from, to) = self.along.bounds();
        let at = from + (to - from) * ((place as f64 + 0.5) / PLACES as f64);
        let mut place = self.standing.clone();
        match self.along {
            Along::Driver(driver, _) => place[driver] = at,
            Along::Time(..) => place = self.linkage.drive(at).unwrap_or(place),
        }
        place
    }

    /// Takes what is seen at a place, `turned` being the same with angles that have made other turns.
    fn see(&mut self, shape: &Shape, seen: &[f64], turned: &[f64]) {
        let is_same = |index: usize| {
            (seen[index] - turned[index]).abs() <= NOTHING * (1.0 + seen[index].abs())
        };
        for (primitive, found) in shape.primitives.iter().zip(&mut self.found) {
            let (value, window) = (seen[primitive.argument], primitive.window);
            let holds = window.is_none_or(|window| seen[window] > 0.0 && is_same(window));
            if !holds || value.is_nan() || !is_same(primitive.argument) {
                continue;
            }
            match primitive.kind {
                Kind::Peak => found.low = found.low.max(value),
                Kind::Lowest => found.high = found.high.min(value),
                _ => {}
            }
        }
    }
}

/// Which linkages of one kind certainly lose on their ways. `is_lost` hears of each, by its index, between which bounds its measures
/// lie as far as is known; one that does not close loses in any case. Of linkages that are iterated, or that have no way, nothing
/// is said.
pub fn losers(
    linkages: &[(usize, Box<dyn AnyLinkage>)],
    is_lost: &dyn Fn(usize, &[Interval]) -> bool,
) -> Vec<usize> {
    let (mut lost, mut sides) = (Vec::new(), Vec::with_capacity(linkages.len()));
    for (index, linkage) in linkages {
        let is_closed_form = !linkage.shape().loops().is_iterated();
        let Some(along) = linkage.way().filter(|_| is_closed_form) else { continue };
        match Side::of(*index, &**linkage, along) {
            Ok(side) => sides.push((side, linkage.bounds())),
            Err(_) => lost.push(*index),
        }
    }
    let mut from = 0;
    for to in ROUNDS {
        let Some((first, _)) = sides.first() else { break };
        let kind = first.linkage;
        kind.survey(Round { sides: sides.iter_mut().map(|one| &mut one.0).collect(), from, to });
        sides.retain(|(side, bounds)| {
            let is_gone = match side.is_open {
                true => !side.is_unsure,
                false => !side.is_unsure && is_lost(side.index, &bounds(&side.found)),
            };
            lost.extend(is_gone.then_some(side.index));
            !is_gone
        });
        from = to;
    }
    lost
}

/// Linkages that are looked at at the same places.
pub struct Round<'a, 'b> {
    sides: Vec<&'b mut Side<'a>>,
    /// The first place, and the one behind the last.
    from: usize,
    to: usize,
}

/// The look at them on packs of numbers.
pub(in crate::closure) struct Looking<'a, 'b, 'c, L> {
    /// One of their kind.
    pub linkage: &'c L,
    pub round: Round<'a, 'b>,
}

impl<L: Linkage> Task for Looking<'_, '_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn run<P: Pack>(self) {
        let Self { linkage, mut round } = self;
        for sides in round.sides.chunks_mut(P::WIDTH) {
            let values: Vec<P> = packed(sides, |side| side.values.clone());
            let modes: Vec<P> = packed(sides, |side| side.modes.clone());
            let loops = linkage.prepare::<P>(&values);
            let (zeros, loops) = (loops.zeros(), Apart(loops));
            for place in round.from..round.to {
                look(&loops, (zeros.as_ref(), &modes), sides, place * NEXT % PLACES);
            }
        }
    }
}

/// Looks at some linkages at a place.
#[inline(always)]
fn look<P: Pack>(
    loops: &dyn Loops<P>,
    (zeros, modes): (&[P], &[P]),
    sides: &mut [&mut Side<'_>],
    place: usize,
) {
    let shape = loops.shape();
    let entry = shape.loops();
    let place: Vec<P> = packed(sides, |side| side.place(place));
    let (drivers, motion) = place.split_at(shape.drivers.len().min(place.len()));
    let motion = if motion.len() == entry.motion { motion } else { &[] };
    let instant = instant_at(loops, drivers, motion);
    let (mut position, mut sine) = (zeros.to_vec(), [f64::NAN; WIDTH]);
    for (group, mode) in modes.iter().enumerate() {
        loops.close(group, &instant, *mode, &mut position).store(&mut sine);
        for (side, sine) in sides.iter_mut().zip(sine) {
            side.is_open |= sine.is_nan();
            side.is_unsure |= entry.groups[group].kind.has_modes() && sine.abs() < DEAD;
        }
    }
    let (mut seen, mut turned) = (vec![P::ZERO; shape.measured], vec![P::ZERO; shape.measured]);
    loops.measured(&instant, &position, &mut seen);
    for (index, _) in entry.angles.iter().enumerate().filter(|one| *one.1) {
        position[index] = position[index] + P::from_f64(TAU * TURNS[index % TURNS.len()]);
    }
    loops.measured(&instant, &position, &mut turned);
    let [seen, turned] = [seen, turned].map(|all| apart(&all));
    for ((side, seen), turned) in sides.iter_mut().zip(seen).zip(turned) {
        side.see(shape, &seen, &turned);
    }
}

/// Numbers of linkages side by side. Where there are fewer of them than lanes, the last one is there several times.
#[inline(always)]
fn packed<P: Pack>(sides: &[&mut Side<'_>], numbers: impl Fn(&Side<'_>) -> Vec<f64>) -> Vec<P> {
    let lists: Vec<Vec<f64>> = sides.iter().map(|side| numbers(side)).collect();
    let lane = |lane: usize, index: usize| lists[lane.min(lists.len() - 1)][index];
    let pack = |index: usize| {
        let lanes: [f64; WIDTH] = std::array::from_fn(|one| lane(one, index));
        P::load(&lanes)
    };
    (0..lists[0].len()).map(pack).collect()
}

/// The numbers of each lane.
#[inline(always)]
fn apart<P: Pack>(packs: &[P]) -> [Vec<f64>; WIDTH] {
    let mut lists: [Vec<f64>; WIDTH] = std::array::from_fn(|_| Vec::with_capacity(packs.len()));
    for pack in packs {
        let mut lanes = [f64::NAN; WIDTH];
        pack.store(&mut lanes);
        lists.iter_mut().zip(lanes).for_each(|(list, lane)| list.push(lane));
    }
    lists
}
