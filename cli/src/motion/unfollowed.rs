//! Why a motion through modes ended early, in words and with the names of its modes and events.

use assur::hybrid::{CycleError, HybridError};
use assur::model::Model;
use assur::ode::OdeError;
use assur::periodic::PeriodicError;
use assur::registry::SceneEntry;
use assur::rest::RestError;
use assur::scalar::fault;

use super::unclosed;
use crate::error::Told;

/// Of a motion that could not be followed to its end.
pub fn tell(scene: &SceneEntry, run: &dyn Model, error: &HybridError) -> Told {
    unclosed::tell(scene, run, error.motion()).unwrap_or_else(|| of_motion(scene, error))
}

fn of_motion(scene: &SceneEntry, error: &HybridError) -> Told {
    match error {
        HybridError::Ode { error, mode, .. } => ended(scene, error, *mode),
        HybridError::Loop { time, modes, turns, .. } => Told::new(
            format!(
                "at time = {time} s events lead from mode to mode without end ({turns} were followed): {}",
                listed(scene, modes)
            ),
            "let one of them ask for more with `if`, or set what keeps the others from happening at once",
        ),
        HybridError::Chatter { time, since, events, modes, .. } => Told::new(
            format!(
                "{events} events between time = {since} s and {time} s, ever sooner after each other{}",
                match listed(scene, modes) {
                    none if none.is_empty() => String::new(),
                    modes => format!(", modes {modes}"),
                }
            ),
            "a mode in which the parts stay together would take their place, reached `if` a speed is small enough",
        ),
        HybridError::Held { time, mode, event, .. } => Told::new(
            format!(
                "at time = {time} s the motion is driven from both sides onto the place where {}, so that it stays there",
                event_text(scene, *mode, *event).unwrap_or("a branch changes")
            ),
            "state what holds there as a mode, with `hold`",
        ),
        HybridError::Guard { time, mode, event, .. } => Told::new(
            format!(
                "after time = {time} s what `{}` watches{} is not a number: a root of something negative, or a division by zero",
                event_text(scene, *mode, *event).unwrap_or("an event"),
                within(scene, *mode)
            ),
            "check the values given with --set; else keep what the event watches defined, with `max` for instance",
        ),
        HybridError::Lost { time, mode, event, .. } => Told::new(
            format!(
                "at time = {time} s {}{}, and nothing says how the motion goes on",
                event_text(scene, *mode, *event).unwrap_or("an event ends the motion"),
                within(scene, *mode)
            ),
            "end the run before; of a loop choose another coordinate as the independent one; of an event of the file check what it sets",
        ),
        HybridError::Turns { time, mode, turned, .. } => Told::new(
            format!(
                "after time = {time} s an angle that events depend on turns by {turned:.3e} rad within one step{}, too often to look \
                 for events",
                within(scene, *mode)
            ),
            "check the speeds that are given with --set; else take a shorter time",
        ),
        HybridError::Start { reason } => Told::new(reason.clone(), "check the start values"),
        other => Told::new(other.to_string(), "check the values given with --set"),
    }
}

/// Of a motion that was to repeat.
pub fn tell_cycle(scene: &SceneEntry, run: &dyn Model, error: &CycleError) -> Told {
    let motion = match error {
        CycleError::Motion(inner) => inner.motion(),
        _ => None,
    };
    unclosed::tell(scene, run, motion).unwrap_or_else(|| of_cycle(scene, error))
}

/// Of a motion without events that was to repeat.
pub fn tell_periodic(scene: &SceneEntry, run: &dyn Model, error: &PeriodicError) -> Told {
    const AWAY: &str = "near a resonance move the speed a little, or choose a scene with damping; else try a smaller --rtol";
    unclosed::tell(scene, run, None).unwrap_or_else(|| Told::new(error.to_string(), AWAY))
}

