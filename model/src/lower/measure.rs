//! Numbers of a whole run: what a measure looks at, and what it is made of.

use std::ops::RangeInclusive;

use super::{Kind, Lowering, Typed};
use crate::checked::{Measured, Moment, Primitive, PrimitiveKind};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Node, Symbol};
use crate::homogeneity::{agree, describe, over, times};
use crate::lower::second;
use crate::nearest::nearest;
use crate::program::Relation;
use crate::syntax::print;
use crate::syntax::tree::{BinaryOperator, Name, Term, TermKind};
use crate::syntax::words::MEASURING;
use crate::token::Span;

/// Most harmonics that a measure may ask for.
const HARMONICS: u32 = 1000;

/// What the measures of a scene have asked for so far.
#[derive(Default)]
pub struct Measuring {
    /// Whether a measure is being read.
    pub is_open: bool,
    /// What the scenes of the file do.
    pub tasks: Vec<Measured>,
    /// Names of the modes.
    pub modes: Vec<String>,
    /// Names of the events.
    pub events: Vec<String>,
    /// The quantities that measures look at.
    pub looked_at: Vec<Expression>,
    /// What is found of them.
    pub primitives: Vec<Primitive>,
}

/// How many arguments a measure may have, and its form.
fn form(word: &str) -> (RangeInclusive<usize>, &'static str) {
    match word {
        "duration" => (1..=1, "duration(x > y)"),
        "count" => (1..=1, "count(event), or count(enter(mode))"),
        "value" => (2..=2, "value(x, enter(mode))"),
        "cosine" | "sine" | "amplitude" => (3..=3, "amplitude(x, angle, 1)"),
        "straightness" => (2..=3, "straightness(y, x), or straightness(y, x, y > z)"),
        "frequency" | "damping" => {
            (1..=1, "frequency(1), the slowest vibration about the position of rest")
        }
        "multiplier" | "detuning" => {
            (1..=1, "multiplier(1), the largest Floquet multiplier of the motion that repeats")
        }
        _ => (1..=2, "peak(x), or peak(x, y > z) where only a part of the run counts"),
    }
}

