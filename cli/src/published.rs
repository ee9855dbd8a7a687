//! Published values beside the computed ones.

use assur::answer::{Ends, Estimate, Motion};
use assur::measure::ALWAYS;
use assur::registry::{Mechanism, SceneEntry, Settings};
use assur::shape::{At, Expectation, Subject};

use crate::case::Case;
use crate::constants::{Constants, find_preset};
use crate::curves;
use crate::error::Failure;
use crate::measures;
use crate::measures::Measured;
use crate::number;
use crate::report::driver_label;
use crate::unit;

/// A published fact and what was computed in its place.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The fact.
    pub fact: &'static Expectation,
    /// What it speaks of.
    pub name: String,
    /// Unit in which it is printed.
    pub unit: String,
    /// SI value of one such unit.
    pub factor: f64,
    /// Index of the variable, if it is one.
    pub variable: Option<usize>,
    /// Where in the motion, in words.
    pub place: String,
    /// The time of the place; none for an extreme, for a position of drivers that are swept, or where the motion does
    /// not get there.
    pub time: Option<f64>,
    /// The computed value, SI units; NaN where the motion does not get there.
    pub computed: f64,
    /// Its estimated error, SI units.
    pub error: f64,
    /// Whether the values of the run are those for which the fact was published.
    pub comparable: bool,
}

impl Comparison {
    /// A value in SI units in the unit of the fact.
    pub fn in_unit(&self, value: f64) -> f64 {
        unit::stated(value, self.factor)
    }

    /// Computed less published.
    pub fn deviation(&self) -> f64 {
        self.computed - self.fact.value
    }

    /// The deviation as a share of the published value; not finite when that is zero.
    pub fn relative(&self) -> f64 {
        self.deviation() / self.fact.value.abs()
    }

    /// Whether the computed value lies in the band of the file; nothing if the values of the run are others.
    pub fn within(&self) -> Option<bool> {
        self.comparable.then(|| self.deviation().abs() <= self.fact.tolerance)
    }
}

/// What is known of a motion.
pub struct Known<'a> {
    /// The scene with its values.
    pub case: &'a Case,
    /// The motion.
    pub motion: &'a Motion,
    /// How accurate it is.
    pub estimate: &'a Estimate,
    /// Smallest and largest value of each variable.
    pub ends: &'a [Ends],
    /// Numbers of the whole task, with their errors.
    pub measures: &'a [Measured],
}

/// The same of a motion that was found for the preset that a fact asks for.
struct Solved {
    preset: &'static str,
    case: Case,
    motion: Motion,
    estimate: Estimate,
    ends: Vec<Ends>,
    measures: Vec<Measured>,
}

impl Solved {
    fn new(
        mechanism: &'static Mechanism,
        scene: &'static SceneEntry,
        preset: &'static str,
        settings: Settings,
    ) -> Result<Self, Failure> {
        let mut constants = Constants::declared(scene);
        constants.apply(find_preset(mechanism, preset)?);
        let mut case = Case::new(constants)?;
        let motion = case.solve(&settings)?;
        case.repeat(&motion);
        let subjects = case.subjects();
        let extremes = motion.extremes(&subjects, ALWAYS);
        let curves = curves::sample(&case, &motion, &extremes);
        let estimate = motion.estimate();
        let estimate = estimate.map_err(|error| case.unanswered(&error))?;
        let measures = measures::of(&case, &motion, &estimate);
        Ok(Self {
            preset,
            ends: estimate.extremes(&motion, &subjects, &curves.samples(), &extremes),
            case,
            motion,
            estimate,
            measures,
        })
    }

    fn known(&self) -> Known<'_> {
        Known {
            case: &self.case,
            motion: &self.motion,
            estimate: &self.estimate,
            ends: &self.ends,
            measures: &self.measures,
        }
    }
}

/// Compares all published facts of the scene.
///
/// A fact may ask for a preset; unless the user has chosen values, the scene is solved with it as well.
///
/// # Errors
/// When solving with a preset does not succeed.
pub fn compare(mechanism: &'static Mechanism, own: &Known<'_>) -> Result<Vec<Comparison>, Failure> {
    let (scene, constants) = (own.case.scene, &own.case.constants);
    let changed = constants.changed();
    let wanted = |fact: &Expectation| match fact.preset.is_empty() {
        true => scene.preset,
        false => fact.preset,
    };
    let mut others: Vec<Solved> = Vec::new();
    for preset in scene.expectations.iter().map(wanted) {
        let is_known = preset == constants.preset || others.iter().any(|one| one.preset == preset);
        if !changed && !is_known {
            others.push(Solved::new(mechanism, scene, preset, own.motion.settings.clone())?);
        }
    }
    let facts = scene.expectations.iter().filter_map(|fact| {
        let preset = wanted(fact);
        match others.iter().find(|one| one.preset == preset) {
            Some(other) => one(fact, preset, &other.known(), true),
            None => one(fact, constants.preset, own, !changed && constants.preset == preset),
        }
    });
    Ok(facts.collect())
}

fn one(
    fact: &'static Expectation,
    preset: &str,
    known: &Known<'_>,
    comparable: bool,
) -> Option<Comparison> {
    let case = known.case;
    let quantity = case.scene.quantity(fact.subject)?;
    let own_preset = |place: &str| match preset == case.scene.preset {
        true => place.to_owned(),
        false => format!("{place}, preset {preset}"),
    };
    if let Subject::Measure(index) = fact.subject {
        let measure = known.measures.get(index)?;
        return Some(Comparison {
            fact,
            name: quantity.name.to_owned(),
            unit: quantity.unit.to_owned(),
            factor: quantity.factor,
            variable: None,
            place: own_preset("whole run"),
            time: None,
            computed: measure.value.unwrap_or(f64::NAN),
            error: measure.error,
            comparable,
        });
    }
    let name = quantity.name;
    let variable = case.variables.iter().position(|variable| variable.name == name)?;
    let (place, time) = match fact.at {
        At::Time(time) => (format!("time = {} s", number::short(time)), case.task.reduce(time)),
        At::Driver(driver, position) => {
            (driver_label(case, driver, position), case.run().time_of(driver, position).ok())
        }
        At::Maximum => ("maximum".to_owned(), None),
        At::Minimum => ("minimum".to_owned(), None),
        At::Amplitude => ("amplitude".to_owned(), None),
        At::Position(_) | At::Run => return None,
    };
    let (computed, error) = match (time, known.ends.get(variable)) {
        (Some(time), _) => (
            case.sample(known.motion, time)[variable],
            known.estimate.at(known.motion, &case.subjects(), time)[variable],
        ),
        (None, Some(ends)) => {
            let end = match fact.at {
                At::Maximum => ends.highest,
                At::Minimum => ends.lowest,
                At::Amplitude => ends.furthest(),
                _ => return None,
            };
            let value = match fact.at {
                At::Amplitude => end.value.abs(),
                _ => end.value,
            };
            (value, end.error)
        }
        (None, None) => (f64::NAN, f64::NAN),
    };
    let printed = &case.variables[variable];
    Some(Comparison {
        fact,
        name: printed.name.clone(),
        unit: printed.unit.clone(),
        factor: printed.factor,
        variable: Some(variable),
        place: own_preset(&place),
        time,
        computed,
        error,
        comparable,
    })
}
