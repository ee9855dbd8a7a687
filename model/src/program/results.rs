//! What the functions of a program return, as expressions while it is asked for and as values once it is built.

use super::{Closing, Event, Value};

/// The functions that compute events, by number.
const EVENTS: usize = 14;

/// The functions of a program: which values each returns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results<T = Value> {
    /// `y'`, one value for each component of the state.
    pub derivative: Vec<T>,
    /// Nonzero entries of `∂y'/∂y`: row, column, value.
    pub jacobian: Vec<(u32, u32, T)>,
    /// In place of its entries its product with a column, where there are many.
    pub along: Vec<T>,
    /// Outputs in their declared order.
    pub outputs: Vec<T>,
    /// Positions of the drivers.
    pub drivers: Vec<T>,
    /// Lower triangle of the mass matrix, row by row; empty when there is none.
    pub mass: Vec<T>,
    /// Kinetic and potential energy; empty when none is stated.
    pub energy: Vec<T>,
    /// Conditions on the values, in the order of the scene's `requirements`.
    pub requirements: Vec<T>,
    /// Period, or start and end time.
    pub span: Vec<T>,
    /// Start values of the state; of a linkage rough ones of the dependent coordinates, no number where none is stated.
    pub start: Vec<T>,
    /// What a linkage computes.
    pub closing: Closing<T>,
    /// Of a motion the places of points, and behind them of forces, x and y of each.
    pub points: Vec<T>,
    /// What measures look at.
    pub measured: Vec<T>,
    /// The measures, from what has been found of a run.
    pub measures: Vec<T>,
    /// By how much the loops that the motion carries along close, in the order of the scene's `carried`.
    pub margins: Vec<T>,
    /// What the events of a mode compute, the switching surfaces behind them, then the kinks of guards, and last the angles
    /// that turn in them.
    pub events: Vec<Event<T>>,
}

impl<T: Copy> Results<T> {
    /// The results with other values in the places of these, made always in the same order.
    pub fn map<U>(&self, mut new: impl FnMut(T) -> U) -> Results<U> {
        let derivative = self.derivative.iter().map(|one| new(*one)).collect();
        let slopes = self.jacobian.iter();
        let slopes = slopes.map(|(row, column, value)| (*row, *column, new(*value)));
        let jacobian = slopes.collect();
        let mut each = |list: &[T]| list.iter().map(|one| new(*one)).collect();
        Results {
            derivative,
            jacobian,
            along: each(&self.along),
            outputs: each(&self.outputs),
            drivers: each(&self.drivers),
            mass: each(&self.mass),
            energy: each(&self.energy),
            requirements: each(&self.requirements),
            span: each(&self.span),
            start: each(&self.start),
            measured: each(&self.measured),
            measures: each(&self.measures),
            margins: each(&self.margins),
            points: each(&self.points),
            closing: self.closing.map(|one| new(*one)),
            events: self.events.iter().map(|event| event.map(&mut new)).collect(),
        }
    }

    /// All values in one list, in that order.
    pub fn all(&self) -> Vec<T> {
        let mut list = Vec::new();
        self.map(|one| list.push(one));
        list
    }

    /// The results with the values of a list as [`Self::all`] gives it.
    pub fn with<U: Default>(&self, values: Vec<U>) -> Results<U> {
        let mut values = values.into_iter();
        self.map(|_| values.next().unwrap_or_default())
    }

    /// What the slopes of the rates are made of.
    pub fn slopes(&self) -> impl Iterator<Item = T> {
        self.jacobian.iter().map(|entry| entry.2).chain(self.along.iter().copied())
    }

    /// How many values an evaluation of the rates and of their slopes takes: the first of all.
    pub(super) fn often(&self) -> usize {
        self.derivative.len() + self.jacobian.len() + self.along.len()
    }

    /// The places of what positions are asked for, among all values.
    pub(super) fn reported(&self) -> Vec<usize> {
        let mut marks = self.map(|_| false);
        for list in [&mut marks.outputs, &mut marks.energy, &mut marks.measured] {
            list.fill(true);
        }
        let marks = marks.all().into_iter().enumerate();
        marks.filter(|(_, is_marked)| *is_marked).map(|(place, _)| place).collect()
    }

    /// For each of all values the function that computes it, as a number.
    pub(super) fn functions(&self) -> Vec<usize> {
        let lists = [
            self.derivative.len(),
            self.jacobian.len(),
            self.along.len(),
            self.outputs.len(),
            self.drivers.len(),
            self.mass.len(),
            self.energy.len(),
            self.requirements.len(),
            self.span.len(),
            self.start.len(),
            self.measured.len(),
            self.measures.len(),
            self.margins.len(),
            self.points.len(),
        ];
        let lists = lists.into_iter().enumerate();
        let repeated = lists.flat_map(|(function, count)| std::iter::repeat_n(function, count));
        let mut functions: Vec<usize> = repeated.collect();
        functions.extend(self.closing.functions(EVENTS + 1));
        functions.resize(self.all().len(), EVENTS);
        functions
    }
}
