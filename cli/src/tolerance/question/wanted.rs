//! Tolerances that are to be chosen: the band, the costs and the limits.

use assur::shape::Quantity;
use assur::tolerance::{Candidate, Cost, Rule, Study};

use super::Label;
use super::names::Names;
use crate::ask::values::{once, quantity, split};
use crate::error::Failure;
use crate::tolerance::arguments::{Kind, ToleranceArguments};

/// Tolerances to be chosen.
pub struct Wanted {
    /// The band.
    pub band: f64,
    /// How the error is reckoned.
    pub rule: Rule,
    /// Which tolerances, in the order of the sources that are no play.
    pub candidates: Vec<Candidate>,
}

impl Names<'_> {
    /// What is to be chosen.
    pub fn wanted(
        &self,
        options: &ToleranceArguments,
        band: &str,
        study: &Study,
        labels: &[Label],
    ) -> Result<Wanted, Failure> {
        let output = &self.scene.outputs[study.output];
        let band = quantity(band, output).map_err(|_| no_band(band, output))?;
        let mut weights = vec![1.0; self.linkage.variables.len()];
        let mut given = Vec::new();
        for text in &options.cost {
            let (name, weight) = split(text, "--cost", "s=2")?;
            let index = self.find(name, "--cost")?;
            let what = format!("the weight of `{name}`");
            once(&mut given, index, &what, &format!("--cost {text}"))?;
            weights[index] = weight.parse().map_err(|_| {
                Failure::request(format!("`{weight}` is no weight"))
                    .place(format!("--cost {text}"))
                    .remedy("give a positive number, --cost s=2")
            })?;
        }
        let mut limits = vec![(0.0, f64::INFINITY); weights.len()];
        let mut given = Vec::new();
        for text in &options.limit {
            let (index, limit) = self.limit(text)?;
            let what = format!("the range of limits of `{}`", self.variable(index).0.name);
            once(&mut given, index, &what, &format!("--limit {text}"))?;
            limits[index] = limit;
        }
        let own = study.sources.iter().zip(labels);
        let candidates = own.filter(|(_, label)| !label.is_play).map(|(source, _)| {
            let (least, most) = limits[source.variable];
            let (_, declared, _) = self.variable(source.variable);
            let present = if declared > 0.0 { declared } else { source.half_width };
            Candidate {
                variable: source.variable,
                distribution: source.distribution,
                cost: Cost {
                    fixed: 0.0,
                    factor: weights[source.variable] * present,
                    exponent: 1.0,
                },
                least,
                most,
            }
        });
        Ok(Wanted {
            band,
            rule: match options.kind {
                Kind::Rss => Rule::Deviation,
                _ => Rule::Worst,
            },
            candidates: candidates.collect(),
        })
    }

    /// Reads `NAME=LOW..HIGH`.
    fn limit(&self, text: &str) -> Result<(usize, (f64, f64)), Failure> {
        let (name, value) = split(text, "--limit", "s=0.05mm..0.2mm")?;
        let index = self.find(name, "--limit")?;
        let ends = value.split_once("..").ok_or_else(|| {
            Failure::request("--limit takes NAME=LOW..HIGH")
                .place(format!("--limit {text}"))
                .remedy("for example: --limit s=0.05mm..0.2mm")
        })?;
        let read = |text: &str| match text.trim() {
            "" => Ok(None),
            text => quantity(text, self.variable(index).0).map(Some),
        };
        let place = |failure: Failure| failure.place(format!("--limit {text}"));
        let low = read(ends.0).map_err(place)?.unwrap_or(0.0);
        let high = read(ends.1).map_err(place)?.unwrap_or(f64::INFINITY);
        Ok((index, (low, high)))
    }
}

/// That no band of an output is given.
fn no_band(given: &str, output: &Quantity) -> Failure {
    let (unit, example) = match output.unit {
        "deg" | "rad" => ("mrad".to_owned(), "1mrad".to_owned()),
        unit if unit.chars().all(char::is_alphabetic) => (unit.to_owned(), format!("0.1{unit}")),
        unit => (unit.to_owned(), format!("'0.1 [{unit}]'")),
    };
    Failure::request(format!("`{given}` is no band of `{}`", output.name))
        .place(format!("--allocate {given}"))
        .reason(format!("expected a number with a unit like {unit}"))
        .remedy(format!("for example: --allocate {example}"))
}
