//! The equations prepared for a scalar type: their values, their Jacobian, its products with columns.

use std::collections::BTreeMap;

use assur_model::program::{OperationKind, Value};
use proc_macro2::TokenStream;
use quote::quote;

use super::blocks::blocks;
use super::body::{Body, Place};
use super::expression::{scalar, size};
use super::layout::Layout;
use super::{counts, docs, instant, outputs, series};

/// Longest array literal for a column of the Jacobian; longer columns are filled entry by entry.
const SHORT: usize = 8;
/// Most factors of a row in one expression.
const TERMS: usize = 8;

/// The struct and its implementation of `Equations`.
pub fn items(layout: &Layout<'_>) -> TokenStream {
    let (name, instant) = (&layout.equations, &layout.instant);
    let states = size(layout.states());
    let fields = layout.fields(&layout.prepared);
    let sides = sides(layout);
    let text = docs::lines(&format!(
        "Equations of [`{}`], prepared for a scalar type.",
        layout.parameters
    ));
    let methods = [
        instant::methods(layout),
        derivative(layout),
        series::method(layout).unwrap_or_default(),
        variation(layout),
        jacobian(layout),
        outputs::methods(layout),
    ];
    quote! {
        #text
        #[derive(Clone, Copy, Debug)]
        pub struct #name<S: ::assur::scalar::Scalar> { #fields #sides }

        impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S> for #name<S> {
            type State = [S; #states];
            type Instant = #instant<S>;

            #[inline(always)]
            fn states(&self) -> usize {
                #states
            }

            #(#methods)*
        }
    }
}

/// The field for the sides of switching surfaces.
fn sides(layout: &Layout<'_>) -> Option<TokenStream> {
    let count = size(layout.program().surfaces.len());
    layout.has_sides().then(|| {
        quote!(
            , /// On which side of each switching surface the motion is, 1 or -1; 0 where its values say it.
            sides_: [S; #count]
        )
    })
}

fn derivative(layout: &Layout<'_>) -> TokenStream {
    let wanted = &layout.program().results.derivative;
    let body = Body::new(layout, Place::Evaluation, wanted, &[]);
    let statements = body.statements(wanted);
    let values = wanted.iter().map(|value| body.value(*value));
    let text = docs::operations(counts::of(layout).derivative);
    let body = layout.body(quote!(#statements *rate = [#(#values),*];));
    quote! {
        #text
        #[inline(always)]
        fn derivative(&self, instant: &Self::Instant, state: &Self::State, rate: &mut Self::State) {
            #body
        }
    }
}

fn jacobian(layout: &Layout<'_>) -> TokenStream {
    let entries = &layout.program().results.jacobian;
    let wanted: Vec<Value> = entries.iter().map(|entry| entry.2).collect();
    let body = Body::new(layout, Place::Evaluation, &wanted, &[]);
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
            let values = (0..states).map(|row| {
                of.get(&row)
                    .map_or(quote!(S::ZERO), |value| body.value(*value))
            });
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
    let first = first(quote!(columns), states);
    let text = docs::operations(counts::of(layout).jacobian);
    let body = layout.body(quote!(#first #statements #writes));
    quote! {
        #text
        #[inline(always)]
        fn jacobian(&self, instant: &Self::Instant, state: &Self::State, columns: &mut [Self::State]) {
            #body
        }
    }
}

fn variation(layout: &Layout<'_>) -> TokenStream {
    let results = &layout.program().results;
    let slopes: Vec<Value> = results.jacobian.iter().map(|entry| entry.2).collect();
    let all: Vec<Value> = results.derivative.iter().chain(&slopes).copied().collect();
    // The entries are read once for each column: each gets a name.
    let body = Body::new(layout, Place::Evaluation, &results.derivative, &slopes);
    let statements = body.statements(&all);
    let values = results.derivative.iter().map(|value| body.value(*value));
    let rows: Vec<TokenStream> = (0..layout.states())
        .map(|row| product(layout, &body, row))
        .collect();
    let rows = blocks(&rows);
    let body = layout.body(quote! {
        #statements
        *rate = [#(#values),*];
        for (column_, product_) in columns.iter().zip(products.iter_mut()) {
            #rows
        }
    });
    quote! {
        #[inline(always)]
        fn variation(
            &self,
            instant: &Self::Instant,
            state: &Self::State,
            rate: &mut Self::State,
            columns: &[Self::State],
            products: &mut [Self::State],
        ) {
            #body
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
    let entries = program
        .results
        .jacobian
        .iter()
        .filter(|entry| entry.0 as usize == row);
    let entries: Vec<_> = entries
        .filter(|entry| number(entry.2) != Some(0.0))
        .collect();
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

/// The first so many places of a slice as an array. Fewer are a mistake of the caller's, which debug builds report.
pub fn first(slice: TokenStream, count: usize) -> TokenStream {
    let count = size(count);
    quote! {
        ::core::debug_assert!(#slice.len() >= #count);
        let ::core::option::Option::Some(#slice) = #slice.first_chunk_mut::<#count>() else { return };
    }
}
