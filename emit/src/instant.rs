//! What depends on the time alone: of a motion rows of numbers for several times at once, of a linkage one row.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{Stage, Value};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::body::{Body, Scope};
use crate::expression::{Expression, size};
use crate::layout::Layout;
use crate::{docs, names};

/// Times that are treated together: so many sines are packed well.
const PACKED: usize = 4;

/// The method of `Closure` that makes the row of a linkage from its drivers, and its length.
pub fn of_drivers(layout: &Layout<'_>) -> (TokenStream, Literal) {
    let wanted: Vec<Value> = layout.staging.timed.iter().copied().collect();
    let body = Body::new(layout, Scope::Independents, &wanted, &[]);
    let (statements, numbers) = (body.statements(&wanted), layout.row_of(&body));
    let length = size(numbers.len());
    let made = quote!(#statements [#(#numbers),*]);
    let motion = layout.program().results.closing.rates.len() + 1;
    let formulas = explained(layout);
    if motion == 1 {
        let method = quote! {
            #formulas
            #[inline(always)]
            fn instant(&self, independents: &[S]) -> Self::Instant {
                #made
            }
        };
        return (method, length);
    }
    let motion = size(motion);
    let methods = quote! {
        #[inline(always)]
        fn instant(&self, independents: &[S]) -> Self::Instant {
            self.moving(independents, &[S::from_f64(f64::NAN); #motion])
        }

        #formulas
        #[inline(always)]
        fn moving(&self, independents: &[S], motion: &[S]) -> Self::Instant {
            #made
        }
    };
    (methods, length)
}

/// Documentation of a method that makes rows: what stands in them, in each mode.
fn explained(layout: &Layout<'_>) -> TokenStream {
    let lists = layout.each_mode().iter().enumerate().map(|(index, mode)| {
        let items: Vec<String> =
            mode.row_formulas().into_iter().map(|entry| format!("- {entry}\n")).collect();
        match layout.scene.modes.get(index).map_or("", |mode| &mode.name) {
            name if !(name.is_empty() || items.is_empty()) => {
                format!("In mode `{name}`:\n{}\n", items.concat())
            }
            _ => items.concat(),
        }
    });
    docs::lines(&lists.collect::<String>())
}

/// The methods of `Equations` that make rows, where there are any.
pub fn methods(layout: &Layout<'_>) -> Option<TokenStream> {
    let row = layout.row();
    if row == 0 {
        return None;
    }
    let (row, packed) = (size(row), size(PACKED));
    let fill = layout.in_mode(&quote!({}), &|mode| {
        let code = rows(mode);
        match code.is_empty() {
            true => code,
            false => layout.body(code),
        }
    });
    let formulas = explained(layout);
    Some(quote! {
        #[inline(always)]
        fn instant(&self) -> usize {
            #row
        }

        #formulas
        #[inline(always)]
        fn instants(&self, phase: ::assur::problem::Phase<'_, S>, times: &[S], rows: &mut [S]) {
            let (rows, _) = rows.as_chunks_mut::<#row>();
            for (times, rows) in times.chunks(#packed).zip(rows.chunks_mut(#packed)) {
                #fill
            }
        }
    })
}

/// The statements that fill the rows of a mode, for at most [`PACKED`] times.
fn rows(layout: &Layout<'_>) -> TokenStream {
    let program = layout.program();
    if layout.staging.timed.is_empty() {
        return TokenStream::new();
    }
    let idle = program.idle();
    if idle.always {
        return TokenStream::new();
    }
    let idle = idle.sides.iter().map(|(surface, side)| {
        let index = size(*surface as usize);
        let pair = match *side < 0.0 {
            true => quote!(phase.side(#index), S::ZERO),
            false => quote!(S::ZERO, phase.side(#index)),
        };
        quote!(if S::holds(S::less(#pair)) { return; })
    });
    let wanted: Vec<Value> = layout.staging.timed.iter().copied().collect();
    // Whatever is prepared is there; the time stands in an array.
    let prepared = |value: Value| program.stage(value) < Stage::Instant;
    let needed = program.needed(&wanted, &prepared);
    let (sines, given) = packed_sines(layout, &needed);
    let body = Body::with_given(layout, Scope::Time, &wanted, &[], given);
    let (statements, numbers) = (body.statements(&wanted), layout.row_of(&body));
    let count = size(numbers.len());
    quote! {
        #(#idle)*
        #(#sines)*
        for (k_, row_) in rows.iter_mut().enumerate() {
            let time = times[k_];
            #statements
            row_[..#count].copy_from_slice(&[#(#numbers),*]);
        }
    }
}

/// The sines and cosines of several instants, taken together level by level, and what stands for each of them.
fn packed_sines(
    layout: &Layout<'_>,
    needed: &BTreeSet<Value>,
) -> (Vec<TokenStream>, BTreeMap<Value, Expression>) {
    let program = layout.program();
    let mut given: BTreeMap<Value, Expression> = BTreeMap::new();
    let mut sines = Vec::new();
    let packed = size(PACKED);
    for level in program.levels(needed) {
        let pairs = program.pairs(&level.batch);
        if pairs.is_empty() {
            continue;
        }
        let angles: Vec<Value> = pairs.iter().map(|pair| pair.angle).collect();
        let names: Vec<_> = angles
            .iter()
            .map(|angle| format_ident!("angle_{}_", names::bare(layout.names.of(*angle))))
            .collect();
        let body = Body::with_given(layout, Scope::Time, &angles, &[], given.clone());
        let statements = body.statements(&angles);
        let values = angles.iter().map(|angle| body.value(*angle));
        sines.push(quote! {
            #(let mut #names = [S::ZERO; #packed];)*
            for k_ in 0..#packed {
                let time = times[k_.min(times.len() - 1)];
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
            sines.push(quote!(let (#sine, #cosine) = S::sin_cos_all(#array);));
        }
    }
    (sines, given)
}
