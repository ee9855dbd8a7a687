//! The equations prepared for a scalar type: their values, their Jacobian, its products with columns.

use std::collections::BTreeMap;

use assur_model::program::{OperationKind, Value};
use proc_macro2::TokenStream;
use quote::quote;

use crate::blocks::blocks;
use crate::body::{Body, Scope};
use crate::expression::{scalar, size};
use crate::layout::Layout;
use crate::{docs, instant, series};

/// Longest array literal for a column of the Jacobian; longer columns are filled entry by entry.
pub const SHORT: usize = 8;
/// Most factors of a row in one expression.
const TERMS: usize = 8;

/// The struct of prepared values, for each mode one of its own, and the implementation of `Equations`.
pub fn items(layout: &Layout<'_>) -> TokenStream {
    let name = &layout.equations;
    let states = size(layout.states());
    let fields = match layout.modes.as_slice() {
        [] => layout.fields(&layout.staging.prepared),
        modes => {
            let fields = modes.iter().map(|mode| {
                let (field, kind) = (&mode.field, &mode.equations);
                quote!(#field: #kind<S>)
            });
            quote!(#(#fields),*)
        }
    };
    let modes = layout.modes.iter().zip(&layout.scene.modes).map(|(mode, own)| {
        let (name, fields) = (&mode.equations, mode.fields(&mode.staging.prepared));
        let text = match own.name.as_str() {
            "" => docs::lines("In the only mode."),
            name => docs::lines(&format!("In the mode `{name}`.")),
        };
        quote! {
            #text
            #[derive(Clone, Copy, Debug)]
            struct #name<S: ::assur::scalar::Scalar> { #fields }
        }
    });
    let text = docs::lines(&format!(
        "Equations of [`{}`], prepared for a scalar type.",
        layout.parameters
    ));
    let (instants, series) = (instant::methods(layout), series::method(layout));
    let shared = layout.has_products_alone().then(|| along(layout));
    let methods = [rates(layout), variation(layout), jacobian(layout)];
    quote! {
        #(#modes)*

        #text
        #[derive(Clone, Copy, Debug)]
        pub struct #name<S: ::assur::scalar::Scalar> { #fields }

        #shared

        impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S> for #name<S> {
            #[inline(always)]
            fn states(&self) -> usize {
                #states
            }

            #instants
            #(#methods)*
            #series
        }
    }
}

/// Slices of a caller as arrays of these lengths. Others are a mistake of the caller's, which debug builds report.
pub fn exact(slices: &[(TokenStream, usize)]) -> TokenStream {
    let slices = slices.iter().map(|(slice, count)| {
        let count = size(*count);
        quote!(::assur::exact!(#slice, #count);)
    });
    slices.collect()
}

fn rates(layout: &Layout<'_>) -> TokenStream {
    let states = layout.states();
    let exact = exact(&[(quote!(state), states), (quote!(mut rates), states)]);
    let body = layout.in_mode(&quote!({}), &|mode| {
        let wanted = &mode.program().results.derivative;
        let body = Body::new(mode, Scope::Evaluation, wanted, &[]);
        let statements = body.statements(wanted);
        let values = wanted.iter().map(|value| body.value(*value));
        layout.body(quote!(#statements *rates = [#(#values),*];))
    });
    let text = layout.counted(layout.counts.derivative);
    quote! {
        #text
        #[inline(always)]
        fn rates(&self, phase: ::assur::problem::Phase<'_, S>, instant: &[S], state: &[S], rates: &mut [S]) {
            #exact
            #body
        }
    }
}

fn jacobian(layout: &Layout<'_>) -> TokenStream {
    let states = size(layout.states());
    let body = (layout.states() > 0).then(|| match layout.has_products_alone() {
        true => quote! {
            columns.fill(S::ZERO);
            columns.iter_mut().step_by(#states + 1).for_each(|own| *own = S::ONE);
            self.along_(phase, instant, state, &mut [S::ZERO; #states], columns);
        },
        false => {
            let body = layout.in_mode(&quote!({}), &|mode| layout.body(columns(mode)));
            quote! {
                ::assur::exact!(state, #states);
                ::assur::exact!(mut columns, #states by #states);
                #body
            }
        }
    });
    let text = layout.counted(layout.counts.jacobian);
    quote! {
        #text
        #[inline(always)]
        fn jacobian(&self, phase: ::assur::problem::Phase<'_, S>, instant: &[S], state: &[S], columns: &mut [S]) {
            #body
        }
    }
}

/// Writes the columns of the Jacobian in a mode.
fn columns(layout: &Layout<'_>) -> TokenStream {
    let entries = &layout.program().results.jacobian;
    let wanted: Vec<Value> = entries.iter().map(|entry| entry.2).collect();
    let body = Body::new(layout, Scope::Evaluation, &wanted, &[]);
    let statements = body.statements(&wanted);
    let (states, count) = (layout.states(), size(layout.states()));
    let mut writes = Vec::new();
    for column in 0..states {
        let of: BTreeMap<usize, Value> = entries
            .iter()
            .filter(|entry| entry.1 as usize == column)
            .map(|entry| (entry.0 as usize, entry.2))
            .collect();
        let at = size(column);
        if states <= SHORT {
            let values = (0..states)
                .map(|row| of.get(&row).map_or(quote!(S::ZERO), |value| body.value(*value)));
            writes.push(quote!(columns[#at] = [#(#values),*];));
        } else {
            writes.push(quote!(columns[#at] = [S::ZERO; #count];));
            writes.extend(of.iter().map(|(row, value)| {
                let (row, value) = (size(*row), body.value(*value));
                quote!(columns[#at][#row] = #value;)
            }));
        }
    }
    let writes = blocks(&writes);
    quote!(#statements #writes)
}

fn variation(layout: &Layout<'_>) -> TokenStream {
    let (states, count) = (layout.states(), size(layout.states()));
    let body = (states > 0).then(|| match layout.has_products_alone() {
        true => quote! {
            products.copy_from_slice(columns);
            self.along_(phase, instant, state, rates, products);
        },
        false => {
            let exact = exact(&[(quote!(state), states), (quote!(mut rates), states)]);
            let zip = quote!((column_, product_) in columns.iter().zip(&mut *products));
            let body = layout.in_mode(&quote!({}), &|mode| products(mode, &zip));
            quote! {
                #exact
                let (columns, products) = (columns.as_chunks::<#count>().0, products.as_chunks_mut::<#count>().0);
                #body
            }
        }
    });
    quote! {
        #[inline(always)]
        fn variation(
            &self,
            phase: ::assur::problem::Phase<'_, S>,
            instant: &[S],
            state: &[S],
            rates: &mut [S],
            columns: &[S],
            products: &mut [S],
        ) {
            #body
        }
    }
}

/// What the Jacobian and its products with columns are written by where it has products alone.
fn along(layout: &Layout<'_>) -> TokenStream {
    let (name, states) = (&layout.equations, layout.states());
    let (exact, count) =
        (exact(&[(quote!(state), states), (quote!(mut rates), states)]), size(states));
    let pairs = quote!((column_, product_) in products.iter_mut().map(|own| (*own, own)));
    let body = layout.in_mode(&quote!({}), &|mode| layout.body(products(mode, &pairs)));
    quote! {
        impl<S: ::assur::scalar::Scalar> #name<S> {
            /// Writes the rates, and products of the Jacobian with columns in place of these.
            fn along_(
                &self,
                phase: ::assur::problem::Phase<'_, S>,
                instant: &[S],
                state: &[S],
                rates: &mut [S],
                products: &mut [S],
            ) {
                #exact
                let products = products.as_chunks_mut::<#count>().0;
                #body
            }
        }
    }
}

/// The rates and the products of the Jacobian with columns in a mode, for each of `pairs` of a column and its product.
fn products(layout: &Layout<'_>, pairs: &TokenStream) -> TokenStream {
    let results = &layout.program().results;
    let slopes: Vec<Value> = match results.along.is_empty() {
        true => results.jacobian.iter().map(|entry| entry.2).collect(),
        false => layout.program().steady(&results.along),
    };
    let all: Vec<Value> = results.derivative.iter().chain(&slopes).copied().collect();
    // These are read once for each column: each gets a name.
    let body = Body::new(layout, Scope::Evaluation, &results.derivative, &slopes);
    let statements = body.statements(&all);
    let values = results.derivative.iter().map(|value| body.value(*value));
    let rows = match results.along.is_empty() {
        true => {
            let rows = (0..layout.states()).map(|row| product(layout, &body, row));
            blocks(&rows.collect::<Vec<_>>())
        }
        false => body.beside(&slopes, &results.along),
    };
    quote! {
        #statements
        *rates = [#(#values),*];
        for #pairs {
            #rows
        }
    }
}

/// One row of the Jacobian times a column.
fn product(layout: &Layout<'_>, body: &Body<'_>, row: usize) -> TokenStream {
    let program = layout.program();
    let number = |value: Value| match program.operations[value.0 as usize].kind {
        OperationKind::Number(number) => Some(number),
        _ => None,
    };
    let entries = program.results.jacobian.iter().filter(|entry| entry.0 as usize == row);
    let entries: Vec<_> = entries.filter(|entry| number(entry.2) != Some(0.0)).collect();
    let mut sum: Option<TokenStream> = None;
    let mut parts = Vec::new();
    for (index, (_, column, value)) in entries.iter().enumerate() {
        let (column, entry) = (size(*column as usize), body.value(*value));
        if let (Some(long), true) = (&sum, index % TERMS == 0) {
            parts.push(quote!(let sum_ = #long;));
            sum = Some(quote!(sum_));
        }
        sum = Some(match (sum, number(*value)) {
            (None, Some(1.0)) => quote!(column_[#column]),
            (None, Some(-1.0)) => quote!(-column_[#column]),
            (None, _) => quote!(#entry * column_[#column]),
            (Some(sum), Some(1.0)) => quote!(#sum + column_[#column]),
            (Some(sum), Some(-1.0)) => quote!(#sum - column_[#column]),
            (Some(sum), _) => quote!(S::mul_add(#entry, column_[#column], #sum)),
        });
    }
    let row = size(row);
    let sum = sum.unwrap_or_else(|| scalar(0.0).tokens);
    if parts.is_empty() {
        quote!(product_[#row] = #sum;)
    } else {
        quote!(product_[#row] = { #(#parts)* #sum };)
    }
}
