//! The loops of a linkage on numbers of any kind.

use std::sync::Arc;

use assur_model::program::{Program, Value};
use assur_solvers::closure::Closure;
use assur_solvers::problem::Storage;
use assur_solvers::scalar::Scalar;
use assur_solvers::shape::Shape;

use super::few::Few;
use super::functions::{Name, Prepared};
use super::linkage::Loops;
use super::room::room;
use crate::code::{Scope, Wanted};

/// The functions of a linkage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// What depends on the drivers alone.
    Instant,
    Residual,
    Coefficients,
    Outputs,
    Influence,
    SecondInfluence,
    Points,
    Measured,
    Measures,
    /// A group in closed form, but for its angles.
    Close(usize),
    Margin(usize),
    /// Residuals and Jacobian of a group.
    Trial(usize),
}

/// Functions that are not those of a single group.
const SHARED: usize = 9;
/// Functions of a group.
const OWN: usize = 3;

impl Function {
    /// How many functions a linkage with so many groups has.
    pub fn count(groups: usize) -> usize {
        SHARED + OWN * groups
    }

    /// All but the trials, which are small.
    pub fn all(groups: usize) -> impl Iterator<Item = Self> {
        let shared = [
            Self::Instant,
            Self::Residual,
            Self::Coefficients,
            Self::Outputs,
            Self::Influence,
            Self::SecondInfluence,
            Self::Points,
            Self::Measured,
            Self::Measures,
        ];
        let own = |group| [Self::Close(group), Self::Margin(group)];
        shared.into_iter().chain((0..groups).flat_map(own))
    }
}

/// The places of a group in closed form that are written as they are.
fn others(program: &Program, group: usize) -> impl Iterator<Item = (usize, Value)> {
    let values = program.results.closing.groups[group].iter().flat_map(|closed| &closed.values);
    values.copied().filter(move |entry| cosine(program, group, entry.0).is_none())
}

/// Of a place of a group in closed form that is an angle the place of its cosine, from which it follows.
fn cosine(program: &Program, group: usize, place: usize) -> Option<usize> {
    let closing = &program.results.closing;
    let cosine = closing.cosines.get(place).copied().flatten()?;
    let mut values = closing.groups[group].iter().flat_map(|closed| &closed.values);
    values.any(|entry| entry.0 == cosine).then_some(cosine)
}

/// The places of a group that are written as they are, and its angles with the places of their cosines.
pub(super) type Form = (Vec<usize>, Vec<(usize, usize)>);

/// What a group in closed form writes.
pub(super) fn form(program: &Program, group: usize) -> Form {
    let values = program.results.closing.groups[group].iter().flat_map(|closed| &closed.values);
    let angles = values.filter_map(|entry| Some((entry.0, cosine(program, group, entry.0)?)));
    (others(program, group).map(|entry| entry.0).collect(), angles.collect())
}

impl Name for Function {
    fn number(self, _: &Program) -> usize {
        let own = |group: usize, number: usize| SHARED + OWN * group + number;
        match self {
            Self::Instant => 0,
            Self::Residual => 1,
            Self::Coefficients => 2,
            Self::Outputs => 3,
            Self::Influence => 4,
            Self::SecondInfluence => 5,
            Self::Points => 6,
            Self::Measured => 7,
            Self::Measures => 8,
            Self::Close(group) => own(group, 0),
            Self::Margin(group) => own(group, 1),
            Self::Trial(group) => own(group, 2),
        }
    }

