//! Texts that are wrong: what is said, and about which words.

use super::{file, read};

/// A wrong text, a part of the message, the words that it points at, and a part of the hint (or nothing).
type Case = (&'static str, &'static str, &'static str, &'static str);

/// Each has one mistake and gives one message.
#[rustfmt::skip]
const WRONG: &[Case] = &[
    ("let x = ;", "found `;`, expected an expression", ";", ""),
    ("let x = 1", "found the end, expected `;`", "1", ""),
    ("let x 1;", "found `1`, expected `=`", "1", ""),
    ("let = 1;", "found `=`, expected a name", "=", ""),
    ("let f() = 1;", "a function needs an argument", ")", "leave `()` out"),
    ("let f(a, a) = a;", "two arguments are called `a`", "a", ""),
    ("let x = a b;", "found `b`, expected `;`", "b", "a product needs `*`"),
    ("let x = 2(a);", "found `(`, expected `;`", "(", "a product needs `*`"),
    ("let x = a = b;", "found `=`, expected `;`", "=", "begins with `motion`"),
    ("let x = y'';", "found `'`, expected `;`", "'", ""),
    ("let x = +1;", "a sign `+` is not needed", "+", "take it away"),
    ("let x = a < b < c;", "comparisons cannot be chained", "<", "a < b && b < c"),
    ("let x = 5 mm^2;", "it is not clear whether the unit or the quantity is raised", "^", "`5 [mm^2]`"),
    ("let x = 5 kg m;", "found `m` after a unit", "m", "compound unit stands in brackets"),
    ("let x = 1e999;", "`1e999` is too large", "1e999", ""),
    ("let x = 1 [J/kg K];", "above or below the line", "K", "`J/(kg K)`"),
    ("let x = 1 [m^0];", "this exponent has no meaning", "m", "whole number or a fraction"),
    ("let x = 1 [m^x];", "found `x`, expected an exponent", "x", ""),
    ("let x = 1 [];", "found `]`, expected a unit", "]", ""),
    ("let x = 1 [1/()];", "found `)`, expected a unit", ")", ""),
    ("let x = if a { 1 };", "needs its `else`", ";", "if c { x } else { y }"),
    ("let x = if a { 1; } else { 2 };", "found `;`, expected `}`", ";", ""),
    ("let x = (1 + ;) + 2;", "found `;`, expected an expression", ";", ""),
    ("let x = sum(k in 1..=5, k);", "a range includes both its ends", "=", "a .. b"),
    ("let x = integral(a, 0 .. 1);", "a range stands behind a formula and its variable", "0", "integral(f, x, a .. b)"),
    ("let x = f(a, b, 0 .. 1);", "a range stands behind a formula and its variable", "0", "integral(f, x, a .. b)"),
    ("let x = root(a, 2, 0 .. 1);", "a range stands behind a formula and its variable", "0", "root(f, x, a .. b)"),
    ("let x = solve(a in 0 .. 1, a);", "found `)`, expected `=`", ")", "left = right"),
    ("let x = table(\"file\"; b);", "found `;`, expected `,`", ";", "spring.csv"),
    ("let x = table(a; 0: 1, 2);", "found `)`, expected `:`", ")", "a point is written"),
    ("let x[1](a) = 1;", "found `(`, expected `=`", "(", ""),
    ("coordinate x = 0;", "found `=`, expected `:` and a unit", "=", "write `x: m`"),
    ("state x: = 0;", "found `=`, expected a unit", "=", ""),
    ("motion a + b;", "found `;`, expected `=`", ";", ""),
    ("force F;", "expected `on`", ";", "force F on x;"),
    ("for k 1..5 { }", "found `1`, expected `in`", "1", "for k in 1..5"),
    ("for k in 1 { }", "expected `..`", "{", ""),
    ("if a let x = 1;", "found `let`, expected `{`", "let", ""),
    ("choice c { }", "the choice `c` has no alternative", "{", ""),
    ("choice c { 1 }", "expected the name of an alternative", "1", ""),
    ("preset p { a 1; }", "found `1`, expected `=`", "1", ""),
    ("scene s = ;", "expected an effect or a choice", ";", ""),
    ("scene s = a b { }", "expected `+`, `{` or `;`", "b", ""),
    ("scene s { period over 1 s; }", "`period` is nothing that a scene does", "period", "periodic over"),
    ("scene s { periodic 1 s; }", "found `1`, expected `over`", "1", "periodic over 2*pi/n"),
    ("scene s { run time 0 s; }", "found `;`, expected `..`", ";", ""),
    ("scene s { measure a = peak(x); }", "a measure stands outside the scenes", "measure", "move it out"),
    ("scene s { sweep theta 1 deg; }", "found `;`, expected `..`", ";", ""),
    ("dependent phi = 10 deg;", "a dependent coordinate is not set", "=", "dependent phi ~"),
    ("link A;", "a link joins at least two points", "A", "link A - B;"),
    ("output a + b = c;", "a name is expected before `=`", "a + b", ""),
    ("mark at theta = 1;", "expected the text of the mark", "at", ""),
    ("mark \"a\" theta = 1;", "expected `at`", "theta", ""),
    ("expect theta = 1: x = 1 +- 1;", "found `theta`, expected `at`", "theta", "expect at maximum"),
    ("expect at theta = 1: x = 1;", "expected `+-` and a tolerance", ";", "how exactly"),
    ("paramter a = 1;", "`paramter` begins no statement", "paramter", "did you mean `parameter`?"),
    ("xyz = 1;", "`xyz` begins no statement", "xyz", "`let xyz = …;`"),
    ("mode { hold x; }", "found `{`, expected the name of the mode", "{", ""),
    ("mode run hold x;", "found `hold`, expected `{`", "hold", ""),
    ("hold;", "found `;`, expected an expression", ";", ""),
    ("when x > 1 -> run;", "found `-`, expected `rises`, `falls` or `crosses`", "-", "when x - l rises"),
    ("when x rises;;", "found `;`, expected a statement", ";", ""),
    ("when x rises run;", "found `run`, expected `->`, `{` or `;`", "run", "when x rises -> mode;"),
    ("when x rises -> ;", "found `;`, expected the mode that follows", ";", ""),
    ("when x rises { dot(x) = 0; }", "found `dot`, expected `set`", "dot", "{ set dot(x) = 0; }"),
    ("when x rises { set x 0; }", "found `0`, expected `=`", "0", ""),
    ("when x rises { set x = 0 }", "found `}`, expected `;`", "}", ""),
    ("part feed Feed;", "found `Feed`, expected `:`", "Feed", ""),
    ("part feed: Feed from feed;", "found `feed`, expected the name of a file in quotation marks", "feed", ""),
    ("; let x = 1;", "found `;`, expected a statement", ";", ""),
    ("effect a { } ;", "found `;`, expected a statement", ";", ""),
    ("\"text\"", "found the text \"text\", expected a statement", "\"text\"", ""),
    ("effect a { /// Nothing.\n }", "this documentation belongs to nothing", "/// Nothing.", ""),
];

