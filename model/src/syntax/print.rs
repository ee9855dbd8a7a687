//! Writes terms and statements as the language has them, with no more parentheses than it needs.

use super::tree::{
    BinaryOperator, Direction, EnergyKind, Points, Statement, StatementKind, TableTerm, Target,
    Term, TermKind, UnaryOperator, UnitTerm, When,
};

/// A term as text.
pub fn term(term: &Term) -> String {
    write(term, 0)
}

/// An equation, energy, force or condition as text; empty for other statements.
pub fn statement(statement: &Statement) -> String {
    match &statement.kind {
        StatementKind::Motion { label: Some(label), left, right } => {
            let label = target(label);
            format!("motion {label}: {} = {}", term(left), term(right))
        }
        StatementKind::Motion { label: None, left, right } => {
            format!("motion {} = {}", term(left), term(right))
        }
        StatementKind::Closure { label, left, right } => {
            let label =
                label.as_ref().map_or(String::new(), |label| format!("{}: ", target(label)));
            format!("closure {label}{} = {}", term(left), term(right))
        }
        StatementKind::Energy { kind, value } => {
            let keyword = match kind {
                EnergyKind::Kinetic => "kinetic",
                EnergyKind::Potential => "potential",
                EnergyKind::Dissipation => "dissipation",
            };
            format!("{keyword} {}", term(value))
        }
        StatementKind::Force { value, on } => format!("force {} on {}", term(value), term(on)),
        StatementKind::Require { condition, .. } => format!("require {}", term(condition)),
        StatementKind::Hold { target } => format!("hold {}", term(target)),
        StatementKind::When(event) => self::event(event),
        StatementKind::Let { target, arguments: None, value } => {
            format!("let {} = {}", self::target(target), term(value))
        }
        _ => String::new(),
    }
}

/// An event as text.
pub fn event(event: &When) -> String {
    let label = event.label.as_ref();
    let label = label.map_or(String::new(), |label| format!("{}: ", target(label)));
    let watched = term(&event.guard);
    let mut text = format!("when {label}{watched} {}", direction(event.direction));
    if let Some(condition) = &event.condition {
        text += &format!(" if {}", term(condition));
    }
    if let Some(target) = &event.target {
        text += &format!(" -> {}", target.text);
    }
    let resets = event.resets.iter();
    let resets: Vec<_> =
        resets.map(|(target, value)| format!("{} = {}", term(target), term(value))).collect();
    if !resets.is_empty() {
        text += &format!(" {{ set {}; }}", resets.join(", "));
    }
    text
}

/// How a quantity passes zero, as a word.
pub fn direction(direction: Direction) -> &'static str {
    match direction {
        Direction::Rises => "rises",
        Direction::Falls => "falls",
        Direction::Crosses => "crosses",
    }
}

/// A declared name as text.
pub fn target(target: &Target) -> String {
    match &target.index {
        Some(index) => format!("{}[{}]", target.name.text, term(index)),
        None => target.name.text.clone(),
    }
}

/// Symbol and binding power of an operator.
fn operator(operator: BinaryOperator) -> (&'static str, u8) {
    match operator {
        BinaryOperator::Or => (" || ", 1),
        BinaryOperator::And => (" && ", 2),
        BinaryOperator::Less => (" < ", 3),
        BinaryOperator::LessEqual => (" <= ", 3),
        BinaryOperator::Greater => (" > ", 3),
        BinaryOperator::GreaterEqual => (" >= ", 3),
        BinaryOperator::Equal => (" == ", 3),
        BinaryOperator::NotEqual => (" != ", 3),
        BinaryOperator::Add => (" + ", 4),
        BinaryOperator::Subtract => (" - ", 4),
        BinaryOperator::Multiply => ("*", 5),
        BinaryOperator::Divide => ("/", 5),
        BinaryOperator::Power => ("^", 7),
    }
}

