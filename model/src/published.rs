//! Published facts and marked places: where in a motion they hold, and what they speak of.

use crate::checked::{
    ExpectInfo, ExpectPlace, MarkInfo, SceneModel, SpanKind, Subject, VariableInfo,
};
use crate::diagnostic::Diagnostic;
use crate::expression::Symbol;
use crate::lower::{Kind, Lowering, Moved, second};
use crate::nearest::nearest;
use crate::resolve::Role;
use crate::syntax::print;
use crate::syntax::tree::{Expect, ExpectAt, File, Name, Statement, StatementKind, Term, TermKind};

/// From when to when a scene runs.
#[derive(Clone, Copy)]
pub struct Stretch {
    /// Its begin.
    pub from: f64,
    /// Its end.
    pub to: f64,
    /// Whether it is the same with any preset.
    pub is_fixed: bool,
}

/// The published facts of a scene of a file, to the first of which facts without a scene belong.
pub fn expectations(
    low: &mut Lowering<'_>,
    (file, is_first): (&File, bool),
    model: &SceneModel,
    measures: &[Kind],
    stretch: Option<Stretch>,
) -> Vec<ExpectInfo> {
    let mut list = Vec::new();
    for statement in &file.statements {
        let StatementKind::Expect(expect) = &statement.kind else {
            continue;
        };
        let concerns = match &expect.scene {
            Some(scene) => scene.text == model.name,
            None => is_first,
        };
        if concerns {
            let found = expectation(low, expect, statement.span, model, measures);
            let stretch = stretch.filter(|one| one.is_fixed || expect.preset.is_none());
            if let (Some(info), Some(run)) = (&found, stretch) {
                let report = outside(expect, &info.at, &model.name, run);
                low.diagnostics.extend(report);
            }
            list.extend(found);
        }
    }
    list
}

fn expectation(
    low: &mut Lowering<'_>,
    expect: &Expect,
    span: crate::token::Span,
    model: &SceneModel,
    measures: &[Kind],
) -> Option<ExpectInfo> {
    let wanted = print::term(&expect.quantity);
    let Some(quantity) = subject(&expect.quantity, &wanted, model) else {
        let report = no_subject(low, expect, &wanted, model);
        low.diagnostics.push(report);
        return None;
    };
    let kind = match quantity {
        Subject::Measure(index) => measures[index],
        _ => low.scalar(&expect.quantity)?.1,
    };
    let value = low.fixed_of(&expect.value, kind, "the quantity")?;
    let tolerance = low.fixed_of(&expect.tolerance, kind, "the quantity")?;
    if tolerance < 0.0 {
        let place = expect.tolerance.span;
        let report = Diagnostic::error(place, "a tolerance cannot be negative");
        low.diagnostics.push(report);
        return None;
    }
    let rests = model.span == SpanKind::Rest;
    let (at, place) = low.place_of(expect, model.linkage.is_some(), rests)?;
    let at = match (quantity, rests) {
        (Subject::Measure(_), true) => ExpectPlace::Run,
        _ => at,
    };
    if matches!(quantity, Subject::Measure(_)) != (at == ExpectPlace::Run) {
        let report = wrong_place(expect, &wanted, &at);
        low.diagnostics.push(report);
        return None;
    }
    let preset = expect.preset.as_ref();
    Some(ExpectInfo {
        at,
        quantity,
        value,
        tolerance,
        preset: preset.map_or(String::new(), |name| name.text.clone()),
        remark: expect.remark.clone().unwrap_or_default(),
        span,
        label: format!("{wanted}{place}"),
    })
}

/// A fact about what the scene does not report.
fn no_subject(low: &Lowering<'_>, expect: &Expect, wanted: &str, model: &SceneModel) -> Diagnostic {
    let measures = || model.measures.iter().map(|one| &one.quantity);
    if matches!(&expect.at, ExpectAt::Extreme(word) if word.text == "run") {
        let names = measures().map(|one| one.name.as_str());
        let is_declared = low.names.measures.iter().any(|one| one.name.text == wanted);
        if is_declared && model.linkage.is_some() {
            let message =
                format!("the scene `{}` does not have the measure `{wanted}`", model.name);
            let hint = "it looks at a motion: let the scene run, as in `periodic over 2*pi/w;`; or at positions: sweep one driver";
            return Diagnostic::error(expect.quantity.span, message).hint(hint);
        }
        return no_measure(expect, wanted, nearest(wanted, names));
    }
    let message = format!("the scene `{}` does not report `{wanted}`", model.name);
    let report = Diagnostic::error(expect.quantity.span, message);
    let all = model.outputs.iter().chain(&model.states).chain(measures());
    let near = nearest(wanted, all.map(|one| one.name.as_str()));
    let near = near.filter(|_| !low.diagnostics.is_crowded());
    report.meant(near, "add it to the outputs")
}

