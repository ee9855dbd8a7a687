//! What is to be said of a case: its numbers beside far more accurate ones, and what stays in it.

use std::path::Path;

use crate::answer::{Answer, Kind, Refusal, ask};
use crate::case::{Case, Precision};
use crate::watch::watch;

/// An estimate below this share of the true error is too small.
pub const SHARE: f64 = 5.0;
/// An error so many times its estimate is a finding by itself; how many are beyond five times is told of all.
const FINDING: f64 = 100.0;

/// A number beside a more accurate one.
pub struct Compared {
    pub kind: Kind,
    /// What it errs by, over the larger error that either answer tells; none where nothing is told.
    pub ratio: Option<f64>,
    /// The number, in words.
    pub what: String,
}

/// What sort of finding it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// The command did not end in an orderly way.
    End,
    /// Other events happen.
    Events,
    Number(Kind),
}

/// What is to be looked at.
#[derive(Clone, Debug)]
pub struct Finding {
    pub sort: Sort,
    pub weight: f64,
    pub what: String,
}

/// What is said of a case.
#[derive(Default)]
pub struct Verdict {
    /// The status, or first lines of refusals.
    pub ends: Vec<String>,
    pub numbers: Vec<Compared>,
    /// The worst that was found.
    pub finding: Option<Finding>,
}

/// Asks for both runs of a case. There is no reference where the first was refused.
pub fn judge(command: &Path, case: &Case) -> Verdict {
    let mut verdict = Verdict::default();
    let tried = match ask(command, case, Precision::Tried) {
        Ok(tried) => tried,
        Err(refusal) => {
            verdict.refused(Precision::Tried, &refusal);
            return verdict;
        }
    };
    verdict.ends.push(tried.status.clone());
    match ask(command, case, Precision::Reference) {
        Ok(reference) => verdict.compare(case, &tried, &reference),
        Err(refusal) => verdict.refused(Precision::Reference, &refusal),
    }
    verdict
}

impl Verdict {
    fn refused(&mut self, precision: Precision, refusal: &Refusal) {
        let first = refusal.text.lines().next().unwrap_or("no words");
        let which = match precision {
            Precision::Tried => "refused",
            Precision::Reference => "reference refused",
        };
        self.ends.push(format!("{which}: {first}"));
        // A panic, a kill, no words at all.
        if !matches!(refusal.code, Some(1 | 2)) || refusal.text.contains("panicked") {
            let which = if precision == Precision::Reference { "the reference " } else { "" };
            let what = format!("{which}ended with {:?}: {first}", refusal.code);
            self.finding = Some(Finding { sort: Sort::End, weight: f64::INFINITY, what });
        }
    }

    fn compare(&mut self, case: &Case, tried: &Answer, reference: &Answer) {
        if tried.status != "complete" || reference.status != "complete" {
            return;
        }
        // Where several motions attract, and the way to them is chaotic, chance picks one: both are right.
        if tried.periods != reference.periods {
            self.ends.push("another motion that repeats than the reference".to_owned());
            return;
        }
        if tried.events != reference.events {
            let (a, b) = (tried.events.len(), reference.events.len());
            let what = format!("events differ: {a} and {b}");
            self.finding = Some(Finding { sort: Sort::Events, weight: FINDING, what });
            return;
        }
        for (a, b) in tried.numbers.iter().zip(&reference.numbers) {
            if a.value.is_nan() && b.value.is_nan() {
                continue;
            }
            // What the reference says of itself may be the whole difference, and may be as wrong.
            let known = if b.error.is_nan() { 0.0 } else { SHARE * b.error };
            let excess = ((a.value - b.value).abs() - known).max(0.0);
            let ratio = if excess == 0.0 { 0.0 } else { excess / a.error.max(b.error) };
            let what = format!("{}: {} against {}, said {:.1e}", a.name, a.value, b.value, a.error);
            let ratio = (!a.error.is_nan()).then_some(ratio);
            self.numbers.push(Compared { kind: a.kind, ratio, what });
        }
        self.numbers.extend(watch(case));
        let ratio = |compared: &&Compared| compared.ratio.unwrap_or(0.0);
        let worst = self.numbers.iter().max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        let worst = worst.filter(|worst| ratio(worst).is_nan() || ratio(worst) > FINDING);
        self.finding = worst.map(|worst| Finding {
            sort: Sort::Number(worst.kind),
            weight: ratio(&worst),
            what: worst.what.clone(),
        });
    }
}

/// The simplest case that shows a finding of the same sort: what can be left out is, one thing after the other.
pub fn simplest(command: &Path, case: Case, finding: Finding) -> (Case, Finding) {
    let (mut case, mut finding) = (case, finding);
    loop {
        let simpler = case.simpler().find_map(|simpler| {
            let found = judge(command, &simpler).finding?;
            (found.sort == finding.sort).then_some((simpler, found))
        });
        match simpler {
            Some(simpler) => (case, finding) = simpler,
            None => return (case, finding),
        }
    }
}
