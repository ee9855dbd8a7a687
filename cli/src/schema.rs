//! `assur schema`: what the answers in JSON are made of, as JSON Schema.

use clap::{Args, ValueEnum};

use crate::error::Failure;
use crate::show::output;

/// Options of `assur schema`.
#[derive(Args, Debug)]
pub struct SchemaArguments {
    /// Whose answer.
    #[arg(value_enum, default_value_t = Of::Run)]
    of: Of,
}

/// The commands that answer in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Of {
    Run,
    Structure,
    Modes,
    Study,
    Attractors,
    Cost,
    Resonances,
    Sensitivity,
    Synth,
    Tolerance,
}

impl Of {
    const fn text(self) -> &'static str {
        match self {
            Self::Run => include_str!("../schema/run.json"),
            Self::Structure => include_str!("../schema/structure.json"),
            Self::Modes => include_str!("../schema/modes.json"),
            Self::Study => include_str!("../schema/study.json"),
            Self::Attractors => include_str!("../schema/attractors.json"),
            Self::Cost => include_str!("../schema/cost.json"),
            Self::Resonances => include_str!("../schema/resonances.json"),
            Self::Sensitivity => include_str!("../schema/sensitivity.json"),
            Self::Synth => include_str!("../schema/synth.json"),
            Self::Tolerance => include_str!("../schema/tolerance.json"),
        }
    }
}

/// Prints a schema.
///
/// # Errors
/// When standard output cannot be written.
pub fn execute(options: &SchemaArguments) -> Result<(), Failure> {
    output::print(options.of.text())
}

#[cfg(test)]
mod tests {
    use super::Of;
    use crate::{cost, modes, run, structure, study, synth, tolerance};
    use schemars::{JsonSchema, schema_for};
    use serde_json::Value;

    /// Compares a file with what follows from the types, and says whether it is the same; `ASSUR_BLESS=1` writes it.
    fn check<T: JsonSchema>(of: Of, name: &str) -> bool {
        let found = serde_json::to_value(schema_for!(T)).expect("texts as keys");
        if std::env::var_os("ASSUR_BLESS").is_some() {
            let path = format!("{}/schema/{name}.json", env!("CARGO_MANIFEST_DIR"));
            std::fs::write(path, text(&found)).expect("the folder is writable");
        }
        serde_json::from_str::<Value>(of.text()).is_ok_and(|known| known == found)
    }

    /// A schema with a line for each property and each definition.
    fn text(schema: &Value) -> String {
        let long = |key: &str| matches!(key, "properties" | "$defs");
        let fields = schema.as_object().expect("an object").iter().map(|(key, value)| {
            let value = match value.as_object().filter(|_| long(key)) {
                Some(object) => {
                    let lines = object.iter().map(|(key, value)| format!("    \"{key}\": {value}"));
                    format!("{{\n{}\n  }}", lines.collect::<Vec<_>>().join(",\n"))
                }
                None => value.to_string(),
            };
            format!("  \"{key}\": {value}")
        });
        format!("{{\n{}\n}}\n", fields.collect::<Vec<_>>().join(",\n"))
    }

    #[test]
    fn the_schemas_are_those_of_the_types() {
        let same = [
            check::<run::Run>(Of::Run, "run"),
            check::<structure::Object>(Of::Structure, "structure"),
            check::<modes::Object>(Of::Modes, "modes"),
            check::<study::Object>(Of::Study, "study"),
            check::<study::AttractorsObject>(Of::Attractors, "attractors"),
            check::<cost::Object>(Of::Cost, "cost"),
            check::<study::ResonancesObject>(Of::Resonances, "resonances"),
            check::<study::SensitivityObject>(Of::Sensitivity, "sensitivity"),
            check::<synth::Object>(Of::Synth, "synth"),
            check::<tolerance::Object>(Of::Tolerance, "tolerance"),
        ];
        assert_eq!(same, [true; 10], "ASSUR_BLESS=1 writes schema/ anew");
    }
}
