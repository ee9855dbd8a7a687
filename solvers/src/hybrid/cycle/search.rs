//! Follows a motion until it shows what attracts it, and closes that.

use super::error::CycleError;
use super::flow::Flow;
use super::lyapunov::{Stretch, frame};
use super::newton::Gap;
use super::returns::Past;
use super::{Cycle, FOLLOWED, PATIENCE};
use crate::registry::Settings;

/// So near to its past, over the sizes of its states, a motion is closed at once.
const NEAR: f64 = 1e-4;
/// Nearer than this Newton's method may be tried.
const CLOSE: f64 = 3e-2;
/// A motion further away than this, over the sizes of the states, is not the one that was followed: Newton's method may
/// come to one elsewhere, and even to one in a mode in which no motion would be there.
const FAR: f64 = 0.5;
/// The last periods over which the growth of disturbances is measured.
const GROWTH: usize = 100;

/// A motion under way.
struct Walk<'a> {
    flow: &'a dyn Flow,
    period: f64,
    settings: &'a Settings,
    mode: usize,
    state: Vec<f64>,
    past: Past,
    followed: usize,
    /// After how many periods it was nearest to its past, and how near.
    nearest: Option<(usize, f64)>,
}

/// The stable motion that a start leads to and that repeats.
pub(super) fn search(
    flow: &dyn Flow,
    (mode, start): (usize, &[f64]),
    period: f64,
    settings: &Settings,
) -> Result<Cycle, CycleError> {
    if !(period.is_finite() && period > 0.0) {
        return Err(CycleError::BadPeriod { period });
    }
    let mut walk = Walk {
        flow,
        period,
        settings,
        mode,
        state: start.to_vec(),
        past: Past::new(flow.scales()),
        followed: 0,
        nearest: None,
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
                Some(cycle) if walk.is_within(FAR, &cycle) => return Ok(cycle),
                _ => {}
            }
        }
        // A simple motion may repeat though nothing is attracted by it.
        if unstable.is_none() {
            unstable = walk.close(1)?;
            if let Some(cycle) = unstable.take_if(|cycle| cycle.is_stable())
                && walk.is_within(CLOSE, &cycle)
            {
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

impl Walk<'_> {
    /// One period.
    fn turn(&mut self) -> Result<(), CycleError> {
        let motion = self.follow(self.mode, &self.state)?;
        self.mode = motion.mode;
        self.state = motion.end;
        self.followed += 1;
        self.nearest = self.past.add(self.mode, &self.state);
        Ok(())
    }

    fn follow(&self, mode: usize, start: &[f64]) -> Result<super::Motion, CycleError> {
        self.flow
            .follow(mode, (0.0, self.period), start, self.settings)
            .map_err(|error| CycleError::Motion(Box::new(error)))
    }

    /// The motion that repeats after so many periods near here, or after fewer.
    fn close(&self, multiple: usize) -> Result<Option<Cycle>, CycleError> {
        let of = |multiple: usize| Gap {
            flow: self.flow,
            mode: self.mode,
            period: self.period,
            multiple,
            sizes: self.past.sizes(),
            settings: self.settings,
        };
        let divisors = (1..multiple).filter(|one| multiple.is_multiple_of(*one));
        let mut unstable = None;
        for divisor in divisors {
            // What repeats sooner near here is not two motions.
            if let Some(cycle) = of(divisor).close(&self.state, self.followed)?
                && self.is_within(10.0 * NEAR, &cycle)
            {
                if cycle.is_stable() {
                    return Ok(Some(cycle));
                }
                unstable = unstable.or(Some(cycle));
            }
        }
        // Just beyond a doubling of the period the shorter motion is near as well, and no longer stable.
        let whole = of(multiple).close(&self.state, self.followed)?;
        match whole {
            Some(cycle) if cycle.is_stable() => Ok(Some(cycle)),
            other => Ok(unstable.or(other)),
        }
    }

    /// Whether a motion that repeats is as near to the one that was followed, over the sizes of the states.
    fn is_within(&self, limit: f64, cycle: &Cycle) -> bool {
        let start = cycle
            .motion
            .pieces
            .first()
            .map(|piece| piece.trajectory.at(0.0));
        start.is_some_and(|start| {
            let pairs = start.iter().zip(&self.state).zip(self.past.sizes());
            let far = pairs.map(|((a, b), size)| (a - b).abs() / size);
            far.fold(0.0, f64::max) <= limit
        })
    }

    /// By what factor small disturbances grow in a period, on average over the periods that follow.
    fn growth(&self) -> Result<f64, CycleError> {
        let mut stretch = Stretch {
            flow: self.flow,
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
