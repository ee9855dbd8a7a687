//! Values and units of what a scene declares: constants with their defaults, kinds of coordinates, motion of drivers.

use crate::checked::{ConstantInfo, QuantityInfo};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Expression, Map, Symbol};
use crate::homogeneity::{agree, disagreement, over, unlike};
use crate::lower::{Kind, Lowering, Moved, Typed, second};
use crate::resolve::{Declared, Names};
use crate::syntax::print;
use crate::syntax::tree::{
    Constant, Dependent, Distribution, Driver, Name, Term, TermKind, Tolerance, UnitTerm, Unknown,
};
use crate::token::Span;
use crate::unit::{self, Dimension, Unit};

/// A description of a quantity.
pub fn quantity(name: &str, summary: &str, dimension: &Dimension, unit: &Unit) -> QuantityInfo {
    QuantityInfo {
        name: name.to_string(),
        summary: summary.to_string(),
        unit: unit.symbol.clone(),
        factor: unit.scale(),
        dimension: dimension.exponents(),
    }
}

/// The unit of a time derivative, `rad` to `rad/s`.
pub fn per_second(unit: &Unit) -> Option<Unit> {
    let dimension = unit.dimension.div(&second())?;
    let symbol = match unit.symbol.as_str() {
        "" => "1/s".to_string(),
        symbol => match symbol.strip_suffix("/s") {
            Some(moved) => format!("{moved}/s^2"),
            None if symbol.contains('/') => return Some(Unit::for_dimension(&dimension)),
            None => format!("{symbol}/s"),
        },
    };
    let read = unit::parse_unit_text(&symbol).ok().filter(|read| read.dimension == dimension);
    Some(read.unwrap_or_else(|| Unit::for_dimension(&dimension)))
}

/// The first unit that is written in a term.
fn written_unit(term: &Term, diagnostics: &mut Diagnostics) -> Option<Unit> {
    match &term.kind {
        TermKind::Number { unit: Some(written), .. } => unit::resolve(written, diagnostics),
        TermKind::Unary(_, inner) => written_unit(inner, diagnostics),
        TermKind::Binary(_, left, right) | TermKind::Bound { value: right, instead: left, .. } => {
            written_unit(left, diagnostics).or_else(|| written_unit(right, diagnostics))
        }
        _ => None,
    }
}

/// That a constant, or one made within its tolerance, lies outside its range.
fn out_of_range(constant: &Constant, value: Span, info: &ConstantInfo) -> Option<Diagnostic> {
    let (low, high) = info.range;
    if !(low..=high).contains(&info.default) {
        let report = Diagnostic::error(value, "the default lies outside the permitted range");
        return Some(report.hint("change the default, or make the range wider"));
    }
    let tolerance = constant.tolerance.as_ref()?;
    let is_within = low <= info.default - info.tolerance && info.default + info.tolerance <= high;
    let message = "sizes within this tolerance leave the permitted range";
    (!is_within).then(|| Diagnostic::error(tolerance.half_width.span, message))
}

/// The motion of a driver.
#[derive(Clone, Copy, Debug, Default)]
pub struct Drive {
    /// Its position in time.
    pub position: Option<Expression>,
    /// Its speed.
    pub rate: Option<Expression>,
    /// Its acceleration.
    pub acceleration: Option<Expression>,
}

