//! The linkage as drawn, at one place: where the search for made ones begins.

use crate::closure::{AnyLinkage, Guide, Newton};
use crate::tolerance::error::ToleranceError;
use crate::tolerance::order::influence::split;
use crate::tolerance::order::variation::Stand;
use crate::tolerance::source::Source;

/// The nominal linkage at one place.
#[derive(Clone, Debug)]
pub struct Nominal {
    /// The constants.
    pub(super) values: Vec<f64>,
    /// Positions of the drivers.
    pub(super) independents: Vec<f64>,
    /// How they move; empty if that is not known.
    pub(super) motion: Vec<f64>,
    /// The whole position.
    pub(super) position: Vec<f64>,
    /// Assembly mode of each group.
    pub(super) modes: Vec<f64>,
    /// Sine of the transmission angle of each group.
    pub(super) sines: Vec<f64>,
    /// Units in which the dependent coordinates are compared: radians, or turns of the longest link.
    pub(super) units: Vec<f64>,
    /// Derivatives of the dependent coordinates by the sources: coordinates by sources. Empty if no group is iterated.
    pub(super) tangents: Vec<f64>,
    /// The outputs.
    pub(in crate::tolerance) outputs: Vec<f64>,
}

impl Nominal {
    /// Puts a linkage together and moves it through places.
    ///
    /// # Errors
    /// Why it does not get to one of them, or that something is not finite there.
    pub(in crate::tolerance) fn along(
        linkage: &dyn AnyLinkage,
        places: &[Vec<f64>],
        sources: &[Source],
    ) -> Result<Vec<Self>, ToleranceError> {
        let mut assembly = linkage.assemble();
        assembly.guide().start()?;
        let mut all = Vec::with_capacity(places.len());
        for (index, place) in places.iter().enumerate() {
            let (drivers, motion) = split(linkage.shape(), place)?;
            assembly.move_to(drivers)?;
            let nominal = Self::of(linkage, assembly.guide(), motion, sources);
            let nominal = nominal.filter(|one| one.outputs.iter().all(|value| value.is_finite()));
            all.push(nominal.ok_or(ToleranceError::NotFinite { place: index, at: place.clone() })?);
        }
        Ok(all)
    }

    /// Where the assembly stands; none at a dead point.
    fn of(
        linkage: &dyn AnyLinkage,
        mut guide: Guide<'_, f64>,
        motion: &[f64],
        sources: &[Source],
    ) -> Option<Self> {
        let (shape, entry) = (linkage.shape(), linkage.shape().loops());
        let instant = guide.loops.instant_row(guide.independents, motion);
        let mut outputs = vec![0.0; shape.outputs.len()];
        guide.loops.outputs(&instant, guide.position, &mut outputs);
        let groups = 0..entry.groups.len();
        let mut nominal = Self {
            values: linkage.values(),
            independents: guide.independents.to_vec(),
            motion: motion.to_vec(),
            position: guide.position.to_vec(),
            modes: groups.clone().map(|group| guide.mode(group)).collect(),
            sines: groups.map(|group| guide.sine(group)).collect(),
            units: vec![1.0; entry.dependents.len()],
            tangents: Vec::new(),
            outputs,
        };
        if entry.is_iterated() {
            nominal.measure(&mut guide);
            nominal.differentiate(linkage, sources)?;
        }
        Some(nominal)
    }

    /// Finds the units of the unknowns of groups that are iterated.
    fn measure(&mut self, guide: &mut Guide<'_, f64>) {
        let shape = guide.loops.shape();
        let mut newton = Newton::new(shape);
        let instant = guide.loops.instant_row(guide.independents, &[]);
        let mut position = guide.position.to_vec();
        for (index, group) in shape.loops().groups.iter().enumerate() {
            newton.sine(guide.loops, index, &instant, &mut position);
            for (&j, unit) in group.unknowns.iter().zip(newton.units()) {
                self.units[j] = *unit;
            }
        }
    }

    /// Finds how the dependent coordinates follow the sources.
    fn differentiate(&mut self, linkage: &dyn AnyLinkage, sources: &[Source]) -> Option<()> {
        let mut tangents = vec![0.0; self.units.len() * sources.len()];
        let variables = linkage.shape().loops().variables;
        for (column, source) in sources.iter().enumerate() {
            let variation = self.stand().varied(linkage, variables[source.variable]);
            for (row, slope) in variation.ok()?.dependents().into_iter().enumerate() {
                tangents[row * sources.len() + column] = slope;
            }
        }
        self.tangents = tangents;
        Some(())
    }

    /// Where it stands.
    pub(in crate::tolerance) fn stand(&self) -> Stand<'_> {
        Stand {
            values: &self.values,
            independents: &self.independents,
            motion: &self.motion,
            position: &self.position,
        }
    }
}
