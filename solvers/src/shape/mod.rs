//! What a scene is made of, as a value: names, units, tables. Empty lists say what it has not.
//!
//! The solvers read counts, scales and events here, and never a name or a unit; these are carried for whoever prints the
//! answer, and the dimensions for whoever states a scene in other units.

mod facts;
mod loops;
mod measured;
mod modes;
mod quantity;

pub use facts::{At, Energy, EquationText, Expectation, Mark, Operations, Subject};
#[cfg(test)]
pub(crate) use loops::by_hand;
pub use loops::{Augmented, Group, GroupKind, Link, LinkageEntry, Loop, Variable};
pub use measured::{Kind, Moment, NamedEvent, Primitive, Solved, Synthesis, Term, Varied};
pub use modes::{Direction, EventEntry, ModeEntry};
pub use quantity::{Constant, Distribution, Quantity, Unit};

/// What emitted tables name.
#[doc(hidden)]
pub mod tables {
    pub use super::*;
}

/// A text of a shape.
pub type Text = &'static str;
/// A list of a shape.
pub type List<T> = &'static [T];

/// What a scene is made of.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Name of the scene.
    pub name: Text,
    /// What the scene shows.
    pub summary: Text,
    /// Names of the effects that are present.
    pub effects: List<Text>,
    /// For each choice its name and the alternative that holds.
    pub choices: List<(Text, Text)>,
    /// The preset that the scene starts from; empty for the declared defaults.
    pub preset: Text,
    /// Dimensions and parameters that the scene depends on, in the order of their values.
    pub constants: List<Constant>,
    /// Prescribed coordinates.
    pub drivers: List<Quantity>,
    /// The state vector: coordinates, their speeds, first-order states.
    pub states: List<Quantity>,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Absolute tolerance of each state per unit of `rtol`, from the state's unit.
    pub scales: List<f64>,
    /// What the scene reports.
    pub outputs: List<Quantity>,
    /// Numbers of a whole run.
    pub measures: List<Quantity>,
    /// For each measure the primitives that it is made of.
    pub uses: List<List<usize>>,
    /// What measures find of a run.
    pub primitives: List<Primitive>,
    /// Number of quantities that primitives look at.
    pub measured: usize,
    /// What it seeks, if it is a synthesis.
    pub synthesis: Option<Synthesis>,
    /// The equations as text.
    pub equations: List<EquationText>,
    /// Operations of one call of each emitted function.
    pub operations: Operations,
    /// Places that plots show.
    pub marks: List<Mark>,
    /// Published facts about this scene.
    pub expectations: List<Expectation>,
    /// Whether the rates are affine in the state, so that superposition holds.
    pub is_linear: bool,
    /// The modes; none where the motion has neither modes nor events.
    pub modes: List<ModeEntry>,
    /// The mode in which the motion begins.
    pub first: usize,
    /// The loops, if the scene is a linkage.
    pub linkage: Option<LinkageEntry>,
    /// The loops by which a motion is reduced to its independent coordinates, if it has any.
    pub reduced: Option<LinkageEntry>,
    /// The closures of a motion that are not solved for, if it has any.
    pub augmented: Option<Augmented>,
    /// The scalar closures whose forces others depend on, as friction does: they are solved for together.
    pub felt: List<Text>,
    /// Names of the points.
    pub points: List<Text>,
    /// Lines between them.
    pub links: List<Link>,
    /// Forces of closures that are reported, by the first of the two outputs that each is. The places at which they act
    /// stand behind those of the points.
    pub arrows: List<usize>,
    /// The loops that the motion carries along, one entry for each group that may fail to close, named by its equations.
    pub carried: List<Loop>,
}

