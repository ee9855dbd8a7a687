//! Published values beside the computed ones.

use assur::registry::{At, Expectation, Mechanism, Subject};

use crate::case::Case;
use crate::constants::{Constants, find_preset};
use crate::curves::{self, Extreme};
use crate::error::Failure;
use crate::motion::Motion;
use crate::number;
use crate::report::driver_label;

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
        value / self.factor
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
        self.comparable
            .then(|| self.deviation().abs() <= self.fact.tolerance)
    }
}

/// A motion with its extremes, for the preset that a fact asks for.
struct Solved<'a> {
    preset: &'static str,
    case: &'a Case,
    motion: &'a Motion,
    extremes: &'a [Extreme],
}

/// Compares all published facts of the scene.
///
/// A fact may ask for a preset; unless the user has chosen values, the scene is solved with it as well. The errors are
/// the estimated ones of the variables.
///
/// # Errors
/// When solving with a preset does not succeed.
pub fn compare(
    mechanism: &'static Mechanism,
    case: &Case,
    motion: &Motion,
    extremes: &[Extreme],
    errors: &[f64],
) -> Result<Vec<Comparison>, Failure> {
    let changed = case.constants.changed();
    let wanted = |fact: &Expectation| {
        if fact.preset.is_empty() {
            case.scene.preset
        } else {
            fact.preset
        }
    };
    let mut others: Vec<(&str, Case, Motion, Vec<Extreme>)> = Vec::new();
    if !changed {
        for fact in case.scene.expectations {
            let preset = wanted(fact);
            if preset != case.constants.preset && others.iter().all(|(known, ..)| *known != preset)
            {
                let mut constants = Constants::declared(case.scene);
                constants.apply(find_preset(mechanism, preset)?);
                let mut case = Case::new(constants)?;
                let motion = case.solve(motion.settings)?;
                case.repeat(&motion);
                let curves = curves::sample(&case, &motion);
                let extremes = curves::extremes(&case, &motion, &curves);
                others.push((preset, case, motion, extremes));
            }
        }
    }
    let own = Solved {
        preset: case.constants.preset,
        case,
        motion,
        extremes,
    };
    let facts = case.scene.expectations.iter().filter_map(|fact| {
        let preset = wanted(fact);
        let other = others.iter().find(|(known, ..)| *known == preset);
        let compared = match other {
            Some((preset, case, motion, extremes)) => one(
                fact,
                &Solved {
                    preset,
                    case,
                    motion,
                    extremes,
                },
                true,
            ),
            None => one(fact, &own, !changed && own.preset == preset),
        };
        compared.map(|compared| Comparison {
            error: compared.variable.map_or(0.0, |variable| errors[variable]),
            ..compared
        })
    });
    Ok(facts.collect())
}

fn one(fact: &'static Expectation, solved: &Solved<'_>, comparable: bool) -> Option<Comparison> {
    let case = solved.case;
    let quantity = case.scene.quantity(fact.subject)?;
    let own_preset = |place: &str| match solved.preset == case.scene.preset {
        true => place.to_owned(),
        false => format!("{place}, preset {}", solved.preset),
    };
    if let Subject::Measure(index) = fact.subject {
        let measures = solved.motion.measures(case);
        let computed = measures.get(index)?.value.unwrap_or(f64::NAN);
        return Some(Comparison {
            fact,
            name: quantity.name.to_owned(),
            unit: quantity.unit.to_owned(),
            factor: quantity.factor,
            variable: None,
            place: own_preset("whole run"),
            time: None,
            computed,
            error: 0.0,
            comparable,
        });
    }
    let name = quantity.name;
    let variable = case
        .variables
        .iter()
        .position(|variable| variable.name == name)?;
    let extreme = solved.extremes.get(variable)?;
    let (place, time, extreme) = match fact.at {
        At::Time(time) => (
            format!("time = {} s", number::short(time)),
            case.task.reduce(time),
            f64::NAN,
        ),
        At::Driver(driver, position) => (
            driver_label(case, driver, position),
            case.run().time_of(driver, position).ok(),
            f64::NAN,
        ),
        At::Maximum => ("maximum".to_owned(), None, extreme.maximum.1),
        At::Minimum => ("minimum".to_owned(), None, extreme.minimum.1),
        At::Amplitude => ("amplitude".to_owned(), None, extreme.amplitude()),
        At::Position(_) | At::Run => return None,
    };
    let computed = time.map_or(extreme, |time| case.sample(solved.motion, time)[variable]);
    let place = own_preset(&place);
    let printed = &case.variables[variable];
    Some(Comparison {
        fact,
        name: printed.name.clone(),
        unit: printed.unit.clone(),
        factor: printed.factor,
        variable: Some(variable),
        place,
        time,
        computed,
        error: 0.0,
        comparable,
    })
}
