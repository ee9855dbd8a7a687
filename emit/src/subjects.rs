//! Locals of what a scene says, as indices of its motion: `motion.at(4.0)[Swing::PHI]`.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expression::size;
use crate::layout::Layout;
use crate::{docs, names};

/// A constant for each state, output and measure. An output that repeats the name of a state is that state.
pub fn items(layout: &Layout<'_>) -> TokenStream {
    let scene = layout.scene;
    let dependents = scene.linkage.iter().flat_map(|linkage| &linkage.dependents);
    let dependents = dependents.map(|one| one.quantity.name.as_str());
    let states = scene.states.iter().map(|one| one.name.as_str());
    let outputs = scene.outputs.iter().map(|one| one.name.as_str());
    let measures = scene.measures.iter().map(|one| one.quantity.name.as_str());
    let mut all: Vec<(&str, TokenStream)> = Vec::new();
    for (index, name) in states.chain(dependents).enumerate() {
        let index = size(index);
        all.push((name, quote!(State(#index))));
    }
    let known: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    for (index, name) in outputs.enumerate() {
        if !known.contains(&name) {
            let index = size(index);
            all.push((name, quote!(Output(#index))));
        }
    }
    for (index, name) in measures.enumerate() {
        let index = size(index);
        all.push((name, quote!(Measure(#index))));
    }
    let loud: Vec<String> = all.iter().map(|(name, _)| names::loud(name)).collect();
    let constants = names::distinct(loud.iter().map(String::as_str));
    let items = constants.iter().zip(all).map(|(constant, (name, subject))| {
        let text = docs::lines(&format!("`{name}`"));
        quote!(#text pub const #constant: ::assur::shape::Subject = ::assur::shape::Subject::#subject;)
    });
    items.collect()
}
