//! What is asked of surfaces, checked.

use assur::registry::{Mechanism, SceneEntry};

use super::patch::{Output, surfaces};
use crate::arguments::DrawArguments;
use crate::ask::constants::Constants;
use crate::error::Failure;

/// Whether a scene is to be drawn as a surface: it is if it has no points, or if that is asked for.
///
/// # Errors
/// An option for surfaces where none is meant.
pub fn is_meant(options: &DrawArguments, scene: &'static SceneEntry) -> Result<bool, Failure> {
    if scene.points.is_empty() || options.surface.surface.is_some() {
        return Ok(true);
    }
    match options.surface.given() {
        None => Ok(false),
        Some(option) => Err(Failure::request(format!("{option} is for surfaces"))
            .reason(format!("scene `{}` has points, which are drawn", scene.name))
            .remedy(match surfaces(scene).first() {
                Some(output) => format!("add --surface {}", output.name),
                None => "leave it out".to_owned(),
            })),
    }
}

/// That there is nothing to draw of a scene.
pub fn nothing(mechanism: &'static Mechanism, scene: &SceneEntry) -> Failure {
    let drawn =
        mechanism.scenes.iter().filter(|one| super::is_surface(one) || !one.points.is_empty());
    let drawn: Vec<_> = drawn.map(|one| one.name).collect();
    let points = "state points in the equation file: point A = [0, 0]; link A - B \"crank\";";
    Failure::request(format!("scene `{}` has no points and is no surface", scene.name))
        .reason(
            "a surface is a vector of three lengths, an output of a scene that sweeps two values",
        )
        .remedy(match &drawn[..] {
            [] => points.to_owned(),
            names => format!("choose one: --scene {}; or {points}", names.join(", --scene ")),
        })
}

/// What a surface has no use for, and scenes that are not drawn.
pub fn check(options: &DrawArguments, scenes: &[Constants]) -> Result<(), Failure> {
    let others = [
        ("--at", !options.at.is_empty()),
        ("--forces", options.forces),
        ("--vibration", options.vibration.is_some()),
    ];
    if let Some((option, _)) = others.iter().find(|(_, is_given)| *is_given) {
        return Err(Failure::request(format!("a surface takes no {option}")).remedy("leave it out"));
    }
    let names: Vec<_> = scenes.iter().map(|one| one.scene.name).collect();
    if let Some(twice) = (1..names.len()).find(|&index| names[..index].contains(&names[index])) {
        return Err(Failure::request(format!("scene `{}` is given twice", names[twice]))
            .place(format!("--scene {}", names.join(",")))
            .remedy("leave one of them out"));
    }
    match options.surface.flip.iter().find(|scene| !names.contains(&scene.as_str())) {
        None => Ok(()),
        Some(other) => Err(Failure::request(format!("scene `{other}` is not drawn"))
            .place(format!("--flip {}", options.surface.flip.join(",")))
            .remedy(format!("choose from {}", names.join(", ")))),
    }
}

/// The output that is drawn of each scene: the one of this name, or the only one that all of them have.
///
/// # Errors
/// When a scene does not have it, or there are several.
pub fn outputs(wanted: Option<&str>, scenes: &[Constants]) -> Result<Vec<Output>, Failure> {
    let found: Vec<_> = scenes.iter().map(|one| surfaces(one.scene)).collect();
    let in_all = |name: &str| {
        let of = |outputs: &Vec<Output>| outputs.iter().find(|one| one.name == name).copied();
        found.iter().map(of).collect::<Option<Vec<_>>>()
    };
    let first = found.iter().take(1).flatten().map(|one| one.name);
    let common: Vec<_> = first.filter(|name| in_all(name).is_some()).collect();
    let chosen = match (wanted, &common[..]) {
        (Some(name), _) => in_all(name),
        (None, [only]) => in_all(only),
        (None, _) => None,
    };
    chosen.ok_or_else(|| {
        let each = scenes.iter().zip(&found).map(|(one, outputs)| {
            let names: Vec<_> = outputs.iter().map(|output| output.name).collect();
            format!("{}: {}", one.scene.name, if names.is_empty() { "none".to_owned() } else { names.join(", ") })
        });
        let failure = match wanted {
            Some(name) => Failure::request(format!("`{name}` is no surface of these scenes"))
                .place(format!("--surface {name}")),
            None if common.is_empty() => Failure::request("the scenes have no surface in common"),
            None => Failure::request("there are several surfaces to draw"),
        };
        let failure = failure.reason(each.collect::<Vec<_>>().join("\n"));
        match &common[..] {
            [] => failure.remedy("draw scenes that have one in common: a vector of three lengths over two swept values"),
            names => failure.remedy(format!("choose one: --surface {}", names.join(", --surface "))),
        }
    })
}
