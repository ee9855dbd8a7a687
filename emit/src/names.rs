//! Locals of emitted things. What the file names keeps its name; what the printer adds ends in `_`, which no name of a
//! file may.

use std::collections::BTreeSet;

use assur_model::checked::SceneModel;
use assur_model::program::{Function, Input, OperationKind, Value};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};

/// Words that have to be written `r#word` to be names.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let",
    "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return",
    "static", "struct", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use",
    "virtual", "where", "while", "yield",
];

/// Words that Rust allows as names in no spelling.
const IMPOSSIBLE: &[&str] = &["self", "Self", "super", "crate", "_"];

/// Local names that the emitted functions use themselves, and items that a `let` cannot shadow.
const RESERVED: &[&str] = &[
    "time",
    "times",
    "phase",
    "state",
    "rate",
    "rates",
    "rows",
    "event",
    "after",
    "slopes",
    "found",
    "length",
    "columns",
    "products",
    "values",
    "instant",
    "instants",
    "independents",
    "motion",
    "position",
    "mode",
    "group",
    "residual",
    "jacobian",
    "MECHANISM",
    "REGISTRY",
    "Some",
    "None",
    "Ok",
    "Err",
];

/// An identifier as close to a name as Rust allows: `l[3]` becomes `l_3`, `dot(x)` becomes `dot_x`, `loop` `r#loop`.
pub fn identifier(name: &str) -> Ident {
    let plain = plain(name);
    if KEYWORDS.contains(&plain.as_str()) {
        Ident::new_raw(&plain, Span::call_site())
    } else {
        Ident::new(&plain, Span::call_site())
    }
}

/// Letters, digits and single underscores; always a word that `Ident::new` takes.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for character in name.chars() {
        let good = character.is_ascii_alphanumeric()
            || (!character.is_ascii() && !character.is_whitespace());
        match good {
            true => plain.push(character),
            false if plain.ends_with('_') || plain.is_empty() => {}
            false => plain.push('_'),
        }
    }
    // An underscore at the end marks a name of the printer's own; those come in here as they are.
    if !name.ends_with('_') {
        plain.truncate(plain.trim_end_matches('_').len());
    }
    if IMPOSSIBLE.contains(&plain.as_str()) || !is_word(&plain) {
        plain =
            format!("v{}_", plain.chars().filter(char::is_ascii_alphanumeric).collect::<String>());
    }
    plain
}

fn is_word(text: &str) -> bool {
    let Ok(stream) = text.parse::<TokenStream>() else {
        return false;
    };
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    matches!(tokens.as_slice(), [TokenTree::Ident(_)])
}

/// `dot(phi)` as `DOT_PHI`: the name of a constant.
pub fn loud(name: &str) -> String {
    plain(name).to_uppercase()
}

/// `two_term` as `TwoTerm`: the name of a type.
pub fn pascal(name: &str) -> String {
    let mut text = String::new();
    for word in plain(name).split('_') {
        let mut letters = word.chars();
        text.extend(letters.next().into_iter().flat_map(char::to_uppercase));
        text.extend(letters);
    }
    text
}

/// `SpringPendulum` as `spring_pendulum`: the name of a module or function.
pub fn snake(name: &str) -> String {
    let mut text = String::new();
    let mut lower_before = false;
    for character in plain(name).chars() {
        if character.is_uppercase() && lower_before {
            text.push('_');
        }
        lower_before = character.is_lowercase() || character.is_ascii_digit();
        text.extend(character.to_lowercase());
    }
    text
}

/// Identifiers that are all different, made in the order of a list.
pub fn distinct<'a>(names: impl IntoIterator<Item = &'a str>) -> Vec<Ident> {
    let mut taken = BTreeSet::new();
    names
        .into_iter()
        .enumerate()
        .map(|(index, name)| free(plain(name), index, &mut taken))
        .collect()
}

/// What the types of the modes of a scene are called behind the name of the scene: `InWind`.
pub fn mode_types(scene: &SceneModel) -> Vec<String> {
    let modes = scene.modes.iter().map(|mode| match mode.name.as_str() {
        "" => "InMotion".to_string(),
        name => format!("In{}", pascal(name)),
    });
    distinct_types(modes)
}

/// Type names that are all different, made in the order of a list: with `Equations` and `Instant` behind them as well.
pub fn distinct_types(names: impl IntoIterator<Item = String>) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let ends = ["", "Equations", "Instant"];
    let mut all = Vec::new();
    for mut name in names {
        while ends.iter().any(|end| taken.contains(&format!("{name}{end}"))) {
            name.push('_');
        }
        taken.extend(ends.iter().map(|end| format!("{name}{end}")));
        all.push(name);
    }
    all
}

