//! How errors compare with their estimates, and what was worst.

use std::collections::BTreeMap;
use std::fmt;

use crate::answer::{Answer, Kind, Refusal};
use crate::case::{Case, Precision};

/// An estimate below this share of the true error is too small.
const SHARE: f64 = 5.0;
/// Share of the estimates that may be too small.
const PERMITTED: f64 = 0.1;
/// An error so many times its estimate is a finding by itself.
const FINDING: f64 = 1e3;
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

/// What is to be looked at.
#[derive(Debug)]
struct Finding {
    weight: f64,
    what: String,
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
    findings: Vec<Finding>,
}

impl Tally {
    /// Adds a case with its two answers; there is no reference where the first was refused.
    pub fn add(
        &mut self,
        case: &Case,
        tried: Result<Answer, Refusal>,
        reference: Option<Result<Answer, Refusal>>,
    ) {
        self.cases += 1;
        let tried = match tried {
            Ok(tried) => tried,
            Err(refusal) => return self.refused(case, Precision::Tried, &refusal),
        };
        *self.ends.entry(tried.status.clone()).or_default() += 1;
        match reference {
            Some(Ok(reference)) => self.compare(case, &tried, &reference),
            Some(Err(refusal)) => self.refused(case, Precision::Reference, &refusal),
            None => {}
        }
    }

    fn refused(&mut self, case: &Case, precision: Precision, refusal: &Refusal) {
        let first = refusal.text.lines().next().unwrap_or("no words");
        let which = match precision {
            Precision::Tried => "refused",
            Precision::Reference => "reference refused",
        };
        *self.ends.entry(format!("{which}: {first}")).or_default() += 1;
        // A panic, a kill, no words at all.
        if !matches!(refusal.code, Some(1 | 2)) || refusal.text.contains("panicked") {
            self.find(f64::INFINITY, format!("ended with {:?}: {first}", refusal.code), case);
        }
    }

    fn compare(&mut self, case: &Case, tried: &Answer, reference: &Answer) {
        if tried.status != "complete" || reference.status != "complete" {
            return;
        }
        if tried.events != reference.events {
            let (a, b) = (tried.events.len(), reference.events.len());
            self.find(FINDING, format!("events differ: {a} and {b}"), case);
            return;
        }
        let mut worst: Option<(f64, String)> = None;
        for (a, b) in tried.numbers.iter().zip(&reference.numbers) {
            if a.value.is_nan() && b.value.is_nan() {
                continue;
            }
            let count = self.counts.entry(a.kind).or_default();
            if a.error.is_nan() {
                count.bare += 1;
                continue;
            }
            // What the reference says of itself may be the whole difference.
            let known = if b.error.is_nan() { 0.0 } else { SHARE * b.error };
            let excess = ((a.value - b.value).abs() - known).max(0.0);
            let ratio = if excess == 0.0 { 0.0 } else { excess / a.error };
            count.compared += 1;
            count.too_small += usize::from(ratio > SHARE || ratio.is_nan());
            count.worst = count.worst.max(ratio);
            if worst.as_ref().is_none_or(|(most, _)| ratio > *most) {
                let what =
                    format!("{}: {} against {}, said {:.1e}", a.name, a.value, b.value, a.error);
                worst = Some((ratio, what));
            }
        }
        if let Some((ratio, what)) = worst.filter(|(ratio, _)| *ratio > FINDING) {
            self.find(ratio, what, case);
        }
    }

    fn find(&mut self, weight: f64, what: String, case: &Case) {
        self.findings.push(Finding {
            weight,
            what: format!("case {}: {what}", case.number),
            line: case.line(Precision::Tried),
            beside: case.line(Precision::Reference),
        });
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
        findings.sort_by(|a, b| b.weight.total_cmp(&a.weight));
        for finding in findings.iter().take(SHOWN) {
            writeln!(f, "\n{}\n  {}\n  {}", finding.what, finding.line, finding.beside)?;
        }
        Ok(())
    }
}
