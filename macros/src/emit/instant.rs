//! What depends on the time alone, at one time and at several at once.

use std::collections::BTreeMap;

use assur_model::program::{Stage, Value};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::body::{Body, Place};
use super::docs;
use super::expression::{Expression, size};
use super::layout::Layout;
use super::pairs::pairs;
use super::{counts, names, schedule};

/// The struct.
pub fn items(layout: &Layout<'_>) -> TokenStream {
    let name = &layout.instant;
    let fields = layout.fields(&layout.timed);
    let text = docs::lines(&format!(
        "What the equations of [`{}`] need of one time.",
        layout.parameters
    ));
    quote! {
        #text
        #[derive(Clone, Copy, Debug)]
        pub struct #name<S: ::assur::scalar::Scalar> { #fields }
    }
}

/// The methods of `Equations` that make it.
pub fn methods(layout: &Layout<'_>) -> TokenStream {
    let one = one(layout);
    let several = several(layout);
    quote!(#one #several)
}

/// The method of `Closure` that makes it from the drivers.
pub fn of_drivers(layout: &Layout<'_>) -> TokenStream {
    let wanted: Vec<Value> = layout.timed.iter().copied().collect();
    let body = Body::new(layout, Place::Independents, &wanted, &[]);
    let (statements, fields) = (
        body.statements(&wanted),
        layout.stored(&layout.timed, &body),
    );
    let name = &layout.instant;
    let made = quote!(#statements #name { #fields });
    let motion = layout.program().results.closing.rates.len() + 1;
    if motion == 1 {
        return quote! {
            #[inline(always)]
            fn instant(&self, independents: &[S]) -> Self::Instant {
                #made
            }
        };
    }
    let motion = size(motion);
    quote! {
        #[inline(always)]
        fn instant(&self, independents: &[S]) -> Self::Instant {
            self.moving(independents, &[S::from_f64(f64::NAN); #motion])
        }

        #[inline(always)]
        fn moving(&self, independents: &[S], motion: &[S]) -> Self::Instant {
            #made
        }
    }
}

fn one(layout: &Layout<'_>) -> TokenStream {
    let wanted: Vec<Value> = layout.timed.iter().copied().collect();
    let body = Body::new(layout, Place::Time, &wanted, &[]);
    let (statements, fields) = (
        body.statements(&wanted),
        layout.stored(&layout.timed, &body),
    );
    let name = &layout.instant;
    let text = docs::operations(counts::of(layout).instant);
    let body = layout.body(quote!(#statements #name { #fields }));
    quote! {
        #text
        #[inline(always)]
        fn instant(&self, time: S) -> Self::Instant {
            #body
        }
    }
}

/// Each angle at all times is one packed call. These instants are for the rates and their slopes alone: where those need
/// nothing of the time, or nothing on the side of a switching surface on which the motion is, nothing is computed.
fn several(layout: &Layout<'_>) -> TokenStream {
    let program = layout.program();
    let is_idle = |side: Option<(u32, f64)>| {
        let results = &program.results;
        let slopes = results.jacobian.iter().map(|(_, _, value)| *value);
        let rates: Vec<Value> = results.derivative.iter().copied().chain(slopes).collect();
        let resting = program.resting(&rates, side);
        let stages = resting
            .iter()
            .map(|value| program.operations[value.0 as usize].stage);
        !layout.timed.is_empty() && stages.into_iter().all(|stage| stage != Stage::Instant)
    };
    let (name, placeholders) = (&layout.instant, layout.placeholders(&layout.timed));
    if is_idle(None) {
        return quote! {
            #[inline(always)]
            fn instants<const K_: usize>(&self, _times: [S; K_]) -> [Self::Instant; K_] {
                [#name { #placeholders }; K_]
            }
        };
    }
    let idle = (0..program.surfaces.len() as u32).flat_map(|surface| {
        let index = size(surface as usize);
        [
            (-1.0, quote!(self.sides_[#index], S::ZERO)),
            (1.0, quote!(S::ZERO, self.sides_[#index])),
        ]
        .map(|(side, pair)| (is_idle(Some((surface, side))), pair))
    });
    let idle = idle.filter(|(is_idle, _)| *is_idle).map(|(_, pair)| {
        quote! {
            if S::holds(S::less(#pair)) {
                return [#name { #placeholders }; K_];
            }
        }
    });
    let idle: Vec<TokenStream> = idle.collect();
    let wanted: Vec<Value> = layout.timed.iter().copied().collect();
    // Whatever is prepared is there; the time stands in an array.
    let prepared = |value: Value| program.operations[value.0 as usize].stage < Stage::Instant;
    let needed = schedule::needed(program, &wanted, &prepared);
    let mut given: BTreeMap<Value, Expression> = BTreeMap::new();
    let mut sines = Vec::new();
    for level in schedule::levels(program, &needed) {
        let pairs = pairs(layout, &level.batch);
        if pairs.is_empty() {
            continue;
        }
        let angles: Vec<Value> = pairs.iter().map(|pair| pair.angle).collect();
        let names: Vec<_> = angles
            .iter()
            .map(|angle| format_ident!("angle_{}_", names::bare(layout.names.of(*angle))))
            .collect();
        let body = Body::with_given(layout, Place::Time, &angles, &[], given.clone());
        let statements = body.statements(&angles);
        let values = angles.iter().map(|angle| body.value(*angle));
        sines.push(quote! {
            #(let mut #names = [S::ZERO; K_];)*
            for k_ in 0..K_ {
                let time = times[k_];
                #statements
                #(#names[k_] = #values;)*
            }
        });
        for (pair, array) in pairs.iter().zip(&names) {
            let mut name = |value: Option<Value>| match value {
                Some(value) => {
                    let name = layout.names.of(value);
                    given.insert(value, Expression::whole(quote!(#name[k_])));
                    quote!(#name)
                }
                None => quote!(_),
            };
            let (sine, cosine) = (name(pair.sine), name(pair.cosine));
            sines.push(quote!(let (#sine, #cosine) = S::sin_cos_all::<K_>(#array);));
        }
    }
    let body = Body::with_given(layout, Place::Time, &wanted, &[], given);
    let (statements, fields) = (
        body.statements(&wanted),
        layout.stored(&layout.timed, &body),
    );
    let fill = match layout.timed.is_empty() {
        true => quote!([#name { #placeholders }; K_]),
        false => quote! {
            let mut instants = [#name { #placeholders }; K_];
            for k_ in 0..K_ {
                let time = times[k_];
                #statements
                instants[k_] = #name { #fields };
            }
            instants
        },
    };
    let body = layout.body(quote!(#(#idle)* #(#sines)* #fill));
    quote! {
        #[inline(always)]
        fn instants<const K_: usize>(&self, times: [S; K_]) -> [Self::Instant; K_] {
            #body
        }
    }
}
