//! The files of tables, read where they are named: relative to the file that names them.

use super::{Flattener, files};
use crate::syntax::tree::{Name, Points, StatementKind, Target, Term, TermKind, Visitor};

impl Flattener<'_, '_> {
    /// Reads the files of the tables in a statement.
    pub(super) fn read_tables(&mut self, statement: &mut StatementKind) {
        statement.visit(&mut Reader(self));
    }
}

struct Reader<'a, 'b, 'c>(&'a mut Flattener<'b, 'c>);

impl Visitor for Reader<'_, '_, '_> {
    fn term(&mut self, term: &mut Term) {
        if let TermKind::Table(table) = &mut term.kind
            && let Points::File { file, sheet: sheet @ None, .. } = &mut table.points
        {
            let Flattener { files, diagnostics, open, place, .. } = &mut *self.0;
            let path = files::beside(open.last().map_or("", String::as_str), &file.text);
            *sheet = files.sheet(&path, place.unwrap_or(file.span), file.span, diagnostics);
        }
        term.parts_mut().into_iter().for_each(|part| self.term(part));
    }

    fn target(&mut self, _: &mut Target) {}

    fn body(&mut self, _: &[Name], body: &mut Term) {
        self.term(body);
    }
}
