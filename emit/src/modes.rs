//! Events: what changes the equations of a scene on the way, mode by mode.
//!
//! They are asked through a pointer, so that each is a function of its own for the instructions of its numbers.

use assur_model::program::{Event, Value};
use proc_macro2::TokenStream;
use quote::quote;

use crate::body::{Body, Scope};
use crate::equations::exact;
use crate::expression::size;
use crate::layout::{Layout, outlined};
use crate::slopes;

/// The implementation of `Events`; none for a scene without modes.
pub fn items(layout: &Layout<'_>) -> Option<TokenStream> {
    if layout.modes.is_empty() {
        return None;
    }
    let name = &layout.equations;
    let methods = [guards(layout), conditions(layout), jumps(layout)];
    let slopes = slopes::methods(layout);
    Some(quote! {
        impl<S: ::assur::scalar::Scalar> ::assur::problem::Events<S> for #name<S> {
            #(#methods)*
            #slopes
        }
    })
}

fn guards(layout: &Layout<'_>) -> TokenStream {
    let states = size(layout.states());
    let body = layout.in_mode(&quote!({}), &|mode| {
        let events = &mode.program().results.events;
        let values: Vec<Value> =
            events.iter().flat_map(|event| [event.guard, event.rate]).collect();
        if values.is_empty() {
            return TokenStream::new();
        }
        let body = Body::new(mode, Scope::Time, &values, &[]);
        let statements = body.statements(&values);
        let exact = exact(&[(quote!(mut values), events.len()), (quote!(mut rates), events.len())]);
        let (values, rates) = (
            events.iter().map(|event| body.value(event.guard)),
            events.iter().map(|event| body.value(event.rate)),
        );
        outlined(quote! {
            #exact
            #statements
            *values = [#(#values),*];
            *rates = [#(#rates),*];
        })
    });
    quote! {
        fn guards(
            &self,
            phase: ::assur::problem::Phase<'_, S>,
            time: S,
            state: &[S],
            values: &mut [S],
            rates: &mut [S],
        ) {
            ::assur::exact!(state, #states);
            #body
        }
    }
}

fn conditions(layout: &Layout<'_>) -> TokenStream {
    let states = size(layout.states());
    let arms = each(layout, &|mode, event| {
        let condition = event.condition?;
        let body = Body::new(mode, Scope::Time, &[condition], &[]);
        let (statements, value) = (body.statements(&[condition]), body.value(condition));
        Some(quote!(#statements S::holds(#value)))
    });
    if arms.is_empty() {
        return arms;
    }
    quote! {
        fn permits(&self, phase: ::assur::problem::Phase<'_, S>, event: usize, time: S, state: &[S]) -> bool {
            ::assur::exact!(state, #states, true);
            match (phase.mode, event) {
                #arms
                _ => true,
            }
        }
    }
}

fn jumps(layout: &Layout<'_>) -> TokenStream {
    let states = layout.states();
    let arms = each(layout, &|mode, event| {
        if event.after.is_empty() {
            return None;
        }
        let body = Body::new(mode, Scope::Time, &event.after, &[]);
        let statements = body.statements(&event.after);
        let values = event.after.iter().map(|value| body.value(*value));
        Some(quote!(#statements *after = [#(#values),*];))
    });
    if arms.is_empty() {
        return arms;
    }
    let exact = exact(&[(quote!(state), states), (quote!(mut after), states)]);
    quote! {
        fn jump(
            &self,
            phase: ::assur::problem::Phase<'_, S>,
            event: usize,
            time: S,
            state: &[S],
            after: &mut [S],
        ) {
            #exact
            match (phase.mode, event) {
                #arms
                _ => after.copy_from_slice(state),
            }
        }
    }
}

/// An arm for each event of each mode that has something to say.
pub fn each<'a>(
    layout: &Layout<'a>,
    arm: &dyn Fn(&Layout<'a>, &Event<Value>) -> Option<TokenStream>,
) -> TokenStream {
    let modes = layout.modes.iter().enumerate();
    let arms = modes.flat_map(|(mode, own)| {
        let events = own.program().results.events.iter().enumerate();
        let arms = events.filter_map(move |(event, statement)| {
            let code = own.owning(outlined(arm(own, statement)?));
            let (mode, event) = (size(mode), size(event));
            Some(quote!((#mode, #event) => { #code }))
        });
        arms.collect::<Vec<_>>()
    });
    arms.collect()
}
