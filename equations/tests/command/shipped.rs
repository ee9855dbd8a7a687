//! What comes with Assur works as it is.

use assur_equations::REGISTRY;

use super::{answer, folder};

/// Every scene of every mechanism runs with its own values, and what was published of it is met.
#[test]
fn every_scene_that_comes_with_assur_runs() {
    let folder = folder("shipped");
    for mechanism in REGISTRY {
        for scene in mechanism.scenes {
            let text = answer(&["run", mechanism.name, "--scene", scene.name], &folder);
            assert!(!text.contains("NaN"), "{} {}", mechanism.name, scene.name);
        }
    }
}