/// Of what was to rest.
pub fn tell_rest(scene: &SceneEntry, run: &dyn Model, error: &RestError) -> Told {
    let remedy = match error {
        RestError::Unbalanced { .. } => {
            "give it a spring, a stop, or a weight that pulls back; or let the scene `run`"
        }
        RestError::Beyond { is_lost: false, .. } => {
            "begin in the mode that follows, or with other start values"
        }
        RestError::Sticks { .. } => {
            "give what sticks a mode in which it stands still, or a law that is smooth about zero"
        }
        _ => "let the scene `start` nearer to where it may rest, or change a value with --set",
    };
    let open = if error.is_lost() { unclosed::tell(scene, run, None) } else { None };
    open.unwrap_or_else(|| Told::new(error.to_string(), remedy))
}

fn of_cycle(scene: &SceneEntry, error: &CycleError) -> Told {
    const NEARBY: &str = "change a value with --set a little; else try another --rtol";
    match error {
        CycleError::Motion(inner) => of_motion(scene, inner),
        CycleError::Grazing { time, mode, event } => Told::new(
            format!(
                "at time = {time} s `{}` is touched{} and not passed, so that the motion does not depend smoothly on where it begins",
                event_text(scene, *mode, *event).unwrap_or("an event"),
                within(scene, *mode)
            ),
            NEARBY,
        ),
        CycleError::NoneStable { .. } => Told::new(
            error.to_string(),
            "look at the motion itself with a scene that says `run`, or change a value in small steps from where it repeats",
        ),
        _ => Told::new(error.to_string(), NEARBY),
    }
}

/// An integration that ended early.
fn ended(scene: &SceneEntry, error: &OdeError, mode: usize) -> Told {
    let place = match within(scene, mode).trim_start() {
        "" => String::new(),
        place => format!("{place}: "),
    };
    // What is looked for and not found says more than that a rate is no number.
    let fault = matches!(error, OdeError::NotFinite { .. }).then(fault::take).flatten();
    let reason = match (fault, error.time()) {
        (Some(fault), Some(time)) => format!("after t = {time} s {fault}"),
        _ => error.to_string(),
    };
    Told::new(
        format!("{place}{reason}"),
        "check the values given with --set; else try another --method or --rtol",
    )
}

/// Where something happens, ` in mode stick`; nothing where the mode has no name.
fn within(scene: &SceneEntry, mode: usize) -> String {
    match name(scene, mode) {
        "" => String::new(),
        name => format!(" in mode {name}"),
    }
}

fn name(scene: &SceneEntry, mode: usize) -> &'static str {
    scene.modes.get(mode).map_or("", |mode| mode.name)
}

/// The statement of an event.
fn event_text(scene: &SceneEntry, mode: usize, event: usize) -> Option<&'static str> {
    let entry = scene.modes.get(mode)?.events.get(event)?;
    Some(entry.text)
}

fn listed(scene: &SceneEntry, modes: &[usize]) -> String {
    let names = modes.iter().map(|mode| name(scene, *mode)).filter(|name| !name.is_empty());
    names.collect::<Vec<_>>().join(" -> ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ask::lookup;
    use assur_equations::REGISTRY;

    fn scene() -> &'static SceneEntry {
        let mechanism = REGISTRY.iter().find(|one| one.name == "table_drive");
        let scene = lookup::scene(mechanism.expect("it comes with Assur"), Some("loose"));
        scene.unwrap_or_else(|_| panic!("a scene with modes"))
    }

    #[test]
    fn modes_and_events_have_their_names() {
        let names = scene().modes.iter().map(|mode| mode.name);
        let wind = names.clone().position(|name| name == "wind").expect("wind");
        let told = ended(scene(), &OdeError::NotFinite { time: 0.0, component: 0 }, wind);
        assert!(told.reason.starts_with("in mode wind: "), "{told:?}");
        let touched = CycleError::Grazing { time: 0.5, mode: wind, event: 0 };
        let told = of_cycle(scene(), &touched);
        let statement = scene().modes[wind].events[0].text;
        let words = format!("at time = 0.5 s `{statement}` is touched in mode wind");
        assert!(told.reason.starts_with(&words), "{told:?}");
        assert_eq!(listed(scene(), &[wind, wind]), "wind -> wind");
    }
}
