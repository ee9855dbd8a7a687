//! Which curves a figure shows: those that matter most unless others are asked for.

use assur::registry::SceneEntry;

use crate::error::Failure;
use crate::lookup::suggestion;
use crate::variables;

/// Which curves a figure shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// The panels that matter most.
    #[default]
    Usual,
    /// All curves.
    All,
    /// The curves of these variables.
    Named(Vec<String>),
}

impl Selection {
    /// Reads `--curves`.
    ///
    /// # Errors
    /// A name that the scene does not have; the nearest one is offered.
    pub fn read(scene: &SceneEntry, text: Option<&str>) -> Result<Self, Failure> {
        let Some(text) = text else {
            return Ok(Self::Usual);
        };
        if text.trim() == "all" {
            return Ok(Self::All);
        }
        let variables = match &scene.linkage {
            Some(entry) => variables::of_linkage(scene, entry),
            None => variables::of_scene(scene),
        };
        let known: Vec<_> = variables
            .iter()
            .map(|variable| variable.name.as_str())
            .collect();
        let named = names(text);
        if let Some(unknown) = named.iter().find(|name| !known.contains(&name.as_str())) {
            return Err(Failure::request(format!(
                "scene `{}` has no curve `{unknown}`",
                scene.name
            ))
            .place(format!("--curves {text}"))
            .remedy(format!(
                "{}\n--curves all draws all of them",
                suggestion(unknown, &known)
            )));
        }
        Ok(Self::Named(named))
    }

    /// Whether a variable is wanted, as far as its name decides.
    pub fn admits(&self, name: &str) -> bool {
        match self {
            Self::Usual | Self::All => true,
            Self::Named(names) => names.iter().any(|wanted| wanted == name),
        }
    }
}

/// The names between commas; those inside brackets belong to a name.
fn names(text: &str) -> Vec<String> {
    let mut depth = 0_usize;
    let parts = text.split(|character| {
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        character == ',' && depth == 0
    });
    parts.map(|part| part.trim().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_inside_brackets_belong_to_a_name() {
        assert_eq!(
            names("phi2, dot(x3),inner(u, v)"),
            ["phi2", "dot(x3)", "inner(u, v)"]
        );
        assert_eq!(names(""), [""]);
    }
}