/// Writes a term that stands where only what binds at least so tightly needs no parentheses.
fn write(term: &Term, least: u8) -> String {
    let list =
        |items: &[Term]| items.iter().map(|item| write(item, 0)).collect::<Vec<_>>().join(", ");
    let (text, power) = match &term.kind {
        TermKind::Number { value, unit: None } => {
            (number(*value), if *value < 0.0 { 6 } else { 9 })
        }
        TermKind::Number { value, unit: Some(written) } => {
            // With a unit name directly after it a number cannot be raised.
            (format!("{} {}", number(*value), unit(written)), 6)
        }
        TermKind::Name(name) => (name.clone(), 9),
        TermKind::Index { name, index } => (format!("{}[{}]", name.text, write(index, 0)), 9),
        TermKind::Member { base, name } => (format!("{}.{}", write(base, 9), name.text), 9),
        TermKind::Vector(items) => (format!("[{}]", list(items)), 9),
        TermKind::Unary(UnaryOperator::Negate, inner) => (format!("-{}", write(inner, 6)), 6),
        TermKind::Unary(UnaryOperator::Not, inner) => (format!("!{}", write(inner, 6)), 6),
        TermKind::Binary(BinaryOperator::Power, base, exponent) => {
            (format!("{}^{}", write(base, 8), write(exponent, 6)), 7)
        }
        TermKind::Binary(kind, left, right) => {
            let (symbol, power) = operator(*kind);
            // Comparisons cannot be chained, so both sides of one are tighter.
            let left = write(left, if power == 3 { 4 } else { power });
            (format!("{left}{symbol}{}", write(right, power + 1)), power)
        }
        TermKind::Call { name, arguments } => (format!("{}({})", name.text, list(arguments)), 9),
        TermKind::If { condition, then, otherwise } => (
            format!(
                "if {} {{ {} }} else {{ {} }}",
                write(condition, 0),
                write(then, 0),
                write(otherwise, 0)
            ),
            9,
        ),
        TermKind::Bound { value, .. } => return write(value, least),
        TermKind::Table(table) => (self::table(table), 9),
        TermKind::Search { name, variable, from, to, body } => {
            let range = format!("{} .. {}", write(from, 4), write(to, 4));
            let text = match &body.kind {
                TermKind::Binary(BinaryOperator::Subtract, left, right) if name.text == "solve" => {
                    let (left, right) = (write(left, 4), write(right, 4));
                    format!("solve({} in {range}, {left} = {right})", variable.text)
                }
                _ => format!("{}({}, {}, {range})", name.text, write(body, 0), variable.text),
            };
            (text, 9)
        }
        TermKind::Sum { index, from, to, body } => (
            format!(
                "sum({} in {}..{}, {})",
                index.text,
                write(from, 4),
                write(to, 4),
                write(body, 0)
            ),
            9,
        ),
    };
    if power < least { format!("({text})") } else { text }
}

/// A sampled curve with at most a few of its points.
fn table(table: &TableTerm) -> String {
    /// Points that are written at each end.
    const FEW: usize = 3;
    let at = write(&table.at, 0);
    let mut text = match &table.points {
        Points::Written(points) => {
            let point = |(x, y): &(Term, Term)| format!("{}: {}", write(x, 0), write(y, 0));
            let mut all: Vec<String> = points.iter().map(point).collect();
            if all.len() > 2 * FEW + 1 {
                all.splice(FEW..all.len() - FEW, ["…".to_string()]);
            }
            format!("table({at}; {}", all.join(", "))
        }
        Points::File { file, column, .. } => {
            let is_word = |text: &str| text.chars().all(|one| one.is_alphanumeric() || one == '_');
            let column = column.iter().map(|one| match is_word(&one.text) {
                true => format!(", {}", one.text),
                false => format!(", \"{}\"", one.text),
            });
            format!("table(\"{}\", {at}{}", file.text, column.collect::<String>())
        }
    };
    let error = table.error.as_ref().map(|error| format!("smooth {}", write(error, 0)));
    let options: Vec<String> =
        table.is_periodic.then(|| "periodic".to_string()).into_iter().chain(error).collect();
    if !options.is_empty() {
        text += &format!("; {}", options.join(", "));
    }
    text + ")"
}

fn number(value: f64) -> String {
    let (plain, short) = (format!("{value}"), format!("{value:e}"));
    if plain.len() <= short.len().max(8) { plain } else { short }
}

/// A unit as it is written after a number.
fn unit(unit: &UnitTerm) -> String {
    if let [(name, (1, 1))] = unit.factors.as_slice() {
        return name.text.clone();
    }
    let factors: Vec<_> = unit
        .factors
        .iter()
        .map(|(name, exponent)| match exponent {
            (1, 1) => name.text.clone(),
            (power, 1) => format!("{}^{power}", name.text),
            (power, root) => format!("{}^({power}/{root})", name.text),
        })
        .collect();
    format!("[{}]", factors.join(" "))
}