    fn wanted(self, program: &Program) -> (Scope, Wanted) {
        let results = &program.results;
        let closing = &results.closing;
        let list = match self {
            Self::Instant => {
                let timed = program.staging().timed;
                return (Scope::Independents, Wanted::of(timed));
            }
            Self::Residual => closing.residuals.clone(),
            Self::Coefficients => closing.coefficients.iter().map(|entry| entry.2).collect(),
            Self::Outputs => results.outputs.clone(),
            Self::Influence => closing.influence.clone(),
            Self::SecondInfluence => closing.second.clone(),
            Self::Points => closing.points.clone(),
            Self::Measured => results.measured.clone(),
            Self::Measures => results.measures.clone(),
            Self::Close(group) => {
                let sine = closing.groups[group].iter().map(|closed| closed.sine);
                others(program, group).map(|entry| entry.1).chain(sine).collect()
            }
            Self::Margin(group) => {
                closing.groups[group].iter().map(|closed| closed.margin).collect()
            }
            // Of the equations of the group, which the shape knows: see `Trial`.
            Self::Trial(_) => Vec::new(),
        };
        (Scope::Position, Wanted::of(list))
    }
}

/// Residuals and Jacobian of a group.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    group: usize,
    wanted: Vec<Value>,
    /// For each entry of the Jacobian where it stands among the results; none where it is zero.
    entries: Vec<Option<usize>>,
}

impl Trial {
    /// Of a group with these equations and unknowns.
    pub fn of(program: &Program, group: usize, equations: &[usize], unknowns: &[usize]) -> Self {
        let closing = &program.results.closing;
        let mut wanted: Vec<Value> = equations.iter().map(|row| closing.residuals[*row]).collect();
        let places = equations.iter().flat_map(|row| unknowns.iter().map(move |one| (*row, *one)));
        let entries = places.map(|place| {
            let found = closing.slopes.iter().find(|entry| (entry.0, entry.1) == place)?;
            wanted.push(found.2);
            Some(wanted.len() - 1)
        });
        let entries = entries.collect();
        Self { group, wanted, entries }
    }
}

impl Name for &Trial {
    fn number(self, program: &Program) -> usize {
        Function::Trial(self.group).number(program)
    }

    fn wanted(self, _: &Program) -> (Scope, Wanted) {
        (Scope::Position, Wanted::of(self.wanted.iter().copied()))
    }
}

/// The loops of a linkage with their prepared values.
#[derive(Debug)]
pub struct Prepare<S: Scalar> {
    loops: Shared,
    prepared: Prepared<S>,
}

/// What all values have in common.
struct Shared(Arc<Loops>);

impl std::fmt::Debug for Shared {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(self.0.shape.name)
    }
}

impl<S: Scalar> Prepare<S> {
    pub(super) fn new(loops: &Arc<Loops>, values: &[S]) -> Self {
        let prepared = Prepared::new(&loops.functions, values);
        Self { loops: Shared(loops.clone()), prepared }
    }

    pub(super) fn renew(&mut self, values: &[S]) {
        self.prepared.renew(values);
    }

    fn program(&self) -> &Program {
        self.prepared.program()
    }

    /// Takes sines and cosines of the angles of a group.
    fn sines(&self, group: usize, position: &mut [S]) {
        let angles = &self.loops.0.angles[group];
        if angles.is_empty() {
            return;
        }
        S::outline(
            #[inline(always)]
            || {
                for (angle, cosine) in angles {
                    let (sin, cos) = position[*angle].sin_cos();
                    (position[*cosine], position[*cosine + 1]) = (cos, sin);
                }
            },
        );
    }
}

/// Implements methods that write values at a closed position.
macro_rules! written {
    ($($method:ident: $function:ident;)*) => {$(
        fn $method(&self, instant: &Few<S>, position: &Few<S>, values: &mut [S]) {
            let (results, closing) = (&self.program().results, &self.program().results.closing);
            let count = match Function::$function {
                Function::Residual => closing.residuals.len(),
                Function::Outputs => results.outputs.len(),
                Function::Influence => closing.influence.len(),
                Function::SecondInfluence => closing.second.len(),
                Function::Measured => results.measured.len(),
                _ => closing.points.len(),
            };
            self.prepared.call(Function::$function, &[instant.as_ref(), position.as_ref()], &mut values[..count]);
        }
    )*};
}

