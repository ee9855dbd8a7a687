//! The equations of a mechanism as they stand in its file: closures, motions of drivers and coordinates, energies, forces,
//! events and parts, inside the blocks to which they belong. All else is left out.

use assur::registry::Mechanism;
use assur_model::diagnostic::Diagnostics;
use assur_model::lexer::{self, Lexed};
use assur_model::syntax::parser;
use assur_model::syntax::tree::{Alternative, Statement, StatementKind};
use assur_model::token::{Span, TokenKind};

/// Spaces of a level of blocks.
const INDENT: usize = 4;

/// The equations, each line ended; of a mechanism without a file those of its scenes, each once.
pub fn excerpt(mechanism: &Mechanism) -> String {
    match read(mechanism.text) {
        Some(lines) => lines.into_iter().map(|line| line + "\n").collect(),
        None => of_scenes(mechanism),
    }
}

fn read(text: &str) -> Option<Vec<String>> {
    let lexed = lexer::lex_file(text).ok()?;
    let file = parser::parse(&lexed.tokens, 0, &mut Diagnostics::default())?;
    let mut excerpt = Excerpt { text, lexed, lines: Vec::new() };
    excerpt.statements(&file.statements, 0);
    Some(excerpt.lines)
}

fn of_scenes(mechanism: &Mechanism) -> String {
    let equations = mechanism.scenes.iter().flat_map(|scene| scene.equations);
    let mut lines: Vec<String> = Vec::new();
    for equation in equations {
        let line = format!("{};\n", equation.text);
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines.concat()
}

/// Whether a statement is an equation, or has one inside it.
fn is_kept(statement: &Statement) -> bool {
    match &statement.kind {
        StatementKind::Closure { .. }
        | StatementKind::Driver(_)
        | StatementKind::Energy { .. }
        | StatementKind::Force { .. }
        | StatementKind::Hold { .. }
        | StatementKind::Motion { .. }
        | StatementKind::Part { .. }
        | StatementKind::When(_) => true,
        other => other.blocks().into_iter().flatten().any(is_kept),
    }
}

/// Whether nothing of a statement is left out.
fn is_whole(statement: &Statement) -> bool {
    let blocks = statement.kind.blocks();
    let mut inside = blocks.into_iter().flatten();
    is_kept(statement) && inside.all(is_whole)
}

/// An excerpt under construction.
struct Excerpt<'a> {
    text: &'a str,
    lexed: Lexed,
    lines: Vec<String>,
}

impl Excerpt<'_> {
    fn statements(&mut self, list: &[Statement], depth: usize) {
        let mut before = None;
        for statement in list.iter().filter(|statement| is_kept(statement)) {
            // The members of a list are statements with the span of the list.
            if before != Some(statement.span) {
                self.statement(statement, depth);
            }
            before = Some(statement.span);
        }
    }

    fn statement(&mut self, statement: &Statement, depth: usize) {
        let source = self.source(statement.span);
        if statement.kind.blocks().is_empty() || (is_whole(statement) && !source.contains('\n')) {
            self.verbatim(statement.span, depth);
            return;
        }
        self.open(statement.span.first, depth);
        match &statement.kind {
            StatementKind::Effect { body, otherwise, .. }
            | StatementKind::If { then: body, otherwise, .. } => {
                self.statements(body, depth + 1);
                if otherwise.iter().any(is_kept) {
                    self.line(depth, "} else {");
                    self.statements(otherwise, depth + 1);
                }
            }
            StatementKind::Choice { alternatives, .. } => {
                alternatives.iter().for_each(|one| self.alternative(one, depth + 1));
            }
            other => other.blocks().into_iter().for_each(|body| self.statements(body, depth + 1)),
        }
        self.line(depth, "}");
    }

    fn alternative(&mut self, alternative: &Alternative, depth: usize) {
        if alternative.body.iter().any(is_kept) {
            self.open(alternative.name.span.first, depth);
            self.statements(&alternative.body, depth + 1);
            self.line(depth, "}");
        }
    }

    /// What stands before a block, from a token to the brace that opens it.
    fn open(&mut self, first: u32, depth: usize) {
        let tokens = self.lexed.tokens.iter().enumerate().skip(first as usize);
        let mut braces = tokens.filter(|(_, token)| token.kind == TokenKind::Open('{'));
        let last = braces.next().map_or(first, |(index, _)| index as u32);
        let header = self.source(Span { first, last });
        let header = header.split_whitespace().collect::<Vec<_>>().join(" ");
        self.line(depth, &header);
    }

    /// A statement as it stands in the file.
    fn verbatim(&mut self, span: Span, depth: usize) {
        let source = self.source(span).to_owned();
        let column = self.column(span);
        for (index, line) in source.lines().enumerate() {
            let spaces = line.len() - line.trim_start_matches(' ').len();
            let cut = if index == 0 { 0 } else { spaces.min(column) };
            self.line(depth, line[cut..].trim_end());
        }
    }

    fn line(&mut self, depth: usize, text: &str) {
        self.lines.push(format!("{:1$}{text}", "", depth * INDENT));
    }

    fn source(&self, span: Span) -> &str {
        let place = |index: u32| self.lexed.ranges.get(index as usize).cloned();
        match (place(span.first), place(span.last)) {
            (Some(first), Some(last)) => &self.text[first.start..last.end],
            _ => "",
        }
    }

    /// How far a statement stands from the beginning of its line.
    fn column(&self, span: Span) -> usize {
        let start = self.lexed.ranges.get(span.first as usize).map_or(0, |range| range.start);
        let before = &self.text[..start];
        start - before.rfind('\n').map_or(0, |end| end + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(statements: &str, expected: &str) {
        let text = format!("assur::mechanism! {{\n    M;\n    {statements}\n}}");
        assert_eq!(read(&text).expect("a file").join("\n"), expected);
    }

    #[test]
    fn equations_are_as_written() {
        check("let a = 1; kinetic  m*v^2 / 2; // half", "kinetic  m*v^2 / 2;");
        check("force F on x, G on y;", "force F on x, G on y;");
        check("closure one:\n        a\n        = b;", "closure one:\n    a\n    = b;");
    }

    #[test]
    fn blocks_stand_around_them() {
        check(
            "effect bends \"it bends\" { parameter c = 1; potential c*x^2/2; } else { let x = 0; }",
            "effect bends \"it bends\" {\n    potential c*x^2/2;\n}",
        );
        check(
            "choice rod { long { let l = 2; } elastic \"e\" { let l = 1; kinetic l; } }",
            "choice rod {\n    elastic \"e\" {\n        kinetic l;\n    }\n}",
        );
        check("for k in 1..3 { kinetic v[k]; }", "for k in 1..3 { kinetic v[k]; }");
        check(
            "if a { let b = 1; } else { force F on x; }",
            "if a {\n} else {\n    force F on x;\n}",
        );
    }
}
