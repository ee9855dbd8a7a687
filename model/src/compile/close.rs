//! The second phase: which coordinates the loops determine, and in which order they are closed.

use std::rc::Rc;

use super::{Here, begin};
use crate::checked::EquationInfo;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Budget, Graph, STEPS, Symbol};
use crate::linkage::{self, Augmented, Linkage, Loops, Places};
use crate::lower::Lowering;
use crate::resolve::Names;
use crate::syntax::tree::{Statement, StatementKind};

/// Makes dependent coordinates of those that the closures determine, where there are more closures than coordinates that
/// are declared so. Where the motion is not reduced in closed form, all of them become coordinates that the closures hold.
pub fn bind(
    here: Here<'_>,
    names: &mut Names,
    budget: Rc<Budget>,
    diagnostics: &mut Diagnostics,
) -> Option<Augmented> {
    let statements = &here.phase().statements;
    let closes = |one: &Statement| matches!(one.kind, StatementKind::Closure { .. });
    if names.coordinates.is_empty() || !statements.iter().any(closes) {
        return None;
    }
    // What is wrong in what is read here is said when it is read for good.
    let mut unsaid = Diagnostics::default();
    let (survey, selected) = (here.task.survey, here.task.selected);
    let low = &mut Lowering::new(names, survey, selected, &mut unsaid, budget.clone());
    let declared = super::declare::quantities(here, low);
    let loops = Loops::read(statements, low);
    if low.diagnostics.has_errors() {
        return None;
    }
    let (places, starts) = begin::places(here, &declared, low);
    let at = |symbol| known(&places, symbol);
    let (bound, wrong) = linkage::bound(&loops, &at, low);
    if (here.task.is_unreduced || wrong.is_some() || !reduces(here, names, &bound))
        && let Some(augmented) = augmented(here, names, budget, diagnostics)
    {
        names.release();
        return Some(augmented);
    }
    let left = names.coordinates.len() - bound.len();
    if left == 0 && names.drivers.is_empty() && wrong.is_none() {
        let place = names.coordinates[0].name.span;
        let message = "no coordinate is left that can move: the closures determine all of them";
        diagnostics.push_once(
            "nothing moves".into(),
            Diagnostic::error(place, message)
                .hint("take a closure away, or prescribe a motion with `driver`"),
        );
    }
    diagnostics.extend(wrong);
    for (index, is_rate, term) in starts {
        let what = &mut names.coordinates[index].what;
        let place = if is_rate { &mut what.start_rate } else { &mut what.start };
        if bound.contains(&index) {
            *place = Some(term);
        }
    }
    names.bind(&bound);
    None
}

/// The value of a symbol where the motion begins, or some other one where none is known.
fn known(places: &Places, symbol: Symbol) -> f64 {
    match places.of(symbol) {
        value if value.is_finite() => value,
        _ => Graph::somewhere(symbol, 1),
    }
}

/// Whether the closures can be solved for these coordinates, and the dependent ones, in closed form.
fn reduces(here: Here<'_>, names: &Names, bound: &[usize]) -> bool {
    let mut names = names.clone();
    names.bind(bound);
    let mut unsaid = Diagnostics::default();
    let (survey, selected) = (here.task.survey, here.task.selected);
    // What is only tried is no part of what the file may take.
    let budget = Rc::new(Budget::new(STEPS));
    let low = &mut Lowering::new(&names, survey, selected, &mut unsaid, budget);
    super::declare::quantities(here, low);
    let loops = Loops::read(&here.phase().statements, low);
    Linkage::of(loops, &names, &here.place(), low).is_some_and(|one| one.is_closed_form())
}

/// How the closures hold the coordinates, the dependent ones among them. None where they do not close, leave no freedom,
/// or leave more of them than there are coordinates.
fn augmented(
    here: Here<'_>,
    names: &Names,
    budget: Rc<Budget>,
    diagnostics: &mut Diagnostics,
) -> Option<Augmented> {
    let most = names.coordinates.len();
    let mut names = names.clone();
    names.release();
    let mut said = Diagnostics::default();
    let (survey, selected) = (here.task.survey, here.task.selected);
    let low = &mut Lowering::new(&names, survey, selected, &mut said, budget);
    let declared = super::declare::quantities(here, low);
    let loops = Loops::read(&here.phase().statements, low);
    if low.diagnostics.has_errors() {
        return None;
    }
    let (places, stated) = begin::places(here, &declared, low);
    let count = names.coordinates.len();
    let given = |symbol| known(&places, symbol);
    let start: Vec<f64> = (0..count as u32).map(Symbol::Coordinate).map(given).collect();
    let speed = |index| Some(places.of(Symbol::Speed(index))).filter(|one| one.is_finite());
    let speeds: Vec<f64> = (0..count as u32).map(|index| speed(index).unwrap_or(0.0)).collect();
    let residuals: Vec<_> = loops.equations.iter().map(|one| one.residual).collect();
    let direction = low.direction()?;
    let rates = low.graph.tangent(&residuals, &direction);
    let closures = (&residuals[..], &rates[..]);
    let found = Augmented::of(&mut low.graph, closures, &given, (&start, &speeds), most)?;
    let freedoms = count - found.rank;
    if freedoms == 0 || freedoms > most {
        return None;
    }
    if here.index == here.phases.first {
        begin::compare_starts(low, &found, &places, (most, &stated));
    }
    low.diagnostics.extend(found.redundancy(&loops.equations));
    diagnostics.extend(said.into_sorted());
    Some(found)
}

/// Reads the loops, which give their texts, and orders them unless there is a mistake.
pub fn close(
    here: Here<'_>,
    low: &mut Lowering<'_>,
    is_augmented: bool,
    is_complete: impl Fn(&Lowering<'_>) -> bool,
) -> (Vec<EquationInfo>, Option<Linkage>) {
    let loops = Loops::read(&here.phase().statements, low);
    let texts = loops.texts.clone();
    let linkage = match is_complete(low) {
        true if is_augmented => Some(Linkage::held(loops)),
        true => Linkage::of(loops, low.names, &here.place(), low),
        false => None,
    };
    low.loops_are_wrong = linkage.is_none();
    linkage::follow(low);
    (texts, linkage)
}
