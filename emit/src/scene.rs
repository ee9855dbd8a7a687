//! What is emitted for one scene, and how its types are called.

use assur_model::checked::Model;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::layout::Layout;
use crate::{Origin, closure, equations, modes, names, outputs, parameters};

/// Locals of the types of the scenes: `TwoTerm` for `two_term`; the only scene of a mechanism that states none has the
/// name of the mechanism.
pub fn type_names(model: &Model) -> Vec<String> {
    if let [only] = model.scenes.as_slice()
        && only.name == "standard"
    {
        return vec![names::pascal(&model.name)];
    }
    names::distinct_types(model.scenes.iter().map(|scene| names::pascal(&scene.name)))
}

/// The name of the mechanism as another name of its first scene, unless a scene has that name.
pub fn alias(model: &Model, types: &[String]) -> Option<(Ident, Ident)> {
    let name = names::pascal(&model.name);
    let first = types.first()?;
    (!types.contains(&name)).then(|| (names::identifier(&name), names::identifier(first)))
}

/// The name of the type of a scene with all positions as coordinates.
pub fn unreduced(name: &Ident) -> Ident {
    format_ident!("{name}Unreduced")
}

/// Locals of the public types of all scenes.
pub fn exported<'a>(layouts: &'a [Layout<'_>]) -> impl Iterator<Item = TokenStream> + use<'a> {
    layouts.iter().filter(|layout| !layout.is_unreduced).map(|layout| {
        let (parameters, equations) = (&layout.parameters, &layout.equations);
        quote!(#parameters, #equations)
    })
}

/// The items of a scene.
pub fn items(layout: &Layout<'_>, model: &Model, origin: &Origin<'_>) -> TokenStream {
    let parameters = parameters::items(layout, model, origin);
    if let Some(linkage) = &layout.scene.linkage {
        let closure = closure::items(layout, linkage);
        return quote!(#parameters #closure);
    }
    let (equations, reports) = (equations::items(layout), outputs::items(layout));
    let events = modes::items(layout);
    quote!(#parameters #equations #reports #events)
}
