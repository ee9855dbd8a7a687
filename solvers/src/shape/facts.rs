//! What is said of a scene: its equations, their cost, places and published numbers.

use super::{List, Text};

/// An equation as text.
#[derive(Clone, Copy, Debug)]
pub struct EquationText {
    /// The equation.
    pub text: Text,
    /// Unit of each of its sides.
    pub unit: Text,
    /// Line in the equation file, from 1.
    pub line: u32,
}

/// Numbers of arithmetic operations, functions and selections per call.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Once per parameter set.
    pub prepare: usize,
    /// Once per instant.
    pub instant: usize,
    /// Per evaluation of the derivative; of a linkage per position, a group without closed form being iterated once.
    pub derivative: usize,
    /// Per evaluation of the Jacobian; of a linkage of the influence coefficients.
    pub jacobian: usize,
    /// Per evaluation of all outputs.
    pub outputs: usize,
    /// Those among an instant and the derivative that are functions of the long kind: exponentials, logarithms, powers, arcs,
    /// hyperbolic functions and tangents.
    pub functions: usize,
    /// Per term of the Taylor series of the motion; none where there is no series.
    pub term: usize,
    /// Sums over all terms so far that each term of the series takes.
    pub sums: usize,
    /// Values, in all modes, that may change within a step and change back without that the terms of the series tell.
    pub unfelt: usize,
}

/// A place that plots show.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// What is there.
    pub text: Text,
    /// A time, or a position of a driver.
    pub at: At,
}

/// A published fact, stated beside the equations.
#[derive(Clone, Copy, Debug)]
pub struct Expectation {
    /// Where in the motion.
    pub at: At,
    /// What it speaks of.
    pub subject: Subject,
    /// Published value, SI units.
    pub value: f64,
    /// Half-width of the band in which the computed value must lie, SI units.
    pub tolerance: f64,
    /// Name of the preset to run with; empty for the scene's own values.
    pub preset: Text,
    /// What the published value is and how far to trust it.
    pub remark: Text,
    /// Line in the equation file, from 1.
    pub line: u32,
}

/// A place in a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// At a time, in seconds.
    Time(f64),
    /// Where the driver of this index first reaches a position, SI units.
    Driver(usize, f64),
    /// At these positions of the drivers of these indices, the others standing where they start.
    Position(List<(usize, f64)>),
    /// The largest value over the task.
    Maximum,
    /// The smallest value over the task.
    Minimum,
    /// The largest absolute value over the task.
    Amplitude,
    /// The whole run, of which it is a measure.
    Run,
}

/// What a published fact speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A component of the state, of a linkage a dependent coordinate.
    State(usize),
    /// The time derivative of a component of the state.
    Rate(usize),
    /// An output.
    Output(usize),
    /// The influence of a variable of a linkage on an output: output, variable.
    Influence(usize, usize),
    /// A measure of the whole run.
    Measure(usize),
    /// An energy of the whole.
    Energy(Energy),
}

/// An energy of the whole, of a scene that states energies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Energy {
    /// That of the masses that move.
    Kinetic,
    /// That of springs and weights.
    Potential,
    /// Both together: what is not gained and lost stays.
    Both,
}

impl EquationText {
    /// An equation of a line of the file.
    #[doc(hidden)]
    pub const fn new(line: u32, text: Text, unit: Text) -> Self {
        Self { text, unit, line }
    }
}

impl Operations {
    /// In the order of the fields.
    #[doc(hidden)]
    pub const fn of(counts: [usize; 9]) -> Self {
        let [prepare, instant, derivative, jacobian, outputs, functions, term, sums, unfelt] =
            counts;
        Self { prepare, instant, derivative, jacobian, outputs, functions, term, sums, unfelt }
    }
}

impl Mark {
    /// What is at a place.
    #[doc(hidden)]
    pub const fn new(text: Text, at: At) -> Self {
        Self { text, at }
    }
}

impl Expectation {
    /// A published value and its band, by the line of the file.
    #[doc(hidden)]
    pub const fn new(line: u32, subject: Subject, at: At, value: f64, tolerance: f64) -> Self {
        Self { at, subject, value, tolerance, preset: "", remark: "", line }
    }

    /// With the values of a preset.
    #[doc(hidden)]
    pub const fn preset(mut self, preset: Text) -> Self {
        self.preset = preset;
        self
    }

    /// With what it is.
    #[doc(hidden)]
    pub const fn remark(mut self, remark: Text) -> Self {
        self.remark = remark;
        self
    }
}
