//! The measures of a scene: numbers of a whole run, made of what is found by looking at it.

use crate::checked::{MeasureInfo, Measured, Primitive, QuantityInfo};
use crate::declare::quantity;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, describe};
use crate::lower::{Kind, Lowering, Measuring, Typed};
use crate::resolve::Names;
use crate::syntax::tree::{Term, TermKind};
use crate::unit::{self, Unit};

/// The measures of a scene with what they need.
#[derive(Default)]
pub struct Measures {
    /// Names and units.
    pub quantities: Vec<QuantityInfo>,
    /// Kinds, in the same order.
    pub kinds: Vec<Kind>,
    /// Values, from what is found of the run.
    pub values: Vec<Expression>,
    /// For each the primitives that it is made of.
    pub uses: Vec<Vec<usize>>,
    /// What is found.
    pub primitives: Vec<Primitive>,
    /// The quantities that are looked at.
    pub looked_at: Vec<Expression>,
}

impl Measures {
    /// Which of them are zero, and so of any kind.
    pub fn free(&self) -> Vec<bool> {
        self.kinds.iter().map(|kind| *kind == Kind::Any).collect()
    }

    /// Adds one.
    pub fn add(
        &mut self,
        quantity: QuantityInfo,
        kind: Kind,
        value: Expression,
        low: &Lowering<'_>,
    ) {
        self.uses.push(uses(low, value));
        self.quantities.push(quantity);
        self.kinds.push(kind);
        self.values.push(value);
    }

    /// What the tables say of them.
    pub fn info(&self) -> Vec<MeasureInfo> {
        let all = self.quantities.iter().zip(&self.uses);
        all.map(|(quantity, uses)| MeasureInfo { quantity: quantity.clone(), uses: uses.clone() })
            .collect()
    }
}

/// Lowers the measures of a scene that goes through these modes and has events of these names, by what it does and what all
/// scenes of the file do. A scene has those measures that it can have.
pub fn read(
    low: &mut Lowering<'_>,
    names: &Names,
    (modes, events): (Vec<String>, Vec<String>),
    (task, tasks): (Measured, Vec<Measured>),
) -> Measures {
    let mut measures = Measures::default();
    low.measured = Measuring { modes, events, tasks, ..Measuring::default() };
    for measure in &names.measures {
        let Some(term) = &measure.what.value else {
            continue;
        };
        low.measured.is_open = true;
        // A number in it is none of the motion, which can still be stated in other units.
        // By its name, so that another measure that speaks of it looks for nothing twice.
        let own_name =
            Term { span: measure.name.span, kind: TermKind::Name(measure.name.text.clone()) };
        let typed = low.aside(|low| low.term(&own_name));
        low.measured.is_open = false;
        let Some((value, kind)) = typed.as_number() else {
            if !matches!(typed, Typed::Wrong) {
                let message = format!("a measure is a number, and this is {}", typed.describe());
                low.diagnostics.push(Diagnostic::error(term.span, message));
            }
            continue;
        };
        let Some(unit) = printed(low, &measure.what.unit, term, kind, &measure.name.text) else {
            continue;
        };
        if !is_fixed(low, value, term) {
            continue;
        }
        let name = &measure.name.text;
        let described = quantity(name, &measure.summary, &unit.dimension, &unit);
        let uses = uses(low, value);
        if is_of(low, task, &uses, term) {
            measures.add(described, kind, value, low);
        }
    }
    let found = std::mem::take(&mut low.measured);
    // What is found for measures of another task than this scene's is found for nobody.
    if !measures.values.is_empty() {
        measures.primitives = found.primitives;
        measures.looked_at = found.looked_at;
    }
    measures
}

/// The primitives that a measure is made of.
fn uses(low: &Lowering<'_>, value: Expression) -> Vec<usize> {
    let symbols = low.graph.symbols(&[value]);
    let uses = symbols.into_iter().filter_map(|symbol| match symbol {
        Symbol::Measured(index) => Some(index as usize),
        _ => None,
    });
    uses.collect()
}

/// Whether a measure is one of what the scene does.
fn is_of(low: &mut Lowering<'_>, task: Measured, uses: &[usize], term: &Term) -> bool {
    let has = |task: Measured| {
        let mut kinds = uses.iter().map(|index| &low.measured.primitives[*index].kind);
        kinds.all(|kind| kind.is_of(task))
    };
    let all = [Measured::Run, Measured::Periodic, Measured::Rest, Measured::Positions];
    if !all.into_iter().any(has) {
        let message = "this is a number of a run and of a position of rest";
        let report = Diagnostic::error(term.span, message);
        low.diagnostics.push(report.hint("a scene runs or rests: make two measures of it"));
        return false;
    }
    has(task)
}

/// The unit in which a measure is printed.
fn printed(
    low: &mut Lowering<'_>,
    written: &Option<crate::syntax::tree::UnitTerm>,
    term: &Term,
    kind: Kind,
    name: &str,
) -> Option<Unit> {
    let Some(written) = written else {
        return Some(low.natural_unit(term, kind));
    };
    let unit = unit::resolve(written, low.diagnostics)?;
    if agree(Kind::Of(unit.dimension), kind).is_some() {
        return Some(unit);
    }
    let message = format!(
        "`{name}` is {}, which cannot be printed in {}",
        describe(kind.dimension()),
        unit.symbol
    );
    low.diagnostics.push(Diagnostic::error(written.span, message));
    None
}

/// Whether a measure is a number of the whole run; what changes during the run is reported.
fn is_fixed(low: &mut Lowering<'_>, value: Expression, term: &Term) -> bool {
    let changes = |symbol: Symbol| !matches!(symbol, Symbol::Parameter(_) | Symbol::Measured(_));
    if !low.graph.depends_on(value, changes) {
        return true;
    }
    low.diagnostics
        .push(Diagnostic::error(term.span, "this changes during the run").hint(
            "say which number of it is meant, as in `peak(x)`, `mean(x)` or `value(x, end)`",
        ));
    false
}