#[test]
fn wrong_texts_are_explained() {
    for (text, message, words, hint) in WRONG {
        let whole = file(text);
        let (_, messages, lexed) = read(&whole);
        assert_eq!(messages.len(), 1, "{text}: {messages:?}");
        let found = &messages[0];
        assert!(found.message.contains(message), "{text}: {found:?}");
        let range = lexed.ranges[found.span.first as usize].start
            ..lexed.ranges[found.span.last as usize].end;
        assert_eq!(&whole[range], *words, "{text}: {found:?}");
        assert!(found.hint.as_deref().unwrap_or("").contains(hint), "{text}: {found:?}");
    }
}

/// Two mistakes in one file, whatever stands between them, give two messages, and what is right is kept.
#[test]
fn after_a_mistake_the_next_statement_is_read() {
    for first in WRONG.iter().map(|case| case.0).filter(|text| text.ends_with([';', '}'])) {
        let (tree, messages, _) =
            read(&file(&format!("{first} let good = 1; let = 2; let last = 3;")));
        assert_eq!(messages.len(), 2, "{first}: {messages:?}");
        let count = tree.unwrap().statements.len();
        assert!((2..=4).contains(&count), "{first}: {count} statements");
    }
}

#[test]
fn a_mistake_inside_a_block_stays_inside() {
    let text = "effect a { let = 1; let b = (; let c = 3; let d = if e { 1; } else { 2 }; let f = 1; } else { let g = 1; } let h = 1;";
    let (tree, messages, _) = read(&file(&text.replace("(;", "1 +;")));
    assert_eq!(messages.len(), 3, "{messages:?}");
    assert_eq!(tree.unwrap().statements.len(), 2);
}

