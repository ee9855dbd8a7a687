//! Whose a documentation comment is.

use std::fmt::Write;

use assur_model::lexer::lex_plain;

use super::SPRING;

/// The documentation of constants, states and outputs after those of the spring, one a line.
#[track_caller]
fn check(statements: &str, expected: &str) {
    let lexed = lex_plain(&format!("{SPRING}{statements}")).expect("the text can be read");
    let compiled = assur_model::compile(&lexed.tokens);
    let scene = &compiled.model.expect("the text is right").scenes[0];
    let constants = scene.constants.iter().skip(2).map(|one| &one.quantity);
    let states = scene.states.iter().filter(|one| !one.name.contains('x'));
    let outputs = scene.outputs.iter().skip(1);
    let mut found = String::new();
    for quantity in constants.chain(states).chain(outputs) {
        let _ = writeln!(found, "{}: {}", quantity.name, quantity.summary);
    }
    assert_eq!(found, expected, "{statements}");
}

#[test]
fn documentation_of_a_list_is_that_of_each_member() {
    check("/// Of both.\noutput a = x, b = 2*x;", "a: Of both.\nb: Of both.\n");
}

#[test]
fn a_member_of_a_list_has_documentation_of_its_own() {
    check(
        "/// First.\nparameter r = 1 m,\n/// Second,\n/// in two lines.\ns = 2 m; output r, s;",
        "r: First.\ns: Second,\nin two lines.\nr: \ns: \n",
    );
    check("output /// First.\na = x, b = x, /// Third.\nd = x;", "a: First.\nb: \nd: Third.\n");
}

#[test]
fn where_members_are_documented_nothing_is_shared() {
    check("/// First.\noutput a = x,\n/// Second.\nb = x, d = x;", "a: First.\nb: Second.\nd: \n");
}
