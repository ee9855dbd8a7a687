//! The tests that the compiler generates from a model, without compiling it.

use std::sync::Arc;

use assur_model::asked::Asked;
use assur_model::checked::{self, SceneModel};
use assur_model::lexer::Unreadable;
use assur_registry::check::{self, Failed};
use assur_registry::registry::Mechanism;
use assur_solvers::problem::Scene;
use assur_solvers::shape::Shape;

use crate::mechanism::Made;
use crate::read::with_model;
use crate::scene::{Moved, Moving};

/// A test of a scene of a mechanism.
pub struct Test {
    /// The scene.
    pub scene: &'static str,
    /// What is tested: `jacobian`, `energy`, `closure`, `scaling`, or a published fact in the words of the file.
    pub name: String,
    made: Arc<Made>,
    shape: &'static Shape,
    mechanism: &'static Mechanism,
    test: checked::Test,
}

/// The tests of those scenes of a mechanism that are asked for, which it must have, in the order of the file; none where it
/// has errors. What has been derived is tested as it is interpreted; published facts are looked for with the mechanism as it
/// is, which may have been compiled.
///
/// # Errors
/// The text of the mechanism is none of an equation file.
pub fn tests(
    mechanism: &'static Mechanism,
    asked: Asked<'_>,
) -> Result<Option<Vec<Test>>, Unreadable> {
    with_model(mechanism, asked, |model, _| {
        model.scenes.iter().flat_map(|scene| of_scene(mechanism, scene)).collect()
    })
}

fn of_scene(mechanism: &'static Mechanism, scene: &SceneModel) -> Vec<Test> {
    let Some(entry) = mechanism.scenes.iter().find(|entry| entry.name == scene.name) else {
        return Vec::new();
    };
    let other = entry.unreduced.map(|other| other.shape);
    let made = Arc::new(Made::of(scene, entry.shape, other));
    let tests = scene.tests().into_iter().map(|test| Test {
        scene: entry.name,
        name: match test {
            checked::Test::Jacobian => "jacobian".to_owned(),
            checked::Test::Energy => "energy".to_owned(),
            checked::Test::Closure => "closure".to_owned(),
            checked::Test::Scaling => "scaling".to_owned(),
            checked::Test::Fact(index) => scene.expectations[index].label.clone(),
        },
        made: made.clone(),
        shape: entry.shape,
        mechanism,
        test,
    });
    tests.collect()
}

impl Test {
    /// Runs it.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn run(&self) -> Result<(), Failed> {
        if let checked::Test::Fact(index) = self.test {
            return check::fact(self.mechanism, self.scene, index);
        }
        let values: Vec<f64> = self.shape.constants.iter().map(|one| one.default).collect();
        match &*self.made {
            Made::Loops(loops) => {
                let linkage = Moved::new(loops, &values);
                match self.test {
                    checked::Test::Closure => check::closure(&linkage),
                    _ => check::closure_scaling(self.mechanism, self.scene, &linkage),
                }
            }
            Made::Motion(motion) if motion.is_smooth() => {
                let make = |values: &[f64]| Moving::<true>::new(motion, values);
                match self.test {
                    checked::Test::Energy => check::energy(&make(&values)),
                    _ => self.moves(&make, &values),
                }
            }
            Made::Motion(motion) => {
                self.moves(&|values: &[f64]| Moving::<false>::new(motion, values), &values)
            }
        }
    }

    /// What is tested of motions of all kinds.
    fn moves<C: Scene>(&self, make: &dyn Fn(&[f64]) -> C, values: &[f64]) -> Result<(), Failed> {
        match self.test {
            checked::Test::Jacobian => check::jacobian(&make(values)),
            _ => check::scaling(self.mechanism, self.scene, &|values| Some(make(values))),
        }
    }
}