/// A measure is a number of the whole run, and nothing else is.
fn wrong_place(expect: &Expect, wanted: &str, at: &ExpectPlace) -> Diagnostic {
    let (message, hint) = match at {
        ExpectPlace::Run => (
            format!("`{wanted}` is no measure, and has a value at each time of the run"),
            "write where: `at time = …`, `at maximum`",
        ),
        _ => (format!("`{wanted}` is a measure, a number of the whole run"), "write `at run`"),
    };
    Diagnostic::error(expect.quantity.span, message).hint(hint)
}

/// A fact about a time at which the scene does not run.
fn outside(expect: &Expect, at: &ExpectPlace, scene: &str, run: Stretch) -> Option<Diagnostic> {
    let (ExpectAt::Value { places }, ExpectPlace::Time(time)) = (&expect.at, at) else {
        return None;
    };
    let Stretch { from, to, .. } = run;
    let slack = 1e-9 * from.abs().max(to.abs());
    if !(*time < from - slack || *time > to + slack) {
        return None;
    }
    let message = format!("the scene `{scene}` runs from {from} s to {to} s, and this is outside");
    let place = places.first()?.1.span;
    Some(
        Diagnostic::error(place, message)
            .hint("choose a time of the run, or let the scene run longer"),
    )
}

/// What holds of a whole run is the value of a measure.
fn no_measure(expect: &Expect, wanted: &str, near: Option<&str>) -> Diagnostic {
    let message = format!("`{wanted}` has to be a measure: `at run` means the whole run");
    let report = Diagnostic::error(expect.quantity.span, message);
    report.meant(
        near,
        "declare a `measure`, as in `measure x_max = peak(x);`, or say where: `at time = …`",
    )
}

/// What a fact speaks of: an output, a state or dependent coordinate, or the derivative of an output of a linkage.
fn subject(term: &Term, wanted: &str, model: &SceneModel) -> Option<Subject> {
    let output = |name: &str| model.outputs.iter().position(|one| one.name == name);
    if let Some(index) = output(wanted) {
        return Some(Subject::Output(index));
    }
    if let Some(index) = model.states.iter().position(|one| one.name == wanted) {
        return Some(Subject::State(index));
    }
    let mut measures = model.measures.iter();
    if let Some(index) = measures.position(|one| one.quantity.name == wanted) {
        return Some(Subject::Measure(index));
    }
    let linkage = model.linkage.as_ref()?;
    let dependents = &linkage.dependents;
    if let Some(index) = dependents.iter().position(|one| one.quantity.name == wanted) {
        return Some(Subject::State(index));
    }
    let TermKind::Call { name, arguments } = &term.kind else {
        return None;
    };
    let ("diff", [what, by]) = (name.text.as_str(), arguments.as_slice()) else {
        return None;
    };
    let by = print::term(by);
    let variable = linkage.variables.iter().position(|variable| match variable {
        VariableInfo::Constant(index) => model.constants[*index].quantity.name == by,
        VariableInfo::Driver(index) => model.drivers[*index].name == by,
    })?;
    Some(Subject::Influence(output(&print::term(what))?, variable))
}

/// The places that plots show.
pub fn marks(low: &mut Lowering<'_>, statements: &[Statement]) -> Vec<MarkInfo> {
    let mut list = Vec::new();
    for statement in statements {
        if let StatementKind::Mark { text, variable, value } = &statement.kind {
            let places = [(variable.clone(), value.clone())];
            let at = low.places(&places, low.moved == Moved::Swept);
            list.extend(at.map(|at| MarkInfo { text: text.clone(), at }));
        }
    }
    list
}

