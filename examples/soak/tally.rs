//! How errors compare with their estimates, and what was worst.

use std::collections::BTreeMap;
use std::fmt;

use crate::answer::Kind;
use crate::case::{Case, Precision};
use crate::judge::{Compared, Finding, SHARE, Verdict};

/// Share of the estimates that may be too small.
const PERMITTED: f64 = 0.1;
/// Findings that are printed.
const SHOWN: usize = 25;

/// Numbers of one kind.
#[derive(Debug, Default)]
struct Count {
    compared: usize,
    too_small: usize,
    /// Without an estimate beside them.
    bare: usize,
    worst: f64,
}

/// What is to be looked at, and how to see it.
#[derive(Debug)]
struct Shown {
    finding: Finding,
    case: u64,
    line: String,
    beside: String,
}

/// What was seen so far.
#[derive(Debug, Default)]
pub struct Tally {
    cases: usize,
    counts: BTreeMap<Kind, Count>,
    /// Cases by status, and refusals by their first line.
    ends: BTreeMap<String, usize>,
    findings: Vec<Shown>,
}

impl Tally {
    /// Adds what is said of a case, but for what was found.
    pub fn add(&mut self, verdict: &Verdict) {
        self.cases += 1;
        for end in &verdict.ends {
            *self.ends.entry(end.clone()).or_default() += 1;
        }
        for Compared { kind, ratio, .. } in &verdict.numbers {
            let count = self.counts.entry(*kind).or_default();
            let Some(ratio) = ratio else {
                count.bare += 1;
                continue;
            };
            count.compared += 1;
            count.too_small += usize::from(*ratio > SHARE || ratio.is_nan());
            count.worst = count.worst.max(*ratio);
        }
    }

    /// Adds what was found with a case.
    pub fn find(&mut self, finding: Finding, case: &Case) {
        let (line, beside) = (case.line(Precision::Tried), case.line(Precision::Reference));
        self.findings.push(Shown { finding, case: case.number, line, beside });
    }

    /// A line of the state.
    pub fn line(&self) -> String {
        let (compared, small) = self.totals();
        let share = 100.0 * small as f64 / compared.max(1) as f64;
        format!(
            "{compared} numbers, {share:.2} % beyond {SHARE} times their estimate, {} findings",
            self.findings.len()
        )
    }

    fn totals(&self) -> (usize, usize) {
        let counts = self.counts.values();
        counts.fold((0, 0), |sum, count| (sum.0 + count.compared, sum.1 + count.too_small))
    }

    /// Whether no kind of number has too many estimates that are too small, and nothing was found.
    pub fn is_clean(&self) -> bool {
        let permitted = |count: &Count| count.too_small as f64 <= PERMITTED * count.compared as f64;
        self.findings.is_empty() && self.counts.values().all(permitted)
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} cases: {}\n", self.cases, self.line())?;
        writeln!(
            f,
            "{:<20}{:>10}{:>14}{:>10}{:>12}",
            "", "compared", "too small, %", "bare", "worst"
        )?;
        for kind in Kind::ALL {
            let Some(count) = self.counts.get(&kind) else {
                continue;
            };
            let share = 100.0 * count.too_small as f64 / count.compared.max(1) as f64;
            writeln!(
                f,
                "{:<20}{:>10}{share:>14.2}{:>10}{:>12.1e}",
                kind.name(),
                count.compared,
                count.bare,
                count.worst
            )?;
        }
        writeln!(f)?;
        for (end, count) in &self.ends {
            writeln!(f, "{count:>8}  {end}")?;
        }
        let mut findings: Vec<_> = self.findings.iter().collect();
        findings.sort_by(|a, b| b.finding.weight.total_cmp(&a.finding.weight));
        for Shown { finding, case, line, beside } in findings.into_iter().take(SHOWN) {
            writeln!(f, "\ncase {case}: {}\n  {line}\n  {beside}", finding.what)?;
        }
        Ok(())
    }
}
