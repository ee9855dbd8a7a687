//! The mechanism as data: `MECHANISM`, and how a scene is bound to values without knowing its type.

use assur_model::checked::Model;
use proc_macro2::TokenStream;
use quote::quote;

use crate::expression::number;
use crate::layout::Layout;
use crate::{Origin, docs, names, scene};

/// The static `MECHANISM` and the functions that its entries point to.
pub fn table(model: &Model, layouts: &[Layout<'_>], origin: &Origin<'_>) -> TokenStream {
    let (name, title) = (names::snake(&model.name), &model.name);
    let (summary, source, file) = (&model.documentation, &model.source, &origin.file);
    let (file, text, parts) = match origin.has_file {
        true => (quote!(#file), quote!(::core::include_str!(#file)), origin.parts.as_slice()),
        false => (quote!(""), quote!(""), [].as_slice()),
    };
    let effects = model.effects.iter().map(|effect| {
        let (name, summary) = (&effect.name, &effect.summary);
        quote!(::assur::registry::Named { name: #name, summary: #summary })
    });
    let choices = model.choices.iter().map(|choice| {
        let (name, summary, alternatives) = (&choice.name, &choice.summary, &choice.alternatives);
        quote!(::assur::registry::Choice { name: #name, summary: #summary, alternatives: &[#(#alternatives),*] })
    });
    let presets = model.presets.iter().map(|preset| {
        let (name, summary) = (&preset.name, &preset.summary);
        let values = preset.values.iter().map(|(name, value)| {
            let value = number(*value);
            quote!((#name, #value))
        });
        quote!(::assur::registry::Preset { name: #name, summary: #summary, values: &[#(#values),*] })
    });
    let entries = layouts.iter().filter(|layout| !layout.is_unreduced).map(|layout| {
        let name = scene::unreduced(&layout.parameters);
        entry(layout, layouts.iter().find(|other| other.parameters == name))
    });
    let lines = docs::lines(&format!("The mechanism `{title}` as data."));
    quote! {
        #lines
        pub static MECHANISM: ::assur::registry::Mechanism = ::assur::registry::Mechanism {
            name: #name,
            title: #title,
            summary: #summary,
            source: #source,
            file: #file,
            text: #text,
            parts: &[#((#parts, ::core::include_str!(#parts))),*],
            effects: &[#(#effects),*],
            choices: &[#(#choices),*],
            presets: &[#(#presets),*],
            scenes: &[#(#entries),*],
        };
    }
}

/// A scene, and what goes on where it comes to a dead point.
fn entry(layout: &Layout<'_>, unreduced: Option<&Layout<'_>>) -> TokenStream {
    let type_name = &layout.parameters;
    let (kind, bind) = match &layout.scene.linkage {
        Some(_) => (quote!(Linkage), quote!(bind_linkage)),
        None => (quote!(Motion), quote!(bind)),
    };
    let unreduced = match unreduced.map(|layout| entry(layout, None)) {
        Some(entry) => quote!(::core::option::Option::Some(&#entry)),
        None => quote!(::core::option::Option::None),
    };
    quote! {
        ::assur::registry::SceneEntry {
            shape: &shapes_::#type_name,
            bind: ::assur::registry::Bind::#kind(&|values| {
                ::assur::registry::#bind(::assur::registry::with(values, #type_name::from_values)?)
            }),
            unreduced: #unreduced,
        }
    }
}
