//! Which tests the model of a scene generates.

use super::{SceneModel, SpanKind};

/// A test of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Test {
    /// That derivatives of the equations of motion are right.
    Jacobian,
    /// That energy stays where nothing takes it.
    Energy,
    /// That loops close, with the derivatives of positions and outputs.
    Closure,
    /// That other units give the same motion.
    Scaling,
    /// That a published fact comes out, by its place in the list of the scene.
    Fact(usize),
}

impl SceneModel {
    /// Its tests.
    pub fn tests(&self) -> Vec<Test> {
        let has_states = !self.states.is_empty();
        let has_energy = self.program.results.energy.len() == 2;
        let moves = has_states && self.span != SpanKind::Rest;
        let is_something = has_states || !self.outputs.is_empty();
        let own = [
            (Test::Jacobian, has_states),
            (Test::Energy, self.conservative && has_energy && moves),
            (Test::Closure, self.linkage.is_some()),
            // Where units can be chosen: the equations hold no number that has one.
            (Test::Scaling, self.literal.is_none() && is_something),
        ];
        let own = own.into_iter().filter_map(|(test, is_there)| is_there.then_some(test));
        own.chain((0..self.expectations.len()).map(Test::Fact)).collect()
    }
}
