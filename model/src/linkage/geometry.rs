//! Points and links, and where the drivers go.

use crate::checked::{Distribution, LinkInfo, RangeInfo};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::agree;
use crate::lower::{Kind, Lowering, Typed};
use crate::nearest::nearest;
use crate::resolve::{Declared, Names};
use crate::syntax::print;
use crate::syntax::tree::{Driver, Scene, SceneItem, Statement, StatementKind, SweepRange, Term};

/// What is drawn.
#[derive(Default)]
pub struct Geometry {
    /// Positions of the points, x and y of each; behind them those at which forces act.
    pub points: Vec<Expression>,
    /// Their names.
    pub names: Vec<String>,
    /// Lines between them.
    pub links: Vec<LinkInfo>,
    /// For each of the forces the first of the two outputs that it is.
    pub arrows: Vec<usize>,
}

impl Geometry {
    /// Reads points and links, and which outputs are the force of a closure.
    pub fn read(
        statements: &[Statement],
        names: &Names,
        outputs: &[Expression],
        low: &mut Lowering<'_>,
    ) -> Self {
        let mut geometry = Self::default();
        for point in &names.points {
            geometry.point(point, low);
        }
        for statement in statements {
            if let StatementKind::Link { points, text } = &statement.kind {
                let found: Option<Vec<usize>> =
                    points.iter().map(|point| geometry.find(point, low)).collect();
                geometry.links.extend(found.map(|points| {
                    LinkInfo {
                        points,
                        text: text.clone().unwrap_or_else(|| {
                            statement.documentation.join(" ").trim().to_string()
                        }),
                    }
                }));
            }
        }
        if !geometry.names.is_empty() {
            geometry.forces(outputs, low);
        }
        geometry
    }

    /// Outputs that are the force of a closure, on what stands on its left side or on the right one.
    fn forces(&mut self, outputs: &[Expression], low: &mut Lowering<'_>) {
        for closure in low.closures.clone() {
            let Some(place) = closure.place.filter(|_| closure.equations.len() == 2) else {
                continue;
            };
            let force =
                closure.equations.map(|index| low.graph.symbol(Symbol::Reaction(index as u32)));
            let force: Vec<_> = force.collect();
            let opposite: Vec<_> = force.iter().map(|one| low.graph.neg(*one)).collect();
            let mut pairs = outputs.windows(2);
            if let Some(first) = pairs.position(|pair| pair == force || pair == opposite) {
                self.points.extend(place);
                self.arrows.push(first);
            }
        }
    }

    fn point(&mut self, point: &Declared<Term>, low: &mut Lowering<'_>) {
        let name = Term {
            span: point.name.span,
            kind: crate::syntax::tree::TermKind::Name(point.name.text.clone()),
        };
        let length = crate::unit::Dimension::base(0);
        let typed = low.term(&name);
        let found = typed.describe();
        match typed {
            Typed::Wrong => {}
            Typed::Quantity(place)
                if place.values().len() == 2 && agree(place.kind, Kind::Of(length)).is_some() =>
            {
                self.points.extend(place.values());
                self.names.push(point.name.text.clone());
            }
            _ => {
                let message =
                    format!("a point has two coordinates that are lengths, and this is {found}");
                low.diagnostics.push(
                    Diagnostic::error(point.what.span, message)
                        .hint("write `[x, y]`, or `l*dir(phi)` for the end of a link"),
                );
            }
        }
    }

    fn find(&self, point: &Term, low: &mut Lowering<'_>) -> Option<usize> {
        let wanted = print::term(point).replace(' ', "");
        let found = self.names.iter().position(|name| *name == wanted);
        if found.is_none() && !low.has_wrong_point(&wanted) && !low.is_unread(&wanted) {
            let report = Diagnostic::error(point.span, format!("there is no point `{wanted}`"));
            let near = nearest(&wanted, self.names.iter().map(String::as_str));
            let otherwise = format!("declare it: `point {wanted} = [x, y];`");
            low.diagnostics.push(report.meant(near, otherwise));
        }
        found
    }
}

impl Lowering<'_> {
    /// Whether a point was declared wrongly, which has been reported.
    fn has_wrong_point(&self, name: &str) -> bool {
        self.names.points.iter().any(|point| point.name.text == name)
    }
}

