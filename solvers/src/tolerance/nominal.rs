//! The linkage as drawn, at one place: where the search for made ones begins.

use super::error::ToleranceError;
use super::influence::split;
use super::source::Source;
use super::variation::Stand;
use crate::closure::{Assembly, Closure, GroupKind, Linkage, Newton};

/// The nominal linkage at one place.
#[derive(Clone, Debug)]
pub(super) struct Nominal {
    /// The constants.
    pub values: Vec<f64>,
    /// Positions of the drivers.
    pub independents: Vec<f64>,
    /// How they move; empty if that is not known.
    pub motion: Vec<f64>,
    /// The whole position.
    pub position: Vec<f64>,
    /// Assembly mode of each group.
    pub modes: Vec<f64>,
    /// Sine of the transmission angle of each group.
    pub sines: Vec<f64>,
    /// Units in which the dependent coordinates are compared: radians, or turns of the longest link.
    pub units: Vec<f64>,
    /// Derivatives of the dependent coordinates by the sources: coordinates by sources. Empty if no group is iterated.
    pub tangents: Vec<f64>,
    /// The outputs.
    pub outputs: Vec<f64>,
}

impl Nominal {
    /// Puts a linkage together and moves it through places.
    ///
    /// # Errors
    /// Why it does not get to one of them, or that something is not finite there.
    pub fn along<L: Linkage>(
        linkage: &L,
        places: &[Vec<f64>],
        sources: &[Source],
    ) -> Result<Vec<Self>, ToleranceError> {
        let mut assembly = Assembly::<L, f64>::new(linkage);
        assembly.start()?;
        let mut all = Vec::with_capacity(places.len());
        for (index, place) in places.iter().enumerate() {
            let (drivers, motion) = split::<L>(place)?;
            assembly.move_to(drivers)?;
            let nominal = Self::of(linkage, &assembly, motion, sources);
            let nominal = nominal.filter(|one| one.outputs.iter().all(|value| value.is_finite()));
            all.push(nominal.ok_or(ToleranceError::NotFinite {
                place: index,
                at: place.clone(),
            })?);
        }
        Ok(all)
    }

    /// Where the assembly stands; none at a dead point.
    fn of<L: Linkage>(
        linkage: &L,
        assembly: &Assembly<L, f64>,
        motion: &[f64],
        sources: &[Source],
    ) -> Option<Self> {
        let closure = assembly.closure();
        let independents = assembly.independents();
        let instant = match motion.is_empty() {
            true => closure.instant(independents),
            false => closure.moving(independents, motion),
        };
        let mut outputs = vec![0.0; L::OUTPUTS];
        closure.outputs(&instant, assembly.position(), &mut outputs);
        let groups = 0..L::GROUPS.len();
        let mut nominal = Self {
            values: linkage.values(),
            independents: independents.to_vec(),
            motion: motion.to_vec(),
            position: assembly.position().as_ref().to_vec(),
            modes: groups.clone().map(|group| assembly.mode(group)).collect(),
            sines: groups.map(|group| assembly.sine(group)).collect(),
            units: vec![1.0; L::DEPENDENTS],
            tangents: Vec::new(),
            outputs,
        };
        if is_iterated::<L>() {
            nominal.measure(assembly);
            nominal.differentiate::<L>(sources)?;
        }
        Some(nominal)
    }

    /// Finds the units of the unknowns of groups that are iterated.
    fn measure<L: Linkage>(&mut self, assembly: &Assembly<L, f64>) {
        let mut newton = Newton::<L, f64>::new();
        let closure = assembly.closure();
        let instant = closure.instant(assembly.independents());
        let mut position = assembly.position().clone();
        for (index, group) in L::GROUPS.iter().enumerate() {
            newton.sine(closure, index, &instant, &mut position);
            for (&j, unit) in group.unknowns.iter().zip(newton.units()) {
                self.units[j] = *unit;
            }
        }
    }

    /// Finds how the dependent coordinates follow the sources.
    fn differentiate<L: Linkage>(&mut self, sources: &[Source]) -> Option<()> {
        let mut tangents = vec![0.0; L::DEPENDENTS * sources.len()];
        for (column, source) in sources.iter().enumerate() {
            let variation = self.stand().varied::<L>(L::VARIABLES[source.variable]);
            for (row, slope) in variation.ok()?.dependents.into_iter().enumerate() {
                tangents[row * sources.len() + column] = slope;
            }
        }
        self.tangents = tangents;
        Some(())
    }

    /// Where it stands.
    pub fn stand(&self) -> Stand<'_> {
        Stand {
            values: &self.values,
            independents: &self.independents,
            motion: &self.motion,
            position: &self.position,
        }
    }
}

/// Whether a group is iterated.
#[inline(always)]
pub(super) fn is_iterated<L: Linkage>() -> bool {
    L::GROUPS
        .iter()
        .any(|group| matches!(group.kind, GroupKind::General))
}