/// Methods that set a field, in constants.
macro_rules! with {
    ($($(#[$text:meta])* $name:ident: $type:ty;)*) => {
        $($(#[$text])*
        #[doc(hidden)]
        pub const fn $name(mut self, $name: $type) -> Self {
            self.$name = $name;
            self
        })*
    };
}

impl Shape {
    /// With nothing in it but a name.
    pub const fn named(name: Text) -> Self {
        Self {
            name,
            summary: "",
            effects: &[],
            choices: &[],
            preset: "",
            constants: &[],
            drivers: &[],
            states: &[],
            coordinates: 0,
            scales: &[],
            outputs: &[],
            measures: &[],
            uses: &[],
            primitives: &[],
            measured: 0,
            synthesis: None,
            equations: &[],
            // Nothing is known of what moves it: a step of a series is looked at in between.
            operations: Operations::of([0, 0, 0, 0, 0, 0, 0, 0, 1]),
            marks: &[],
            expectations: &[],
            is_linear: false,
            modes: &[],
            first: 0,
            linkage: None,
            reduced: None,
            augmented: None,
            felt: &[],
            points: &[],
            links: &[],
            arrows: &[],
            carried: &[],
        }
    }

    with! {
        summary: Text;
        effects: List<Text>;
        choices: List<(Text, Text)>;
        preset: Text;
        constants: List<Constant>;
        drivers: List<Quantity>;
        coordinates: usize;
        outputs: List<Quantity>;
        equations: List<EquationText>;
        operations: Operations;
        marks: List<Mark>;
        expectations: List<Expectation>;
        felt: List<Text>;
        points: List<Text>;
        links: List<Link>;
        arrows: List<usize>;
        carried: List<Loop>;
    }

    /// The state vector with its scales.
    #[doc(hidden)]
    pub const fn states(mut self, states: List<Quantity>, scales: List<f64>) -> Self {
        (self.states, self.scales) = (states, scales);
        self
    }

    /// The rates are affine in the state.
    #[doc(hidden)]
    pub const fn linear(mut self) -> Self {
        self.is_linear = true;
        self
    }

    /// The measures with the primitives that each is made of, those, and how many quantities they look at.
    #[doc(hidden)]
    pub const fn measures(
        mut self,
        measures: List<Quantity>,
        uses: List<List<usize>>,
        primitives: List<Primitive>,
        measured: usize,
    ) -> Self {
        (self.measures, self.uses) = (measures, uses);
        (self.primitives, self.measured) = (primitives, measured);
        self
    }

    /// What it seeks.
    #[doc(hidden)]
    pub const fn synthesis(mut self, synthesis: Synthesis) -> Self {
        self.synthesis = Some(synthesis);
        self
    }

    /// The modes, and in which the motion begins.
    #[doc(hidden)]
    pub const fn modes(mut self, modes: List<ModeEntry>, first: usize) -> Self {
        (self.modes, self.first) = (modes, first);
        self
    }

    /// The loops of a linkage.
    #[doc(hidden)]
    pub const fn linkage(mut self, linkage: LinkageEntry) -> Self {
        self.linkage = Some(linkage);
        self
    }

    /// The loops by which a motion is reduced.
    #[doc(hidden)]
    pub const fn reduced(mut self, reduced: LinkageEntry) -> Self {
        self.reduced = Some(reduced);
        self
    }

    /// The closures that hold the coordinates of a motion.
    #[doc(hidden)]
    pub const fn augmented(mut self, augmented: Augmented) -> Self {
        self.augmented = Some(augmented);
        self
    }

    /// The loops; none where the scene is no linkage.
    #[inline]
    pub const fn loops(&self) -> &LinkageEntry {
        match &self.linkage {
            Some(loops) => loops,
            None => &LinkageEntry::NONE,
        }
    }

    /// The defaults of its constants, of which there are `N`.
    #[doc(hidden)]
    pub fn defaults<const N: usize>(&self) -> [f64; N] {
        std::array::from_fn(|index| self.constants[index].default)
    }

    /// The closures that hold the coordinates in a mode and are not solved for, if there are any.
    pub fn held_in(&self, mode: usize) -> Option<Augmented> {
        match self.modes.get(mode) {
            Some(mode) => mode.augmented,
            None => self.augmented,
        }
    }

    /// The number of values that points and places of forces have.
    pub fn places(&self) -> usize {
        2 * (self.points.len() + self.arrows.len())
    }

    /// The largest number of guards of a mode.
    pub(crate) fn most_guards(&self) -> usize {
        self.modes.iter().map(ModeEntry::guards).max().unwrap_or(0)
    }

    /// The largest number of values that the guards of a mode write.
    pub(crate) fn most_written(&self) -> usize {
        self.modes.iter().map(ModeEntry::written).max().unwrap_or(0)
    }

    /// What a published fact speaks of; of an influence coefficient the output that is influenced.
    pub fn quantity(&self, subject: Subject) -> Option<&'static Quantity> {
        match (subject, &self.linkage) {
            (Subject::Output(index) | Subject::Influence(index, _), _) => self.outputs.get(index),
            (Subject::Rate(_) | Subject::Energy(_), _) => None,
            (Subject::State(index), Some(linkage)) => linkage.dependents.get(index),
            (Subject::State(index), None) => self.states.get(index),
            (Subject::Measure(index), _) => self.measures.get(index),
        }
    }
}

/// The place of a name in a list, `Shape::outputs` for instance.
pub fn find(list: &[Quantity], name: &str) -> Option<usize> {
    list.iter().position(|quantity| quantity.name == name)
}
