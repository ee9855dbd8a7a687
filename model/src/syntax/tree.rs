//! The syntax tree: the file as it is written, before any name has a meaning.

mod scene;
mod term;
mod visit;

pub use scene::{Among, Expect, ExpectAt, Output, Scene, SceneItem, Selection, SweepRange, Varied};
pub use term::{BinaryOperator, Points, TableTerm, Term, TermKind, UnaryOperator, UnitTerm};
pub use visit::Visitor;

use crate::token::Span;

/// A name with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The text.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A name that is declared, inside a `for` perhaps with an index: `x` or `x[k]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// The name.
    pub name: Name,
    /// The index, a whole number once the repetition is unrolled.
    pub index: Option<Box<Term>>,
}

/// A whole equation file.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    /// Documentation lines before the name.
    pub documentation: Vec<String>,
    /// Name of the mechanism.
    pub name: Name,
    /// The cited source.
    pub source: Option<String>,
    /// The statements, in the order of the file (which does not matter).
    pub statements: Vec<Statement>,
    /// Words of statements that could not be read: what they would have declared is not reported as missing.
    pub unread: std::collections::BTreeSet<String>,
}

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Documentation lines before it.
    pub documentation: Vec<String>,
    /// From its first token to its last.
    pub span: Span,
    /// What it says.
    pub kind: StatementKind,
}

impl Statement {
    /// How many statements these are with those in its blocks.
    pub fn count(&self) -> usize {
        let blocks = self.kind.blocks();
        1 + blocks.into_iter().flatten().map(Self::count).sum::<usize>()
    }
}

/// Whether a name, or the part that it belongs to, stood in a statement that could not be read.
pub fn is_unread(unread: &std::collections::BTreeSet<String>, name: &str) -> bool {
    let base = name.split('[').next().unwrap_or(name);
    let ends = base.match_indices('.').map(|(at, _)| at);
    ends.chain([base.len()]).any(|end| unread.contains(&base[..end]))
}

/// What a statement says.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the example of each variant names its parts")]
pub enum StatementKind {
    /// `dimension R = 75 mm +- 0.05 mm normal in 60 mm .. 90 mm;` or `parameter …`; several after commas become several statements.
    Constant(Constant),
    /// `preset table "text" { T = 207e3 [1/s^2]; }`
    Preset { name: Name, text: Option<String>, values: Vec<(Target, Term)> },
    /// `let x = …;`, `let f(a, b) = …;`
    Let { target: Target, arguments: Option<Vec<Name>>, value: Term },
    /// `driver theta = n*time in 0 .. 2*pi;` or `driver phi ~ 90 deg in 60 deg .. 120 deg +- 0.1 deg;`
    Driver(Driver),
    /// `dependent phi7 ~ -70 deg, s: m ~ 0.1 m;`
    Dependent(Dependent),
    /// `closure loop: l4*dir(phi4) + l5*dir(phi5) = [b, a];`
    Closure { label: Option<Target>, left: Term, right: Term },
    /// `point E = l4*dir(phi4);`. Several after commas become several statements.
    Point { target: Target, value: Term },
    /// `link D - E - F "rod";`. Several after commas become several statements.
    Link { points: Vec<Term>, text: Option<String> },
    /// `part feed: SewingFeed from "sewing_feed.eqn" { phi = theta; e_v = 6 mm +- 0.1 mm; beta ~ 180 deg; }`
    Part { name: Name, mechanism: Name, file: Option<Name>, bindings: Vec<Binding> },
    /// `coordinate phi2: rad = 0;`
    Coordinate(Unknown),
    /// `state i: A = 0;`
    State(Unknown),
    /// `motion rotor: J*ddot(phi) = M;`, `motion floor[k]: …`
    Motion { label: Option<Target>, left: Term, right: Term },
    /// `kinetic …;`, `potential …;` or `dissipation …;`
    Energy { kind: EnergyKind, value: Term },
    /// `force F on x;`: the force does the work `F·δx`. Several after commas become several statements.
    Force { value: Term, on: Term },
    /// `require l1 + l4 < l2 + l3 "Grashof";`
    Require { condition: Term, text: Option<String> },
    /// `mode wind "text" { … }`: statements that hold in a phase of the motion. What stands outside every mode holds in
    /// all of them.
    Mode { name: Name, text: Option<String>, body: Vec<Statement> },
    /// `hold phi2;`: the coordinate stays where it is while the mode lasts. Several after commas become several
    /// statements.
    Hold { target: Term },
    /// `when hit: x - l rises if dot(x) > 0 -> run { set dot(x) = 0; }`: an event.
    When(When),
    /// `effect torsion "text" { … } else { … }`
    Effect { name: Name, text: Option<String>, body: Vec<Statement>, otherwise: Vec<Statement> },
    /// `choice crank "text" { a { … } b { … } }`
    Choice { name: Name, text: Option<String>, alternatives: Vec<Alternative> },
    /// `if torsion && !bending { … } else { … }` on statements; the condition is over effects and choices.
    If { condition: Term, then: Vec<Statement>, otherwise: Vec<Statement> },
    /// `for k in 1..30 { … }`, both ends included.
    For { index: Name, from: Term, to: Term, body: Vec<Statement> },
    /// `scene elastic "text" = torsion + crank.exact { … }`
    Scene(Scene),
    /// `output x;`, `output F1 = … [kN];`. Several after commas become several statements.
    Output(Output),
    /// `measure F_max = peak(F) [kN] "largest force";`: a number of a whole run. Several after commas become several
    /// statements.
    Measure { what: Output, text: Option<String> },
    /// `mark "beat-up" at theta = 180 deg;`: a place that plots show.
    Mark { text: String, variable: Name, value: Term },
    /// `expect scene S at theta = 110 deg: x = 1 mm +- 0.1 mm "remark";`
    Expect(Expect),
}

