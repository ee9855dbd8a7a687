//! How many operations a scene takes at each of its stages.

use std::collections::BTreeSet;

use super::{Form, Function, OperationKind as Kind, Program, Stage, Staging, Value};

/// Operations of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Once per parameter set.
    pub prepare: usize,
    /// Once per instant.
    pub instant: usize,
    /// Per evaluation of the derivative; of a linkage per position, a group without closed form being iterated once.
    pub derivative: usize,
    /// Per evaluation of the Jacobian; of a linkage of the influence coefficients.
    pub jacobian: usize,
    /// Per evaluation of all outputs.
    pub outputs: usize,
    /// Those among an instant and the derivative that are functions of the long kind: exponentials, logarithms, powers, arcs,
    /// hyperbolic functions and tangents.
    pub functions: usize,
    /// Per term of the Taylor series of the motion; none where there is no series.
    pub term: usize,
    /// Sums over all terms so far that each term of the series takes.
    pub sums: usize,
    /// Values, in all modes, that may change within a step and change back without that the terms of the series tell.
    pub unfelt: usize,
}

impl Counts {
    /// All of them.
    pub fn all(&self) -> [usize; 9] {
        let Self { prepare, instant, derivative, jacobian, outputs, functions, term, sums, unfelt } =
            *self;
        [prepare, instant, derivative, jacobian, outputs, functions, term, sums, unfelt]
    }
}

impl Program {
    /// Counts the operations of a scene that evaluates some values, and some slopes beside them.
    pub fn counts(&self, staging: &Staging, evaluated: &[Value], slopes: &[Value]) -> Counts {
        let stored = |value: Value, from: Stage| self.stage(value) < from && !self.is_number(value);
        let count = |wanted: &[Value], from: Stage| {
            self.operations_of(&self.needed(wanted, &|value| stored(value, from)))
        };
        let list = |values: &BTreeSet<Value>| values.iter().copied().collect::<Vec<Value>>();
        let there = |value: Value| stored(value, Stage::Instant) || staging.timed.contains(&value);
        let series = self.series(&self.results.derivative);
        let (term, sums) = series.as_ref().map_or((0, 0), |series| series.counts());
        let moving = self.needed(evaluated, &|value| self.stage(value) < Stage::Instant);
        Counts {
            functions: moving.iter().filter(|value| self.is_long(**value)).count(),
            term,
            sums,
            unfelt: series.map_or(0, |series| series.unfelt(&self.results.derivative)),
            prepare: count(&list(&staging.prepared), Stage::Constant),
            instant: count(&list(&staging.timed), Stage::Instant),
            derivative: count(evaluated, Stage::State),
            jacobian: self.operations_of(&self.needed(slopes, &there)),
            outputs: count(&self.results.outputs, Stage::Instant),
        }
    }

    /// Whether a value is a function that takes much longer than arithmetic, sines and cosines do.
    fn is_long(&self, value: Value) -> bool {
        use Function::{Abs, Cos, Floor, Hypot, Max, Min, Sign, Sin, Sqrt};
        let is_short = |function: &Function| {
            matches!(function, Abs | Cos | Floor | Hypot | Max | Min | Sign | Sin | Sqrt)
        };
        matches!(self.kind(value), Kind::Call(function, _) if !is_short(function))
    }

    /// Arithmetic operations, functions and selections among some values.
    fn operations_of(&self, values: &BTreeSet<Value>) -> usize {
        let cost = |value: &Value| match self.kind(*value) {
            // The triangular systems are counted with each solution.
            Kind::Factor { form, size, .. } => {
                let size = *size as usize;
                let symmetric = size * (size + 1) * (2 * size + 1) / 6;
                match form {
                    Form::Symmetric => symmetric,
                    Form::General | Form::Bound { .. } => 2 * symmetric,
                }
            }
            kind => kind.weight(),
        };
        values.iter().map(cost).sum()
    }
}
