//! The page of hard cases, `docs/stability.md`: what was tried, what the naive way gives, what Assur gives, and at what cost.
//!
//! Each case is a test, which asserts what its row says and tells it here. `ASSUR_BLESS=1 cargo test --test suite`
//! writes the rows anew; without it a test whose row is missing or speaks of another trial fails.

use std::fs;
use std::path::Path;
use std::sync::Mutex;

/// The cases in the order of the page, that of section 9 of the design.
const CASES: [&str; 19] = [
    "Dead points",
    "Flattened parallelogram",
    "Near a change point",
    "Switching of assembly mode",
    "Loops that just fail to close",
    "Redundant loops",
    "Drift of constraints",
    "Stiffness",
    "Grazing",
    "Chatter and Zeno",
    "Resonance",
    "Multipliers at -1",
    "Nothing stable",
    "Undamped motion",
    "Cancellation",
    "Very small mechanisms",
    "Inconsistent start values",
    "Masses far apart",
    "Absurd parameters",
];

/// One row.
pub struct Row<'a> {
    /// One of the cases of the page.
    pub case: &'a str,
    /// What was tried.
    pub tried: &'a str,
    /// What the naive way gives.
    pub naive: String,
    /// What Assur gives.
    pub ours: String,
    /// What it takes.
    pub cost: String,
}

const HEAD: &str = "# Hard cases

What must stay stable, what the naive way gives, and what Assur gives. Each row is a test of `tests/suite`, which asserts what it
says; the figures are those of one machine, written by

```console
$ ASSUR_BLESS=1 cargo test --test suite
```

| case | tried | the naive way | Assur | what it takes |
|---|---|---|---|---|
";

static PAGE: Mutex<()> = Mutex::new(());

/// Tells what a test has found.
#[track_caller]
pub fn told(row: &Row<'_>) {
    let place = CASES.iter().position(|case| *case == row.case).expect("a case of the page");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.md");
    let guard = PAGE.lock();
    let page = fs::read_to_string(&path).unwrap_or_default();
    let begin = |row: &Row<'_>| format!("| {} | {} |", row.case, row.tried);
    if std::env::var_os("ASSUR_BLESS").is_none() {
        assert!(page.contains(&begin(row)), "write docs/stability.md anew: {}", begin(row));
        return;
    }
    let rank = |line: &str| CASES.iter().position(|case| line.starts_with(&format!("| {case} |")));
    let mut rows: Vec<&str> = page.lines().filter(|line| rank(line).is_some()).collect();
    rows.retain(|line| rank(line) != Some(place));
    let own = format!("{} {} | {} | {} |", begin(row), row.naive, row.ours, row.cost);
    rows.push(&own);
    rows.sort_by_key(|line| rank(line));
    fs::write(&path, format!("{HEAD}{}\n", rows.join("\n"))).expect("the page can be written");
    drop(guard);
}

/// No case without a row.
#[test]
fn the_page_has_all_cases() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.md");
    let page = fs::read_to_string(path).expect("the page is there");
    let missing = CASES.iter().filter(|case| !page.contains(&format!("\n| {case} |")));
    let missing: Vec<_> = missing.collect();
    assert!(missing.is_empty() || std::env::var_os("ASSUR_BLESS").is_some(), "{missing:?}");
    assert!(page.starts_with(HEAD) || std::env::var_os("ASSUR_BLESS").is_some());
}
