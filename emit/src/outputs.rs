//! What is asked of single positions: outputs, drivers, loops, energy, mass matrix, measures.

use assur_model::program::{OperationKind, Value};
use proc_macro2::TokenStream;
use quote::quote;

use crate::blocks::blocks;
use crate::body::{Body, Scope};
use crate::equations::{SHORT, exact};
use crate::expression::{size, triangle};
use crate::layout::{Layout, outlined};

/// The implementation of `Reports`.
pub fn items(layout: &Layout<'_>) -> TokenStream {
    let name = &layout.equations;
    let first = &layout.first_mode().program().results;
    let drivers = of_time(layout, "drivers", &first.drivers);
    let methods = [
        outputs(layout),
        drivers,
        margins(layout),
        points(layout),
        energy(layout),
        mass(layout),
        measures(layout),
    ];
    let methods = methods.iter().flatten();
    let closures = closures(layout);
    quote! {
        impl<S: ::assur::scalar::Scalar> ::assur::problem::Reports<S> for #name<S> {
            #(#methods)*
            #closures
        }
    }
}

fn outputs(layout: &Layout<'_>) -> Option<TokenStream> {
    let text = layout.counted(layout.counts.outputs);
    let states = size(layout.states());
    let outputs =
        layout.in_mode(&quote!({}), &|mode| of_state(mode, &mode.program().results.outputs));
    (!layout.scene.outputs.is_empty()).then(|| {
        quote! {
            #text
            fn outputs(&self, phase: ::assur::problem::Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
                ::assur::exact!(state, #states);
                #outputs
            }
        }
    })
}

fn margins(layout: &Layout<'_>) -> Option<TokenStream> {
    let states = size(layout.states());
    let margins =
        layout.in_mode(&quote!({}), &|mode| of_state(mode, &mode.program().results.margins));
    (!layout.scene.carried.is_empty()).then(|| {
        quote! {
            fn margins(&self, phase: ::assur::problem::Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
                ::assur::exact!(state, #states);
                #margins
            }
        }
    })
}

/// The places of points and forces.
fn points(layout: &Layout<'_>) -> Option<TokenStream> {
    let states = size(layout.states());
    let points =
        layout.in_mode(&quote!({}), &|mode| of_state(mode, &mode.program().results.points));
    let is_linkage = layout.scene.linkage.is_some();
    (!layout.scene.points.is_empty() && !is_linkage).then(|| {
        quote! {
            fn points(&self, phase: ::assur::problem::Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
                ::assur::exact!(state, #states);
                #points
            }
        }
    })
}

/// The closures that hold the coordinates.
fn closures(layout: &Layout<'_>) -> Option<TokenStream> {
    let n = layout.scene.coordinates;
    let mut modes = layout.each_mode().iter();
    modes.find(|mode| mode.scene.augmented.is_some())?;
    let body = layout.in_mode(&quote!({}), &|mode| {
        let Some(augmented) = &mode.scene.augmented else {
            return TokenStream::new();
        };
        let m = augmented.loops.len();
        let closing = &mode.program().results.closing;
        let values = closing.residuals.iter().chain(&closing.rates).copied().enumerate();
        let slopes =
            closing.slopes.iter().map(|(row, column, value)| (2 * m + row * n + column, *value));
        let entries: Vec<(usize, Value)> = values.chain(slopes).collect();
        let wanted: Vec<Value> = entries.iter().map(|entry| entry.1).collect();
        let body = Body::new(mode, Scope::Time, &wanted, &[]);
        let (statements, exact) =
            (body.statements(&wanted), exact(&[(quote!(mut values), m * (2 + n))]));
        let writes = entries.iter().map(|(place, value)| {
            let (place, value) = (size(*place), body.value(*value));
            quote!(values[#place] = #value;)
        });
        let writes = blocks(&writes.collect::<Vec<_>>());
        outlined(quote!(#exact #statements values.fill(S::ZERO); #writes))
    });
    let states = size(layout.states());
    Some(quote! {
        fn closures(&self, phase: ::assur::problem::Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
            ::assur::exact!(state, #states);
            #body
        }
    })
}

/// A method for values that depend on the time alone, which the first mode computes; none where there are none.
fn of_time(layout: &Layout<'_>, method: &str, wanted: &[Value]) -> Option<TokenStream> {
    let method = crate::names::identifier(method);
    let first = layout.first_mode();
    let body = first.owning(outlined(writes(first, wanted)));
    (!wanted.is_empty()).then(|| {
        quote! {
            fn #method(&self, time: S, values: &mut [S]) {
                #body
            }
        }
    })
}

/// Writes values at a time and state.
fn of_state(layout: &Layout<'_>, wanted: &[Value]) -> TokenStream {
    let writes = writes(layout, wanted);
    match writes.is_empty() {
        true => writes,
        false => outlined(writes),
    }
}

/// The methods for measures, where the scene has any.
fn measures(layout: &Layout<'_>) -> Option<TokenStream> {
    let states = size(layout.states());
    let measured =
        layout.in_mode(&quote!({}), &|mode| of_state(mode, &mode.program().results.measured));
    let first = layout.first_mode();
    let measures = first.owning(outlined(writes(first, &first.program().results.measures)));
    (!layout.scene.measures.is_empty()).then(|| {
        quote! {
            fn measured(&self, phase: ::assur::problem::Phase<'_, S>, time: S, state: &[S], values: &mut [S]) {
                ::assur::exact!(state, #states);
                #measured
            }

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
    let body = Body::new(layout, Scope::Time, wanted, &[]);
    let exact = exact(&[(quote!(mut values), wanted.len())]);
    let statements = body.statements(wanted);
    let written: Vec<TokenStream> = wanted
        .iter()
        .enumerate()
        .map(|(index, value)| {
            let (index, value) = (size(index), body.value(*value));
            quote!(values[#index] = #value;)
        })
        .collect();
    let written = blocks(&written);
    quote!(#exact #statements #written)
}

fn mass(layout: &Layout<'_>) -> Option<TokenStream> {
    let count = layout.scene.coordinates;
    let has_mass = |mode: &Layout<'_>| {
        let mass = &mode.program().results.mass;
        !mass.is_empty() && mass.len() == triangle(count, 0)
    };
    let body = layout.in_mode(&quote!(false), &|mode| {
        if !has_mass(mode) {
            return quote!(false);
        }
        let mass = &mode.program().results.mass;
        // Entries beside the diagonal are written twice: each gets a name.
        let body = Body::new(mode, Scope::Time, &[], mass);
        let statements = body.statements(mass);
        let entry = |place: &usize| {
            let (row, column) = (place / count, place % count);
            mass[triangle(row.max(column), row.min(column))]
        };
        let (states, square) = (size(mode.states()), size(count * count));
        let places = 0..count * count;
        let writes = if count <= SHORT {
            let entries = places.map(|place| body.value(entry(&place)));
            quote!(*rows = [#(#entries),*];)
        } else {
            // Most of it is zero.
            let is_none = |place: &usize| {
                let kind = mode.program().kind(entry(place));
                matches!(kind, OperationKind::Number(0.0))
            };
            let writes = places.filter(|place| !is_none(place)).map(|place| {
                let (value, place) = (body.value(entry(&place)), size(place));
                quote!(rows[#place] = #value;)
            });
            let writes = blocks(&writes.collect::<Vec<_>>());
            quote!(rows.fill(S::ZERO); #writes)
        };
        outlined(quote! {
            ::assur::exact!(state, #states, false);
            ::assur::exact!(mut rows, #square, false);
            #statements
            #writes
            true
        })
    });
    layout.each_mode().iter().any(has_mass).then(|| {
        quote! {
            fn mass(&self, phase: ::assur::problem::Phase<'_, S>, time: S, state: &[S], rows: &mut [S]) -> bool {
                #body
            }
        }
    })
}

fn energy(layout: &Layout<'_>) -> Option<TokenStream> {
    let none = quote!(::core::option::Option::None);
    let body = layout.in_mode(&none, &|mode| {
        let energy = &mode.program().results.energy;
        let [kinetic, potential] = energy.as_slice() else {
            return none.clone();
        };
        let body = Body::new(mode, Scope::Time, energy, &[]);
        let statements = body.statements(energy);
        let (kinetic, potential) = (body.value(*kinetic), body.value(*potential));
        let states = size(mode.states());
        outlined(quote! {
            ::assur::exact!(state, #states, ::core::option::Option::None);
            #statements
            ::core::option::Option::Some((#kinetic, #potential))
        })
    });
    let mut modes = layout.each_mode().iter();
    modes.any(|mode| mode.program().results.energy.len() == 2).then(|| {
        quote! {
            fn energy(
                &self,
                phase: ::assur::problem::Phase<'_, S>,
                time: S,
                state: &[S],
            ) -> ::core::option::Option<(S, S)> {
                #body
            }
        }
    })
}
