//! A scene that chooses its own values: those for which a measure is least, of all that keep its conditions.

mod complete;
mod judge;
mod made;
#[cfg(feature = "synthesis")]
mod neighbours;
#[cfg(feature = "synthesis")]
mod polish;
mod seek;
mod stand;
mod unmeasured;

#[cfg(feature = "synthesis")]
pub use polish::{Held, Polish, Settled, settle};
pub use seek::seek;
pub use stand::{Candidate, Stand};
pub use unmeasured::Unmeasured;

use std::f64::consts::{FRAC_2_PI, TAU};

use crate::registry::{Bind, SceneEntry};
use assur_solvers::answer::{Question, Settings};
use assur_solvers::closure::{Along, AnyLinkage, ClosureError};
use assur_solvers::measure::Missing;
use assur_solvers::shape::{Constant, Shape, Synthesis, Varied};
use assur_solvers::synthesis::{Score, Sought};

/// What of a way is lost counts half, what gap is left at its begin the other half.
const HALF: f64 = 0.5;
/// Of what is nowhere to be found, short of one.
const ALL: f64 = 1.0 - 1e-9;
/// A whole turn, to rounding.
const TURN: f64 = 1e-12 * TAU;

/// The synthesis that a scene states.
pub struct Design<'a> {
    bind: &'a Bind,
    constants: &'a [Constant],
    synthesis: Synthesis,
    shape: &'static Shape,
    /// Of each condition whether it follows from the constants alone.
    fixed: Vec<bool>,
    sought: Vec<Sought>,
    /// The values of all constants, of which those that are varied do not count.
    values: Vec<f64>,
    /// How motions are followed.
    settings: Settings,
}

impl<'a> Design<'a> {
    /// That of a scene, with the values of the constants that it does not vary; none if it states none.
    pub fn of(scene: &'a SceneEntry, values: &[f64], settings: &Settings) -> Option<Self> {
        let synthesis = scene.shape.synthesis?;
        let sought = synthesis.varied.iter().map(|one| {
            let is_angle = scene.constants[one.constant].quantity.dimension
                == assur_solvers::shape::Unit::NONE.dimension;
            let is_turn = is_angle && (one.to - one.from - TAU).abs() <= TURN;
            // Half of what lies between two values that it may have belongs to each.
            let (low, high) = match (one.values.first_chunk(), one.values.last_chunk()) {
                (Some([first, second]), Some([before, last])) => {
                    (first - 0.5 * (second - first), last + 0.5 * (last - before))
                }
                _ => (one.from, one.to),
            };
            Sought { low, high, is_turn: is_turn && one.values.is_empty() }
        });
        let conditions = synthesis.conditions.iter();
        Some(Self {
            bind: &scene.bind,
            constants: scene.constants,
            synthesis,
            shape: scene.shape,
            fixed: conditions.map(|index| scene.shape.uses[*index].is_empty()).collect(),
            sought: sought.collect(),
            values: values.to_vec(),
            settings: settings.clone(),
        })
    }

    /// What is varied, kept and made small.
    pub fn synthesis(&self) -> Synthesis {
        self.synthesis
    }

    /// All constants of a design.
    pub fn values(&self, design: &[f64]) -> Vec<f64> {
        let mut values = self.values.clone();
        for (one, value) in self.synthesis.varied.iter().zip(self.permitted(design)) {
            values[one.constant] = value;
        }
        values
    }

    /// A design with the nearest values that each number may have.
    fn permitted(&self, design: &[f64]) -> Vec<f64> {
        let nearest = |(one, value): (&Varied, &f64)| {
            let closer = |a: &&f64, b: &&f64| (*a - value).abs().total_cmp(&(*b - value).abs());
            one.values.iter().min_by(closer).copied().unwrap_or(*value)
        };
        self.synthesis.varied.iter().zip(design).map(nearest).collect()
    }

    /// The measures of a design with their estimated errors, none where nobody knows one.
    ///
    /// # Errors
    /// Why the design has none.
    pub fn measures(&self, design: &[f64]) -> Result<Vec<(f64, f64)>, Unmeasured> {
        let values = self.values(design);
        match self.bind {
            Bind::Linkage(bind) => {
                let linkage = bind(&values).map_err(Unmeasured::Refused)?;
                let way = linkage.way().ok_or(Unmeasured::NoTask)?;
                let found = linkage.measures(way).map_err(Unmeasured::Stuck)?;
                Ok(found.iter().map(|one| (one.value.unwrap_or(f64::NAN), one.error)).collect())
            }
            Bind::Motion(bind) => {
                let model = bind(&values).map_err(Unmeasured::Refused)?;
                let motion = Question::of(model.into()).solve(&self.settings);
                let motion = motion.map_err(Unmeasured::Still)?;
                let measures = motion.measures();
                let errors =
                    motion.estimate().map(|estimate| estimate.measures(&motion, &measures));
                let errors = errors.unwrap_or_else(|_| vec![f64::NAN; measures.len()]);
                let all = measures.into_iter().zip(errors);
                Ok(all.map(|(value, error)| (value.unwrap_or(f64::NAN), error)).collect())
            }
        }
    }