/// Where the drivers go.
#[derive(Default)]
pub struct Ranges {
    /// For each driver its range, nothing stated being NaN.
    pub list: Vec<RangeInfo>,
}

impl Ranges {
    /// Whether a driver is set with an error.
    pub fn have_tolerances(&self) -> bool {
        self.list.iter().any(|range| range.tolerance.0 > 0.0)
    }

    /// Reads declared ranges and those of the scene.
    pub fn read(names: &Names, scene: Option<&Scene>, low: &mut Lowering<'_>) -> Self {
        let swept: Vec<&SweepRange> = scene
            .iter()
            .flat_map(|scene| &scene.items)
            .filter_map(|item| match item {
                SceneItem::Sweep { drivers } => Some(drivers),
                _ => None,
            })
            .flatten()
            .collect();
        for one in &swept {
            let is_known = names.drivers.iter().any(|driver| driver.name.text == one.driver.text);
            if !is_known && !low.is_unread(&one.driver.text) {
                let known = || names.drivers.iter().map(|driver| driver.name.text.as_str());
                let report = Diagnostic::error(
                    one.driver.span,
                    format!("there is no driver `{}`", one.driver.text),
                );
                low.diagnostics.push(match nearest(&one.driver.text, known()) {
                    Some(near) => report.hint(format!("did you mean `{near}`?")),
                    None if names.drivers.is_empty() => report
                        .hint("what moves by itself is followed in time: `run time 0 s .. 1 s;`"),
                    None => report.hint(format!(
                        "the drivers are {}",
                        known().collect::<Vec<_>>().join(", ")
                    )),
                });
            }
        }
        let list = names
            .drivers
            .iter()
            .enumerate()
            .filter_map(|(index, driver)| {
                let own = swept.iter().find(|one| one.driver.text == driver.name.text);
                low.range(index as u32, driver, own.copied(), !swept.is_empty())
            })
            .collect();
        Self { list }
    }
}

impl Lowering<'_> {
    fn range(
        &mut self,
        index: u32,
        driver: &Declared<Driver>,
        swept: Option<&SweepRange>,
        others: bool,
    ) -> Option<RangeInfo> {
        let kind = self.kind_of(Symbol::Driver(index));
        let what = format!("`{}`", driver.name.text);
        let stated = swept.and_then(|one| one.range.as_ref()).or(driver.what.range.as_ref());
        let (mut from, mut to) = (f64::NAN, f64::NAN);
        if let Some((low, high)) = stated {
            (from, to) = (self.fixed_of(low, kind, &what)?, self.fixed_of(high, kind, &what)?);
            if from == to || (driver.what.range.as_ref() == stated && from > to) {
                self.diagnostics.push(
                    Diagnostic::error(
                        low.span.to(high.span),
                        "the range is empty: its lower end is not below its upper end",
                    )
                    .hint("a `sweep` may run backwards, a declared range may not"),
                );
                return None;
            }
        }
        let declared = match &driver.what.range {
            Some((low, high)) => {
                (self.fixed_of(low, kind, &what)?, self.fixed_of(high, kind, &what)?)
            }
            None => (from, to),
        };
        let start = match &driver.what.start {
            Some(term) => self.fixed_of(term, kind, &what)?,
            None => (declared.0 + declared.1) / 2.0,
        };
        if let (Some(term), Some((low, high))) = (&driver.what.start, &driver.what.range)
            && !(declared.0..=declared.1).contains(&start)
        {
            self.diagnostics.push(
                Diagnostic::error(term.span, format!("{what} starts outside its range"))
                    .related(low.span.to(high.span), "the range")
                    .hint("what stands after `~` is where the start values of the dependent coordinates are meant"),
            );
            return None;
        }
        // A driver that the scene does not name stands where it starts.
        if others && swept.is_none() {
            (from, to) = (start, start);
        }
        let tolerance = match &driver.what.tolerance {
            Some(tolerance) => self.tolerance(tolerance, kind, start)?,
            None => (0.0, Distribution::default()),
        };
        Some(RangeInfo { from, to, start, period: f64::INFINITY, tolerance })
    }
}
