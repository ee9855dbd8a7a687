//! What holds at a place where a mechanism may rest.

use super::error::RestError;
use super::slopes::{Noise, Slopes};
use crate::model::{Flow, Model};
use crate::ode::larger;
use crate::problem::Phase;
use crate::shape::{Augmented, Quantity, Shape};
use nalgebra::{DMatrix, DVector};
use std::cell::Cell;

/// Places beside a state at which it is seen what rounding does.
const PROBES: usize = 8;

/// Times at which the same has to hold as at time 0, in seconds.
const TIMES: [f64; 3] = [0.137, 2.3, 71.9];

/// The equations of rest of a mode: no acceleration, no rate of a state, and closed closures.
pub struct Place<'a> {
    model: &'a dyn Model,
    pub flow: Flow<'a>,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Coordinates that can move, and states, by their places in the state vector.
    pub unknowns: Vec<usize>,
    closures: Option<Augmented>,
    /// Evaluations of the rates and of their slopes.
    evaluations: Cell<(usize, usize)>,
}

impl<'a> Place<'a> {
    /// The equations of a mode, at a state at which they have values.
    pub fn new(model: &'a dyn Model, mode: usize, state: &[f64]) -> Result<Self, RestError> {
        let shape = model.shape();
        let refused = |reason: String| Err(RestError::Start { reason });
        if state.len() != shape.states.len() {
            return refused(format!(
                "a state has {} components, not {}",
                shape.states.len(),
                state.len()
            ));
        }
        let entry = shape.modes.get(mode);
        if entry.is_none() && mode > 0 {
            return refused(format!("there are {} modes, and no number {mode}", shape.modes.len()));
        }
        let closures = shape.held_in(mode);
        let n = shape.coordinates;
        let held = entry.map_or(&[][..], |entry| entry.held);
        let moves = |index: &usize| !held.contains(&(n + index));
        let unknowns = (0..n).filter(moves).chain(2 * n..state.len()).collect();
        let (flow, evaluations) = (Flow::new(model, mode), Cell::default());
        let place = Self { model, flow, coordinates: n, unknowns, closures, evaluations };
        let state = place.still(state);
        let rates = place.rates(&state);
        match rates.iter().chain(&state).position(|value| !value.is_finite()) {
            Some(index) => {
                let name = shape.states[index % state.len()].name;
                refused(format!("the equations of {name} have no value"))
            }
            None => Ok(place),
        }
    }

