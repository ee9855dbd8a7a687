//! How the events of a cycle depend on the state.

use assur_model::checked::SpanKind;
use proc_macro2::TokenStream;
use quote::quote;

use crate::body::{Body, Scope};
use crate::equations::exact;
use crate::expression::size;
use crate::layout::Layout;
use crate::modes::each;

/// The methods of `Events`, where variations of the motion pass through them.
pub fn methods(layout: &Layout<'_>) -> Option<TokenStream> {
    if layout.scene.span != SpanKind::Periodic {
        return None;
    }
    let (guards, jumps) = (guards(layout), jumps(layout));
    Some(quote! {
        fn has_slopes(&self) -> bool {
            true
        }

        #guards
        #jumps
    })
}

fn guards(layout: &Layout<'_>) -> Option<TokenStream> {
    let states = layout.states();
    let arms = each(layout, &|mode, event| {
        let wanted = &event.slopes.guard;
        if wanted.is_empty() {
            return None;
        }
        let body = Body::new(mode, Scope::Time, wanted, &[]);
        let statements = body.statements(wanted);
        let values = wanted.iter().map(|value| body.value(*value));
        Some(quote!(#statements *slopes = [#(#values),*];))
    });
    let exact = exact(&[(quote!(state), states), (quote!(mut slopes), states)]);
    (!arms.is_empty()).then(|| {
        quote! {
            fn guard_slopes(
                &self,
                phase: ::assur::problem::Phase<'_, S>,
                event: usize,
                time: S,
                state: &[S],
                slopes: &mut [S],
            ) {
                #exact
                match (phase.mode, event) {
                    #arms
                    _ => slopes.fill(S::ZERO),
                }
            }
        }
    })
}

fn jumps(layout: &Layout<'_>) -> Option<TokenStream> {
    let count = layout.states();
    let arms = each(layout, &|mode, event| {
        let (after, rate) = (&event.slopes.after, &event.slopes.rate);
        if after.is_empty() {
            return None;
        }
        let wanted: Vec<_> = after.iter().chain(rate).copied().collect();
        let body = Body::new(mode, Scope::Time, &wanted, &[]);
        let statements = body.statements(&wanted);
        let columns = (0..count).map(|column| {
            let values = after[column * count..][..count].iter();
            let (values, at) = (values.map(|value| body.value(*value)), size(column));
            quote!(columns[#at] = [#(#values),*];)
        });
        let rates = rate.iter().map(|value| body.value(*value));
        Some(quote! {
            #statements
            #(#columns)*
            *rates = [#(#rates),*];
            true
        })
    });
    let count = size(count);
    (!arms.is_empty()).then(|| {
        quote! {
            fn jump_slopes(
                &self,
                phase: ::assur::problem::Phase<'_, S>,
                event: usize,
                time: S,
                state: &[S],
                columns: &mut [S],
                rates: &mut [S],
            ) -> bool {
                ::assur::exact!(state, #count, false);
                ::assur::exact!(mut columns, #count by #count, false);
                ::assur::exact!(mut rates, #count, false);
                match (phase.mode, event) {
                    #arms
                    _ => false,
                }
            }
        }
    })
}
