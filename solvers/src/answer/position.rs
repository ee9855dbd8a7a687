//! Everything that a scene says at one time.

use crate::shape::Subject;
use std::ops::Index;

/// Everything that a scene says at one time of a motion, SI units. Emitted names are its indices: `position[Swing::PHI]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// The time, in seconds.
    pub time: f64,
    /// The mode, by its index.
    pub mode: usize,
    /// The state vector.
    pub state: Vec<f64>,
    /// Its time derivative.
    pub rates: Vec<f64>,
    /// The outputs.
    pub outputs: Vec<f64>,
}

impl Position {
    /// What a subject is here; none if it is a measure of the whole run, or not of this scene.
    pub fn get(&self, subject: Subject) -> Option<f64> {
        match subject {
            Subject::State(index) => self.state.get(index).copied(),
            Subject::Rate(index) => self.rates.get(index).copied(),
            Subject::Output(index) => self.outputs.get(index).copied(),
            Subject::Influence(..) | Subject::Measure(_) | Subject::Energy(_) => None,
        }
    }
}

impl Index<Subject> for Position {
    type Output = f64;

    /// # Panics
    /// If the subject is a measure, or not one of this scene.
    fn index(&self, subject: Subject) -> &f64 {
        match subject {
            Subject::State(index) => &self.state[index],
            Subject::Rate(index) => &self.rates[index],
            Subject::Output(index) => &self.outputs[index],
            Subject::Influence(..) | Subject::Measure(_) => {
                panic!("{subject:?} has no value at one time: ask `Motion::measure`")
            }
            Subject::Energy(_) => {
                panic!("{subject:?} is no part of a position: ask `Motion::values`")
            }
        }
    }
}
