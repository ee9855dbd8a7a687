//! How the events of a cycle depend on the state.

use assur_model::checked::SpanKind;
use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Body, Place};
use super::expression::size;
use super::layout::{Layout, outlined};
use super::modes::each;

/// Whether variations of the motion pass through its events.
pub fn has(layout: &Layout<'_>) -> bool {
    layout.scene.span == SpanKind::Periodic
}

/// The methods of a mode's equations.
pub fn of_mode(layout: &Layout<'_>) -> Option<TokenStream> {
    if !has(layout) {
        return None;
    }
    let events = &layout.program().results.events;
    let count = layout.states();
    let guards = each(events, |event| {
        let wanted = &event.slopes.guard;
        if wanted.is_empty() {
            return None;
        }
        let body = Body::new(layout, Place::Evaluation, wanted, &[]);
        let statements = body.statements(wanted);
        let values = wanted.iter().map(|value| body.value(*value));
        Some(quote!({ #statements *slopes = [#(#values),*]; }))
    });
    let jumps = each(events, |event| {
        let (after, rate) = (&event.slopes.after, &event.slopes.rate);
        if after.is_empty() {
            return None;
        }
        let wanted: Vec<_> = after.iter().chain(rate).copied().collect();
        let body = Body::new(layout, Place::Evaluation, &wanted, &[]);
        let statements = body.statements(&wanted);
        let columns = (0..count).map(|column| {
            let values = after[column * count..][..count].iter();
            let (values, at) = (values.map(|value| body.value(*value)), size(column));
            quote!(columns[#at] = [#(#values),*];)
        });
        let rates = rate.iter().map(|value| body.value(*value));
        Some(quote!({ #statements #(#columns)* *rate = [#(#rates),*]; true }))
    });
    let guards = (!guards.is_empty()).then(|| {
        let guards = outlined(quote!(match event { #guards _ => {} }));
        quote! {
            #[inline(always)]
            fn guard_slopes(&self, event: usize, instant: &Self::Instant, state: &Self::State, slopes: &mut Self::State) {
                #guards
            }
        }
    });
    let jumps = (!jumps.is_empty()).then(|| {
        let jumps = outlined(quote!(match event { #jumps _ => false, }));
        quote! {
            #[inline(always)]
            fn jump_slopes(
                &self,
                event: usize,
                instant: &Self::Instant,
                state: &Self::State,
                columns: &mut [Self::State],
                rate: &mut Self::State,
            ) -> bool {
                #jumps
            }
        }
    });
    Some(quote!(#guards #jumps))
}
