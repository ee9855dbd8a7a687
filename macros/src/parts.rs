//! The files of parts and tables, found beside the file that names them.

use std::path::{Path, PathBuf};

use assur_model::flatten::Wanted;
use assur_model::lexer::Unreadable;
use assur_model::texts::Texts;
use assur_model::token::Token;
use proc_macro2::{Literal, TokenStream};
use quote::quote_spanned;

use crate::tokens::Source;

/// What was read of the files of parts.
#[derive(Default)]
pub struct Parts {
    /// Their texts.
    pub texts: Texts,
    /// Items that name the files, so that an edit of one compiles the mechanism anew.
    pub used: TokenStream,
}

impl Parts {
    /// Reads a file.
    pub fn load(&mut self, wanted: &Wanted, source: &Source) -> Result<Vec<Token>, Unreadable> {
        let named = source.places(wanted.place).1;
        let folder = folder(named).ok_or_else(|| Unreadable {
            range: 0..0,
            message: format!(
                "the file `{}` cannot be found: the compiler does not tell where this one lies",
                wanted.path
            ),
            hint: None,
        })?;
        if folder.join(&wanted.path).is_file() {
            let path = Literal::string(&wanted.path);
            let item = quote_spanned!(named=> const _: &[u8] = ::core::include_bytes!(#path););
            self.used.extend(item);
        }
        self.texts.read(&folder, wanted)
    }
}

/// The folder of the file that a place is in.
fn folder(place: proc_macro2::Span) -> Option<PathBuf> {
    if !proc_macro::is_available() {
        return Some(PathBuf::new());
    }
    let file = place.unwrap().local_file()?;
    file.parent().map(Path::to_owned)
}
