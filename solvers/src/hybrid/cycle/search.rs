//! Follows a motion until it shows what attracts it, and closes that.

use super::super::HybridError;
use super::error::CycleError;
use super::lyapunov::{Stretch, frame};
use super::newton::Gap;
use super::returns::Past;
use super::{Cycle, FOLLOWED, PATIENCE, follow, phase};
use crate::model::Model;
use crate::ode::OdeError;
use crate::settings::Settings;

/// So near to its past, over the sizes of its states, a motion is closed at once.
const NEAR: f64 = 1e-4;
/// Nearer than this Newton's method may be tried.
const CLOSE: f64 = 3e-2;
/// A motion further away than this, over the sizes of the states, is not the one that was followed: Newton's method may
/// come to one elsewhere, and even to one in a mode in which no motion would be there.
const FAR: f64 = 0.5;
/// Motions that are nearer to each other, over the sizes of the states, are one.
const SAME: f64 = 1e-6;
/// Periods over which the distance from a motion is taken.
const BEATS: usize = 10;
/// How often a distance that dies out is compared with what the multipliers say.
const SPANS: usize = 2;
/// Difference of their logarithms that is let pass, for a fall by nothing, and more with the fall.
const ALIKE: f64 = 0.05;
/// Steps after which a motion is given up.
const STEPS: usize = 10_000_000;
/// The last periods over which the growth of disturbances is measured.
const GROWTH: usize = 100;

/// A motion under way.
struct Walk<'a> {
    model: &'a dyn Model,
    period: f64,
    settings: &'a Settings,
    mode: usize,
    state: Vec<f64>,
    past: Past,
    followed: usize,
    /// Steps so far.
    steps: usize,
    /// The events of the last period.
    events: Vec<(usize, usize)>,
    /// After how many periods it was nearest to its past, and how near.
    nearest: Option<(usize, f64)>,
    /// Mode and state that a period changed least, and by how much.
    calmest: Option<(usize, Vec<f64>, f64)>,
}

/// The stable motion that a start leads to and that repeats.
pub(super) fn search(
    model: &dyn Model,
    (mode, start): (usize, &[f64]),
    period: f64,
    settings: &Settings,
) -> Result<Cycle, CycleError> {
    if !(period.is_finite() && period > 0.0) {
        return Err(CycleError::BadPeriod { period });
    }
    let mut walk = Walk {
        model,
        period,
        settings,
        mode,
        state: start.to_vec(),
        past: Past::new(model.shape().scales),
        followed: 0,
        steps: 0,
        events: Vec::new(),
        nearest: None,
        calmest: None,
    };
    walk.past.add(mode, start);
    let mut unstable: Option<Cycle> = None;
    // Where the motion comes near to its past it is closed; at the end of each part in any case.
    for limit in [FOLLOWED, FOLLOWED + PATIENCE] {
        let mut tried = 0;
        while walk.followed < limit {
            walk.turn()?;
            let is_last = walk.followed == limit;
            let Some((multiple, distance)) = walk.nearest else {
                continue;
            };
            // A failed attempt is not repeated before the motion has gone on for a while.
            let is_due = distance <= NEAR && walk.followed >= tried + 10;
            if !(is_due || (is_last && distance <= CLOSE)) {
                continue;
            }
            tried = walk.followed;
            match walk.close(multiple)? {
                Some(cycle) if !cycle.is_stable() => unstable = Some(cycle),
                Some(cycle) if walk.is_within(FAR, &cycle) => return walk.begun(cycle),
                _ => {}
            }
        }
        // A simple motion may repeat though nothing is attracted by it, or very slowly. An irregular motion comes near to
        // those within it now and then, and a period changes it little there.
        let here = Some((walk.mode, walk.state.clone()));
        let calmest = walk.calmest.as_ref();
        let calmest = calmest.map(|(mode, state, _)| (*mode, state.clone()));
        for (mode, state) in here.into_iter().chain(calmest) {
            if unstable.as_ref().is_some_and(|cycle| cycle.multiple == 1) {
                break;
            }
            let Some(cycle) = walk.close_from(1, mode, &state)? else {
                continue;
            };
            if !cycle.is_stable() {
                unstable = Some(cycle);
            } else if walk.is_within(CLOSE, &cycle) || walk.comes_to(&cycle)? {
                return Ok(cycle);
            }
        }
    }
    Err(CycleError::NoneStable {
        followed: walk.followed,
        nearest: walk.nearest,
        growth: walk.growth()?,
        unstable: unstable.map(Box::new),
    })
}

/// The events of a motion, each with its mode.
fn passed(motion: &super::Motion) -> Vec<(usize, usize)> {
    let events = motion.events.iter();
    events.map(|one| (one.from, one.event)).collect()
}