#[test]
fn the_header_is_needed() {
    for (text, message, words) in [
        ("", "found the end, expected the name of the mechanism", ""),
        ("1", "found `1`, expected the name of the mechanism", "1"),
        ("Sample", "expected `;` after the name", "Sample"),
        ("Sample from x;", "expected the source in quotation marks", "x"),
        ("dimension R = 75 mm;", "expected `;` after the name", "R"),
    ] {
        let (_, messages, lexed) = read(text);
        assert_eq!(messages.len(), 1, "{text}: {messages:?}");
        assert!(messages[0].message.contains(message), "{text}: {messages:?}");
        let range = lexed.ranges.get(messages[0].span.first as usize).cloned().unwrap_or(0..0);
        assert_eq!(&text[range], words, "{text}");
    }
}

/// What rustc's tokens never are: brackets that do not match.
#[test]
fn brackets_that_do_not_match_end() {
    use crate::diagnostic::Diagnostics;
    use crate::lexer::lex_plain;
    let whole = lex_plain("Sample; let x = if a { (1 } else { [2) }; effect b { let y = 1; } }")
        .map(|lexed| lexed.tokens);
    assert!(whole.is_err());
    let tokens = lex_plain("Sample; effect a { let x = if a { (1) } else { [2] }; } let y = 1;")
        .unwrap()
        .tokens;
    for missing in 0..tokens.len() {
        let mut tokens = tokens.clone();
        tokens.remove(missing);
        let mut diagnostics = Diagnostics::default();
        let _ = super::parse(&tokens, 0, &mut diagnostics);
    }
}

#[test]
fn depth_is_limited() {
    for (open, inner, close) in [
        ("(", "1", ")"),
        ("-", "1", ""),
        ("if a { ", "1", " } else { 2 }"),
        ("f(", "1", ")"),
        ("[", "1", "]"),
    ] {
        let deep = |count: usize| {
            format!("let x = {}{inner}{}; let y = 1;", open.repeat(count), close.repeat(count))
        };
        assert!(read(&file(&deep(20))).1.is_empty(), "{open}");
        let (tree, messages, _) = read(&file(&deep(2000)));
        assert_eq!(messages.len(), 1, "{open}: {messages:?}");
        assert!(messages[0].message.contains("nested more than 64 deep"), "{open}: {messages:?}");
        assert_eq!(tree.unwrap().statements.len(), 1, "{open}");
    }
    for operator in [" + ", "*", " && "] {
        let long =
            |count: usize| format!("let x = {}; let y = 1;", vec!["a"; count].join(operator));
        assert!(read(&file(&long(1900))).1.is_empty(), "{operator}");
        let (_, messages, _) = read(&file(&long(100_000)));
        assert_eq!(messages.len(), 1, "{operator}");
        assert!(messages[0].message.contains("joins more than 2000 operands"), "{messages:?}");
    }
    let blocks = format!("{}{} let y = 1;", "if a { ".repeat(500), "}".repeat(500));
    let (tree, messages, _) = read(&file(&blocks));
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert_eq!(tree.unwrap().statements.len(), 2);
}
