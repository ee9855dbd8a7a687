//! Sampled curves: their points as numbers, and the spline through them.

use std::sync::Arc;

use assur_functions::{Ends, Spline, TableFault};

use super::{Kind, Lowering, Typed};
use crate::checked::LiteralInfo;
use crate::diagnostic::Diagnostic;
use crate::homogeneity::{agree, disagreement, unlike};
use crate::nearest::nearest;
use crate::sheet::{Column, Sheet};
use crate::syntax::print;
use crate::syntax::tree::{Name, Points, TableTerm, Term};
use crate::token::Span;
use crate::unit::{Unit, parse_unit_text};

/// The points of a curve as numbers in SI units.
struct Sampled {
    list: Vec<(f64, f64)>,
    kinds: (Kind, Kind),
    /// Where the abscissas and the ordinates stand.
    spans: (Span, Span),
}

impl Lowering<'_> {
    pub(super) fn table(&mut self, table: &TableTerm, term: &Term) -> Typed {
        let at = self.scalar(&table.at);
        let points = match &table.points {
            Points::Written(points) => self.written(points, term.span),
            Points::File { file, column, sheet } => sheet.as_ref().and_then(|sheet| {
                // Other units of the scene do not change what stands in the file.
                self.note(Some(LiteralInfo { text: print::term(term), span: term.span }));
                self.columns(sheet, file, column.as_ref())
            }),
        };
        let (Some((at, at_kind)), Some(Sampled { list, kinds, spans })) = (at, points) else {
            return Typed::Wrong;
        };
        if agree(at_kind, kinds.0).is_none() {
            let message = unlike("the abscissa of the table", kinds.0, at_kind);
            return self
                .error(Diagnostic::error(table.at.span, message).related(spans.0, "its points"));
        }
        let error = match &table.error {
            Some(error) => match self.fixed(error) {
                Some((value, kind)) if agree(kind, kinds.1).is_some() => Some(value),
                Some((_, kind)) => {
                    let places = ((spans.1, kinds.1), (error.span, kind));
                    return self.error(disagreement(
                        "the points and their error are",
                        places.0,
                        places.1,
                    ));
                }
                None => return Typed::Wrong,
            },
            None => None,
        };
        let ends = if table.is_periodic { Ends::Periodic } else { Ends::Open };
        match Spline::new(&print::term(term), &list, ends, error) {
            Ok(spline) => Typed::scalar(self.graph.sampled(Arc::new(spline), 0, at), kinds.1),
            Err(fault) => self.no_curve(fault, &table.points, (spans, term.span)),
        }
    }

    /// Points that stand in the term.
    fn written(&mut self, points: &[(Term, Term)], span: Span) -> Option<Sampled> {
        let mut sampled =
            Sampled { list: Vec::new(), kinds: (Kind::Any, Kind::Any), spans: (span, span) };
        let mut firsts: [Option<Span>; 2] = [None; 2];
        for (x, y) in points {
            let (one, other) = (self.fixed(x), self.fixed(y));
            let (Some(one), Some(other)) = (one, other) else {
                return None;
            };
            let kinds = [
                (&mut sampled.kinds.0, one.1, x, "abscissas"),
                (&mut sampled.kinds.1, other.1, y, "ordinates"),
            ];
            for (index, (known, kind, term, words)) in kinds.into_iter().enumerate() {
                let first = firsts[index].unwrap_or(term.span);
                let Some(both) = agree(*known, kind) else {
                    let what = format!("the {words} are");
                    self.error(disagreement(&what, (first, *known), (term.span, kind)));
                    return None;
                };
                *known = both;
                firsts[index] = Some(first);
            }
            sampled.list.push((one.0, other.0));
        }
        if sampled.kinds.1 == Kind::Any {
            sampled.kinds.1 = Kind::NUMBER;
        }
        sampled.spans = (firsts[0].unwrap_or(span), firsts[1].unwrap_or(span));
        Some(sampled)
    }

    /// Points that stand in a file: its first column, and another one.
    fn columns(&mut self, sheet: &Sheet, file: &Name, wanted: Option<&Name>) -> Option<Sampled> {
        let heads = || sheet.columns[1..].iter().map(|one| one.name.as_str());
        let column = match wanted {
            Some(name) => sheet.column(&name.text).ok_or_else(|| {
                let message = format!("`{}` has no column `{}`", file.text, name.text);
                let hint = match nearest(&name.text, heads()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("it has {}", list(heads())),
                };
                Diagnostic::error(name.span, message).hint(hint)
            }),
            None if sheet.columns.len() == 2 => Ok(&sheet.columns[1]),
            None => {
                let message = format!("`{}` has several columns: {}", file.text, list(heads()));
                let hint =
                    format!("name one: `table(\"{}\", x, {})`", file.text, sheet.columns[1].name);
                Err(Diagnostic::error(file.span, message).hint(hint))
            }
        };
        let column = column.map_err(|report| self.diagnostics.push(report)).ok()?;
        let columns = [&sheet.columns[0], column].map(|one| self.in_si_units(one, file));
        let [Some((abscissas, first)), Some((ordinates, second))] = columns else {
            return None;
        };
        Some(Sampled {
            list: abscissas.into_iter().zip(ordinates).collect(),
            kinds: (first, second),
            spans: (file.span, file.span),
        })
    }

    /// The values of a column.
    fn in_si_units(&mut self, column: &Column, file: &Name) -> Option<(Vec<f64>, Kind)> {
        let unit = match column.unit.as_str() {
            "" => Unit::none(),
            text => match parse_unit_text(text) {
                Ok(unit) => unit,
                Err(error) => {
                    let message =
                        format!("`{}`: the unit of `{}`: {}", file.text, column.name, error.reason);
                    let report = Diagnostic::error(file.span, message);
                    self.error(error.hint.iter().fold(report, |report, hint| report.hint(hint)));
                    return None;
                }
            },
        };
        let values = column.values.iter().map(|value| unit.to_si(*value));
        Some((values.collect(), Kind::Of(unit.dimension)))
    }

    /// Reports points that make no curve.
    fn no_curve(
        &mut self,
        fault: TableFault,
        points: &Points,
        (spans, whole): ((Span, Span), Span),
    ) -> Typed {
        let index = match fault {
            TableFault::NotFinite(index)
            | TableFault::Equal(index)
            | TableFault::Falling(index) => Some(index),
            _ => None,
        };
        let (place, before) = match (points, index) {
            (Points::Written(list), Some(index)) => (list[index].0.span, String::new()),
            (Points::File { file, sheet: Some(sheet), .. }, Some(index)) => {
                (file.span, format!("line {} of `{}`: ", sheet.lines[index], file.text))
            }
            (Points::File { file, .. }, _) => (file.span, format!("`{}`: ", file.text)),
            _ => (
                if matches!(fault, TableFault::Open { .. }) { spans.1 } else { whole },
                String::new(),
            ),
        };
        let (message, hint) = match fault {
            TableFault::Open { first, last } => (
                format!("it begins with {first:.6e} and ends with {last:.6e} in SI units"),
                "repeat the first ordinate at the end of the period",
            ),
            TableFault::Few(_) => (String::new(), "give at least two points"),
            TableFault::Error(_) => {
                (String::new(), "leave `smooth` out for a curve through the points")
            }
            _ => (String::new(), "give each point an abscissa of its own, in rising order"),
        };
        let message = if message.is_empty() { message } else { format!(": {message}") };
        let message = format!("{before}{fault}{message}");
        self.error(Diagnostic::error(place, message).hint(hint))
    }
}

/// Names, in words.
fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