impl Lowering<'_> {
    /// A fixed value: numbers, `pi` and functions of them.
    pub fn fixed(&mut self, term: &Term) -> Option<(f64, Kind)> {
        let what = "a fixed value is expected here, made of numbers alone";
        let hint = "a value that depends on other values is a `let`";
        let (value, kind) = self.made_of(term, |_| false, (what, hint))?;
        let number = self.graph.evaluate(&[value], &|_| f64::NAN)[0];
        if !number.is_finite() {
            self.diagnostics
                .push(Diagnostic::error(term.span, format!("the value of this is {number}")));
            return None;
        }
        Some((number, kind))
    }

    /// Where something starts that closures determine: by the constants, and by where drivers and coordinates start.
    pub fn start(&mut self, term: &Term) -> Option<(Expression, Kind)> {
        let is_given = |symbol| {
            matches!(symbol, Symbol::Parameter(_) | Symbol::Driver(_) | Symbol::Coordinate(_))
        };
        let what = "a start value is expected here, made of numbers, constants, drivers and coordinates alone";
        let hint = "it says how the links are put together before anything moves";
        self.made_of(term, is_given, (what, hint))
    }

    /// A value that depends on nothing but what it may be made of; anything else is reported.
    fn made_of(
        &mut self,
        term: &Term,
        may: impl Fn(Symbol) -> bool,
        (what, hint): (&str, &str),
    ) -> Option<(Expression, Kind)> {
        let before = self.diagnostics.error_count();
        let lowered = self.scalar(term);
        let depends = match lowered {
            Some((value, _)) => self.graph.depends_on(value, |symbol| !may(symbol)),
            // What moves has no kind yet where constants are read.
            None => {
                self.diagnostics.error_count() == before
                    && !self.is_incomplete()
                    && !term.is_made_of_numbers()
            }
        };
        if depends {
            self.diagnostics.push(Diagnostic::error(term.span, what).hint(hint));
            return None;
        }
        lowered
    }

    /// The value of a term that has to be of a kind.
    pub fn fixed_of(&mut self, term: &Term, kind: Kind, what: &str) -> Option<f64> {
        let (value, found) = self.fixed(term)?;
        self.check_kind(term, (kind, found), what)?;
        Some(value)
    }

    /// Where something of a kind starts.
    pub fn start_of(&mut self, term: &Term, kind: Kind, what: &str) -> Option<Expression> {
        let (value, found) = self.start(term)?;
        self.check_kind(term, (kind, found), what)?;
        Some(value)
    }

    fn check_kind(&mut self, term: &Term, (kind, found): (Kind, Kind), what: &str) -> Option<()> {
        if agree(found, kind).is_none() {
            let message = unlike(what, kind, found);
            let unit = Unit::for_dimension(&kind.dimension()).symbol;
            let hint = match unit.as_str() {
                "" => "give it as a pure number or an angle".to_owned(),
                unit => format!("give it in {unit}"),
            };
            self.diagnostics.push(Diagnostic::error(term.span, message).hint(hint));
            return None;
        }
        Some(())
    }

    /// Default, tolerance and range of a constant. Declares its kind.
    pub fn constant(&mut self, index: u32, declared: &Declared<Constant>) -> Option<ConstantInfo> {
        let constant = &declared.what;
        let Some(value) = &constant.value else {
            self.diagnostics.push(
                Diagnostic::error(
                    declared.name.span,
                    format!("`{}` has no value", declared.name.text),
                )
                .hint("give it a default with its unit, as in `= 75 mm`"),
            );
            return None;
        };
        if !value.is_made_of_numbers() {
            self.diagnostics.push(
                Diagnostic::error(
                    value.span,
                    format!("the value of `{}` is not made of numbers alone", declared.name.text),
                )
                .hint(in_brackets(value).unwrap_or_else(|| {
                    format!(
                        "a value that follows from others is a `let {} = …;`",
                        declared.name.text
                    )
                })),
            );
            return None;
        }
        let (default, kind) = self.fixed(value)?;
        let dimension = kind.dimension();
        let unit = written_unit(value, self.diagnostics).filter(|unit| unit.dimension == dimension);
        let unit = unit.unwrap_or_else(|| Unit::for_dimension(&dimension));
        let kind = Kind::Of(dimension);
        self.declare_kind(Symbol::Parameter(index), kind, &unit);
        let mut info = ConstantInfo {
            quantity: quantity(&declared.name.text, &declared.summary, &dimension, &unit),
            is_dimension: constant.is_dimension,
            default,
            tolerance: 0.0,
            distribution: Distribution::default(),
            range: (f64::NEG_INFINITY, f64::INFINITY),
        };
        if let Some(tolerance) = &constant.tolerance {
            (info.tolerance, info.distribution) = self.tolerance(tolerance, kind, default)?;
        }
        if let Some(range) = &constant.range {
            info.range = self.permitted(range, kind)?;
            if let Some(report) = out_of_range(constant, value.span, &info) {
                self.diagnostics.push(report.related(range.0.span.to(range.1.span), "the range"));
                return None;
            }
        }
        Some(info)
    }

    /// The range of a constant, SI units.
    fn permitted(&mut self, (low, high): &(Term, Term), kind: Kind) -> Option<(f64, f64)> {
        let low_value = self.fixed_of(low, kind, "the bounded value")?;
        let high_value = self.fixed_of(high, kind, "the bounded value")?;
        if low_value >= high_value {
            self.diagnostics.push(Diagnostic::error(
                low.span.to(high.span),
                "the range is empty: its lower end is not below its upper end",
            ));
            return None;
        }
        Some((low_value, high_value))
    }

    /// Half-width and distribution of a permitted error about a mean.
    pub fn tolerance(
        &mut self,
        tolerance: &Tolerance,
        kind: Kind,
        mean: f64,
    ) -> Option<(f64, Distribution)> {
        let half_width = self.fixed_of(&tolerance.half_width, kind, "the toleranced size")?;
        if half_width < 0.0 {
            self.diagnostics.push(Diagnostic::error(
                tolerance.half_width.span,
                "a tolerance cannot be negative",
            ));
            return None;
        }
        if tolerance.distribution == Distribution::Lognormal && mean <= 0.0 {
            let message = "only what is above zero is distributed lognormally";
            let report = Diagnostic::error(tolerance.half_width.span, message);
            self.diagnostics.push(report.hint("write `normal`, `uniform` or `truncated`"));
            return None;
        }
        Some((half_width, tolerance.distribution))
    }

    /// Kind and unit of a coordinate or state.
    pub fn unknown(&mut self, symbol: Symbol, declared: &Declared<Unknown>) -> Option<Unit> {
        let Unknown { unit, start, .. } = &declared.what;
        self.position(symbol, &declared.name, (unit.as_ref(), start.as_ref()))
    }

    /// Lowers the motions of all drivers and takes their rates.
    pub fn drivers(&mut self, names: &Names, moved: Moved) -> Vec<Drive> {
        let mut drives = Vec::new();
        for (index, driver) in names.drivers.iter().enumerate() {
            let drive = match &driver.what.motion {
                Some(term) => self.motion_of(index as u32, term, moved),
                None => self.free(index as u32, driver, moved),
            };
            drives.push(drive.unwrap_or_default());
        }
        self.drivers_read();
        drives
    }

    fn motion_of(&mut self, index: u32, term: &Term, moved: Moved) -> Option<Drive> {
        let symbol = Symbol::Driver(index);
        let before = self.diagnostics.error_count();
        let Some((value, kind)) = self.scalar(term) else {
            // Another driver that is not read yet says nothing by itself.
            if self.diagnostics.error_count() == before {
                self.not_prescribed(term.span);
            }
            return None;
        };
        let moving = |symbol| !matches!(symbol, Symbol::Time | Symbol::Parameter(_));
        if self.graph.depends_on(value, moving) {
            self.not_prescribed(term.span);
            return None;
        }
        let dimension = kind.dimension();
        let unit = match dimension == Dimension::NONE {
            true => {
                unit::parse_unit_text("rad").unwrap_or_else(|_| Unit::for_dimension(&dimension))
            }
            false => Unit::for_dimension(&dimension),
        };
        self.declare_kind(symbol, Kind::Of(dimension), &unit);
        let direction = Map::from_iter([(Symbol::Time, self.graph.one())]);
        let rate = self.graph.tangent(&[value], &direction)[0];
        let acceleration = self.graph.tangent(&[rate], &direction)[0];
        let varies = self.graph.depends_on(rate, |symbol| symbol == Symbol::Time);
        let given = self.graph.symbol(Symbol::DriverRate(index));
        let speed = match moved {
            Moved::Given => Some(given),
            // Where the driver is swept, its speed is known if it is always the same.
            Moved::Swept if varies => None,
            _ if self.has_speeds => {
                self.followed.insert(Symbol::DriverRate(index), rate);
                self.followed.insert(Symbol::DriverAcceleration(index), acceleration);
                Some(given)
            }
            _ => Some(rate),
        };
        self.driver_motions[index as usize] = speed.map(|speed| (value, speed));
        Some(Drive { position: Some(value), rate: Some(rate), acceleration: Some(acceleration) })
    }

    /// A driver without a motion, which is set from outside.
    fn free(&mut self, index: u32, driver: &Declared<Driver>, moved: Moved) -> Option<Drive> {
        let name = &driver.name.text;
        if moved != Moved::Swept {
            // What could not be read may have closed the loops that it drives.
            if self.is_incomplete() {
                return None;
            }
            let message = format!("the motion of the driver `{name}` is not stated");
            let hint = match name.rsplit_once('.') {
                Some((part, own)) => {
                    format!("bind it where `{part}` is declared, as in `{own} = n*time;`")
                }
                None => format!("say how it moves, as in `driver {name} = n*time;`"),
            };
            self.diagnostics.push(Diagnostic::error(driver.name.span, message).hint(hint));
            return None;
        }
        let bounds = driver.what.range.iter().flat_map(|(low, high)| [low, high]);
        let Some(term) = driver.what.start.iter().chain(bounds).next() else {
            let message = format!("nothing says where the driver `{name}` is");
            self.diagnostics.push(
                Diagnostic::error(driver.name.span, message)
                    .hint(format!("give it a range, as in `driver {name} in 60 deg .. 120 deg;`")),
            );
            return None;
        };
        let (_, kind) = self.fixed(term)?;
        let dimension = kind.dimension();
        let unit = written_unit(term, self.diagnostics).filter(|unit| unit.dimension == dimension);
        let unit = unit.unwrap_or_else(|| Unit::for_dimension(&dimension));
        self.declare_kind(Symbol::Driver(index), Kind::Of(dimension), &unit);
        None
    }

    /// Kind and unit of a dependent coordinate: those that it states, else those of its start value.
    pub fn dependent(&mut self, index: u32, declared: &Declared<Dependent>) -> Option<Unit> {
        let Dependent { unit, start, .. } = &declared.what;
        let symbol = Symbol::Dependent(index);
        self.position(symbol, &declared.name, (unit.as_ref(), start.as_ref()))
    }

    /// The unit of a position, which is stated or that of its start value.
    fn position(
        &mut self,
        symbol: Symbol,
        name: &Name,
        (unit, start): (Option<&UnitTerm>, Option<&Term>),
    ) -> Option<Unit> {
        let unit = match (unit, start) {
            (Some(unit), _) => unit::resolve(unit, self.diagnostics)?,
            (None, Some(start)) => {
                let (_, kind) = self.start(start)?;
                let dimension = kind.dimension();
                let written = written_unit(start, self.diagnostics);
                written
                    .filter(|unit| unit.dimension == dimension)
                    .unwrap_or_else(|| Unit::for_dimension(&dimension))
            }
            (None, None) => {
                let (name, span) = (&name.text, name.span);
                let message = format!("`{name}` has no unit");
                self.diagnostics.push(
                    Diagnostic::error(span, message)
                        .hint(format!("say roughly where it starts, `dependent {name} ~ 10 deg;`, or only its unit, `{name}: rad`")),
                );
                return None;
            }
        };
        self.declare_kind(symbol, Kind::Of(unit.dimension), &unit);
        Some(unit)
    }

    fn not_prescribed(&mut self, span: Span) {
        self.diagnostics.push(
            Diagnostic::error(
                span,
                "a driver is prescribed: its motion can depend on the time and on constants alone",
            )
            .hint("a quantity that follows from coordinates or drivers is a `let`"),
        );
    }

    /// An equation's two sides, as `left − right` in each component.
    pub fn balance(&mut self, left: &Term, right: &Term) -> Option<(Vec<Expression>, Kind)> {
        let (x, y) = match (self.term(left), self.term(right)) {
            (Typed::Wrong, _) | (_, Typed::Wrong) => return None,
            (Typed::Quantity(x), Typed::Quantity(y)) if x.is_like(&y) => (x, y),
            (a, b) => {
                let message = format!(
                    "the two sides of the equation are {} and {}",
                    a.describe(),
                    b.describe()
                );
                self.diagnostics.push(Diagnostic::error(left.span.to(right.span), message));
                return None;
            }
        };
        let Some(kind) = agree(x.kind, y.kind) else {
            let text = "the two sides of the equation are";
            let report = disagreement(text, (left.span, x.kind), (right.span, y.kind));
            self.diagnostics.push(report);
            return None;
        };
        let difference = x.with(&y, kind, |x, y| self.graph.sub(x, y));
        Some((difference.values().to_vec(), kind))
    }

    /// Unit in which a reported value is printed when the file states none.
    pub fn natural_unit(&self, term: &Term, kind: Kind) -> Unit {
        let given = |name: &str| match self.names.table.get(name).map(|entry| &entry.role) {
            Some(crate::resolve::Role::Constant(index)) => self.unit_of(Symbol::Parameter(*index)),
            Some(crate::resolve::Role::Driver(index)) => self.unit_of(Symbol::Driver(*index)),
            Some(crate::resolve::Role::Dependent(index)) => self.unit_of(Symbol::Dependent(*index)),
            Some(crate::resolve::Role::Coordinate(index)) => {
                self.unit_of(Symbol::Coordinate(*index))
            }
            Some(crate::resolve::Role::State(index)) => self.unit_of(Symbol::State(*index)),
            _ => None,
        };
        let natural = match &term.kind {
            TermKind::Name(name) => given(name),
            TermKind::Call { name, arguments } => {
                match (name.text.as_str(), arguments.as_slice()) {
                    ("dot", [inner]) => {
                        let (TermKind::Name(_) | TermKind::Call { .. }) = &inner.kind else {
                            return Unit::for_dimension(&kind.dimension());
                        };
                        kind_times_second(kind)
                            .and_then(|kind| per_second(&self.natural_unit(inner, kind)))
                    }
                    ("ddot", [inner]) => kind_times_second(kind)
                        .and_then(kind_times_second)
                        .and_then(|kind| per_second(&per_second(&self.natural_unit(inner, kind))?)),
                    ("peak" | "lowest" | "mean" | "rms" | "value" | "amplitude", [inner, ..]) => {
                        Some(self.natural_unit(inner, kind))
                    }
                    _ => None,
                }
            }
            _ => None,
        };
        natural
            .filter(|unit| unit.dimension == kind.dimension())
            .unwrap_or_else(|| Unit::for_dimension(&kind.dimension()))
    }
}

fn kind_times_second(kind: Kind) -> Option<Kind> {
    let inverse = over(Kind::NUMBER, Kind::Of(second()))?;
    over(kind, inverse)
}

/// How a number is written whose unit stands behind it without brackets, `9.81 m/s^2`.
fn in_brackets(value: &Term) -> Option<String> {
    let text = print::term(value);
    let (number, unit) = text.split_once(' ')?;
    let is_meant = number.parse::<f64>().is_ok() && unit::parse_unit_text(unit).is_ok();
    is_meant.then(|| {
        format!("a unit that is more than one name stands in brackets: `{number} [{unit}]`")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check_per_second(unit: &str, expected: &str) {
        let unit = unit::parse_unit_text(unit).expect("a unit");
        assert_eq!(per_second(&unit).expect("a unit").symbol, expected);
    }

    /// A coordinate in degrees has an acceleration in degrees.
    #[test]
    fn derivatives_keep_the_unit_of_what_they_are_of() {
        check_per_second("deg", "deg/s");
        check_per_second("deg/s", "deg/s^2");
        check_per_second("mm/s", "mm/s^2");
        check_per_second("rad/s", "rad/s^2");
        check_per_second("rpm", "rpm/s");
    }
}
