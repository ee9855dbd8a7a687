//! Keeps a motion on the closures that hold its coordinates.
//!
//! The equations keep the second time derivative of the closures at zero; what an integration leaves of the closures and
//! of their first derivative is taken out again once an accepted step, by the shortest change of positions and then of
//! speeds. Where closures depend on each other for an instant, what is nearly undetermined is left for the next step.

use super::Model;
use crate::dense::{Order, Parts, Reading, Scan, Writing};
use crate::ode::{OdeError, larger};
use crate::problem::{Phase, Refused, Reports, Scene, Span};
use crate::shape::{Augmented, Loop, Shape};

/// Over the size of its slopes, how far a closure may stay open.
const OPEN: f64 = 1e-6;
/// Pivots below this are left out where a step is corrected, and where the motion begins. Over a pivot, what closures round to
/// becomes a jump of positions, and over its square one of speeds: below a limit a correction does more harm than good.
const NOTHING: [f64; 2] = [1e-3, 1e-9];
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
    order: Order<Vec<u16>>,
    largest: Vec<(f64, u16)>,
    first: Vec<u16>,
    next: Vec<u16>,
    right: Vec<f64>,
    room: Vec<f64>,
    /// Coordinates that do not move.
    held: Vec<bool>,
    /// The masses by which a change is measured; none where all coordinates count alike.
    masses: Vec<f64>,
}

impl Correction {
    /// For a mode whose closures are not solved for.
    pub fn of(shape: &Shape, mode: usize) -> Option<Self> {
        let closures = shape.held_in(mode)?;
        let (n, m) = (closures.coordinates, closures.loops.len());
        let size = n + m;
        let held = shape.modes.get(mode).map_or(&[][..], |mode| mode.held);
        Some(Self {
            closures,
            values: vec![0.0; m * (2 + n)],
            matrix: vec![0.0; size * n],
            reduced: vec![0.0; n * n],
            order: Order {
                lists: vec![0; size * n],
                lengths: vec![0; size],
                rows: vec![0; m],
                columns: vec![0; n],
                places: vec![0; n],
            },
            largest: vec![(0.0, 0); m],
            first: vec![0; n],
            next: vec![0; m * n],
            right: vec![0.0; size],
            room: vec![0.0; size],
            held: (0..n).map(|index| held.contains(&(n + index))).collect(),
            masses: Vec::new(),
        })
    }

    /// Corrects what a step has reached.
    pub fn correct(
        &mut self,
        reports: &dyn Reports<f64>,
        phase: Phase<'_, f64>,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), OdeError> {
        self.close(reports, phase, time, state, 0).map_err(|(closure, by)| OdeError::Open {
            time,
            closure,
            by,
        })
    }

    /// Lets the closures of a mode take hold of a state that has jumped: what an event has set stays if it can, and the
    /// impulses of the closures change the other speeds, the masses being what they are.
    pub fn jump(
        &mut self,
        reports: &dyn Reports<f64>,
        phase: Phase<'_, f64>,
        time: f64,
        (before, state): (&[f64], &mut [f64]),
    ) -> Result<(), OdeError> {
        let n = self.closures.coordinates;
        self.masses.resize(n * n, 0.0);
        if !reports.mass(phase, time, state, &mut self.masses) {
            self.masses.clear();
        }
        let (held, kept) = (self.held.clone(), state.to_vec());
        for (index, held) in self.held.iter_mut().enumerate() {
            *held |= before[n + index] != state[n + index];
        }
        let is_done = self.close(reports, phase, time, state, 0).is_ok()
            && !self.slips(reports, phase, time, state);
        self.held = held;
        let done = match is_done {
            true => Ok(()),
            false => {
                state.copy_from_slice(&kept);
                self.close(reports, phase, time, state, 0)
            }
        };
        self.masses.clear();
        done.map_err(|(closure, by)| OdeError::Open { time, closure, by })
    }

    /// Whether speeds contradict a closure.
    fn slips(
        &mut self,
        reports: &dyn Reports<f64>,
        phase: Phase<'_, f64>,
        time: f64,
        state: &[f64],
    ) -> bool {
        let (n, m) = (self.closures.coordinates, self.closures.loops.len());
        reports.closures(phase, time, state, &mut self.values);
        let fastest = state[n..2 * n].iter().fold(0.0_f64, |most, one| most.max(one.abs()));
        let rates = self.values[m..2 * m].iter().zip(self.closures.sizes);
        rates.into_iter().any(|(rate, size)| rate.abs() > OPEN * size * fastest)
    }

