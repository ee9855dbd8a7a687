//! Published values beside the computed ones.

mod table;

pub use table::section;

use std::ops::Deref;

use assur::shape::Expectation;

use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::show::unit;

/// A published fact in words, before anything is computed.
#[derive(Clone, Debug)]
pub struct Stated {
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
}

impl Stated {
    /// A value in SI units in the unit of the fact.
    pub fn in_unit(&self, value: f64) -> f64 {
        unit::stated(value, self.factor)
    }

    /// The same with the preset for which it was published, unless the scene starts from that.
    pub fn with_preset(self, constants: &Constants) -> Self {
        match preset(constants, self.fact) {
            own if own == constants.preset => self,
            other => Self { place: format!("{}, preset {other}", self.place), ..self },
        }
    }
}

/// A published fact and what was computed in its place.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The fact.
    pub stated: Stated,
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

impl Deref for Comparison {
    type Target = Stated;

    fn deref(&self) -> &Stated {
        &self.stated
    }
}

impl Comparison {
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

/// What was found with some values, so that published facts can be compared with it.
pub trait Known: Sized {
    /// The values.
    fn constants(&self) -> &Constants;

    /// What is found with other values.
    ///
    /// # Errors
    /// When the mechanism refuses them, or nothing is found.
    fn with(&self, constants: Constants) -> Result<Self, Failure>;

    /// A fact beside what was computed in its place; none where nothing is.
    fn compare(&self, fact: &'static Expectation) -> Option<Comparison>;
}

/// Compares all published facts of the scene. A fact may ask for a preset; unless the user has chosen values, the answer is
/// found with it as well.
///
/// # Errors
/// When there is no answer with a preset.
pub fn compare<K: Known>(own: &K) -> Result<Vec<Comparison>, Failure> {
    let constants = own.constants();
    let changed = constants.changed();
    let mut others: Vec<K> = Vec::new();
    let mut list = Vec::new();
    for fact in constants.scene.expectations {
        let preset = preset(constants, fact);
        // With --preset the values may be those of the fact and not those of the file.
        let is_own = constants.of_preset(preset)?.values == constants.values;
        if is_own || changed {
            let found = own.compare(fact);
            list.extend(found.map(|one| Comparison { comparable: is_own, ..one }));
            continue;
        }
        let is_of = |other: &K| other.constants().preset == preset;
        if !others.iter().any(is_of) {
            others.push(own.with(constants.of_preset(preset)?)?);
        }
        let other = others.iter().find(|other| is_of(other));
        list.extend(
            other
                .and_then(|other| other.compare(fact))
                .map(|one| Comparison { stated: one.stated.with_preset(constants), ..one }),
        );
    }
    Ok(list)
}

/// The preset for which a fact was published: that of its scene unless it names one.
fn preset(constants: &Constants, fact: &Expectation) -> &'static str {
    match fact.preset {
        "" => constants.scene.preset,
        named => named,
    }
}