    /// Whether a measure is made small, kept or preferred.
    fn needs(&self, measure: usize) -> bool {
        measure == self.synthesis.objective
            || self.synthesis.conditions.contains(&measure)
            || self.synthesis.preferences.iter().any(|one| one.0 == measure)
    }

    /// How many conditions there are.
    fn count(&self) -> f64 {
        self.synthesis.conditions.len() as f64
    }

    /// What a design is worth.
    ///
    /// Of a linkage conditions that follow from the constants alone come first. Then, for all, comes that the design gets
    /// through its task, then the other conditions, each in the order in which they are stated. The first one that is missed
    /// decides, see [`missed`].
    fn score(&self, design: &[f64]) -> Score {
        let values = self.values(design);
        let measures = match self.bind {
            Bind::Linkage(bind) => {
                let Ok(linkage) = bind(&values) else {
                    return Score::missing(2.0 * self.count() + 1.0);
                };
                let known = linkage.of_constants();
                let margins = self.margins(|index| known[index], true);
                if let Some(first) = missed(&margins) {
                    return Score::missing(self.count() + 1.0 + first);
                }
                let Some(way) = linkage.way() else {
                    return Score::WORST;
                };
                match linkage.weighed(way, &|index| self.needs(index)) {
                    Ok(measures) => measures,
                    Err(error) => {
                        return Score::missing(self.count() + lost(&*linkage, way, &error));
                    }
                }
            }
            Bind::Motion(bind) => {
                let Ok(model) = bind(&values) else {
                    return Score::missing(2.0 * self.count() + 1.0);
                };
                match Question::of(model.into()).solve(&self.settings) {
                    Ok(motion) => motion.measures(),
                    Err(_) => return Score::missing(self.count() + ALL),
                }
            }
        };
        self.weigh(&measures)
    }

    /// The measures of the motion that a design has; none where it has none.
    #[cfg(feature = "synthesis")]
    fn found(&self, design: &[f64]) -> Option<Vec<Result<f64, Missing>>> {
        let Bind::Motion(bind) = self.bind else { return None };
        let model = bind(&self.values(design)).ok()?;
        let motion = Question::of(model.into()).solve(&self.settings).ok()?;
        Some(motion.measures())
    }

    fn weigh(&self, measures: &[Result<f64, Missing>]) -> Score {
        let is_known = |index: usize| matches!(measures[index], Ok(value) if value.is_finite());
        if (0..measures.len()).any(|index| self.needs(index) && !is_known(index)) {
            return Score::missing(self.count() + ALL);
        }
        let measure = |index: usize| measures[index].unwrap_or(f64::NAN);
        match missed(&self.margins(measure, false)) {
            Some(first) => Score::missing(first),
            None => Score::kept(self.synthesis.worth(measure(self.synthesis.objective), measure)),
        }
    }

    /// The margins of all conditions, or of those that follow from the constants, the others counting as kept.
    fn margins(&self, measure: impl Fn(usize) -> f64, fixed: bool) -> Vec<f64> {
        let conditions = self.synthesis.conditions.iter().zip(&self.fixed);
        let margin = |(index, own): (&usize, &bool)| match !fixed || *own {
            true => measure(*index),
            false => f64::INFINITY,
        };
        conditions.map(margin).collect()
    }
}

/// By how much conditions are missed: what decides is the first of those margins that are below zero. Each condition before
/// another counts one more than it can be missed by, so that no design that keeps it is worse. Below the number of margins.
fn missed(margins: &[f64]) -> Option<f64> {
    let first = margins.iter().position(|margin| *margin < 0.0)?;
    Some((margins.len() - 1 - first) as f64 + FRAC_2_PI * (-margins[first]).atan())
}

/// How much of its way a linkage does not get through, or what gap is left at its begin; between 0 and 1.
fn lost(linkage: &dyn AnyLinkage, way: Along, error: &ClosureError) -> f64 {
    let at = match error {
        ClosureError::DeadPoint { at, .. } | ClosureError::ModeLost { at, .. } => at,
        ClosureError::NotAssembled { gap, .. } => {
            return HALF + HALF * FRAC_2_PI * gap.abs().atan() * ALL;
        }
        _ => return ALL,
    };
    let (Along::Driver(driver, (from, to)), true) = (way, linkage.shape().loops().motion == 0)
    else {
        return HALF * ALL;
    };
    let left = (to - at[driver]) / (to - from);
    HALF * left.clamp(0.0, 1.0) * ALL
}

#[cfg(test)]
mod tests {
    use super::missed;

    #[test]
    fn the_first_condition_that_is_missed_decides() {
        assert_eq!(missed(&[0.0, 1.0, f64::INFINITY]), None);
        assert_eq!(missed(&[]), None);
        let of = |margins: &[f64]| missed(margins).expect("one is missed");
        // One that comes first is worse, however little it is missed by; the more of it, the worse.
        let ordered = [
            [1.0, 1.0, -1e-3],
            [1.0, 1.0, -9.0],
            [1.0, -1e-9, -9.0],
            [-1e-9, 1.0, 1.0],
            [-1e9, -1.0, -1.0],
        ];
        for pair in ordered.windows(2) {
            assert!(of(&pair[0]) < of(&pair[1]), "{pair:?}");
        }
        assert!(of(&ordered[4]) < 3.0);
    }
}
