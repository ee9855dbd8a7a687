//! `assur test`: the tests that the compiler would generate from a model, without compiling it.

use assur_interpreter::Test;
use assur_model::asked::Asked;

use crate::arguments::TestArguments;
use crate::ask::For;
use crate::ask::lookup::{self, Registry};
use crate::error::Failure;
use crate::show::output::print;
use crate::show::progress::Progress;

/// Runs the tests of a mechanism, or of one of its scenes, and prints how each ended.
///
/// # Errors
/// An unknown mechanism or scene, a file with errors; or that a test failed, after all have been run.
pub fn execute(options: &TestArguments, registry: Registry) -> Result<(), Failure> {
    let mechanism = registry.mechanism(options.name.as_deref(), "test", For::All)?;
    let scene = options.scene.as_deref();
    let scene = scene.map(|name| lookup::scene(mechanism, Some(name))).transpose()?;
    let names: Vec<&str> = scene.iter().map(|scene| scene.name).collect();
    let asked = if names.is_empty() { Asked::All } else { Asked::Some(&names) };
    let unreadable = || {
        Failure::request(format!("`{}` cannot be tested", mechanism.name))
            .reason("its text is none of an equation file")
    };
    let tests = assur_interpreter::tests(mechanism, asked).ok().flatten();
    let tests = tests.ok_or_else(unreadable)?;
    let tests: Vec<&Test> =
        tests.iter().filter(|test| names.is_empty() || names.contains(&test.scene)).collect();
    let progress = Progress::start(format!("testing {}", mechanism.name), tests.len() as u64);
    let mut failed = 0;
    for test in &tests {
        let found = test.run();
        let verdict = match &found {
            Ok(()) => "ok".to_owned(),
            Err(why) => format!("FAILED\n  {why}"),
        };
        print(&format!("{}: {} ... {verdict}\n", test.scene, test.name))?;
        failed += usize::from(found.is_err());
        progress.advance();
    }
    drop(progress);
    let plural = if tests.len() == 1 { "" } else { "s" };
    match failed {
        0 => print(&format!("\n{} test{plural}, all passed\n", tests.len())),
        _ => Err(Failure::numerical(format!("{failed} of {} test{plural} failed", tests.len()))),
    }
}