impl<S: Scalar> Closure<S> for Prepare<S> {
    type Position = Few<S>;
    type Instant = Few<S>;
    type Row = Few<S>;
    type Matrix = Few<S>;

    #[inline]
    fn shape(&self) -> &'static Shape {
        self.loops.0.shape
    }

    fn zeros(&self) -> Few<S> {
        Few::zeros(self.program().results.closing.position())
    }

    fn instant(&self, independents: &[S]) -> Few<S> {
        let motion = self.shape().loops().motion;
        room(motion, |unknown| {
            unknown.fill(S::from_f64(f64::NAN));
            self.moving(independents, unknown)
        })
    }

    fn moving(&self, independents: &[S], motion: &[S]) -> Few<S> {
        let mut row = Few::zeros(self.prepared.functions.storage.length);
        self.prepared.call(Function::Instant, &[independents, motion], row.as_mut());
        row
    }

    fn close(&self, group: usize, instant: &Few<S>, mode: S, position: &mut Few<S>) -> S {
        if self.program().results.closing.groups[group].is_none() {
            return S::from_f64(f64::NAN);
        }
        let (others, angles) = &self.loops.0.forms[group];
        room(others.len() + 1, |all| {
            self.prepared.call(
                Function::Close(group),
                &[instant.as_ref(), position.as_ref(), &[mode]],
                all,
            );
            let position = position.as_mut();
            for (place, value) in others.iter().zip(&*all) {
                position[*place] = *value;
            }
            S::outline(
                #[inline(always)]
                || {
                    for (angle, cosine) in angles {
                        position[*angle] = S::atan2(position[*cosine + 1], position[*cosine]);
                    }
                },
            );
            all[others.len()]
        })
    }

    fn margin(&self, group: usize, instant: &Few<S>, position: &Few<S>) -> S {
        let mut margin = [S::from_f64(f64::NAN)];
        if self.program().results.closing.groups[group].is_some() {
            self.prepared.call(
                Function::Margin(group),
                &[instant.as_ref(), position.as_ref()],
                &mut margin,
            );
        }
        margin[0]
    }

    fn trial(
        &self,
        group: usize,
        instant: &Few<S>,
        position: &mut Few<S>,
        residual: &mut Few<S>,
        jacobian: &mut Few<S>,
    ) {
        let trial = &self.loops.0.trials[group];
        self.sines(group, position.as_mut());
        let (residual, jacobian) = (residual.as_mut(), jacobian.as_mut());
        let rows = self.shape().loops().groups[group].equations.len();
        room(trial.wanted.len(), |all| {
            self.prepared.call(trial, &[instant.as_ref(), position.as_ref()], all);
            residual[..rows].copy_from_slice(&all[..rows]);
            for (entry, found) in jacobian.iter_mut().zip(&trial.entries) {
                *entry = found.map_or(S::ZERO, |found| all[found]);
            }
        });
    }

    fn coefficients(&self, instant: &Few<S>, position: &Few<S>, columns: &mut [Few<S>]) {
        let entries = &self.program().results.closing.coefficients;
        let dependents = self.shape().loops().dependents.len();
        room(entries.len(), |all| {
            self.prepared.call(Function::Coefficients, &[instant.as_ref(), position.as_ref()], all);
            columns.iter_mut().for_each(|column| column.as_mut()[..dependents].fill(S::ZERO));
            for ((dependent, driver, _), value) in entries.iter().zip(&*all) {
                columns[*driver].as_mut()[*dependent] = *value;
            }
        });
    }

    written! {
        residual: Residual;
        outputs: Outputs;
        influence: Influence;
        second_influence: SecondInfluence;
        points: Points;
        measured: Measured;
    }

    fn measures(&self, found: &[S], values: &mut [S]) {
        let count = self.program().results.measures.len();
        self.prepared.call(Function::Measures, &[&[], &[], &[], found], &mut values[..count]);
    }
}
