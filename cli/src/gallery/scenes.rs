//! The table of the scenes.

use assur::registry::{Mechanism, SceneEntry};

use super::markdown::{Table, code, inline};
use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::list::describe;
use crate::{linkage, motion};

/// What each scene shows, what it does, how large it is, and the command that runs it.
///
/// # Errors
/// When the mechanism refuses its own values.
pub fn table(mechanism: &'static Mechanism) -> Result<String, Failure> {
    let columns = ["scene", "what it shows", "task", "states", "loops", "command"];
    let mut table = Table::new(&columns, &["states", "loops"]);
    for scene in mechanism.scenes {
        let count = |count: usize| if count == 0 { "-".to_owned() } else { count.to_string() };
        table.row(vec![
            code(scene.name),
            inline(&shown(mechanism, scene)),
            inline(&task(mechanism, scene)?),
            count(scene.states.len()),
            count(loops(scene)),
            code(&format!("assur run {} --scene {}", mechanism.name, scene.name)),
        ]);
    }
    Ok(table.render())
}

/// What a scene shows, or what is in it; of a mechanism without effects and choices not that it has none.
fn shown(mechanism: &Mechanism, scene: &SceneEntry) -> String {
    if !scene.summary.is_empty() {
        return scene.summary.split("\n\n").next().unwrap_or_default().to_owned();
    }
    let description = describe(scene);
    let is_plain = mechanism.effects.is_empty() && mechanism.choices.is_empty();
    let rest = description.strip_prefix("no effect").filter(|_| is_plain);
    rest.map_or(description.as_str(), |rest| rest.trim_start_matches([',', ' '])).to_owned()
}

/// What a scene does, in words.
fn task(mechanism: &'static Mechanism, scene: &'static SceneEntry) -> Result<String, Failure> {
    let constants = Constants::declared(mechanism, scene);
    Ok(match scene.linkage {
        Some(_) => linkage::case::Case::new(constants)?.task_in_words(),
        None => motion::case::Case::new(constants)?.task_in_words(),
    })
}

/// The number of scalar loop equations.
fn loops(scene: &SceneEntry) -> usize {
    let closed = scene.linkage.or(scene.reduced).map_or(0, |entry| entry.loops.len());
    let held = scene.augmented.map_or(0, |held| held.loops.len());
    closed + held
}
