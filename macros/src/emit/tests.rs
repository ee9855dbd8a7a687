//! The generated unit tests.
use super::Origin;
use super::layout::Layout;
use proc_macro2::TokenStream;
pub fn module(_layouts: &[Layout<'_>], _origin: &Origin<'_>) -> TokenStream {
    TokenStream::new()
}
