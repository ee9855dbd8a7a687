//! `equations!`: a list of equation files as modules, and the table of their mechanisms.

use std::path::PathBuf;

use assur_emit::names;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::LitStr;
use syn::parse::Parser;
use syn::punctuated::Punctuated;

use crate::report;

/// Expands the macro.
pub fn equations(input: TokenStream) -> TokenStream {
    let list = match Punctuated::<LitStr, syn::Token![,]>::parse_terminated.parse2(input) {
        Ok(list) => list,
        Err(error) => {
            let text = format!(
                "{error}; expected a list of equation files, \"batten.eqn\", \"needle.eqn\""
            );
            let registry = registry(&[]);
            let error = report::error(error.span(), error.span(), &text);
            return quote!(#error #registry);
        }
    };
    let mut modules: Vec<Ident> = Vec::new();
    let mut items = TokenStream::new();
    for file in &list {
        match module(file, &modules) {
            Ok((name, item)) => {
                modules.push(name);
                items.extend(item);
            }
            Err(text) => items.extend(report::error(file.span(), file.span(), &text)),
        }
    }
    let registry = registry(&modules);
    quote!(#items #registry)
}

/// The module of a file, or what is wrong with it.
fn module(file: &LitStr, others: &[Ident]) -> Result<(Ident, TokenStream), String> {
    let path = file.value();
    let shown = PathBuf::from(&path);
    let stem =
        shown.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let name = names::identifier(&stem);
    if !path.ends_with(".eqn") || stem != name.to_string().trim_start_matches("r#") {
        return Err(format!(
            "found `{path}`, expected a file like `pendulum.eqn`, which names a module"
        ));
    }
    if others.contains(&name) {
        return Err(format!("`{path}` is the second file for the module `{name}`"));
    }
    let place = beside(file, &path);
    if let Some(missing) = place.as_ref().filter(|place| !place.is_file()) {
        return Err(format!(
            "there is no file `{path}` beside this one (looked for `{}`)",
            missing.display()
        ));
    }
    let summary = format!(" The equation file `{path}`.");
    let (items, text) = analyzed(place).map_or_else(
        || (quote!(::core::include!(#file);), quote!(::core::include_str!(#file))),
        |tokens| (tokens, quote!("")),
    );
    Ok((
        name.clone(),
        quote! {
            #[doc = #summary]
            pub mod #name {
                #items
                /// Text of the equation file.
                pub const TEXT: &str = #text;
            }
        },
    ))
}

/// The path of a file that is named relative to the source file of the invocation; unknown outside of rustc.
fn beside(file: &LitStr, path: &str) -> Option<PathBuf> {
    if !proc_macro::is_available() {
        return None;
    }
    let source = file.span().unwrap().local_file()?;
    Some(source.parent()?.join(path))
}

/// The tokens of the file themselves, for rust-analyzer, which includes `.rs` files only. It runs macros in a server of
/// its own; a `cfg` would be one that the crates of users do not know.
fn analyzed(place: Option<PathBuf>) -> Option<TokenStream> {
    let server = std::env::current_exe().ok()?;
    let name = server.file_stem()?.to_str()?;
    if !name.starts_with("rust-analyzer") {
        return None;
    }
    std::fs::read_to_string(place?).ok()?.parse().ok()
}

/// The table of all mechanisms.
fn registry(modules: &[Ident]) -> TokenStream {
    quote! {
        /// All mechanisms, in the order of the list.
        pub static REGISTRY: &[::assur::registry::Mechanism] = &[#(#modules::MECHANISM),*];
    }
}
