//! A linkage moved along its task, by one of its drivers or in time, and looked at anywhere on it.

use super::extremes::Node;
use super::rates::Rates;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::position::assembly::Event;
use crate::closure::position::guide::Moves;
use crate::scalar::Dual;

/// Part of a task over which the change of an acceleration is taken.
const SHORT: f64 = 1e-5;

/// What moves a linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// The driver of this index goes over bounds, the others stand where they start.
    Driver(usize, (f64, f64)),
    /// All drivers move in time, from the first time to the second.
    Time(f64, f64),
}

impl Along {
    /// Where it begins and ends.
    pub fn bounds(self) -> (f64, f64) {
        match self {
            Self::Driver(_, bounds) => bounds,
            Self::Time(from, to) => (from, to),
        }
    }
}

/// The outputs and behind them the dependent coordinates at one place, with their rates.
pub(super) struct Look {
    at: f64,
    values: Vec<Dual>,
}

impl Look {
    /// One of them.
    pub fn of(&self, channel: usize) -> Node {
        let Dual { value, slope } = self.values[channel];
        Node { at: self.at, value, rate: slope }
    }
}

/// A linkage that is moved along.
pub(super) struct Track<'a> {
    assembly: Box<dyn Moves>,
    rates: Rates,
    linkage: &'a dyn AnyLinkage,
    along: Along,
    standing: Vec<f64>,
    /// Where modes of a group have met, and both go on.
    pub change_points: Vec<f64>,
}

impl<'a> Track<'a> {
    /// Puts a linkage together.
    ///
    /// # Errors
    /// As [`Assembly::start`](crate::closure::Assembly::start).
    pub fn new(linkage: &'a dyn AnyLinkage, along: Along) -> Result<Self, ClosureError> {
        let mut assembly = linkage.assemble();
        assembly.guide().start()?;
        Ok(Self {
            standing: assembly.guide().independents.to_vec(),
            assembly,
            rates: Rates::new(linkage),
            linkage,
            along,
            change_points: Vec::new(),
        })
    }

    /// Moves to a place and looks around.
    ///
    /// # Errors
    /// Why it does not get there.
    pub fn look(&mut self, at: f64) -> Result<Look, ClosureError> {
        let place = self.place(at)?;
        let independents = place[..self.standing.len()].iter().map(|x| x.value);
        self.assembly.travel(&independents.collect::<Vec<_>>())?;
        self.note_change_points(at);
        let values = self.rates.of(&mut self.assembly.guide(), &place);
        Ok(Look { at, values })
    }

    /// Remembers the change points that were passed on the way to a place, or that it is.
    fn note_change_points(&mut self, at: f64) {
        let mut guide = self.assembly.guide();
        let events = guide.take_events().into_iter();
        let passed = events.filter_map(|event| match (event, self.along) {
            (Event::ChangePoint { at, .. }, Along::Driver(index, _)) => at.get(index).copied(),
            (Event::ChangePoint { .. }, Along::Time(..)) => Some(at),
            _ => None,
        });
        let here = (!guide.stands.is_empty()).then_some(at);
        self.change_points.extend(passed.chain(here));
    }

    /// The independent variables at a place, in time with how they move behind them, and the rates of all that.
    fn place(&self, at: f64) -> Result<Vec<Dual>, ClosureError> {
        match self.along {
            Along::Driver(index, _) => {
                let mut place: Vec<_> = self.standing.iter().map(|x| Dual::constant(*x)).collect();
                place[index] = Dual::variable(at);
                Ok(place)
            }
            Along::Time(from, to) => {
                let step = SHORT * (to - from);
                let drive = |time| {
                    self.linkage.drive(time).ok_or(ClosureError::BadRange {
                        reason: "the drivers do not move in time".to_owned(),
                    })
                };
                let (here, ahead, behind) = (drive(at)?, drive(at + step)?, drive(at - step)?);
                let n = self.standing.len();
                // Behind positions stand speeds, accelerations and the time.
                let slope = |k: usize| match k {
                    _ if k < 2 * n => here[k + n],
                    _ => (ahead[k] - behind[k]) / (2.0 * step),
                };
                let dual = |k: usize| Dual { value: here[k], slope: slope(k) };
                Ok((0..here.len()).map(dual).collect())
            }
        }
    }
}
