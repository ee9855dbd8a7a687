//! Linkages of one kind that are weighed against others, looked at side by side at some places.
//!
//! What is furthest out at some places of a way is no further than the extreme of the whole way: it bounds measures, and mostly
//! tells that a linkage loses. Only those that do not are worth the exact way, [`super::measures`].

use super::track::Along;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::{Apart, Loops};
use crate::closure::linkage::problem::{Closure, Linkage};
use crate::dispatch::Task;
use crate::scalar::{Interval, Pack, WIDTH};
use crate::shape::{Kind, Shape};
use std::f64::consts::TAU;

/// Places of a way.
const PLACES: usize = 72;
/// Sine of a transmission angle below which a group may pass a change point between two places, and be in its other mode then.
const DEAD: f64 = 0.1;
/// Whole turns that angles make without changing quantities that count none.
const TURNS: [f64; 4] = [7.0, -19.0, 43.0, -91.0];
/// Places from one at which this is looked at to the next.
const EACH: usize = 12;
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
    /// Of each quantity whether it is the same whatever turns angles have made.
    is_same: Vec<bool>,
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
            is_same: vec![true; shape.measured],
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

    /// Takes what is seen at a place.
    fn see(&mut self, shape: &Shape, seen: &[f64]) {
        for (primitive, found) in shape.primitives.iter().zip(&mut self.found) {
            let (value, window) = (seen[primitive.argument], primitive.window);
            let holds = window.is_none_or(|window| seen[window] > 0.0);
            match primitive.kind {
                Kind::Peak if holds => found.low = found.low.max(value),
                Kind::Lowest if holds => found.high = found.high.min(value),
                _ => {}
            }
        }
    }

    /// Compares two sights of one place between which angles have turned.
    fn compare(&mut self, seen: &[f64], turned: &[f64]) {
        for ((is_same, a), b) in self.is_same.iter_mut().zip(seen).zip(turned) {
            *is_same &= (a - b).abs() <= NOTHING * (1.0 + a.abs());
        }
    }

    /// Between which bounds each primitive lies.
    fn bounds(&self) -> Vec<Interval> {
        let primitives = self.linkage.shape().primitives.iter().zip(&self.found);
        let bounds = primitives.map(|(primitive, found)| {
            let mut uses = [Some(primitive.argument), primitive.window].into_iter().flatten();
            if uses.all(|index| self.is_same[index]) { *found } else { Interval::ENTIRE }
        });
        bounds.collect()
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
    if let Some((first, _)) = sides.first() {
        let kind = first.linkage;
        kind.survey(Sides(sides.iter_mut().map(|one| &mut one.0).collect()));
    }
    for (side, bounds) in &sides {
        // In which mode it is beyond a change point is not known.
        if !side.is_unsure && (side.is_open || is_lost(side.index, &bounds(&side.bounds()))) {
            lost.push(side.index);
        }
    }
    lost
}

/// Linkages that are looked at at the same places.
pub struct Sides<'a, 'b>(Vec<&'b mut Side<'a>>);

/// The look at them on packs of numbers.
pub(in crate::closure) struct Looking<'a, 'b, 'c, L> {
    /// One of their kind.
    pub linkage: &'c L,
    pub sides: Sides<'a, 'b>,
}

impl<L: Linkage> Task for Looking<'_, '_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn run<P: Pack>(self) {
        let Self { linkage, mut sides } = self;
        for sides in sides.0.chunks_mut(P::WIDTH) {
            let values: Vec<P> = packed(sides, |side| side.values.clone());
            let modes: Vec<P> = packed(sides, |side| side.modes.clone());
            let loops = linkage.prepare::<P>(&values);
            let (zeros, loops) = (loops.zeros(), Apart(loops));
            for place in 0..PLACES {
                look(&loops, (zeros.as_ref(), &modes), sides, place);
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
    let at: Vec<P> = packed(sides, |side| side.place(place));
    let (drivers, motion) = at.split_at(shape.drivers.len().min(at.len()));
    let motion = if motion.len() == entry.motion { motion } else { &[] };
    let instant = loops.instant_row(drivers, motion);
    let (mut position, mut sine) = (zeros.to_vec(), [f64::NAN; WIDTH]);
    for (group, mode) in modes.iter().enumerate() {
        loops.close(group, &instant, *mode, &mut position).store(&mut sine);
        for (side, sine) in sides.iter_mut().zip(sine) {
            side.is_open |= sine.is_nan();
            side.is_unsure |= entry.groups[group].kind.has_modes() && sine.abs() < DEAD;
        }
    }
    let mut seen = vec![P::ZERO; shape.measured];
    loops.measured(&instant, &position, &mut seen);
    let seen = apart(&seen);
    if place.is_multiple_of(EACH) {
        for (index, _) in entry.angles.iter().enumerate().filter(|one| *one.1) {
            position[index] = position[index] + P::from_f64(TAU * TURNS[index % TURNS.len()]);
        }
        let mut turned = vec![P::ZERO; shape.measured];
        loops.measured(&instant, &position, &mut turned);
        for ((side, seen), turned) in sides.iter_mut().zip(&seen).zip(apart(&turned)) {
            side.compare(seen, &turned);
        }
    }
    for (side, seen) in sides.iter_mut().zip(seen) {
        side.see(shape, &seen);
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
