//! Long lists of statements, cut into blocks: rustc is slow on long scopes.

use proc_macro2::TokenStream;
use quote::quote;

/// Most statements in one block.
pub const BLOCK: usize = 100;

/// Statements that write things, in blocks when they are many.
pub fn blocks(statements: &[TokenStream]) -> TokenStream {
    if statements.len() <= BLOCK {
        return quote!(#(#statements)*);
    }
    statements.chunks(BLOCK).map(|block| quote!({ #(#block)* })).collect()
}
