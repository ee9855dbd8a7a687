//! Counts operations.

use super::order::reach;
use assur_functions::POINTS;

use super::{Form, Line, OperationKind, Program, Stage, Value};

impl OperationKind {
    /// Arithmetic operations in it: none for what is given or only named, two for a product that is added.
    pub fn weight(&self) -> usize {
        match self {
            Self::Number(_) | Self::Input(_) | Self::Element { .. } => 0,
            Self::MultiplyAdd(..) | Self::MultiplySubtract(..) | Self::NegateMultiplyAdd(..) => 2,
            // L·D·Lᵀ: n³/6 products with their differences, and the two triangular systems.
            Self::Factor { form, size, .. } => {
                let size = *size as usize;
                let symmetric = size * (size * size + 3 * size + 2) / 3;
                match form {
                    Form::Symmetric => symmetric,
                    Form::General | Form::Bound { .. } => 2 * symmetric,
                }
            }
            Self::Solve { right, .. } => 2 * right.len() * right.len(),
            // A rule of an integral; more rarely looked for longer.
            Self::Search { lines, .. } => {
                let line = |line: &Line| line.operations.iter().map(Self::weight).sum::<usize>();
                POINTS * lines.iter().map(line).sum::<usize>() / lines.len().max(1)
            }
            _ => 1,
        }
    }
}

impl Program {
    /// Operations that some values take at a stage, everything of earlier stages being there.
    pub fn count(&self, values: &[Value], stage: Stage) -> usize {
        let reached = reach(self, values);
        let operations = reached.iter().map(|value| &self.operations[value.0 as usize]);
        operations
            .filter(|operation| operation.stage == stage)
            .map(|operation| operation.kind.weight())
            .sum()
    }
}
