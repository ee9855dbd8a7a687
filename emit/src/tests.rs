//! The generated unit tests: a module for each scene, a test for its derivatives, for its energy, for its units, and
//! for each published fact. The checks themselves are `assur::check`.

use assur_model::checked::Test;
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
    let facts = &layout.scene.expectations;
    let functions = names::distinct(facts.iter().map(|fact| fact.label.as_str()));
    let tests = layout.scene.tests();
    if tests.is_empty() {
        return TokenStream::new();
    }
    let tests = tests.into_iter().map(|test| match test {
        Test::Fact(index) => fact(layout, origin, (index, &functions[index])),
        own => generated(layout, own),
    });
    quote!(mod #module { #(#tests)* })
}

/// A test of what has been derived.
fn generated(layout: &Layout<'_>, test: Test) -> TokenStream {
    let (name, scene) = (&layout.parameters, &layout.scene.name);
    let default = quote!(&<super::super::#name as ::core::default::Default>::default());
    let mechanism = quote!(&super::super::MECHANISM);
    let (text, function, check) = match test {
        Test::Jacobian => (None, "jacobian_", quote!(jacobian(#default))),
        Test::Energy => (None, "energy_", quote!(energy(#default))),
        Test::Closure => (None, "closure_", quote!(closure(#default))),
        Test::Scaling | Test::Fact(_) => {
            let text = " The same mechanism stated in mm, g, ms gives the same motion.";
            let check = match layout.scene.linkage {
                None => quote! {
                    scaling(#mechanism, #scene, &|values| {
                        ::core::option::Option::Some(super::super::#name::from_values(values.try_into().ok()?))
                    })
                },
                Some(_) => quote!(closure_scaling(#mechanism, #scene, #default)),
            };
            (Some(text), "scaling_", check)
        }
    };
    let (text, function) = (text.iter(), names::identifier(function));
    quote! {
        #(#[doc = #text])*
        #[test]
        fn #function() -> ::core::result::Result<(), ::assur::check::Failed> {
            ::assur::check::#check
        }
    }
}

/// A test for a published fact, called after it: `phi2_at_theta_0_rad`.
fn fact(
    layout: &Layout<'_>,
    origin: &Origin<'_>,
    (index, function): (usize, &Ident),
) -> TokenStream {
    let (scene, fact) = (&layout.scene.name, &layout.scene.expectations[index]);
    let text = format!(" `{}`, {}:{}", fact.label, origin.file, (origin.line_of)(fact.span));
    let index = size(index);
    quote! {
        #[doc = #text]
        #[test]
        fn #function() -> ::core::result::Result<(), ::assur::check::Failed> {
            ::assur::check::fact(&super::super::MECHANISM, #scene, #index)
        }
    }
}
