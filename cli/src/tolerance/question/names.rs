//! What the names in options mean: what errs, the output, the place.

use assur::closure::Variable;
use assur::registry::SceneEntry;
use assur::shape::{Distribution, LinkageEntry, Quantity};
use assur::tolerance::Source;

use super::Label;
use crate::ask::lookup::suggestion;
use crate::ask::tolerances::{Given, named_in};
use crate::ask::values::{once, quantity, split};
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::tolerance::arguments::ToleranceArguments;

/// The names of a scene.
pub struct Names<'a> {
    pub scene: &'static SceneEntry,
    pub linkage: &'static LinkageEntry,
    pub case: &'a Case,
}

impl Names<'_> {
    /// The quantity of a variable, its tolerance and how it is distributed.
    pub fn variable(&self, index: usize) -> (&'static Quantity, f64, Distribution) {
        match self.linkage.variables[index] {
            Variable::Constant(index) => {
                let one = &self.scene.constants[index];
                (&one.quantity, one.tolerance, one.distribution)
            }
            Variable::Driver(index) => {
                let (tolerance, distribution) = self.linkage.tolerances[index];
                (&self.scene.drivers[index], tolerance, distribution)
            }
        }
    }

    /// The value of a variable; of a driver where it starts.
    fn value(&self, index: usize) -> f64 {
        match self.linkage.variables[index] {
            Variable::Constant(index) => self.case.constants.values[index],
            Variable::Driver(index) => self.case.moved.ranges[index].start,
        }
    }

    /// The index of a variable.
    pub fn find(&self, name: &str, option: &str) -> Result<usize, Failure> {
        let count = self.linkage.variables.len();
        let names: Vec<_> = (0..count).map(|one| self.variable(one).0.name).collect();
        names.iter().position(|one| *one == name).ok_or_else(|| {
            Failure::request(format!("nothing that can err is called `{name}`"))
                .place(format!("{option} {name}=…"))
                .remedy(suggestion(name, &names))
        })
    }

    /// Reads `NAME=VALUE` with the unit of the variable.
    fn read(&self, text: &str, option: &str) -> Result<(usize, f64), Failure> {
        let (name, value) = split(text, option, "l5=0.02mm")?;
        let index = self.find(name, option)?;
        let value = quantity(value, self.variable(index).0)
            .map_err(|failure| failure.place(format!("{option} {text}")))?;
        match value >= 0.0 {
            true => Ok((index, value)),
            false => Err(Failure::request(format!("`{name}` cannot err by less than nothing"))
                .place(format!("{option} {text}"))
                .remedy("give a half-width of zero or more")),
        }
    }

    /// What errs.
    pub fn sources(
        &self,
        options: &ToleranceArguments,
    ) -> Result<(Vec<Source>, Vec<Label>), Failure> {
        if !(options.scale > 0.0 && options.scale.is_finite()) {
            return Err(Failure::request(format!("--scale {} cannot be", options.scale))
                .remedy("give a positive number"));
        }
        let variables = 0..self.linkage.variables.len();
        let mut tolerances: Vec<_> = variables.map(|one| self.variable(one)).collect();
        let mut given = Vec::new();
        for text in &options.tolerance {
            let (name, width) = named_in(text)?;
            let index = self.find(name, "--tolerance")?;
            let place = format!("--tolerance {text}");
            once(&mut given, index, &format!("the tolerance of `{name}`"), &place)?;
            let (quantity, tolerance, distribution) = &mut tolerances[index];
            let asked = Given::read(width, quantity, self.value(index))
                .map_err(|failure| failure.place(place))?;
            (*tolerance, *distribution) =
                (asked.half_width, asked.distribution.unwrap_or(*distribution));
        }
        let mut sources = self.toleranced(&tolerances, options.scale);
        let label =
            |source: &Source| Label { quantity: tolerances[source.variable].0, is_play: false };
        let mut labels: Vec<_> = sources.iter().map(label).collect();
        for text in &options.play {
            let (variable, radial) = self.read(text, "--play")?;
            sources.push(Source::play(variable, radial));
            labels.push(Label { quantity: self.variable(variable).0, is_play: true });
        }
        match sources.is_empty() {
            false => Ok((sources, labels)),
            true => Err(Failure::request("nothing has a tolerance in this scene")
                .remedy("state one in the file, `dimension l4 = 90 mm +- 0.05 mm;`, or with --tolerance NAME=VALUE")),
        }
    }

    /// What errs by the tolerances of the file.
    pub fn declared(&self) -> Vec<Source> {
        let variables = 0..self.linkage.variables.len();
        self.toleranced(&variables.map(|one| self.variable(one)).collect::<Vec<_>>(), 1.0)
    }

    /// What errs by tolerances that are given for all variables.
    fn toleranced(
        &self,
        tolerances: &[(&'static Quantity, f64, Distribution)],
        scale: f64,
    ) -> Vec<Source> {
        let source =
            |(variable, (_, tolerance, distribution)): (usize, &(_, f64, Distribution))| {
                let half_width = tolerance * scale;
                let distribution = distribution.about(half_width, self.value(variable));
                (half_width > 0.0).then_some(Source { variable, half_width, distribution })
            };
        tolerances.iter().enumerate().filter_map(source).collect()
    }

    /// The index of the output that an option names.
    pub fn output(&self, name: Option<&str>, option: &str) -> Result<usize, Failure> {
        let names: Vec<_> = self.scene.outputs.iter().map(|one| one.name).collect();
        let Some(name) = name else {
            return names.len().checked_sub(1).ok_or_else(|| {
                Failure::request(format!("scene `{}` has no output", self.scene.name))
            });
        };
        names.iter().position(|one| *one == name).ok_or_else(|| {
            Failure::request(format!("scene `{}` has no output `{name}`", self.scene.name))
                .place(format!("{option} {name}"))
                .remedy(suggestion(name, &names))
        })
    }
}
