//! The printer of Assur: a checked model as Rust items.
//!
//! It knows only the model and proc-macro2, so that the macros and the command print the same text, and it does no
//! analysis: what is stored, in which order operations are done and which of them have series is said by
//! [`assur_model::program`]. [`mechanism`] prints everything. The order is that of the output: for each scene the
//! parameters that a user fills in (`parameters`), the equations prepared for a scalar type (`equations`), what depends on
//! the time alone (`instant`), outputs and energies (`outputs`); then the shapes (`shape`), the tables (`registry`) and
//! the tests (`tests`). The functions are straight lines of statements (`body`); what has which name and type is found in
//! `layout`; `formula` says in the fields' documentation what it is.

mod blocks;
mod body;
mod closure;
mod docs;
mod equations;
mod expression;
mod formula;
mod instant;
mod layout;
mod linkage;
mod measures;
mod modes;
pub mod names;
mod outputs;
mod parameters;
mod registry;
mod requirements;
mod scene;
mod series;
mod shape;
mod slopes;
mod subjects;
mod tables;
mod tests;
mod values;

use assur_model::checked::{Model, SceneModel};
use assur_model::token::Span;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use layout::Layout;

/// Where the equations stand.
pub struct Origin<'a> {
    /// Name of the file, `batten.eqn`, or of the Rust file when they stand inline.
    pub file: String,
    /// Whether the file is an equation file, so that its text can be carried along.
    pub has_file: bool,
    /// The line of a place in it, from 1; of the part that is meant, if the place is in the file of one.
    pub line_of: &'a dyn Fn(Span) -> u32,
    /// File and line of a place in the file of a part.
    pub part_of: &'a dyn Fn(Span) -> Option<(String, u32)>,
    /// The files of its parts, relative to its own.
    pub parts: Vec<String>,
}

/// The items of a mechanism. They stand in a module of their own, so that no constant of the user's can be taken for
/// a quantity of the equations.
pub fn mechanism(model: &Model, origin: &Origin<'_>) -> TokenStream {
    let types = scene::type_names(model);
    let named = model.scenes.iter().zip(&types).map(|(scene, name)| (scene, name.clone(), false));
    let unreduced = model.scenes.iter().zip(&types).filter_map(|(scene, name)| {
        let name = scene::unreduced(&names::identifier(name)).to_string();
        Some((scene.unreduced.as_deref()?, name, true))
    });
    let named: Vec<(&SceneModel, String, bool)> = named.chain(unreduced).collect();
    let modes: Vec<_> = named.iter().map(|(scene, ..)| scene.split()).collect();
    let layouts: Vec<Layout<'_>> = named
        .iter()
        .zip(&modes)
        .map(|((scene, name, is_unreduced), modes)| Layout {
            is_unreduced: *is_unreduced,
            ..Layout::with_modes(scene, modes, name)
        })
        .collect();
    let scenes = layouts.iter().map(|layout| scene::items(layout, model, origin));
    let alias = scene::alias(model, &types);
    let alias_name = alias.iter().map(|(name, _)| quote!(#name));
    let exported = scene::exported(&layouts).chain(alias_name).chain([quote!(MECHANISM)]);
    let alias_item = alias.as_ref().map(|(name, target)| {
        let text = docs::lines(&format!("The first scene of the mechanism, `{target}`."));
        quote!(#text pub type #name = #target;)
    });
    let curves = tables::items(named.iter().map(|(scene, ..)| *scene));
    let table = registry::table(model, &layouts, origin);
    let shapes = shape::module(&layouts, origin);
    let tests = tests::module(&layouts, origin);
    let module = format_ident!("{}_", names::snake(&model.name).trim_end_matches('_'));
    let text = docs::lines(&docs::mechanism(model, origin));
    quote! {
        #text
        #[allow(
            clippy::all, clippy::pedantic, clippy::nursery, rustdoc::all, non_snake_case, non_camel_case_types,
            non_upper_case_globals, unused_qualifications, unused_parens, unused_variables, dead_code
        )]
        mod #module {
            #curves
            #(#scenes)*
            #alias_item
            #shapes
            #table
            #tests
        }
        #[allow(unused_imports)]
        pub use #module::{#(#exported),*};
    }
}
