//! Scenes, what they report, and published facts.

use super::{Name, Target, Term, UnitTerm};
use crate::token::Span;

/// A scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Its name.
    pub name: Name,
    /// Its explanation.
    pub text: Option<String>,
    /// Effects (`torsion`) and chosen alternatives (`crank.exact`), joined by `+`.
    pub selection: Vec<Selection>,
    /// What it does and reports.
    pub items: Vec<SceneItem>,
}

/// One selected effect or alternative.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// Effect, or choice when `alternative` is there.
    pub name: Name,
    /// Alternative of the choice.
    pub alternative: Option<Name>,
}

/// A statement inside a scene.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the example of each variant names its parts")]
pub enum SceneItem {
    /// `periodic over P;`, or `periodic;` where the period is a result.
    Periodic { period: Option<Term> },
    /// `run time a .. b;`
    Run { variable: Name, from: Term, to: Term },
    /// `rest;`
    Rest { place: Span },
    /// `sweep phi4;`, `sweep alpha 60 deg .. 120 deg, beta;`: a grid when several.
    Sweep { drivers: Vec<SweepRange> },
    /// `preset table;`
    Preset { name: Name },
    /// `output a, b = …;` adds to the outputs that the scene reports. A scene with any reports only these.
    Output(Output),
    /// `start phi2 = 0.1 rad, dot(phi2) = 0;`
    Start { values: Vec<(Term, Term)> },
    /// `hold nu;`: drivers that are values in the scene, as parameters are.
    Hold { drivers: Vec<Name> },
    /// `start run;`: the mode in which the motion begins.
    StartIn { mode: Name },
    /// `vary L1 in 3 mm .. 20 mm, mode in {-1, 1}, eta;`: constants that a synthesis chooses.
    Vary { constants: Vec<Varied> },
    /// `solve for x in 3 mm .. 20 mm, y: left = right;`: constants that follow from a condition while designs are sought.
    Solve { constants: Vec<Varied>, left: Term, right: Term },
    /// `require peak(mu) < 50 deg "text";`: a condition that a synthesis keeps.
    Require { condition: Term, text: Option<String> },
    /// `prefer peak(mu) < 50 deg weight 0.2 "text";`: a condition that a synthesis keeps if that is worth it.
    Prefer { condition: Term, weight: Option<Term>, text: Option<String> },
    /// `minimise peak(abs(error));`: what a synthesis makes small.
    Minimise { what: Output },
}

/// A constant that a synthesis chooses.
#[derive(Clone, Debug, PartialEq)]
pub struct Varied {
    /// The constant.
    pub constant: Target,
    /// From what.
    pub among: Among,
}

/// What a value is chosen from.
#[derive(Clone, Debug, PartialEq)]
pub enum Among {
    /// All that the constant permits.
    Permitted,
    /// `in 3 mm .. 20 mm`
    Range(Term, Term),
    /// `in {-1, 1}`
    Values(Vec<Term>),
}

/// A driver that a scene moves through a range.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepRange {
    /// The driver.
    pub driver: Name,
    /// From where to where; over the declared range unless stated.
    pub range: Option<(Term, Term)>,
}

/// A reported quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// The name after which it is reported; none for a bare expression, which is reported under its own text.
    pub name: Option<Target>,
    /// Its value; none when an existing name is reported.
    pub value: Option<Term>,
    /// The unit in which it is printed.
    pub unit: Option<UnitTerm>,
    /// Where it stands.
    pub span: Span,
}

/// A published fact.
#[derive(Clone, Debug, PartialEq)]
pub struct Expect {
    /// Scene concerned; the first one unless said.
    pub scene: Option<Name>,
    /// Preset to run with.
    pub preset: Option<Name>,
    /// Where in the motion.
    pub at: ExpectAt,
    /// The quantity: a state, the `dot` of one, or an output, by name.
    pub quantity: Term,
    /// Its published value.
    pub value: Term,
    /// Half-width of the band in which the computed one must lie.
    pub tolerance: Term,
    /// What the value is and how far to trust it.
    pub remark: Option<String>,
}

/// Where in a motion a published fact holds.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the example of each variant names its parts")]
pub enum ExpectAt {
    /// `at time = …`, `at theta = …`, `at alpha = …, beta = …`.
    Value { places: Vec<(Name, Term)> },
    /// `maximum`, `minimum` or `amplitude`, over the task of the scene.
    Extreme(Name),
}
