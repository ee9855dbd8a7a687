//! The files of parts and of tables: each is read once, and its tokens are counted on behind those of the files before.

use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

use crate::checked::PartFile;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::lexer::Unreadable;
use crate::sheet::Sheet;
use crate::syntax::parser::parse;
use crate::syntax::tree::File;
use crate::token::{Span, Token, TokenKind};

/// A file that a part or a table needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// Its path, relative to the folder of the main file.
    pub path: String,
    /// Where the main file names the part that needs it; its last token is the name of the file, as a rule.
    pub place: Span,
    /// Whether it holds measured values: its whole text is one token then.
    pub is_sheet: bool,
}

/// Gives the tokens of a file, or says why it has none.
pub type Loader<'a> = dyn FnMut(&Wanted) -> Result<Vec<Token>, Unreadable> + 'a;

/// The files that have been asked for.
pub struct Files<'a, 'b> {
    loader: &'a mut Loader<'b>,
    /// By path; none where the file has been read and reported as no mechanism.
    known: BTreeMap<String, Result<Option<Rc<File>>, Unreadable>>,
    /// Files of values by path.
    sheets: BTreeMap<String, Result<Arc<Sheet>, Unreadable>>,
    /// What was read.
    pub list: Vec<PartFile>,
    /// What the first token of the next file is counted as.
    next: usize,
}

impl<'a, 'b> Files<'a, 'b> {
    /// Begins behind the tokens of the main file.
    pub fn new(tokens: usize, loader: &'a mut Loader<'b>) -> Self {
        Self {
            loader,
            known: BTreeMap::new(),
            sheets: BTreeMap::new(),
            list: Vec::new(),
            next: tokens,
        }
    }

    /// The tree of a file. `place` is where the main file needs it, `named` where it is named.
    pub fn load(
        &mut self,
        path: &str,
        place: Span,
        named: Span,
        diagnostics: &mut Diagnostics,
    ) -> Option<Rc<File>> {
        if !self.known.contains_key(path) {
            let read = self.read(path, place, diagnostics);
            self.known.insert(path.to_string(), read);
        }
        let file = self.known[path].as_ref();
        file.map_or_else(|error| unreadable(error, named, diagnostics), Clone::clone)
    }

    /// The values in a file.
    pub fn sheet(
        &mut self,
        path: &str,
        place: Span,
        named: Span,
        diagnostics: &mut Diagnostics,
    ) -> Option<Arc<Sheet>> {
        if !self.sheets.contains_key(path) {
            let sheet = self.read_sheet(path, place);
            self.sheets.insert(path.to_string(), sheet);
        }
        let sheet = self.sheets[path].as_ref();
        sheet.map_or_else(|error| unreadable(error, named, diagnostics), |one| Some(one.clone()))
    }

    fn read_sheet(&mut self, path: &str, place: Span) -> Result<Arc<Sheet>, Unreadable> {
        let tokens = (self.loader)(&Wanted { path: path.to_string(), place, is_sheet: true })?;
        let [Token { kind: TokenKind::Text, text }] = tokens.as_slice() else {
            let message = format!("`{path}` holds no values");
            return Err(Unreadable { range: 0..0, message, hint: None });
        };
        if let Ok(first) = u32::try_from(self.next) {
            self.list.push(PartFile { path: path.to_string(), first, place });
            self.next += 1;
        }
        Sheet::read(text).map(Arc::new).map_err(|error| {
            let message = format!("the values of `{path}` cannot be read: {}", error.message);
            Unreadable { message, ..error }
        })
    }

    fn read(
        &mut self,
        path: &str,
        place: Span,
        diagnostics: &mut Diagnostics,
    ) -> Result<Option<Rc<File>>, Unreadable> {
        let tokens = (self.loader)(&Wanted { path: path.to_string(), place, is_sheet: false })?;
        let first = u32::try_from(self.next).ok();
        let first = first.filter(|_| !tokens.is_empty()).ok_or(Unreadable {
            range: 0..0,
            message: format!("`{path}` holds no mechanism"),
            hint: None,
        })?;
        self.next += tokens.len();
        self.list.push(PartFile { path: path.to_string(), first, place });
        Ok(parse(&tokens, first, diagnostics).map(Rc::new))
    }
}

/// Reports a file that cannot be read where it is named.
fn unreadable<T>(error: &Unreadable, named: Span, diagnostics: &mut Diagnostics) -> Option<T> {
    let report = Diagnostic::error(named, &error.message);
    diagnostics.push(match &error.hint {
        Some(hint) => report.hint(hint),
        None => report,
    });
    None
}

/// The path of a file that is named in another.
pub fn beside(around: &str, file: &str) -> String {
    let folder = around.rfind('/').map_or("", |end| &around[..end]);
    if file.starts_with('/') || file.contains(':') {
        return file.to_string();
    }
    let mut path: Vec<&str> = Vec::new();
    for step in folder.split('/').chain(file.split('/')) {
        match step {
            "" | "." => {}
            ".." if path.last().is_some_and(|last| *last != "..") => {
                path.pop();
            }
            _ => path.push(step),
        }
    }
    let root = if folder.starts_with('/') { "/" } else { "" };
    format!("{root}{}", path.join("/"))
}

#[cfg(test)]
mod tests {
    use super::beside;

    #[test]
    fn files_are_named_relative_to_their_own() {
        assert_eq!(beside("", "a.eqn"), "a.eqn");
        assert_eq!(beside("", "./parts/../a.eqn"), "a.eqn");
        assert_eq!(beside("parts/a.eqn", "b.eqn"), "parts/b.eqn");
        assert_eq!(beside("parts/a.eqn", "../b.eqn"), "b.eqn");
        assert_eq!(beside("a.eqn", "../../b.eqn"), "../../b.eqn");
        assert_eq!(beside("../a.eqn", "../b.eqn"), "../../b.eqn");
        assert_eq!(beside("/parts/a.eqn", "b.eqn"), "/parts/b.eqn");
        assert_eq!(beside("parts/a.eqn", "/b.eqn"), "/b.eqn");
    }
}
