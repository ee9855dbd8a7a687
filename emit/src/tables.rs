//! Sampled curves as statics: each once, whichever scene reads it.

use std::collections::BTreeMap;

use assur_model::checked::SceneModel;
use assur_model::program::{OperationKind, Spline};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::docs;
use crate::expression::number;

/// The name of a curve.
pub fn name(spline: &Spline) -> Ident {
    format_ident!("table_{:016x}_", spline.fingerprint())
}

/// The curves that some scenes read.
pub fn items<'a>(scenes: impl Iterator<Item = &'a SceneModel>) -> TokenStream {
    let mut found = BTreeMap::new();
    for scene in scenes {
        let modes = scene.modes.iter().map(|mode| &mode.program);
        for program in modes.chain([&scene.program]) {
            collect(program.operations.iter().map(|one| &one.kind), &mut found);
        }
    }
    let items = found.into_iter().map(|(name, spline)| item(&name, spline));
    quote!(#(#items)*)
}

/// The curves that some operations read, those of searches included.
fn collect<'a>(
    operations: impl Iterator<Item = &'a OperationKind>,
    found: &mut BTreeMap<Ident, &'a Spline>,
) {
    for kind in operations {
        match kind {
            OperationKind::Table { spline, .. } => {
                found.insert(name(spline), spline);
            }
            OperationKind::Search { lines, .. } => {
                lines.iter().for_each(|line| collect(line.operations.iter(), found));
            }
            _ => {}
        }
    }
}

fn item(name: &Ident, spline: &Spline) -> TokenStream {
    let table = spline.table();
    let (what, periodic) = (table.what, table.is_periodic);
    let text =
        docs::lines(&format!("The curve `{what}`, {} pieces, in SI units.", table.pieces.len()));
    let knots = table.knots.iter().map(|one| number(*one));
    let pieces = table.pieces.iter().map(|piece| {
        let factors = piece.iter().map(|one| number(*one));
        quote!([#(#factors),*])
    });
    let (density, starts) = (number(table.density), table.starts.iter().copied());
    let starts = starts.map(Literal::u32_unsuffixed);
    quote! {
        #text
        static #name: ::assur::scalar::Table<'static> = ::assur::scalar::Table {
            what: #what,
            knots: &[#(#knots),*],
            pieces: &[#(#pieces),*],
            density: #density,
            starts: &[#(#starts),*],
            is_periodic: #periodic,
        };
    }
}
