//! Expressions: how operators bind, which units numbers have, and that printing loses nothing.

use super::term;
use crate::syntax::print;
use crate::syntax::tree::{Points, Term, TermKind};
use crate::unroll::with_index;

/// Expressions, and how the parser groups them.
#[test]
fn operators_bind_as_in_mathematics() {
    for (text, grouped) in [
        ("a + b*c", "a + (b*c)"),
        ("a - b - c", "(a - b) - c"),
        ("a/b/c", "(a/b)/c"),
        ("a/b*c", "(a/b)*c"),
        ("-x^2", "-(x^2)"),
        ("-x*y", "(-x)*y"),
        ("a^b^c", "a^(b^c)"),
        ("a^-b", "a^(-b)"),
        ("2*x^2*y", "(2*(x^2))*y"),
        ("a < b && c < d || e < f", "((a < b) && (c < d)) || (e < f)"),
        ("!a && b", "(!a) && b"),
        ("a + b < c*d", "(a + b) < (c*d)"),
        ("75 mm*x", "(75 mm)*x"),
        ("5 N/q", "(5 N)/q"),
        ("if a { b } else { c }*d", "(if a { b } else { c })*d"),
    ] {
        assert_eq!(bare(&term(text)), bare(&term(grouped)), "{text} is not {grouped}");
    }
}

/// Expressions that are printed as they are written, so that reading and printing lose nothing.
#[test]
fn printing_and_reading_keep_the_tree() {
    for text in [
        "a",
        "1.5",
        "1e-9",
        "1.2345678901e10",
        "75 mm",
        "0.1 [kg m^2]",
        "3 [s^-1]",
        "2 [m^(1/2)]",
        "2 [m^(-1/2)]",
        "-5 mm",
        "(5 mm)^2",
        "(-x)^2",
        "-x^2",
        "-(a + b)",
        "--x",
        "a - (b - c)",
        "a - -b",
        "a/(b*c)",
        "a*(b/c)",
        "(a^b)^c",
        "a^b^c",
        "a^(1/2)",
        "(a + b)^(c + d)",
        "!(a && b) || c",
        "(a < b) == (c < d)",
        "(a < b) < c",
        "x[k + 1]",
        "x[2*k - 1]",
        "crank.exact",
        "feed.lift.l_v^2",
        "feed.h[k + 1]",
        "feed.f(x, feed.y)",
        "[x, y + z, -1]",
        "[x, y]*[a, b]",
        "sin(x)^2",
        "atan2(y, x)",
        "dot(dot(x))",
        "f(a, b)*g(c)",
        "if a < b { c } else { if d { e } else { f } }",
        "if a { b } else { c }^2",
        "sum(k in 1..5, x[k]^2)",
        "sum(k in n + 1..2*n, sum(j in 1..k, x[j]))",
        "(if a { b } else { c } + d)*e",
        "integral(x^2 + a, x, 0 .. b + 1)",
        "solve(x in a .. b, x^2 = 2)^2",
        "peak(integral(x*y, y, 0 .. x), x, -1 .. 1)",
        "table(x + 1; 0 mm: -1 N, 2*pi: a + b, 3: 0)^2",
        "table(x; 0: 1, 1: 2; periodic)",
        "table(\"data/spring.csv\", x, F; periodic, smooth 2 N)",
        "table(\"spring.csv\", x, \"F [N]\")",
    ] {
        let tree = term(text);
        let printed = print::term(&tree);
        assert_eq!(bare(&term(&printed)), bare(&tree), "{text} is printed as {printed}");
        assert_eq!(print::term(&term(&printed)), printed, "{text}");
    }
}

/// A tree as text in which every group has its brackets and no place is named.
fn bare(term: &Term) -> String {
    let list = |items: &[Term]| items.iter().map(bare).collect::<Vec<_>>().join(" ");
    match &term.kind {
        TermKind::Number { value, unit } => {
            let factors = unit.iter().flat_map(|unit| &unit.factors);
            let unit: Vec<_> =
                factors.map(|(name, power)| format!("{}{power:?}", name.text)).collect();
            format!("{value:e}{}", unit.join("."))
        }
        TermKind::Name(name) => name.clone(),
        TermKind::Index { name, index } => format!("(at {} {})", name.text, bare(index)),
        TermKind::Member { base, name } => format!("(member {} {})", bare(base), name.text),
        TermKind::Vector(items) => format!("(vector {})", list(items)),
        TermKind::Bound { value, .. } => bare(value),
        TermKind::Unary(operator, inner) => format!("({operator:?} {})", bare(inner)),
        TermKind::Binary(operator, left, right) => {
            format!("({operator:?} {} {})", bare(left), bare(right))
        }
        TermKind::Call { name, arguments } => format!("({} {})", name.text, list(arguments)),
        TermKind::If { condition, then, otherwise } => {
            format!("(if {} {} {})", bare(condition), bare(then), bare(otherwise))
        }
        TermKind::Search { name, variable, from, to, body } => {
            let (name, variable) = (&name.text, &variable.text);
            format!("({name} {variable} {} {} {})", bare(from), bare(to), bare(body))
        }
        TermKind::Table(table) => {
            let points: Vec<_> = match &table.points {
                Points::Written(list) => {
                    list.iter().map(|(x, y)| format!("{} {}", bare(x), bare(y))).collect()
                }
                Points::File { file, column, .. } => [Some(file), column.as_ref()]
                    .into_iter()
                    .flatten()
                    .map(|one| one.text.clone())
                    .collect(),
            };
            let (at, error) = (bare(&table.at), table.error.as_ref().map(bare));
            format!("(table {at} {points:?} {} {error:?})", table.is_periodic)
        }
        TermKind::Sum { index, from, to, body } => {
            format!("(sum {} {} {} {})", index.text, bare(from), bare(to), bare(body))
        }
    }
}

#[track_caller]
fn check_unit(text: &str, expected: &[(&str, (i8, i8))]) {
    let TermKind::Number { unit, .. } = term(text).kind else { panic!("{text} is no number") };
    let factors = unit.map(|unit| unit.factors).unwrap_or_default();
    let found: Vec<_> = factors.iter().map(|(name, power)| (name.text.as_str(), *power)).collect();
    assert_eq!(found, expected, "{text}");
}

#[test]
fn a_number_takes_its_unit() {
    check_unit("75", &[]);
    check_unit("75 mm", &[("mm", (1, 1))]);
    check_unit("75mm", &[("mm", (1, 1))]);
    check_unit("75 [mm]", &[("mm", (1, 1))]);
    check_unit("0.1 [kg m^2]", &[("kg", (1, 1)), ("m", (2, 1))]);
    check_unit("0.1 [kg*m^2]", &[("kg", (1, 1)), ("m", (2, 1))]);
    check_unit("1 [N m/rad]", &[("N", (1, 1)), ("m", (1, 1)), ("rad", (-1, 1))]);
    check_unit("1 [1/(m^2 s^2)]", &[("m", (-2, 1)), ("s", (-2, 1))]);
    check_unit("1 [J/(kg K)]", &[("J", (1, 1)), ("kg", (-1, 1)), ("K", (-1, 1))]);
    check_unit("1 [kg/m/s]", &[("kg", (1, 1)), ("m", (-1, 1)), ("s", (-1, 1))]);
    check_unit("1 [m^(1/2)]", &[("m", (1, 2))]);
    check_unit("1 [s^-1]", &[("s", (-1, 1))]);
}

#[test]
fn a_unit_name_is_untouched_by_an_index() {
    let replaced = with_index(&term("3 m + m"), "m", 2);
    assert_eq!(print::term(&replaced), "3 m + 2");
}
