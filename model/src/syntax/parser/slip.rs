//! What stands in a file as other notations have it, and how it is written here.

use super::Parser;
use super::statement::KEYWORDS;
use crate::nearest::nearest;
use crate::syntax::words::FUNCTIONS;
use crate::token::TokenKind;

/// Words of other notations that begin a statement there, and what says the same here.
const STATEMENTS: &[(&str, &str)] = &[
    ("equation", "an equation of motion begins with `motion`"),
    ("eq", "an equation of motion begins with `motion`"),
    ("constraint", "an equation between positions begins with `closure`"),
    ("energy", "energies are `kinetic` and `potential`"),
    ("lagrangian", "write the energies apart, `kinetic …;` and `potential …;`"),
    ("const", CONSTANT),
    ("constant", CONSTANT),
    ("param", CONSTANT),
    ("var", UNKNOWN),
    ("variable", UNKNOWN),
    ("def", "an abbreviation begins with `let`: `let f(x) = x^2;`"),
    ("fn", "an abbreviation begins with `let`: `let f(x) = x^2;`"),
    ("function", "an abbreviation begins with `let`: `let f(x) = x^2;`"),
    ("input", "a prescribed motion is a `driver`"),
    ("event", "an event is `when x falls { set dot(x) = 0; }`"),
    ("start", "start values stand in a scene: `scene s { start x = 1 m; run time 0 s .. 1 s; }`"),
    ("run", "what is done stands in a scene: `scene s { run time 0 s .. 1 s; }`"),
    ("set", "an event sets what jumps: `when x falls { set dot(x) = 0; }`"),
    ("print", "what is reported is an `output`"),
    ("plot", "what is reported is an `output`"),
    ("assert", "a condition on constants is a `require`, a published fact an `expect`"),
    ("include", "a mechanism of another file is a `part`"),
    ("import", "a mechanism of another file is a `part`"),
];

const CONSTANT: &str = "a constant is a `parameter`, one that is made and toleranced a `dimension`";
const UNKNOWN: &str = "an unknown is a `coordinate` with an equation of second order, or a `state`";

/// The hint for a word that begins no statement.
pub(super) fn statement(word: &str, is_definition: bool) -> String {
    if let Some((_, hint)) = STATEMENTS.iter().find(|(other, _)| *other == word) {
        return (*hint).to_owned();
    }
    match nearest(word, KEYWORDS.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if is_definition => format!("an abbreviation begins with `let`: `let {word} = …;`"),
        None => format!("a statement begins with one of {}", KEYWORDS.join(", ")),
    }
}

impl Parser<'_> {
    /// How what stands here is written.
    pub(super) fn slip(&self) -> Option<&'static str> {
        let next = self.cursor.ahead(0)?;
        match next.kind {
            TokenKind::Other if next.text == "'" => {
                Some("a derivative is `dot(x)`, a second one `ddot(x)`")
            }
            TokenKind::Word => self.word_slip(&next.text),
            TokenKind::Number if self.is_behind(',') && self.is_number_behind(2) => {
                Some("a decimal number is written with a point: `1.5`")
            }
            TokenKind::Number if self.is_number_behind(1) => Some(
                "digits stand together, `1000`; a unit that is more than one name stands in brackets, `1500 [1/min]`",
            ),
            TokenKind::Open('[') if self.kind_behind(1) == Some(TokenKind::Text) => {
                Some("the unit stands before the text: `measure top = peak(x) [mm] \"how high\";`")
            }
            TokenKind::Punctuation { character, .. } => self.sign_slip(character),
            _ => None,
        }
    }

    fn word_slip(&self, word: &str) -> Option<&'static str> {
        Some(match word {
            "rises" | "falls" | "crosses" => {
                "an event gets a name where it is declared, `when hit: x falls …`, and is counted by it: `count(hit)`"
            }
            "and" | "or" | "not" => "conditions are joined by `&&` and `||`; `!` negates one",
            "if" | "then" | "else" => {
                "a value that depends on a condition is `if c { x } else { y }`"
            }
            "in" => {
                "the unit in which something is printed stands in brackets: `output y = x [mm];`"
            }
            _ if self.is_function_behind() => {
                "the argument of a function stands in parentheses: `sin(x)`"
            }
            _ => return None,
        })
    }

    fn sign_slip(&self, character: char) -> Option<&'static str> {
        Some(match character {
            '|' => "an absolute value is `abs(x)`",
            '?' => "a value that depends on a condition is `if c { x } else { y }`",
            '%' => "write 10 % as `0.1`",
            '#' => "a comment begins with `//`",
            ':' => "a value follows `=`, and its unit stands behind the number: `a = 3 m`",
            '*' if self.is_behind('*') || self.is_operator("**") => "a power is written with `^`",
            _ => return None,
        })
    }

    /// Whether the token before is this sign.
    fn is_behind(&self, wanted: char) -> bool {
        let is_wanted =
            |kind| matches!(kind, TokenKind::Punctuation { character, .. } if character == wanted);
        self.kind_behind(1).is_some_and(is_wanted)
    }

    fn is_number_behind(&self, count: usize) -> bool {
        self.kind_behind(count) == Some(TokenKind::Number)
    }

    fn is_function_behind(&self) -> bool {
        let token = self.cursor.behind(1);
        token.is_some_and(|token| FUNCTIONS.contains(&token.text.as_str()))
    }

    fn kind_behind(&self, count: usize) -> Option<TokenKind> {
        self.cursor.behind(count).map(|token| token.kind)
    }
}