/// The name if it is free, else the name with its index.
fn free(name: String, index: usize, taken: &mut BTreeSet<String>) -> Ident {
    if taken.insert(name.clone()) {
        return identifier(&name);
    }
    let mut other = format!("{}_{index}_", name.trim_end_matches('_'));
    while !taken.insert(other.clone()) {
        other.push('_');
    }
    identifier(&other)
}

/// The local name of each value of a program.
pub struct Locals {
    of: Vec<Ident>,
}

impl Locals {
    /// Locals the values of a scene.
    pub fn new(scene: &SceneModel) -> Self {
        let mut taken: BTreeSet<String> = RESERVED.iter().map(|name| (*name).to_owned()).collect();
        let mut of: Vec<Ident> = Vec::new();
        for (index, operation) in scene.program.operations.iter().enumerate() {
            let wished = match (&operation.kind, &operation.name) {
                (OperationKind::Input(input), _) => input_name(scene, *input),
                (_, Some(name)) => Some(plain(name)),
                (OperationKind::Call(function @ (Function::Sin | Function::Cos), angle), None) => {
                    angle
                        .first()
                        .and_then(|angle| of.get(angle.0 as usize))
                        .map(|angle| trigonometric_name(*function, angle))
                }
                _ => result_name(scene, Value(index as u32)),
            };
            of.push(free(wished.unwrap_or_else(|| format!("v{index}_")), index, &mut taken));
        }
        Self { of }
    }

    /// The name of a value.
    pub fn of(&self, value: Value) -> &Ident {
        &self.of[value.0 as usize]
    }
}

fn input_name(scene: &SceneModel, input: Input) -> Option<String> {
    let quantity = match input {
        Input::Parameter(index) => {
            scene.constants.get(index as usize).map(|constant| &constant.quantity)
        }
        Input::State(index) => scene.states.get(index as usize),
        Input::Time => return Some("time_".to_owned()),
        Input::Driver(index) => return driver_name(scene, index as usize),
        Input::Position(place) => return position_name(scene, place as usize),
        Input::Mode(group) => return Some(format!("mode_{group}_")),
        Input::Measured(index) => return Some(format!("found_{index}_")),
        Input::Side(surface) => return Some(format!("side_{surface}_")),
        Input::Change(index) => return Some(format!("change_{index}_")),
        Input::Captured(_) | Input::Place => return None,
    };
    quantity.map(|quantity| plain(&quantity.name))
}

/// The name of what a linkage is given, without what makes it the printer's.
pub fn given(scene: &SceneModel, input: Input) -> Option<String> {
    input_name(scene, input).map(|name| name.trim_end_matches('_').to_owned())
}

/// `beta`, `beta_rate_`, `beta_acceleration_`
fn driver_name(scene: &SceneModel, index: usize) -> Option<String> {
    let count = scene.drivers.len().max(1);
    let name = plain(&scene.drivers.get(index % count)?.name);
    Some(match index / count {
        0 => name,
        1 => format!("{name}_rate_"),
        _ => format!("{name}_acceleration_"),
    })
}

/// `phi5`, `cos_phi5_`, `sin_phi5_`
fn position_name(scene: &SceneModel, place: usize) -> Option<String> {
    let dependents = &scene.linkage.as_ref()?.dependents;
    if let Some(one) = dependents.get(place) {
        return Some(plain(&one.quantity.name));
    }
    let cosines = &scene.program.results.closing.cosines;
    let index =
        cosines.iter().position(|one| one.is_some_and(|one| place == one || place == one + 1))?;
    let function = if cosines[index] == Some(place) { "cos" } else { "sin" };
    Some(format!("{function}_{}_", plain(&dependents[index].quantity.name)))
}

fn trigonometric_name(function: Function, angle: &Ident) -> String {
    let angle = bare(angle);
    let prefix = if function == Function::Sin { "sin" } else { "cos" };
    format!("{prefix}_{angle}_")
}

/// A name without what makes it one of Rust's or of the printer's: `type` for `r#type`, `v3` for `v3_`.
pub fn bare(name: &Ident) -> String {
    let name = name.to_string();
    name.trim_start_matches("r#").trim_end_matches('_').to_owned()
}

/// The name of a driver or output, `slope_2_0_` for an entry of the Jacobian, `rate_2_` for a derivative.
fn result_name(scene: &SceneModel, value: Value) -> Option<String> {
    let results = &scene.program.results;
    let drivers = results.drivers.iter().zip(&scene.drivers);
    let outputs = results.outputs.iter().zip(&scene.outputs);
    if let Some((_, quantity)) = drivers.chain(outputs).find(|(entry, _)| **entry == value) {
        return Some(plain(&quantity.name));
    }
    if let Some(index) = results.derivative.iter().position(|entry| *entry == value) {
        return Some(format!("rate_{index}_"));
    }
    let entry = results.jacobian.iter().find(|entry| entry.2 == value)?;
    Some(format!("slope_{}_{}_", entry.0, entry.1))
}
