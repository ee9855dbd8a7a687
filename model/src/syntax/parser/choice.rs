//! What is asked for beside the scenes of a file.

use super::Parser;
use crate::diagnostic::Diagnostics;
use crate::syntax::tree::{SceneItem, Selection};
use crate::token::Token;

/// Changes of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Effects that are switched on, and alternatives that are chosen.
    pub with: Vec<Selection>,
    /// Effects that are switched off.
    pub without: Vec<Selection>,
    /// What it does instead.
    pub items: Vec<SceneItem>,
}

/// Reads `with damping; without coupling; with crank.exact; start w = 1 mm; run time 0 s .. 2 s;`.
pub fn parse_changes(tokens: &[Token], first: u32, diagnostics: &mut Diagnostics) -> Changes {
    let mut parser = Parser::new(tokens, first, diagnostics);
    let mut changes = Changes::default();
    while !parser.at_end() {
        let begin = parser.cursor.at;
        let read = match (parser.take_word("with"), parser.take_word("without")) {
            (true, _) => parser.selected().map(|one| changes.with.push(one)),
            (_, true) => parser.selected().map(|one| changes.without.push(one)),
            _ => parser.item().map(|list| changes.items.extend(list)),
        };
        if read.is_err() {
            parser.skip_statement(begin);
        }
    }
    changes
}

impl Parser<'_> {
    fn selected(&mut self) -> super::Read<Selection> {
        let selection = self.selection()?;
        self.operator(";")?;
        Ok(selection)
    }
}