    /// What the scene is made of.
    pub fn shape(&self) -> &'a Shape {
        self.flow.shape()
    }

    /// A state with all speeds zero.
    pub fn still(&self, state: &[f64]) -> Vec<f64> {
        let mut still = state.to_vec();
        still[self.coordinates..2 * self.coordinates].fill(0.0);
        still
    }

    /// The time derivative of the state.
    pub fn rates(&self, state: &[f64]) -> Vec<f64> {
        self.rates_at(0.0, state)
    }

    fn rates_at(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; state.len()];
        self.flow.rates(time, state, &mut rates);
        let (count, slopes) = self.evaluations.get();
        self.evaluations.set((count + 1, slopes));
        rates
    }

    /// How often rates and slopes have been evaluated.
    pub fn evaluations(&self) -> (usize, usize) {
        self.evaluations.get()
    }

    /// Refuses what moves with the time: at the start it is pushed in another way later.
    pub fn check_time(&self, start: &[f64]) -> Result<(), RestError> {
        let start = self.still(start);
        let rates = self.rates(&start);
        for time in TIMES {
            let later = self.rates_at(time, &start);
            let differs = rates.iter().zip(&later).position(|(a, b)| a != b);
            if let Some(index) = differs {
                return Err(RestError::Driven { name: self.shape().states[index].name, time });
            }
        }
        Ok(())
    }

    /// `∂f/∂y`.
    pub fn jacobian(&self, state: &[f64]) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(state.len(), state.len());
        self.flow.jacobian(0.0, state, matrix.as_mut_slice());
        let (rates, count) = self.evaluations.get();
        self.evaluations.set((rates, count + 1));
        matrix
    }

    /// The rate that is zero at rest, by the unknown that it belongs to.
    fn rate_of(&self, unknown: usize) -> usize {
        if unknown < self.coordinates { self.coordinates + unknown } else { unknown }
    }

    /// Speeds and states whose rates are zero at rest.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        let states: &'static [Quantity] = self.shape().states;
        self.unknowns.iter().map(|unknown| states[self.rate_of(*unknown)].name)
    }

    /// What is zero at rest: accelerations and rates of the unknowns, then the closures.
    pub fn residual(&self, state: &[f64]) -> DVector<f64> {
        let rates = self.rates(state);
        let own = self.unknowns.iter().map(|unknown| rates[self.rate_of(*unknown)]);
        let closures = self.closures(state).0;
        DVector::from_vec(own.chain(closures).collect())
    }

    /// States a few roundings beside one.
    pub fn around(state: &[f64]) -> impl Iterator<Item = Vec<f64>> {
        (1..=PROBES).map(|probe| {
            let aside = state.iter().enumerate().map(|(index, value)| {
                let sign = if (index + probe) % 2 == 0 { 1.0 } else { -1.0 };
                value * (1.0 + sign * (probe as f64) * f64::EPSILON)
            });
            aside.collect()
        })
    }

    /// The slopes of that by the unknowns, over the scales of these, and what rounding makes of both.
    pub fn slopes(&self, state: &[f64]) -> Slopes {
        let matrix = self.scaled(state);
        let residual = self.residual(state);
        let around: Vec<Vec<f64>> = Self::around(state).collect();
        let slopes = around.iter().map(|aside| (self.scaled(aside) - &matrix).abs());
        let slopes: Vec<DMatrix<f64>> = slopes.collect();
        let residuals = around.iter().map(|aside| (self.residual(aside) - &residual).abs());
        let residuals: Vec<DVector<f64>> = residuals.collect();
        // Not the largest: across a switching surface, where half of them are, the difference is no rounding.
        let middle = |all: &mut dyn Iterator<Item = f64>| {
            let mut all: Vec<f64> = all.collect();
            all.sort_by(f64::total_cmp);
            all[PROBES / 2 - 1]
        };
        let noise = Noise {
            slopes: DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
                middle(&mut slopes.iter().map(|one| one[(row, column)]))
            }),
            residual: DVector::from_fn(matrix.nrows(), |row, _| {
                middle(&mut residuals.iter().map(|one| one[row]))
            }),
        };
        let scales = self.shape().scales;
        let places = self.unknowns.iter().map(|unknown| (*unknown, scales[*unknown]));
        Slopes::new(matrix, noise, places.collect(), state.len(), self.closures.is_some())
    }

    fn scaled(&self, state: &[f64]) -> DMatrix<f64> {
        let jacobian = self.jacobian(state);
        let (_, closures) = self.closures(state);
        let (own, rows) = (self.unknowns.len(), self.unknowns.len() + closures.nrows());
        let scales = self.shape().scales;
        DMatrix::from_fn(rows, own, |row, column| {
            let by = self.unknowns[column];
            scales[by]
                * match row.checked_sub(own) {
                    None => jacobian[(self.rate_of(self.unknowns[row]), by)],
                    Some(closure) if by < self.coordinates => closures[(closure, by)],
                    Some(_) => 0.0,
                }
        })
    }

    /// The closures that hold the coordinates, and their slopes by these.
    fn closures(&self, state: &[f64]) -> (Vec<f64>, DMatrix<f64>) {
        let Some(closures) = self.closures else {
            return (Vec::new(), DMatrix::zeros(0, self.coordinates));
        };
        let (n, m) = (self.coordinates, closures.loops.len());
        let mut values = vec![0.0; m * (2 + n)];
        self.model.reports().closures(Phase::of(self.flow.mode()), 0.0, state, &mut values);
        let slopes = DMatrix::from_row_slice(m, n, &values[2 * m..]);
        (values[..m].to_vec(), slopes)
    }

    /// What components of the state are measured by; a speed like its coordinate.
    pub fn sizes(&self) -> Vec<f64> {
        let mut sizes = self.shape().scales.to_vec();
        sizes.copy_within(..self.coordinates, self.coordinates);
        sizes
    }

    /// Columns that span what the closures allow of the state, those of rest among the unknowns and their speeds; SI units.
    pub fn allowed(&self, state: &[f64]) -> DMatrix<f64> {
        let (n, scales) = (self.coordinates, self.shape().scales);
        let moving: Vec<usize> = self.unknowns.iter().copied().filter(|one| *one < n).collect();
        let (_, slopes) = self.closures(state);
        let scaled = DMatrix::from_fn(slopes.nrows(), moving.len(), |row, column| {
            slopes[(row, moving[column])] * scales[moving[column]]
        });
        let free = super::slopes::nullspace(&scaled);
        let own = self.unknowns.len() - moving.len();
        let mut columns = DMatrix::zeros(state.len(), 2 * free.ncols() + own);
        for column in 0..free.ncols() {
            for (row, place) in moving.iter().enumerate() {
                let share = free[(row, column)] * scales[*place];
                columns[(*place, column)] = share;
                columns[(n + place, free.ncols() + column)] = share;
            }
        }
        for (index, place) in self.unknowns[moving.len()..].iter().enumerate() {
            columns[(*place, 2 * free.ncols() + index)] = scales[*place];
        }
        columns
    }

    /// The largest component over its scale; not a number where one is not.
    pub fn length(&self, change: &[f64]) -> f64 {
        let parts =
            change.iter().zip(self.shape().scales).map(|(change, scale)| change.abs() / scale);
        parts.fold(0.0, larger)
    }

    /// That Newton's method has not come to an end.
    pub fn unsettled(&self, state: &[f64], iterations: usize) -> RestError {
        let residual = self.residual(state);
        let scales = self.unknowns.iter().map(|unknown| self.shape().scales[*unknown]);
        let rates = self.names().zip(residual.iter().copied()).zip(scales);
        let over =
            |rate: f64, scale: f64| if rate.is_nan() { f64::INFINITY } else { rate.abs() / scale };
        let largest =
            rates.max_by(|((_, a), x), ((_, b), y)| over(*a, *x).total_cmp(&over(*b, *y)));
        let (name, rate) = largest.map_or(("", 0.0), |(largest, _)| largest);
        RestError::Unsettled { name, rate, iterations }
    }

    /// The same on a side of a switching surface.
    pub fn beside(&self, surface: usize, side: f64) -> Self {
        let mut flow = Flow::new(self.model, self.flow.mode());
        flow.put(surface, side);
        let (unknowns, evaluations) = (self.unknowns.clone(), Cell::default());
        Self { model: self.model, flow, unknowns, evaluations, ..*self }
    }
}
