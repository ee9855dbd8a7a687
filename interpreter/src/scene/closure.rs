//! The loops of a linkage on numbers of any kind.

use std::sync::Arc;

use assur_model::program::{Program, Value};
use assur_solvers::closure::Closure;
use assur_solvers::scalar::Scalar;
use assur_solvers::shape::Shape;

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
            // Of the equations of the group, which the shape knows: see `Prepare::trial`.
            Self::Trial(_) => Vec::new(),
        };
        (Scope::Position, Wanted::of(list))
    }
}

/// Residuals and Jacobian of a group.
#[derive(Clone, Copy)]
struct Trial<'a> {
    group: usize,
    equations: &'a [usize],
    unknowns: &'a [usize],
}

impl Trial<'_> {
    fn slopes(self, program: &Program) -> impl Iterator<Item = Option<Value>> {
        let slopes = &program.results.closing.slopes;
        self.equations.iter().flat_map(move |row| {
            self.unknowns.iter().map(move |column| {
                let found = slopes.iter().find(|entry| (entry.0, entry.1) == (*row, *column));
                found.map(|entry| entry.2)
            })
        })
    }
}

impl Name for Trial<'_> {
    fn number(self, program: &Program) -> usize {
        Function::Trial(self.group).number(program)
    }

    fn wanted(self, program: &Program) -> (Scope, Wanted) {
        let residuals = &program.results.closing.residuals;
        let residuals = self.equations.iter().map(|row| residuals[*row]);
        (Scope::Position, Wanted::of(residuals.chain(self.slopes(program).flatten())))
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
        fn $method(&self, instant: &Vec<S>, position: &Vec<S>, values: &mut [S]) {
            let (results, closing) = (&self.program().results, &self.program().results.closing);
            let count = match Function::$function {
                Function::Residual => closing.residuals.len(),
                Function::Outputs => results.outputs.len(),
                Function::Influence => closing.influence.len(),
                Function::SecondInfluence => closing.second.len(),
                Function::Measured => results.measured.len(),
                _ => closing.points.len(),
            };
            self.prepared.call(Function::$function, &[instant, position], &mut values[..count]);
        }
    )*};
}

impl<S: Scalar> Closure<S> for Prepare<S> {
    type Position = Vec<S>;
    type Instant = Vec<S>;
    type Row = Vec<S>;
    type Matrix = Vec<S>;

    #[inline]
    fn shape(&self) -> &'static Shape {
        self.loops.0.shape
    }

    fn zeros(&self) -> Vec<S> {
        vec![S::ZERO; self.program().results.closing.position()]
    }

    fn instant(&self, independents: &[S]) -> Vec<S> {
        let motion = self.shape().loops().motion;
        self.moving(independents, &vec![S::from_f64(f64::NAN); motion])
    }

    fn moving(&self, independents: &[S], motion: &[S]) -> Vec<S> {
        let mut row = vec![S::ZERO; self.prepared.functions.storage.length];
        self.prepared.call(Function::Instant, &[independents, motion], &mut row);
        row
    }

    fn close(&self, group: usize, instant: &Vec<S>, mode: S, position: &mut Vec<S>) -> S {
        if self.program().results.closing.groups[group].is_none() {
            return S::from_f64(f64::NAN);
        }
        let (others, angles) = &self.loops.0.forms[group];
        room(others.len() + 1, |all| {
            self.prepared.call(Function::Close(group), &[instant, position, &[mode]], all);
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

    fn margin(&self, group: usize, instant: &Vec<S>, position: &Vec<S>) -> S {
        let mut margin = [S::from_f64(f64::NAN)];
        if self.program().results.closing.groups[group].is_some() {
            self.prepared.call(Function::Margin(group), &[instant, position], &mut margin);
        }
        margin[0]
    }

    fn trial(
        &self,
        group: usize,
        instant: &Vec<S>,
        position: &mut Vec<S>,
        residual: &mut Vec<S>,
        jacobian: &mut Vec<S>,
    ) {
        let own = &self.shape().loops().groups[group];
        let trial = Trial { group, equations: own.equations, unknowns: own.unknowns };
        self.sines(group, position);
        let rows = own.equations.len();
        let slopes: usize = trial.slopes(self.program()).flatten().count();
        room(rows + slopes, |all| {
            self.prepared.call(trial, &[instant, position], all);
            residual[..rows].copy_from_slice(&all[..rows]);
            let mut found = all[rows..].iter();
            let entries = jacobian.iter_mut().zip(trial.slopes(self.program()));
            for (entry, slope) in entries {
                *entry = slope.and_then(|_| found.next().copied()).unwrap_or(S::ZERO);
            }
        });
    }

    fn coefficients(&self, instant: &Vec<S>, position: &Vec<S>, columns: &mut [Vec<S>]) {
        let entries = &self.program().results.closing.coefficients;
        let dependents = self.shape().loops().dependents.len();
        room(entries.len(), |all| {
            self.prepared.call(Function::Coefficients, &[instant, position], all);
            columns.iter_mut().for_each(|column| column[..dependents].fill(S::ZERO));
            for ((dependent, driver, _), value) in entries.iter().zip(&*all) {
                columns[*driver][*dependent] = *value;
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