impl Lowering<'_> {
    /// A function that only a measure knows; none if there is no such function, or a scene that has no run.
    pub(super) fn measuring(
        &mut self,
        name: &Name,
        arguments: &[Term],
        span: Span,
    ) -> Option<Typed> {
        if !MEASURING.contains(&name.text.as_str()) {
            return None;
        }
        if !self.measured.is_open {
            let report = Diagnostic::error(
                span,
                format!("`{}` is a number of a whole run, and this holds at one time", name.text),
            );
            return Some(self.error(report.hint("such numbers belong in a `measure`")));
        }
        // What it looks at is a quantity of one time.
        self.measured.is_open = false;
        let typed = self.found(name, arguments, span).unwrap_or(Typed::Wrong);
        self.measured.is_open = true;
        Some(typed)
    }

    fn found(&mut self, name: &Name, arguments: &[Term], span: Span) -> Option<Typed> {
        use PrimitiveKind as Is;
        let word = name.text.as_str();
        let (counts, shape) = form(word);
        if !counts.contains(&arguments.len()) {
            let message = format!("`{word}` does not take {} arguments", arguments.len());
            let report = Diagnostic::error(span, message);
            self.error(report.hint(format!("its form is `{shape}`")));
            return None;
        }
        let first = &arguments[0];
        match word {
            "duration" => {
                let index = self.margin(first)?;
                let value = self.primitive(Is::Duration, index, None);
                return Some(Typed::scalar(value, Kind::Of(second())));
            }
            "count" => {
                let moment = match first.kind {
                    TermKind::Call { .. } | TermKind::Binary(BinaryOperator::Equal, ..) => {
                        self.moment(first)?
                    }
                    _ => Moment::After(self.event(first)?, false),
                };
                let value = self.primitive(Is::Count(moment), 0, None);
                return Some(Typed::number(value));
            }
            "frequency" | "damping" => return self.numbered(word, first, Measured::Rest),
            "multiplier" | "detuning" => return self.numbered(word, first, Measured::Periodic),
            _ => {}
        }
        let (quantity, kind) = self.scalar(first)?;
        let place = self.look_at(quantity);
        let simple = match word {
            "value" => {
                let moment = self.moment(&arguments[1])?;
                let value = self.primitive(Is::Value(moment), place, None);
                return Some(Typed::scalar(value, kind));
            }
            "cosine" | "sine" | "amplitude" => {
                let value = self.harmonic(word, place, &arguments[1], &arguments[2])?;
                return Some(Typed::scalar(value, kind));
            }
            "peak" => Is::Peak,
            "lowest" => Is::Lowest,
            "mean" => Is::Mean,
            "rms" => Is::Rms,
            "travel" => Is::Travel,
            "straightness" => {
                let (along, _) = self.scalar(&arguments[1])?;
                Is::Straightness(self.look_at(along))
            }
            _ => Is::Integral,
        };
        let condition = match simple {
            Is::Straightness(_) => arguments.get(2),
            _ => arguments.get(1),
        };
        let window = match condition {
            Some(condition) => Some(self.margin(condition)?),
            None => None,
        };
        let kind = match simple {
            Is::Integral => times(kind, Kind::Of(second()))?,
            _ => kind,
        };
        let value = self.primitive(simple, place, window);
        Some(Typed::scalar(value, kind))
    }

    /// A number of a vibration about a position of rest, or of a disturbance of a motion that repeats.
    fn numbered(&mut self, word: &str, number: &Term, of: Measured) -> Option<Typed> {
        let (what, hint) = match of {
            Measured::Rest => ("vibration", "number 1 is the slowest"),
            _ => ("multiplier", "number 1 is the largest, or the nearest to 1"),
        };
        let index = match number.kind {
            TermKind::Number { value, unit: None }
                if value.fract() == 0.0 && (1.0..=f64::from(HARMONICS)).contains(&value) =>
            {
                value as u32
            }
            _ => {
                let message = format!("a {what} has a whole number from 1 to {HARMONICS}");
                let report = Diagnostic::error(number.span, message);
                self.diagnostics.push(report.hint(hint));
                return None;
            }
        };
        if !self.measured.tasks.contains(&of) {
            let (what, task) = match of {
                Measured::Rest => ("a position of rest", "rest;"),
                _ => ("a motion that repeats", "periodic over 2*pi/n;"),
            };
            let message =
                format!("`{word}` is a number of {what}, and no scene of the file is one");
            let report = Diagnostic::error(number.span, message);
            self.diagnostics.push(report.hint(format!("write a scene with the task `{task}`")));
            return None;
        }
        let kind = match word {
            "frequency" => PrimitiveKind::Frequency(index),
            "damping" => PrimitiveKind::Damping(index),
            "multiplier" => PrimitiveKind::Multiplier(index),
            _ => PrimitiveKind::Detuning(index),
        };
        let value = self.primitive(kind, 0, None);
        match word {
            "frequency" => Some(Typed::scalar(value, over(Kind::NUMBER, Kind::Of(second()))?)),
            _ => Some(Typed::number(value)),
        }
    }

    /// A quantity that measures look at, by its place. Each has a place of its own: two that are the same in one mode
    /// may differ in another, and a place means the same in all of them.
    fn look_at(&mut self, quantity: Expression) -> usize {
        self.measured.looked_at.push(quantity);
        self.measured.looked_at.len() - 1
    }

    /// What stands in a measure for something that is found.
    fn primitive(
        &mut self,
        kind: PrimitiveKind,
        argument: usize,
        window: Option<usize>,
    ) -> Expression {
        let index = self.measured.primitives.len();
        self.measured.primitives.push(Primitive { kind, argument, window });
        self.graph.symbol(Symbol::Measured(index as u32))
    }

    fn harmonic(
        &mut self,
        word: &str,
        place: usize,
        angle: &Term,
        order: &Term,
    ) -> Option<Expression> {
        let (turned, kind) = self.scalar(angle)?;
        if agree(kind, Kind::NUMBER).is_none() {
            let message =
                format!("an angle is expected here, and this is {}", describe(kind.dimension()));
            self.diagnostics.push(Diagnostic::error(angle.span, message));
            return None;
        }
        let order = match order.kind {
            TermKind::Number { value, unit: None }
                if value.fract() == 0.0 && (0.0..=f64::from(HARMONICS)).contains(&value) =>
            {
                value as u32
            }
            _ => {
                let message = format!("a harmonic has a whole number from 0 to {HARMONICS}");
                self.diagnostics.push(Diagnostic::error(order.span, message));
                return None;
            }
        };
        let direction = self.direction()?;
        let rate = self.graph.tangent(&[turned], &direction)[0];
        let (turned, rate) = (self.look_at(turned), self.look_at(rate));
        let cosine = PrimitiveKind::Cosine(turned, rate, order);
        let sine = PrimitiveKind::Sine(turned, rate, order);
        Some(match word {
            "cosine" => self.primitive(cosine, place, None),
            "sine" => self.primitive(sine, place, None),
            _ => {
                let parts = [cosine, sine].map(|kind| self.primitive(kind, place, None));
                self.graph.call(crate::program::Function::Hypot, &parts)
            }
        })
    }

    /// `enter(mode)`, `leave(mode)`, `before(event)`, `after(event)`, `last(enter(mode))`, `start` or `end`.
    fn moment(&mut self, term: &Term) -> Option<Moment> {
        match &term.kind {
            TermKind::Name(word) if word == "start" => return Some(Moment::Start),
            TermKind::Name(word) if word == "end" => return Some(Moment::End),
            TermKind::Binary(BinaryOperator::Equal, ..) => return self.passage(term),
            TermKind::Call { name, arguments } => {
                match (name.text.as_str(), arguments.as_slice()) {
                    ("last", [inner]) => {
                        if let Some(last) = last_time(self.moment(inner)?) {
                            return Some(last);
                        }
                    }
                    ("enter", [mode]) => return Some(Moment::Enter(self.mode(mode)?, false)),
                    ("leave", [mode]) => return Some(Moment::Leave(self.mode(mode)?, false)),
                    ("before", [event]) => {
                        return Some(Moment::Before(self.event(event)?, false));
                    }
                    ("after", [event]) => {
                        return Some(Moment::After(self.event(event)?, false));
                    }
                    _ => {}
                }
            }
            _ => {}
        }
        let hint = self.moments(term);
        let report = Diagnostic::error(term.span, "a moment of the run is expected here");
        self.diagnostics.push(report.hint(hint));
        None
    }

    /// `x == y`: where both are equal for the first time.
    fn passage(&mut self, term: &Term) -> Option<Moment> {
        let condition = self.condition(term)?;
        let difference = match *self.graph.node(condition) {
            Node::Compare(Relation::Equal, left, right) => Some(self.graph.sub(left, right)),
            _ => None,
        };
        let Some(difference) = difference.filter(|one| !self.is_constant(*one)) else {
            let report = Diagnostic::error(term.span, "nothing in this changes during the run");
            self.diagnostics
                .push(report.hint("compare what moves with a value, as in `x == 1 mm`"));
            return None;
        };
        Some(Moment::Passes(self.look_at(difference), false))
    }

    /// Which moments there are; of the event or mode that a term names, if it names one.
    fn moments(&self, term: &Term) -> String {
        let measured = &self.measured;
        let name = print::term(term);
        if measured.events.contains(&name) {
            return format!("write `before({name})` or `after({name})`");
        }
        if measured.modes.contains(&name) {
            return format!("write `enter({name})` or `leave({name})`");
        }
        let mut moments = vec!["`start`", "`end`", "`x == 1 mm`"];
        if measured.modes.iter().any(|mode| !mode.is_empty()) {
            moments.extend(["`enter(mode)`", "`leave(mode)`"]);
        }
        if measured.events.is_empty() {
            return format!(
                "write {}; an event has moments once it has a name, `when hit: x falls …`: `before(hit)`, `after(hit)`",
                moments.join(", ")
            );
        }
        moments.extend(["`before(event)`", "`after(event)`"]);
        format!("write {}, and around one of them `last(…)` for the last time", moments.join(", "))
    }

    /// The event that a term names.
    fn event(&mut self, term: &Term) -> Option<String> {
        let name = print::term(term);
        let Measuring { events, modes, .. } = &self.measured;
        if events.contains(&name) {
            return Some(name);
        }
        let hint = match nearest(&name, events.iter().map(String::as_str)) {
            _ if modes.contains(&name) => {
                format!("`{name}` is a mode: write `enter({name})` or `leave({name})`")
            }
            Some(near) => format!("did you mean `{near}`?"),
            None if events.is_empty() => {
                "give the event a name, `when hit: x falls …`, and write `count(hit)`".to_owned()
            }
            None => format!("the events with a name are {}", events.join(", ")),
        };
        let report = Diagnostic::error(term.span, "the name of an event is expected here");
        self.diagnostics.push(report.hint(hint));
        None
    }

    fn mode(&mut self, term: &Term) -> Option<usize> {
        let wanted = match &term.kind {
            TermKind::Name(name) => name.clone(),
            _ => String::new(),
        };
        let modes = &self.measured.modes;
        if let Some(index) = modes.iter().position(|one| *one == wanted && !one.is_empty()) {
            return Some(index);
        }
        let report = Diagnostic::error(term.span, "a mode of this scene is expected here");
        let near = nearest(&wanted, modes.iter().map(String::as_str));
        let hint = match near {
            Some(near) if !near.is_empty() => format!("did you mean `{near}`?"),
            _ if modes.iter().all(String::is_empty) => {
                "this scene has no modes; an event is counted by its name: `when hit: x falls …`, `count(hit)`".to_string()
            }
            _ => format!("its modes are {}", modes.join(", ")),
        };
        self.diagnostics.push(report.hint(hint));
        None
    }

    /// A quantity that is positive where a condition holds, by its place.
    fn margin(&mut self, term: &Term) -> Option<usize> {
        let condition = self.condition(term)?;
        match self.margin_of(condition) {
            Some(margin) => Some(self.look_at(margin)),
            None => {
                let report = Diagnostic::error(
                    term.span,
                    "how long two quantities are exactly equal cannot be measured",
                );
                self.diagnostics.push(report.hint("compare them with `<` or `>`"));
                None
            }
        }
    }

    fn margin_of(&mut self, condition: Expression) -> Option<Expression> {
        use crate::program::Function::{Max, Min};
        match self.graph.node(condition).clone() {
            Node::Compare(Relation::Less | Relation::LessEqual, a, b) => Some(self.graph.sub(b, a)),
            Node::And(a, b) => {
                let parts = [self.margin_of(a)?, self.margin_of(b)?];
                Some(self.graph.call(Min, &parts))
            }
            Node::Or(a, b) => {
                let parts = [self.margin_of(a)?, self.margin_of(b)?];
                Some(self.graph.call(Max, &parts))
            }
            Node::Not(a) => {
                let margin = self.margin_of(a)?;
                Some(self.graph.neg(margin))
            }
            _ => None,
        }
    }
}

/// The last time that a moment comes, if it may come several times.
fn last_time(moment: Moment) -> Option<Moment> {
    match moment {
        Moment::Enter(mode, _) => Some(Moment::Enter(mode, true)),
        Moment::Leave(mode, _) => Some(Moment::Leave(mode, true)),
        Moment::Before(event, _) => Some(Moment::Before(event, true)),
        Moment::After(event, _) => Some(Moment::After(event, true)),
        Moment::Passes(place, _) => Some(Moment::Passes(place, true)),
        Moment::Start | Moment::End => None,
    }
}
