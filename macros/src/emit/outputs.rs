//! What is asked of single positions: outputs, drivers, mass matrix, energy.

use assur_model::program::Value;
use proc_macro2::TokenStream;
use quote::quote;

use super::blocks::blocks;
use super::body::{Body, Place};
use super::equations::first;
use super::expression::{size, triangle};
use super::layout::{Layout, outlined};
use super::{counts, docs};

/// The methods of `Equations` for outputs and drivers, where there are any.
pub fn methods(layout: &Layout<'_>) -> TokenStream {
    let results = &layout.program().results;
    let outputs = (!results.outputs.is_empty()).then(|| {
        let text = docs::operations(counts::of(layout).outputs);
        let outputs = layout.body(writes(layout, &results.outputs));
        quote! {
            #text
            #[inline(always)]
            fn outputs(&self, time: S, state: &Self::State, values: &mut [S]) {
                #outputs
            }
        }
    });
    let drivers = (!results.drivers.is_empty()).then(|| {
        let drivers = layout.body(writes(layout, &results.drivers));
        quote! {
            #[inline(always)]
            fn drivers(&self, time: S, values: &mut [S]) {
                #drivers
            }
        }
    });
    let (margins, measures) = (margins(layout), measures(layout));
    quote!(#outputs #drivers #margins #measures)
}

/// The method of `Equations` for loops that are carried along, where there are any.
fn margins(layout: &Layout<'_>) -> Option<TokenStream> {
    let wanted = &layout.program().results.margins;
    let margins = outlined(writes(layout, wanted));
    (!wanted.is_empty()).then(|| {
        quote! {
            #[inline(always)]
            fn margins(&self, time: S, values: &mut [S]) {
                #margins
            }
        }
    })
}

/// The methods of `Equations` for measures, where the scene has any.
fn measures(layout: &Layout<'_>) -> Option<TokenStream> {
    let results = &layout.program().results;
    let measured = outlined(writes(layout, &results.measured));
    let measures = outlined(writes(layout, &results.measures));
    (!layout.scene.measures.is_empty()).then(|| {
        quote! {
            #[inline(always)]
            fn measured(&self, time: S, state: &Self::State, values: &mut [S]) {
                #measured
            }

            #[inline(always)]
            fn measures(&self, found: &[S], values: &mut [S]) {
                #measures
            }
        }
    })
}

fn writes(layout: &Layout<'_>, wanted: &[Value]) -> TokenStream {
    if wanted.is_empty() {
        return TokenStream::new();
    }
    let body = Body::new(layout, Place::Time, wanted, &[]);
    let (first, statements) = (first(quote!(values), wanted.len()), body.statements(wanted));
    let writes: Vec<TokenStream> = wanted
        .iter()
        .enumerate()
        .map(|(index, value)| {
            let (index, value) = (size(index), body.value(*value));
            quote!(values[#index] = #value;)
        })
        .collect();
    let writes = blocks(&writes);
    quote!(#first #statements #writes)
}

/// Methods of the equations' own, where the scene has them.
pub fn inherent(layout: &Layout<'_>) -> TokenStream {
    let methods = [mass_matrix(layout), energy(layout)];
    if methods.iter().all(TokenStream::is_empty) {
        return TokenStream::new();
    }
    let name = &layout.equations;
    quote! {
        impl<S: ::assur::scalar::Scalar> #name<S> {
            #(#methods)*
        }
    }
}

fn mass_matrix(layout: &Layout<'_>) -> TokenStream {
    let mass = &layout.program().results.mass;
    let rows = layout.scene.coordinates;
    if mass.is_empty() || mass.len() != triangle(rows, 0) {
        return TokenStream::new();
    }
    // Entries beside the diagonal are written twice: each gets a name.
    let body = Body::new(layout, Place::Time, &[], mass);
    let statements = body.statements(mass);
    let row = |i: usize| {
        let row = (0..rows).map(|j| body.value(mass[triangle(i.max(j), i.min(j))]));
        quote!([#(#row),*])
    };
    let (states, count, matrix) = (size(layout.states()), size(rows), (0..rows).map(row));
    let body = outlined(quote!(#statements [#(#matrix),*]));
    quote! {
        /// The symmetric mass matrix, in the order of the coordinates.
        #[inline(always)]
        pub fn mass_matrix(&self, time: S, state: &[S; #states]) -> [[S; #count]; #count] {
            #body
        }
    }
}

fn energy(layout: &Layout<'_>) -> TokenStream {
    let energy = &layout.program().results.energy;
    let [kinetic, potential] = energy.as_slice() else {
        return TokenStream::new();
    };
    let body = Body::new(layout, Place::Time, energy, &[]);
    let statements = body.statements(energy);
    let (kinetic, potential) = (body.value(*kinetic), body.value(*potential));
    let states = size(layout.states());
    let body = outlined(quote!(#statements (#kinetic, #potential)));
    quote! {
        /// Kinetic and potential energy, in joules.
        #[inline(always)]
        pub fn energy(&self, time: S, state: &[S; #states]) -> (S, S) {
            #body
        }
    }
}
