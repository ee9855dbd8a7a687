//! Which constants a mode has, and their values.

use super::declare::Declared;
use super::{Here, Mode};
use crate::checked::SceneModel;
use crate::expression::Symbol;
use crate::facts;
use crate::lower::Lowering;
use crate::program::{Input, Request};

/// The values that a scene starts from.
pub struct Chosen {
    /// Name of the preset; empty for the declared defaults.
    pub preset: String,
    /// Values of all constants of the file.
    pub values: Vec<f64>,
}

/// Values of all constants: those of the scene's preset, else the declared ones.
pub fn values(here: Here<'_>, declared: &Declared, low: &mut Lowering<'_>) -> Chosen {
    let preset = here.scene().and_then(|scene| facts::preset(low, here.task.file, scene));
    let (preset, given) = preset.unwrap_or_default();
    let constants = low.names.constants.iter().zip(&declared.constants);
    let value = |name: &str| given.iter().find(|(own, _)| own == name).map(|one| one.1);
    let values = constants.map(|(declared, info)| {
        let default = info.as_ref().map_or(f64::NAN, |info| info.default);
        value(&declared.name.text).unwrap_or(default)
    });
    Chosen { preset, values: values.collect() }
}

/// Makes inputs of the constants that anything in the program depends on, and describes them. Gives their indices.
pub fn constants(
    mode: &Mode<'_>,
    chosen: &Chosen,
    model: &mut SceneModel,
    request: &mut Request,
    low: &Lowering<'_>,
) -> Vec<usize> {
    let symbols = request.needed(&low.graph);
    let given = mode.here.constants;
    let depends = |index: &usize| {
        given.contains(index) || symbols.contains(&Symbol::Parameter(*index as u32))
    };
    let kept: Vec<usize> = (0..chosen.values.len()).filter(depends).collect();
    for (new, old) in kept.iter().enumerate() {
        let symbol = Symbol::Parameter(*old as u32);
        request.inputs.insert(symbol, Input::Parameter(new as u32));
        let info = mode.declared.constants[*old].clone();
        model.constants.extend(info.map(|mut info| {
            info.default = chosen.values[*old];
            info
        }));
    }
    request.parameters = kept.len();
    model.preset.clone_from(&chosen.preset);
    for requirement in &mut model.requirements {
        let names = requirement.names.iter();
        let places = names.filter_map(|old| kept.iter().position(|one| one == old));
        requirement.names = places.collect();
    }
    kept
}
