//! What the default values of a scene make impossible.

use super::Mode;
use crate::checked::SpanKind;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Node, Symbol};
use crate::facts::TaskValues;
use crate::lower::{Kind, Lowering};
use crate::published::Stretch;
use crate::unit;

/// Reports masses that are zero or negative: what multiplies the highest derivatives, where it follows from constants
/// alone.
pub fn masses(low: &mut Lowering<'_>, mode: &Mode<'_>, values: &[f64]) {
    let names = low.names;
    for (row, column, factor) in &mode.solved.pivots {
        if !low.is_constant(*factor) {
            continue;
        }
        let value = low.graph.evaluate(&[*factor], &given(values))[0];
        let equation = &mode.equations[*row];
        let unknown = &mode.unknowns[*column].name;
        let negative = negative_mass(low, *factor, values);
        let (message, otherwise) = if value == 0.0 {
            (
                format!("`{unknown}` is multiplied by zero, so nothing determines it"),
                "a coordinate without mass is a `state`",
            )
        } else if let (true, Some(coordinate)) = (value < 0.0, equation.lagrange) {
            let name = &names.coordinates[coordinate].name.text;
            (format!("the mass that `{name}` moves is negative"), "a kinetic energy is positive")
        } else if negative.is_some() {
            (format!("`{unknown}` is multiplied by a negative mass"), "")
        } else {
            continue;
        };
        // Lagrange's equation is stated nowhere by itself.
        let place = match equation.lagrange {
            Some(_) => mode.unknowns[*column].span,
            None => equation.span,
        };
        let report = Diagnostic::error(place, message);
        let suspect = negative.or_else(|| suspect(low, *factor, values));
        low.diagnostics.push(match suspect {
            Some(index) => {
                let name = &names.constants[index].name;
                let hint = format!("give `{}` a value above zero", name.text);
                report.related(name.span, "this value").hint(hint)
            }
            None => report.hint(otherwise),
        });
    }
}

/// Reports what neither mass nor closures determine, where closures hold the coordinates.
pub fn freedoms(low: &mut Lowering<'_>, mode: &Mode<'_>, values: &[f64]) {
    let Some(augmented) = &mode.augmented else { return };
    let count = low.names.coordinates.len() as u32;
    let place = |symbol| match symbol {
        Symbol::Parameter(index) => values[index as usize],
        Symbol::Coordinate(index) => augmented.start[index as usize],
        Symbol::Speed(index) => augmented.speeds[index as usize],
        _ => 0.0,
    };
    let own = mode.equations.len() - augmented.closures;
    let rows: Vec<_> = mode.equations[..own].iter().map(|one| one.residual).collect();
    let unknowns: Vec<_> = (0..count)
        .map(Symbol::Acceleration)
        .chain((0..augmented.closures as u32).map(Symbol::Reaction))
        .collect();
    let entries = low.graph.jacobian(&rows, &unknowns);
    let slopes: Vec<_> = entries.iter().map(|one| one.2).collect();
    let numbers = low.graph.evaluate(&slopes, &place);
    let mut matrix = vec![vec![0.0; unknowns.len()]; rows.len()];
    for ((row, column, _), number) in entries.iter().zip(numbers) {
        matrix[*row][*column] = number;
    }
    for index in undetermined(&mut matrix, count as usize) {
        let name = &low.names.coordinates[index].name;
        let message = format!(
            "`{}` can move without moving any mass, so nothing determines how it is accelerated",
            name.text
        );
        low.diagnostics.push(
            Diagnostic::error(name.span, message)
                .hint("give what it moves a mass, or take the coordinate away"),
        );
    }
}

