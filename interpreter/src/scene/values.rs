//! What depends on the values of the constants alone: conditions on them, the task, the start.

use std::sync::Arc;

use assur_model::checked::{RequirementInfo, SceneModel, SpanKind};
use assur_model::program::Program;
use assur_registry::registry::{check_values, unmet};
use assur_solvers::problem::{Refused, Span};
use assur_solvers::shape::Shape;

use super::functions::{Functions, Name};
use crate::code::{CannotRun, Scope, Wanted};

/// That a scene cannot be run without being compiled.
pub fn too_large(shape: &Shape, cannot: CannotRun) -> Refused {
    let reason = format!("{cannot}; compiled by `equations!` it can be run");
    Refused { name: format!("the scene `{}`", shape.name), reason }
}

/// A function of the values.
#[derive(Clone, Copy, Debug)]
enum Function {
    Requirements,
    Span,
    Start,
    /// Positions of the drivers at a time, their speeds and accelerations.
    Drive,
}

impl Name for Function {
    fn number(self, _: &Program) -> usize {
        self as usize
    }

    fn wanted(self, program: &Program) -> (Scope, Wanted) {
        let results = &program.results;
        let (scope, list) = match self {
            Self::Requirements => (Scope::Values, results.requirements.clone()),
            Self::Span => (Scope::Values, results.span.clone()),
            Self::Start => (Scope::Values, results.start.clone()),
            Self::Drive => {
                let all = results.drivers.iter().chain(&results.closing.rates);
                (Scope::Drive, all.copied().collect())
            }
        };
        (scope, Wanted::of(list))
    }
}

/// The functions of the values, and what is said of them.
pub struct OfValues {
    shape: &'static Shape,
    functions: Arc<Functions>,
    requirements: Vec<RequirementInfo>,
    span: SpanKind,
}

impl OfValues {
    pub fn new(scene: &SceneModel, shape: &'static Shape) -> Self {
        let functions = Functions::new(scene.program.clone(), scene.drivers.len(), 4);
        Self {
            shape,
            functions: Arc::new(functions),
            requirements: scene.requirements.clone(),
            span: scene.span,
        }
    }

    fn results(&self, function: Function, given: &[&[f64]], count: usize) -> Vec<f64> {
        let mut results = vec![0.0; count];
        self.functions.bare(function, given, &mut results);
        results
    }

    /// Checks ranges and conditions.
    pub fn check(&self, values: &[f64]) -> Result<(), Refused> {
        check_values(self.shape.constants, values)?;
        let held = self.results(Function::Requirements, &[values], self.requirements.len());
        match self.requirements.iter().zip(held).find(|(_, held)| *held == 0.0) {
            Some((RequirementInfo { names, message, text, .. }, _)) => {
                Err(unmet(self.shape.constants, values, names, (message, text)))
            }
            None => Ok(()),
        }
    }

    /// The task.
    pub fn span(&self, values: &[f64]) -> Span {
        let count = self.functions.program.results.span.len();
        let found = self.results(Function::Span, &[values], count);
        match (self.span, found.as_slice()) {
            (SpanKind::Periodic, [period]) => Span::Periodic(*period),
            (SpanKind::Periodic, []) => Span::Autonomous,
            (SpanKind::Rest, _) => Span::Rest,
            (SpanKind::Run, [from, to]) => Span::Run(*from, *to),
            _ => Span::Open,
        }
    }

    /// The declared start values of the state.
    pub fn start(&self, values: &[f64]) -> Vec<f64> {
        let count = self.functions.program.results.start.len();
        self.results(Function::Start, &[values], count)
    }

    /// Positions, speeds and accelerations of the drivers at a time, and the time; none where they do not move in time.
    pub fn drive(&self, values: &[f64], time: f64) -> Option<Vec<f64>> {
        let results = &self.functions.program.results;
        if results.closing.rates.is_empty() {
            return None;
        }
        let count = results.drivers.len() + results.closing.rates.len();
        let mut found = self.results(Function::Drive, &[values, &[time]], count);
        found.push(time);
        Some(found)
    }
}
