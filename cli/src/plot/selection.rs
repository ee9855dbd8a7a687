//! Which curves a figure shows: those that matter most unless others are asked for.

use assur::closure::Variable as By;
use assur::registry::SceneEntry;
use assur::shape::Quantity;

use crate::ask::lookup::suggestion;
use crate::ask::variables;
use crate::error::Failure;

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
            None => [variables::of_scene(scene), variables::energies().to_vec()].concat(),
        };
        let known: Vec<_> = variables.iter().map(|variable| variable.name.as_str()).collect();
        let coefficients = coefficients(scene);
        let known: Vec<_> =
            known.into_iter().chain(coefficients.iter().map(String::as_str)).collect();
        let named = names(text);
        if let Some(unknown) = named.iter().find(|name| !known.contains(&name.as_str())) {
            return Err(Failure::request(format!(
                "scene `{}` has no curve `{unknown}`",
                scene.name
            ))
            .place(format!("--curves {text}"))
            .remedy(format!("{}\n--curves all draws all of them", suggestion(unknown, &known))));
        }
        Ok(Self::Named(named))
    }

    /// Whether a variable is asked for by its name.
    pub fn names(&self, name: &str) -> bool {
        matches!(self, Self::Named(_)) && self.admits(name)
    }

    /// Whether a variable is wanted, as far as its name decides.
    pub fn admits(&self, name: &str) -> bool {
        match self {
            Self::Usual | Self::All => true,
            Self::Named(names) => names.iter().any(|wanted| wanted == name),
        }
    }
}

/// Names of the coefficients of a linkage, `diff(phi7, l5)`.
fn coefficients(scene: &SceneEntry) -> Vec<String> {
    let Some(entry) = &scene.linkage else {
        return Vec::new();
    };
    let by = entry.variables.iter().map(|one| match one {
        By::Constant(index) => scene.constants[*index].quantity.name,
        By::Driver(index) => scene.drivers[*index].name,
    });
    let of = |output: &Quantity| {
        let names = by.clone().map(|by| format!("diff({}, {by})", output.name));
        names.collect::<Vec<_>>()
    };
    scene.outputs.iter().flat_map(of).collect()
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
        assert_eq!(names("phi2, dot(x3),inner(u, v)"), ["phi2", "dot(x3)", "inner(u, v)"]);
        assert_eq!(names(""), [""]);
    }
}
