//! Keeps a motion on the closures that hold its coordinates.
//!
//! The equations keep the second time derivative of the closures at zero; what an integration leaves of the closures and
//! of their first derivative is taken out again once an accepted step, by the shortest change of positions and then of
//! speeds. Where closures depend on each other for an instant, what is nearly undetermined is left for the next step.

use super::Model;
use crate::dense::Parts;
use crate::ode::OdeError;
use crate::problem::{Phase, Refused, Reports, Scene, Span};
use crate::shape::{Augmented, Loop, Shape};

/// Part of its size by which a closure may stay open.
const OPEN: f64 = 1e-6;
/// Pivots below this are left out where a step is corrected, and where the motion begins.
const NOTHING: [f64; 2] = [1e-4, 1e-9];
/// Most corrections of a step, and of a start.
const MOST: [usize; 2] = [4, 60];
/// What is left then, in roundings.
const ROUNDED: f64 = 8.0;

/// Room for corrections.
pub(super) struct Correction {
    closures: Augmented,
    values: Vec<f64>,
    matrix: Vec<f64>,
    reduced: Vec<f64>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    right: Vec<f64>,
    room: Vec<f64>,
    /// Coordinates that do not move.
    held: Vec<bool>,
}

impl Correction {
    /// For a scene whose closures are not solved for.
    pub fn of(shape: &Shape) -> Option<Self> {
        let closures = shape.augmented?;
        let (n, m) = (closures.coordinates, closures.loops.len());
        let size = n + m;
        Some(Self {
            closures,
            values: vec![0.0; m * (2 + n)],
            matrix: vec![0.0; size * size],
            reduced: vec![0.0; size * size],
            rows: vec![0; size],
            columns: vec![0; size],
            right: vec![0.0; size],
            room: vec![0.0; size],
            held: vec![false; n],
        })
    }

    /// Corrects what a step has reached.
    pub fn correct(
        &mut self,
        model: &dyn Model,
        phase: Phase<'_, f64>,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), OdeError> {
        self.held.fill(false);
        if let Some(mode) = model.shape().modes.get(phase.mode) {
            mode.held.iter().for_each(|place| self.held[*place - self.closures.coordinates] = true);
        }
        self.close(model.reports(), phase, time, state, 0).map_err(|(closure, by)| OdeError::Open {
            time,
            closure,
            by,
        })
    }

    /// Closes all closures by positions that are not held, then their rates by speeds. Fails with the closure that stays open
    /// most, and by how much.
    fn close(
        &mut self,
        reports: &dyn Reports<f64>,
        phase: Phase<'_, f64>,
        time: f64,
        state: &mut [f64],
        kind: usize,
    ) -> Result<(), (usize, f64)> {
        let (n, m) = (self.closures.coordinates, self.closures.loops.len());
        let mut last = f64::INFINITY;
        for _ in 0..MOST[kind] {
            reports.closures(phase, time, state, &mut self.values);
            let moved = self.solve(0, NOTHING[kind]);
            let open = self.open();
            // Far from closed a step may be too long; a rounding goes on without end.
            let part = if open > 2.0 * last { 0.5 } else { 1.0 };
            for (place, change) in state[..n].iter_mut().zip(&self.right) {
                *place += part * change;
            }
            let scale = state[..n].iter().fold(1.0_f64, |most, one| most.max(one.abs()));
            if moved <= ROUNDED * f64::EPSILON * scale || moved.is_nan() {
                break;
            }
            last = open;
        }
        reports.closures(phase, time, state, &mut self.values);
        self.solve(m, NOTHING[kind]);
        for (speed, change) in state[n..2 * n].iter_mut().zip(&self.right) {
            *speed += change;
        }
        let slopes = &self.values[2 * m..];
        let worst = (0..m).map(|row| {
            let slopes = slopes[row * n..][..n].iter().zip(&state[..n]);
            let size = slopes.fold(0.0_f64, |most, (slope, place)| {
                most.max(slope.abs()).max((slope * place).abs())
            });
            (row, self.values[row].abs(), self.values[row].abs() / size.max(f64::MIN_POSITIVE))
        });
        match worst.max_by(|a, b| a.2.total_cmp(&b.2)) {
            Some((row, by, part)) if !(part <= OPEN) => Err((row, by)),
            _ => Ok(()),
        }
    }

    /// How far the closures are open.
    fn open(&self) -> f64 {
        let open = self.values[..self.closures.loops.len()].iter();
        open.fold(0.0, |most, one| if one.abs() <= most { most } else { one.abs() })
    }

    /// The shortest change that takes residuals away, which stand from a place on. Gives its largest component.
    fn solve(&mut self, from: usize, nothing: f64) -> f64 {
        let (n, m) = (self.closures.coordinates, self.closures.loops.len());
        let size = n + m;
        self.matrix.fill(0.0);
        for column in 0..n {
            self.matrix[column * size + column] = 1.0;
        }
        for row in 0..m {
            let slopes = &self.values[2 * m + row * n..][..n];
            for (column, slope) in slopes.iter().enumerate().filter(|one| !self.held[one.0]) {
                self.matrix[(n + row) * size + column] = *slope;
            }
            self.right[n + row] = -self.values[from + row];
        }
        self.right[..n].fill(0.0);
        let mut parts = Parts { unknowns: n, closures: m, rank: self.closures.rank };
        let order = (&mut self.rows[..], &mut self.columns[..]);
        parts.factor(&mut self.matrix, &mut self.reduced, order, nothing);
        let order = (&self.rows[..], &self.columns[..]);
        let both = (&mut self.right[..], &mut self.room[..]);
        parts.solve(&self.matrix, &self.reduced, order, both);
        self.right[..n]
            .iter()
            .fold(0.0, |most, one| if one.abs() <= most { most } else { one.abs() })
    }
}

/// The state in which a motion begins: positions and speeds that are kept, and for the others what closures make of those.
///
/// # Errors
/// The closure that does not close, and by how much.
pub fn assemble<C: Scene>(scene: &C, mut start: Vec<f64>) -> Result<Vec<f64>, Refused> {
    let shape = C::shape();
    let Some(mut correction) = Correction::of(shape) else {
        return Ok(start);
    };
    for kept in correction.closures.kept {
        correction.held[*kept] = true;
    }
    let time = match scene.span() {
        Span::Run(from, _) => from,
        _ => 0.0,
    };
    let equations = scene.prepare::<f64>();
    match correction.close(&equations, Phase::of(shape.first), time, &mut start, 1) {
        Ok(()) => Ok(start),
        Err((closure, by)) => {
            let Loop { name, unit, factor, .. } = correction.closures.loops[closure];
            Err(Refused {
                name: name.to_string(),
                reason: format!(
                    "does not close where the motion begins: it stays open by {:.3e} {unit}; change the dimensions or the start values",
                    by / factor
                ),
            })
        }
    }
}

/// [`assemble`], or the start as it is stated where that fails.
pub fn begin<C: Scene>(scene: &C, start: Vec<f64>) -> Vec<f64> {
    assemble(scene, start.clone()).unwrap_or(start)
}