    /// Closes the closures where a motion begins, some coordinates being kept.
    fn assemble(
        mut self,
        reports: &dyn Reports<f64>,
        (mode, time): (usize, f64),
        mut start: Vec<f64>,
        kept: &[usize],
    ) -> Result<Vec<f64>, Refused> {
        let coordinates = self.held.iter_mut().enumerate();
        coordinates.for_each(|(index, held)| *held |= kept.contains(&index));
        match self.close(reports, Phase::of(mode), time, &mut start, 1) {
            Ok(()) => Ok(start),
            Err((closure, by)) => {
                let Loop { name, unit, factor, .. } = self.closures.loops[closure];
                let by = by / factor;
                Err(Refused {
                    name: name.to_string(),
                    reason: format!(
                        "does not close where the motion begins: it stays open by {by:.3e} {unit}; change the dimensions or the start values"
                    ),
                })
            }
        }
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
        let worst = self.values[..m].iter().zip(self.closures.sizes).enumerate();
        let worst = worst.map(|(row, (by, size))| (row, by.abs(), by.abs() / size));
        match worst.max_by(|a, b| a.2.total_cmp(&b.2)) {
            Some((row, by, part)) if part > OPEN || part.is_nan() => Err((row, by)),
            _ => Ok(()),
        }
    }

    /// How far the closures are open.
    fn open(&self) -> f64 {
        let open = self.values[..self.closures.loops.len()].iter();
        open.map(|one| one.abs()).fold(0.0, larger)
    }

    /// The shortest change that takes residuals away, which stand from a place on. Gives its largest component.
    fn solve(&mut self, from: usize, nothing: f64) -> f64 {
        let (n, m) = (self.closures.coordinates, self.closures.loops.len());
        let parts = self.factor(nothing);
        for row in 0..m {
            self.right[n + row] = -self.values[from + row] / self.closures.sizes[row];
        }
        self.right[..n].fill(0.0);
        let Order { lists, lengths, rows, columns, places } = &self.order;
        let order = Order { lists: &lists[..], lengths, rows, columns, places };
        let (matrix, reduced) = (&self.matrix[..], &self.reduced[..]);
        let reading = Reading { parts: &parts, matrix, reduced, order };
        reading.solve(&mut self.right, &mut self.room);
        let changes = self.right[..n].iter();
        changes.map(|one| one.abs()).fold(0.0, larger)
    }

    /// Factors masses, or ones, with the closures.
    fn factor(&mut self, nothing: f64) -> Parts {
        let (n, m) = (self.closures.coordinates, self.closures.loops.len());
        let mut parts = Parts { unknowns: n, closures: m, rank: self.closures.rank, lasting: None };
        let Order { lists, lengths, rows, columns, places } = &mut self.order;
        let mut writing = Writing {
            parts: &mut parts,
            matrix: &mut self.matrix,
            reduced: &mut self.reduced,
            order: Order { lists: &mut lists[..], lengths, rows, columns, places },
            scan: Scan { largest: &mut self.largest, first: &mut self.first, next: &mut self.next },
        };
        writing.clear();
        let is_free = |one: &(usize, &f64)| !self.held[one.0] && *one.1 != 0.0;
        for column in 0..n {
            match self.masses.get(column * n..=column * n + column) {
                Some(masses) if !self.held[column] => {
                    for (index, mass) in masses.iter().enumerate().filter(is_free) {
                        writing.put(column, index, *mass);
                    }
                }
                _ => writing.put(column, column, 1.0),
            }
        }
        for row in 0..m {
            let slopes = &self.values[2 * m + row * n..][..n];
            for (column, slope) in slopes.iter().enumerate().filter(is_free) {
                writing.put(n + row, column, *slope / self.closures.sizes[row]);
            }
        }
        writing.factor(nothing);
        parts
    }
}

/// The state in which a motion begins: positions and speeds that are kept, and for the others what closures make of those.
///
/// # Errors
/// The closure that does not close, and by how much.
pub fn assemble<C: Scene>(scene: &C, start: Vec<f64>) -> Result<Vec<f64>, Refused> {
    let shape = scene.shape();
    let Some(correction) = Correction::of(shape, shape.first) else {
        return Ok(start);
    };
    let time = match scene.span() {
        Span::Run(from, _) => from,
        _ => 0.0,
    };
    let (equations, kept) = (scene.prepare::<f64>(), correction.closures.kept);
    correction.assemble(&equations, (shape.first, time), start, kept)
}

/// [`assemble`] of a model in a mode at a time, from a start of which other coordinates are kept.
pub(crate) fn assemble_beside(
    model: &dyn Model,
    (mode, time): (usize, f64),
    start: Vec<f64>,
    kept: &[usize],
) -> Result<Vec<f64>, Refused> {
    match Correction::of(model.shape(), mode) {
        Some(correction) => correction.assemble(model.reports(), (mode, time), start, kept),
        None => Ok(start),
    }
}

/// [`assemble`], or the start as it is stated where that fails.
pub fn begin<C: Scene>(scene: &C, start: Vec<f64>) -> Vec<f64> {
    assemble(scene, start.clone()).unwrap_or(start)
}
