//! From options to a question that the solvers understand.

mod names;
mod wanted;

use assur::shape::{Distribution, Quantity};
use assur::tolerance::{Sampling, Source, Study};

use super::arguments::{Kind, ToleranceArguments};
use super::places::{along, range};
use crate::ask::For;
use crate::ask::constants::Constants;
use crate::ask::lookup::Registry;
use crate::ask::permitted::permitted;
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::linkage::place;
use crate::linkage::wording::contradiction;
use crate::show::number;
pub use names::Names;
pub use wanted::Wanted;

/// A question, and what its numbers are called.
pub struct Question {
    /// The linkage with its values.
    pub case: Case,
    /// What was given with --set, in words; empty if nothing.
    pub changed: String,
    /// What errs, over the range.
    pub study: Study,
    /// Whether the output was named; else it is the last one of the scene.
    pub is_named: bool,
    /// Places over the range of the first driver alone, where the study goes over a grid.
    pub along: Option<Vec<Vec<f64>>>,
    /// What each source is called.
    pub labels: Vec<Label>,
    /// Where `--at` looks.
    pub at: Option<Vec<f64>>,
    /// Which bands are wanted.
    pub kind: Kind,
    /// How linkages are made.
    pub sampling: Sampling,
    /// What is to be chosen.
    pub allocation: Option<Wanted>,
    /// What the numbers do not say, in words.
    pub notes: Vec<String>,
}

/// What a source of error is called.
#[derive(Clone, Copy)]
pub struct Label {
    /// The quantity that errs.
    pub quantity: &'static Quantity,
    /// Whether by play.
    pub is_play: bool,
}

impl Question {
    /// Reads the options.
    ///
    /// # Errors
    /// A name, unit or number that is wrong, or a scene that is no linkage.
    pub fn read(options: &ToleranceArguments, registry: Registry) -> Result<Self, Failure> {
        let case = Case::new(options.asked.find(registry, "tolerance", For::Linkages)?)?;
        let places = options.places as usize;
        let sampling =
            Sampling { samples: options.samples, seed: options.seed, ..Sampling::default() };
        let names = Names { scene: case.scene, linkage: case.moved.entry, case: &case };
        let (sources, labels) = names.sources(options)?;
        let study = Study {
            output: names.output(options.output.as_deref(), "--output")?,
            places: range(case.run(), places),
            sources,
        };
        let allocation = match &options.allocate {
            Some(band) => Some(names.wanted(options, band, &study, &labels)?),
            None => None,
        };
        let notes = contradiction(&case.constants, case.run())
            .into_iter()
            .chain(beyond(&case.constants, &labels, &study))
            .collect();
        Ok(Self {
            notes,
            at: match options.at.as_slice() {
                [] => None,
                given => Some(place::read(&case, &given.join(","))?.independents),
            },
            along: along(case.run(), places),
            changed: changed(&case.constants),
            case,
            study,
            labels,
            is_named: options.output.is_some(),
            kind: options.kind,
            sampling,
            allocation,
        })
    }

    /// The output.
    pub fn output(&self) -> &'static Quantity {
        &self.case.scene.outputs[self.study.output]
    }

    /// Options of the other outputs.
    pub fn other_outputs(&self) -> Vec<&'static str> {
        let outputs = self.case.scene.outputs.iter().enumerate();
        let others = outputs.filter(|(index, _)| *index != self.study.output);
        others.map(|(_, one)| one.name).collect()
    }
}

/// The dimensions whose tolerances lead out of their declared ranges, each in words.
fn beyond(constants: &Constants, labels: &[Label], study: &Study) -> Vec<String> {
    let own = labels.iter().zip(&study.sources).filter(|(one, _)| !one.is_play);
    let note = |(label, source): (&Label, &Source)| {
        let all = constants.scene.constants;
        let index = all.iter().position(|one| one.quantity.name == label.quantity.name)?;
        let (value, half_width) = (constants.values[index], source.half_width);
        let least = match source.distribution {
            Distribution::Lognormal { .. } => None,
            _ => Some(value - half_width),
        };
        let mut extremes = least.into_iter().chain([value + half_width]);
        let refused = extremes.find_map(|extreme| permitted(&all[index], extreme).err())?;
        let half_width = number::declared(half_width / label.quantity.factor);
        Some(format!(
            "{}, which +- {half_width} {} leads to: what lies there is counted all the same",
            refused.what(),
            label.quantity.unit
        ))
    };
    own.filter_map(note).collect()
}

/// The values that were given with --set, in words.
fn changed(constants: &Constants) -> String {
    let all = constants.scene.constants.iter().enumerate();
    let given = all.filter(|(index, _)| constants.is_changed(*index));
    let words = given.map(|(index, constant)| {
        let quantity = &constant.quantity;
        let value = number::declared(constants.values[index] / quantity.factor);
        format!("{} = {value} {}", quantity.name, quantity.unit).trim_end().to_owned()
    });
    words.collect::<Vec<_>>().join(", ")
}