impl Lowering<'_> {
    /// Where a fact holds, and the same in words.
    fn place_of(
        &mut self,
        expect: &Expect,
        linkage: bool,
        rests: bool,
    ) -> Option<(ExpectPlace, String)> {
        let word = match &expect.at {
            ExpectAt::Value { places } if rests => {
                let report = Diagnostic::error(
                    places[0].0.span,
                    "the scene rests, and is at one place only",
                );
                self.diagnostics.push(report.hint("write `at rest`"));
                return None;
            }
            ExpectAt::Value { places } => {
                let text = places.iter();
                let text =
                    text.map(|(name, value)| format!("{} = {}", name.text, print::term(value)));
                let text: Vec<_> = text.collect();
                return Some((self.places(places, linkage)?, format!(" at {}", text.join(", "))));
            }
            ExpectAt::Extreme(word) => word,
        };
        let place = match word.text.as_str() {
            "maximum" => ExpectPlace::Maximum,
            "minimum" => ExpectPlace::Minimum,
            "amplitude" => ExpectPlace::Amplitude,
            "run" => ExpectPlace::Run,
            "rest" if rests => ExpectPlace::Time(0.0),
            "rest" => {
                let report = Diagnostic::error(word.span, "the scene does not rest");
                self.diagnostics.push(report.hint("its task is to be `rest;`"));
                return None;
            }
            other => {
                let message = format!("`{other}` is no place in a motion");
                self.diagnostics.push(Diagnostic::error(word.span, message).hint(
                    "write `maximum`, `minimum`, `amplitude`, `theta = …`, `rest` for a position of rest, or `run` for a measure",
                ));
                return None;
            }
        };
        let label =
            if word.text == "rest" { " at rest".to_owned() } else { format!(", {}", word.text) };
        Some((place, label))
    }

    /// Where a fact holds. A linkage may be asked for positions of several drivers.
    fn places(&mut self, places: &[(Name, Term)], linkage: bool) -> Option<ExpectPlace> {
        if linkage && self.moved == Moved::Swept {
            return self.positions(places);
        }
        let [(variable, value)] = places else {
            let (second, _) = &places[1];
            self.diagnostics.push(
                Diagnostic::error(second.span, "a motion is asked for one place")
                    .hint("give the time, or the position of one driver"),
            );
            return None;
        };
        self.place(variable, value)
    }

    fn positions(&mut self, places: &[(Name, Term)]) -> Option<ExpectPlace> {
        let mut positions: Vec<(usize, f64)> = Vec::new();
        for (variable, value) in places {
            match self.place(variable, value)? {
                ExpectPlace::Driver(index, _) if positions.iter().any(|one| one.0 == index) => {
                    let message = format!("`{}` is given twice", variable.text);
                    self.diagnostics.push(Diagnostic::error(variable.span, message));
                    return None;
                }
                ExpectPlace::Driver(index, position) => positions.push((index, position)),
                _ => {
                    self.diagnostics.push(
                        Diagnostic::error(
                            variable.span,
                            "this scene sweeps its drivers and has no time",
                        )
                        .hint("give the position of a driver"),
                    );
                    return None;
                }
            }
        }
        Some(ExpectPlace::Position(positions))
    }

    /// A time, or a position of a driver.
    fn place(&mut self, variable: &Name, value: &Term) -> Option<ExpectPlace> {
        if variable.text == "time" {
            return self.fixed_of(value, Kind::Of(second()), "the time").map(ExpectPlace::Time);
        }
        let Some(Role::Driver(index)) =
            self.names.table.get(&variable.text).map(|entry| &entry.role)
        else {
            let drivers: Vec<_> = self
                .names
                .drivers
                .iter()
                .map(|one| one.name.text.as_str())
                .chain(["time"])
                .collect();
            self.diagnostics.push(
                Diagnostic::error(
                    variable.span,
                    format!("`{}` is neither a driver nor the time", variable.text),
                )
                .hint(format!("a place in the motion is a value of {}", drivers.join(" or "))),
            );
            return None;
        };
        let index = *index;
        let position = self.fixed_of(value, self.kind_of(Symbol::Driver(index)), "the place")?;
        Some(ExpectPlace::Driver(index as usize, position))
    }
}