/// Reports what moves with the time where a position of rest is sought.
pub fn rest(low: &mut Lowering<'_>, mode: &Mode<'_>) {
    let Some(scene) = mode.here.scene().filter(|_| mode.asked.span.kind == SpanKind::Rest) else {
        return;
    };
    let (graph, drives) = (&low.graph, &mode.declared.drives);
    let varies = |position: Expression| graph.depends_on(position, |one| one == Symbol::Time);
    let moves = |symbol: Symbol| match symbol {
        Symbol::Driver(index) => drives[index as usize].position.is_some_and(varies),
        other => other == Symbol::Time,
    };
    let equations = mode.equations.iter().map(|one| (one.residual, one.span));
    let closures = mode.linkage.equations.iter().map(|one| (one.residual, one.span));
    let mut all = equations.chain(closures);
    let Some((_, place)) = all.find(|(residual, _)| graph.depends_on(*residual, moves)) else {
        return;
    };
    let report =
        Diagnostic::error(scene.name.span, "this scene moves with the time and never rests");
    low.diagnostics.push(
        report
            .related(place, "this depends on the time")
            .hint("leave out what drives it, by an effect for instance, or let the scene `run`"),
    );
}

/// The first columns that have no pivot of their own in an elimination with row exchanges, each row over its size.
fn undetermined(matrix: &mut [Vec<f64>], first: usize) -> Vec<usize> {
    for row in matrix.iter_mut() {
        let size = row.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
        row.iter_mut().for_each(|one| *one /= size.max(f64::MIN_POSITIVE));
    }
    let (mut at, mut left) = (0, Vec::new());
    let columns = matrix.first().map_or(0, Vec::len);
    // The forces come first: what is left of the rows then are the free motions.
    for column in (first..columns).chain(0..first) {
        let larger =
            |a: &usize, b: &usize| matrix[*a][column].abs().total_cmp(&matrix[*b][column].abs());
        let best = (at..matrix.len()).max_by(larger);
        let Some(best) = best.filter(|row| matrix[*row][column].abs() > 1e-14) else {
            left.extend((column < first).then_some(column));
            continue;
        };
        matrix.swap(at, best);
        let (above, below) = matrix.split_at_mut(at + 1);
        for other in below {
            let multiple = other[column] / above[at][column];
            other.iter_mut().zip(&above[at]).for_each(|(a, b)| *a -= multiple * b);
        }
        at += 1;
    }
    left
}

/// A constant that is zero or negative.
fn suspect(low: &Lowering<'_>, factor: Expression, values: &[f64]) -> Option<usize> {
    let mut symbols = low.graph.symbols(&[factor]).into_iter();
    symbols.find_map(|symbol| match symbol {
        Symbol::Parameter(index) if values[index as usize] <= 0.0 => Some(index as usize),
        _ => None,
    })
}

/// A mass or moment of inertia that is negative, of the factors of a product.
fn negative_mass(low: &Lowering<'_>, factor: Expression, values: &[f64]) -> Option<usize> {
    match low.graph.node(factor) {
        Node::Symbol(Symbol::Parameter(index)) => {
            let index = *index as usize;
            (values[index] < 0.0 && is_mass(low, index)).then_some(index)
        }
        Node::Product(factors) => {
            let mut factors = factors.iter();
            factors.find_map(|one| negative_mass(low, *one, values))
        }
        _ => None,
    }
}

/// Whether a constant is a mass or a moment of inertia.
fn is_mass(low: &Lowering<'_>, index: usize) -> bool {
    let kind = low.kind_of(Symbol::Parameter(index as u32));
    let mut units = ["kg", "kg m^2"].into_iter();
    units.any(|one| unit::parse_unit_text(one).is_ok_and(|one| Kind::Of(one.dimension) == kind))
}

/// From when to when a scene runs with its own values.
pub fn stretch(low: &Lowering<'_>, span: &TaskValues, values: &[f64]) -> Option<Stretch> {
    let [from, to] = low.graph.evaluate(&span.values, &given(values))[..] else {
        return None;
    };
    let fixed = |one: &Expression| low.graph.as_number(*one).is_some();
    (span.kind == SpanKind::Run).then(|| Stretch {
        from,
        to,
        is_fixed: span.values.iter().all(fixed),
    })
}

/// The values of constants.
fn given(values: &[f64]) -> impl Fn(Symbol) -> f64 {
    move |symbol| match symbol {
        Symbol::Parameter(index) => values[index as usize],
        _ => f64::NAN,
    }
}
