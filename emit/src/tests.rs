//! The generated unit tests: a module for each scene, a test for its derivatives, for its energy, for its units, and
//! for each published fact. The checks themselves are `assur::check`.

use assur_model::checked::SpanKind;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::expression::size;
use crate::layout::Layout;
use crate::{Origin, names};

/// The module of the tests; nothing when there is nothing to test.
pub fn module(layouts: &[Layout<'_>], origin: &Origin<'_>) -> TokenStream {
    let own = || layouts.iter().filter(|layout| !layout.is_unreduced);
    let modules = names::distinct(own().map(|layout| layout.scene.name.as_str()));
    let scenes: TokenStream =
        own().zip(&modules).map(|(layout, name)| scene(layout, name, origin)).collect();
    if scenes.is_empty() {
        return scenes;
    }
    quote! {
        #[cfg(test)]
        #[allow(unnameable_test_items)]
        mod tests_ {
            #scenes
        }
    }
}

fn scene(layout: &Layout<'_>, module: &Ident, origin: &Origin<'_>) -> TokenStream {
    let own = [jacobian(layout), energy(layout), closure(layout), scaling(layout)];
    let tests: TokenStream = own.into_iter().flatten().chain([facts(layout, origin)]).collect();
    if tests.is_empty() {
        return tests;
    }
    quote!(mod #module { #tests })
}

fn jacobian(layout: &Layout<'_>) -> Option<TokenStream> {
    let name = &layout.parameters;
    (layout.states() > 0).then(|| {
        quote! {
            #[test]
            fn jacobian_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::jacobian::<super::super::#name>()
            }
        }
    })
}

fn closure(layout: &Layout<'_>) -> Option<TokenStream> {
    let name = &layout.parameters;
    layout.scene.linkage.as_ref().map(|_| {
        quote! {
            #[test]
            fn closure_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::closure::<super::super::#name>()
            }
        }
    })
}

fn energy(layout: &Layout<'_>) -> Option<TokenStream> {
    let name = &layout.parameters;
    let has_energy = layout.program().results.energy.len() == 2;
    let moves = layout.states() > 0 && layout.scene.span != SpanKind::Rest;
    (layout.scene.conservative && has_energy && moves).then(|| {
        quote! {
            #[test]
            fn energy_() -> ::core::result::Result<(), ::assur::check::Failed> {
                ::assur::check::energy::<super::super::#name>()
            }
        }
    })
}

/// A test that other units give the same motion, where they can be chosen: the equations hold no number that has one.
fn scaling(layout: &Layout<'_>) -> Option<TokenStream> {
    let (name, scene) = (&layout.parameters, &layout.scene.name);
    let is_something = layout.states() + layout.scene.outputs.len() > 0;
    let check = match layout.scene.linkage {
        None => quote! {
            ::assur::check::scaling(&super::super::MECHANISM, #scene, super::super::#name::from_values)
        },
        Some(_) => quote! {
            ::assur::check::closure_scaling::<super::super::#name>(&super::super::MECHANISM, #scene)
        },
    };
    (layout.scene.literal.is_none() && is_something).then(|| {
        quote! {
            /// The same mechanism stated in mm, g, ms gives the same motion.
            #[test]
            fn scaling_() -> ::core::result::Result<(), ::assur::check::Failed> {
                #check
            }
        }
    })
}

/// A test for each published fact, called after it: `phi2_at_theta_0_rad`.
fn facts(layout: &Layout<'_>, origin: &Origin<'_>) -> TokenStream {
    let scene = layout.scene;
    let facts = &scene.expectations;
    let functions = names::distinct(facts.iter().map(|fact| fact.label.as_str()));
    let tests = facts.iter().zip(functions).enumerate();
    tests
        .map(|(index, (fact, function))| {
            let text =
                format!(" `{}`, {}:{}", fact.label, origin.file, (origin.line_of)(fact.span));
            let (scene, index) = (&scene.name, size(index));
            quote! {
                #[doc = #text]
                #[test]
                fn #function() -> ::core::result::Result<(), ::assur::check::Failed> {
                    ::assur::check::fact(&super::super::MECHANISM, #scene, #index)
                }
            }
        })
        .collect()
}