impl StatementKind {
    /// The quantity that it declares, an output apart.
    pub fn declared(&self) -> Option<&Target> {
        match self {
            Self::Constant(Constant { target, .. })
            | Self::Let { target, .. }
            | Self::Driver(Driver { target, .. })
            | Self::Dependent(Dependent { target, .. })
            | Self::Point { target, .. }
            | Self::Coordinate(Unknown { target, .. })
            | Self::State(Unknown { target, .. })
            | Self::Output(Output { name: Some(target), value: Some(_), .. })
            | Self::Measure { what: Output { name: Some(target), .. }, .. } => Some(target),
            _ => None,
        }
    }

    /// The statements inside it, block by block.
    pub fn blocks(&self) -> Vec<&[Statement]> {
        match self {
            Self::Effect { body, otherwise, .. } | Self::If { then: body, otherwise, .. } => {
                vec![body, otherwise]
            }
            Self::Choice { alternatives, .. } => {
                alternatives.iter().map(|one| one.body.as_slice()).collect()
            }
            Self::For { body, .. } | Self::Mode { body, .. } => vec![body],
            _ => Vec::new(),
        }
    }

    /// The blocks, to be changed.
    pub fn blocks_mut(&mut self) -> Vec<&mut Vec<Statement>> {
        match self {
            Self::Effect { body, otherwise, .. } | Self::If { then: body, otherwise, .. } => {
                vec![body, otherwise]
            }
            Self::Choice { alternatives, .. } => {
                alternatives.iter_mut().map(|one| &mut one.body).collect()
            }
            Self::For { body, .. } | Self::Mode { body, .. } => vec![body],
            _ => Vec::new(),
        }
    }
}

/// An event: where a quantity passes zero, the mode may change, and coordinates may jump.
#[derive(Clone, Debug, PartialEq)]
pub struct When {
    /// What measures call it; several events may have one name.
    pub label: Option<Target>,
    /// The quantity that passes zero.
    pub guard: Term,
    /// In which direction.
    pub direction: Direction,
    /// What else has to hold there.
    pub condition: Option<Term>,
    /// The mode that follows; the same one goes on unless stated.
    pub target: Option<Name>,
    /// What jumps, with the value that it gets from those before the event.
    pub resets: Vec<(Term, Term)>,
}

/// How a quantity passes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From below.
    Rises,
    /// From above.
    Falls,
    /// Either way.
    Crosses,
}

impl Direction {
    /// How the same quantity with the other sign passes zero.
    pub fn turned(self) -> Self {
        match self {
            Direction::Rises => Direction::Falls,
            Direction::Falls => Direction::Rises,
            Direction::Crosses => Direction::Crosses,
        }
    }
}

/// A dimension or parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// Whether it is a dimension.
    pub is_dimension: bool,
    /// Its name.
    pub target: Target,
    /// Its default value.
    pub value: Option<Term>,
    /// Permitted error of the made size.
    pub tolerance: Option<Tolerance>,
    /// Permitted range, `in lo .. hi`.
    pub range: Option<(Term, Term)>,
}

/// A driver.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    /// Its name.
    pub target: Target,
    /// Its motion, `= n*time`; one without is set from outside.
    pub motion: Option<Term>,
    /// Position for which the start values of the dependent coordinates are meant, `~ 90 deg`.
    pub start: Option<Term>,
    /// Range over which it moves, `in 60 deg .. 120 deg`.
    pub range: Option<(Term, Term)>,
    /// Permitted error of its position.
    pub tolerance: Option<Tolerance>,
}

/// A dependent coordinate: closures determine it.
#[derive(Clone, Debug, PartialEq)]
pub struct Dependent {
    /// Its name.
    pub target: Target,
    /// Its unit; that of the start value unless stated.
    pub unit: Option<UnitTerm>,
    /// Roughly its value where the drivers start, which also picks the assembly mode.
    pub start: Option<Term>,
}

/// What a part gets from outside: a value (with a tolerance perhaps), or a start value.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// The quantity of the part.
    pub target: Target,
    /// Its value, `= 6 mm`.
    pub value: Option<Term>,
    /// Where it starts, `~ 180 deg`.
    pub start: Option<Term>,
    /// Permitted error of the made size.
    pub tolerance: Option<Tolerance>,
    /// Permitted range.
    pub range: Option<(Term, Term)>,
}

/// A permitted error with its distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Half-width.
    pub half_width: Term,
    /// How the made sizes are distributed.
    pub distribution: Distribution,
}

/// Distribution of a made size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Distribution {
    /// Half-width is three standard deviations.
    #[default]
    Normal,
    /// All within the half-width alike.
    Uniform,
    /// Normal, cut off at the half-width.
    Truncated,
    /// Of what is above zero, the half-width three standard deviations; its logarithm is normal.
    Lognormal,
}

/// A coordinate or state with its unit and start value.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// Its name.
    pub target: Target,
    /// Its unit; that of the start value unless stated.
    pub unit: Option<UnitTerm>,
    /// Its start value.
    pub start: Option<Term>,
    /// Start value of its first derivative, `coordinate x: m = 0, rate = 1 [m/s];` written after a second `,` as `rate`.
    pub start_rate: Option<Term>,
}

/// Which energy a statement adds to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnergyKind {
    /// Kinetic energy.
    Kinetic,
    /// Potential energy.
    Potential,
    /// Rayleigh's dissipation function: half the dissipated power where it is quadratic in the speeds.
    Dissipation,
}

/// One alternative of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// Its name.
    pub name: Name,
    /// Its explanation.
    pub text: Option<String>,
    /// Statements that hold with it.
    pub body: Vec<Statement>,
}