impl Walk<'_> {
    /// One period.
    fn turn(&mut self) -> Result<(), CycleError> {
        let motion = self.follow(self.mode, &self.state)?;
        self.steps += motion.statistics.steps + motion.statistics.rejected;
        if self.steps > STEPS {
            let error = OdeError::TooManySteps {
                time: self.followed as f64 * self.period,
                steps: self.steps,
            };
            let (mode, motion) = (motion.mode, Box::new(motion));
            let error = HybridError::Ode { error, mode, motion };
            return Err(error.into());
        }
        self.events = passed(&motion);
        if motion.mode == self.mode {
            let change = self.apart(&motion.end, &self.state);
            if self.calmest.as_ref().is_none_or(|(.., least)| change < *least) {
                self.calmest = Some((self.mode, self.state.clone(), change));
            }
        }
        self.mode = motion.mode;
        self.state = motion.end;
        self.followed += 1;
        self.nearest = self.past.add(self.mode, &self.state);
        Ok(())
    }

    fn follow(&self, mode: usize, start: &[f64]) -> Result<super::Motion, CycleError> {
        Ok(follow(self.model, mode, (0.0, self.period), start, self.settings)?)
    }

    /// The motion that repeats after so many periods near here, or after fewer if that is one and the same.
    fn close(&self, multiple: usize) -> Result<Option<Cycle>, CycleError> {
        self.close_from(multiple, self.mode, &self.state)
    }

    /// Closes a cycle of so many periods near any state.
    fn close_from(
        &self,
        multiple: usize,
        mode: usize,
        state: &[f64],
    ) -> Result<Option<Cycle>, CycleError> {
        let of = |multiple: usize| self.gap(multiple, mode);
        let mut divisors = (1..multiple).filter(|one| multiple.is_multiple_of(*one));
        let found = of(multiple).close(state, self.followed)?;
        let Some(cycle) = &found else {
            return divisors
                .find_map(|one| of(one).close(state, self.followed).transpose())
                .transpose();
        };
        // What repeats sooner is not several motions. Just beyond a doubling of the period the shorter motion is near as
        // well, and no longer stable.
        let alike = self.alike();
        for divisor in divisors {
            if let Some(sooner) = of(divisor).close(&cycle.start(), self.followed)?
                && self.apart(&sooner.start(), &cycle.start()) <= alike
            {
                return Ok(Some(sooner));
            }
        }
        Ok(found)
    }

    /// Difference of motions, over the sizes of the states, up to which they are one.
    fn alike(&self) -> f64 {
        SAME.max(1e3 * self.settings.rtol)
    }

    /// A motion of several periods, begun in the one that `phase` states.
    fn begun(&self, cycle: Cycle) -> Result<Cycle, CycleError> {
        let begin = |number: usize| cycle.motion.at(number as f64 * self.period);
        let begins: Vec<_> = (0..cycle.multiple).map(begin).collect();
        let number = phase::first(&begins, self.past.sizes(), self.alike());
        if number == 0 {
            return Ok(cycle);
        }
        let (mode, state) = &begins[number];
        let moved = self.gap(cycle.multiple, *mode).close(state, self.followed)?;
        Ok(moved.unwrap_or(cycle))
    }

    /// The motion over so many periods from a mode, to be closed.
    fn gap(&self, multiple: usize, mode: usize) -> Gap<'_> {
        Gap {
            model: self.model,
            mode,
            period: self.period,
            multiple,
            is_free: false,
            sizes: self.past.sizes(),
            settings: self.settings,
        }
    }

    /// Whether the motion comes nearer to one that repeats, as quickly as its multipliers say, and through the same events.
    /// What dies out slowly is far away for long; what is irregular may come nearer for a while, but not so.
    fn comes_to(&mut self, cycle: &Cycle) -> Result<bool, CycleError> {
        let (start, expected) = (cycle.start(), passed(&cycle.motion));
        let slowest = cycle.multipliers.first().map_or(0.0, |one| one.modulus());
        let fall = slowest.ln() * (GROWTH + BEATS) as f64;
        let mut before = self.farthest(&start)?;
        for _ in 0..SPANS {
            for _ in 0..GROWTH {
                self.turn()?;
            }
            let after = self.farthest(&start)?;
            let off = ((after / before).ln() - fall).abs();
            if !(after < before && off <= ALIKE * (1.0 - fall)) || self.events != expected {
                return Ok(false);
            }
            before = after;
        }
        Ok(true)
    }

    /// The largest distance from a state over some periods, over which what swings shows its size.
    fn farthest(&mut self, start: &[f64]) -> Result<f64, CycleError> {
        let mut farthest = 0.0;
        for _ in 0..BEATS {
            self.turn()?;
            farthest = self.apart(start, &self.state).max(farthest);
        }
        Ok(farthest)
    }

    /// Whether a motion that repeats is as near to the one that was followed, over the sizes of the states.
    fn is_within(&self, limit: f64, cycle: &Cycle) -> bool {
        self.apart(&cycle.start(), &self.state) <= limit
    }

    /// How far two states are from each other, over the sizes of the states.
    fn apart(&self, one: &[f64], other: &[f64]) -> f64 {
        let pairs = one.iter().zip(other).zip(self.past.sizes());
        let far = pairs.map(|((a, b), size)| (a - b).abs() / size);
        far.fold(0.0, f64::max)
    }

    /// By what factor small disturbances grow in a period, on average over the periods that follow.
    fn growth(&self) -> Result<f64, CycleError> {
        let mut stretch = Stretch {
            model: self.model,
            period: self.period,
            sizes: self.past.sizes(),
            settings: self.settings,
            mode: self.mode,
            state: self.state.clone(),
            frame: frame(self.state.len()),
        };
        let grown = stretch.advance(GROWTH)?;
        Ok((grown[0] / GROWTH as f64).exp())
    }
}
