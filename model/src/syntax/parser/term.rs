//! Expressions, by precedence climbing.

use super::cursor::within;
use super::statement::KEYWORDS;
use super::{DEPTH, Parser, Read};
use crate::syntax::tree::{BinaryOperator, Name, Term, TermKind, UnaryOperator, UnitTerm};
use crate::token::TokenKind;

/// Operators with their binding power, longest first where one begins another.
const OPERATORS: &[(&str, BinaryOperator, u8)] = &[
    ("||", BinaryOperator::Or, 1),
    ("&&", BinaryOperator::And, 2),
    ("<=", BinaryOperator::LessEqual, 3),
    (">=", BinaryOperator::GreaterEqual, 3),
    ("==", BinaryOperator::Equal, 3),
    ("!=", BinaryOperator::NotEqual, 3),
    ("<", BinaryOperator::Less, 3),
    (">", BinaryOperator::Greater, 3),
    ("+", BinaryOperator::Add, 4),
    ("-", BinaryOperator::Subtract, 4),
    ("*", BinaryOperator::Multiply, 5),
    ("/", BinaryOperator::Divide, 5),
];

/// Most operands that operators of one strength may join without brackets.
const CHAIN: usize = 2000;

/// Words that go on with the statement after a number, so that they are no units.
const NOT_UNITS: &[&str] = &[
    "in",
    "on",
    "normal",
    "uniform",
    "truncated",
    "lognormal",
    "over",
    "else",
    "weight",
    "rises",
    "falls",
    "crosses",
    "if",
    // Words of other notations, which are answered where they stand.
    "then",
    "and",
    "or",
    "to",
];

impl Parser<'_> {
    /// An expression.
    pub(super) fn term(&mut self) -> Read<Term> {
        self.deeper(|parser| parser.binary(1))
    }

    fn binary(&mut self, least: u8) -> Read<Term> {
        let mut left = self.unary()?;
        for _ in 0..CHAIN {
            if self.is_operator("+/") && self.is_operator_ahead(2, "-") {
                return self
                    .wrong("a tolerance begins with `+-`", Some("write `75 mm +- 0.05 mm`"));
            }
            if self.is_operator("**") {
                return self.wrong("a power is written with `^`", Some("write `x^2`"));
            }
            // `+-` begins a tolerance, `->` says what follows an event.
            if self.is_operator("+-") || self.is_operator("->") {
                return Ok(left);
            }
            let found = OPERATORS.iter().find(|(text, ..)| self.is_operator(text));
            let Some((text, operator, power)) = found.filter(|(_, _, power)| *power >= least)
            else {
                return Ok(left);
            };
            self.cursor.at += text.len();
            let right = self.binary(power + 1)?;
            if *power == 3 && OPERATORS[2..8].iter().any(|(text, ..)| self.is_operator(text)) {
                return self.wrong(
                    "comparisons cannot be chained",
                    Some("join two with `&&`, as in `a < b && b < c`"),
                );
            }
            left = Term {
                span: left.span.to(right.span),
                kind: TermKind::Binary(*operator, Box::new(left), Box::new(right)),
            };
        }
        self.wrong(
            format!("this joins more than {CHAIN} operands"),
            Some("give parts of it names with `let`, or write a `sum`"),
        )
    }

    fn unary(&mut self) -> Read<Term> {
        let start = self.here();
        let operator = match () {
            () if self.take_operator("-") => UnaryOperator::Negate,
            () if self.is_operator("!") && !self.is_operator("!=") => {
                self.advance();
                UnaryOperator::Not
            }
            () if self.is_operator("+") => {
                return self.wrong("a sign `+` is not needed here", Some("take it away"));
            }
            () => return self.power(),
        };
        let inner = self.deeper(Self::unary)?;
        Ok(Term { span: start.to(inner.span), kind: TermKind::Unary(operator, Box::new(inner)) })
    }

    fn power(&mut self) -> Read<Term> {
        let base = self.primary()?;
        if !self.is_operator("^") {
            return Ok(base);
        }
        if let TermKind::Number { value, unit: Some(unit) } = &base.kind
            && unit.span.first == unit.span.last
            // In parentheses it is clear.
            && unit.span.last == base.span.last
        {
            let name = &unit.factors[0].0.text;
            let hint = format!(
                "write `{value} [{name}^2]` for the unit {name}^2, or `({value} {name})^2` for the power of the quantity"
            );
            return self
                .wrong("it is not clear whether the unit or the quantity is raised", Some(&hint));
        }
        self.advance();
        let exponent = self.deeper(Self::unary)?;
        Ok(Term {
            span: base.span.to(exponent.span),
            kind: TermKind::Binary(BinaryOperator::Power, Box::new(base), Box::new(exponent)),
        })
    }

    fn primary(&mut self) -> Read<Term> {
        let start = self.here();
        let Some(token) = self.cursor.ahead(0) else {
            return self.expected("an expression");
        };
        let kind = match token.kind {
            TokenKind::Number => return self.number(""),
            _ if self.is_operator(".") && !self.is_operator("..") && self.is_number_ahead(1) => {
                self.advance();
                return self.number("0.");
            }
            TokenKind::Open('(') => {
                self.advance();
                let mut inner = self.term()?;
                self.close(')')?;
                inner.span = self.since(start);
                return Ok(self.members()?.into_iter().fold(inner, member));
            }
            TokenKind::Open('[') => {
                self.advance();
                let items = self.list(']')?;
                TermKind::Vector(items)
            }
            TokenKind::Word if token.text == "if" => return self.branch(),
            TokenKind::Word => return self.named(),
            _ => return self.expected("an expression"),
        };
        Ok(Term { span: self.since(start), kind })
    }

    /// Items between commas, up to the closing bracket.
    fn list(&mut self, bracket: char) -> Read<Vec<Term>> {
        let mut items = Vec::new();
        while !self.is_close(bracket) {
            items.push(self.term()?);
            if !self.take_operator(",") {
                break;
            }
        }
        self.close(bracket)?;
        Ok(items)
    }

    fn is_number_ahead(&self, count: usize) -> bool {
        let token = self.cursor.ahead(count);
        token.is_some_and(|token| token.kind == TokenKind::Number)
    }

    /// A number with its unit; `before` is what is left out before its first digit.
    fn number(&mut self, before: &str) -> Read<Term> {
        let start = match before.is_empty() {
            true => self.here(),
            false => self.before(),
        };
        let text = self.cursor.ahead(0).map_or("", |token| token.text.as_str());
        let text = format!("{before}{text}");
        let (digits, suffix) = split(&text);
        let Ok(value) = digits.replace('_', "").parse::<f64>() else {
            return self.wrong(
                format!("`{text}` is not a number"),
                Some("numbers are decimal, as in `0.5` or `2.1e11`"),
            );
        };
        if !value.is_finite() {
            return self.wrong(format!("`{text}` is too large for a number"), None);
        }
        let suffix = (!suffix.is_empty()).then(|| Name { text: suffix.to_string(), span: start });
        self.advance();
        let unit = match suffix {
            Some(name) => Some(UnitTerm { span: start, factors: vec![(name, (1, 1))] }),
            None if self.is_open_ahead(0, '[') => Some(self.bracketed_unit()?),
            None => self.following_unit(),
        };
        let keyword = self.cursor.ahead(0).filter(|token| KEYWORDS.contains(&token.text.as_str()));
        if let (true, Some(keyword)) = (unit.is_some(), keyword)
            && keyword.text.len() > 2
            && !NOT_UNITS.contains(&keyword.text.as_str())
        {
            let message = format!("a `;` is missing before `{}`", keyword.text);
            return self.wrong(message, Some("a statement ends with `;`"));
        }
        if unit.is_some() && self.is_any_word() && !NOT_UNITS.iter().any(|word| self.is_word(word))
        {
            return self.wrong(
                format!("found {} after a unit", self.found()),
                self.slip().or(Some(
                    "a compound unit stands in brackets, as in `0.1 [kg m^2]`; a product needs `*`",
                )),
            );
        }
        Ok(Term { span: self.since(start), kind: TermKind::Number { value, unit } })
    }

    /// One unit name directly after a number.
    fn following_unit(&mut self) -> Option<UnitTerm> {
        if !self.is_any_word() || NOT_UNITS.iter().any(|word| self.is_word(word)) {
            return None;
        }
        let span = self.here();
        let name = self.name("a unit").ok()?;
        Some(UnitTerm { span, factors: vec![(name, (1, 1))] })
    }

    /// A name, perhaps of a part, with an index or arguments.
    fn named(&mut self) -> Read<Term> {
        let name = self.name("a name")?;
        let start = name.span;
        let members = self.members()?;
        if members.is_empty() || self.is_open_ahead(0, '(') || self.is_indexed() {
            let name = members.iter().fold(name, within);
            return self.applied(name);
        }
        let term = Term { span: start, kind: TermKind::Name(name.text) };
        Ok(members.into_iter().fold(term, member))
    }

    /// A name with an index, arguments or neither.
    fn applied(&mut self, name: Name) -> Read<Term> {
        let start = name.span;
        let term = if self.is_open_ahead(0, '(') {
            self.call(name)?
        } else if self.is_indexed() {
            let index = Box::new(self.index()?);
            Term { span: self.since(start), kind: TermKind::Index { name, index } }
        } else {
            Term { span: start, kind: TermKind::Name(name.text) }
        };
        Ok(self.members()?.into_iter().fold(term, member))
    }

    /// The names behind dots.
    fn members(&mut self) -> Read<Vec<Name>> {
        let mut members = Vec::new();
        while self.is_operator(".") && !self.is_operator("..") {
            if members.len() >= DEPTH {
                return self.wrong(format!("more than {DEPTH} names follow each other"), None);
            }
            self.advance();
            members.push(self.name("a name after `.`")?);
        }
        Ok(members)
    }

    /// Whether an index follows.
    fn is_indexed(&self) -> bool {
        self.is_open_ahead(0, '[') && (!self.in_output || self.is_index())
    }

    /// Whether the bracket that follows a name holds an index: whole numbers and indices of repetitions, nothing else.
    /// Else it is the unit of an output.
    fn is_index(&self) -> bool {
        let mut ahead = 1;
        while let Some(token) = self.cursor.ahead(ahead) {
            match token.kind {
                TokenKind::Close(']') => return ahead > 1,
                TokenKind::Word if !self.indices.contains(&token.text) => return false,
                TokenKind::Punctuation { character: '/' | '^', .. } => return false,
                _ => ahead += 1,
            }
        }
        false
    }

    /// `[k + 1]`
    pub(super) fn index(&mut self) -> Read<Term> {
        self.open('[')?;
        let index = self.term()?;
        self.close(']')?;
        Ok(index)
    }

    fn call(&mut self, name: Name) -> Read<Term> {
        let start = name.span;
        self.open('(')?;
        if name.text == "sum" && self.is_any_word() && self.is_word_ahead(1, "in") {
            let index = self.name("an index")?;
            self.advance();
            let (from, to) = self.range()?;
            self.operator(",")?;
            self.indices.push(index.text.clone());
            let body = self.term();
            self.indices.pop();
            let body = Box::new(body?);
            self.close(')')?;
            let kind = TermKind::Sum { index, from: Box::new(from), to: Box::new(to), body };
            return Ok(Term { span: self.since(start), kind });
        }
        if name.text == "solve" && self.is_any_word() && self.is_word_ahead(1, "in") {
            return self.equation_to_solve(name);
        }
        if name.text == "table" {
            return self.table(start);
        }
        let in_output = std::mem::replace(&mut self.in_output, false);
        let arguments = self.call_arguments(&name);
        self.in_output = in_output;
        Ok(Term { kind: arguments?, span: self.since(start) })
    }

    /// `a .. b`, both ends included.
    pub(super) fn range(&mut self) -> Read<(Term, Term)> {
        let from = self.term()?;
        if !self.is_operator("..") {
            return self.wrong(
                format!("found {}, expected `..`", self.found()),
                Some("a range is written `a .. b`: `for k in 1..5 { … }`, `run time 0 s .. 1 s;`"),
            );
        }
        Ok((from, self.far_end()?))
    }

    /// `if c { x } else { y }`
    fn branch(&mut self) -> Read<Term> {
        let start = self.here();
        self.advance();
        let condition = self.term()?;
        let then = self.block_of_term()?;
        if !self.take_word("else") {
            return self.wrong(
                "an `if` inside an expression needs its `else`",
                Some("write `if c { x } else { y }`"),
            );
        }
        let otherwise =
            if self.is_word("if") { self.deeper(Self::branch)? } else { self.block_of_term()? };
        let kind = TermKind::If {
            condition: Box::new(condition),
            then: Box::new(then),
            otherwise: Box::new(otherwise),
        };
        Ok(Term { span: self.since(start), kind })
    }

    fn block_of_term(&mut self) -> Read<Term> {
        if !self.take_open('{') {
            return self.wrong(
                format!("found {}, expected `{{`", self.found()),
                Some("write `if c { x } else { y }`"),
            );
        }
        let term = self.term()?;
        self.close('}')?;
        Ok(term)
    }
}

/// `base.name`
fn member(base: Term, name: Name) -> Term {
    Term { span: base.span.to(name.span), kind: TermKind::Member { base: Box::new(base), name } }
}

/// Digits and suffix of a number literal: `75mm` is 75 and `mm`.
fn split(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let exponent = matches!(bytes[end], b'e' | b'E')
            && match bytes.get(end + 1) {
                Some(b'+' | b'-') => bytes.get(end + 2).is_some_and(u8::is_ascii_digit),
                other => other.is_some_and(|byte| byte.is_ascii_digit()),
            };
        let sign = matches!(bytes[end], b'+' | b'-')
            && matches!(bytes.get(end.wrapping_sub(1)), Some(b'e' | b'E'));
        if !(bytes[end].is_ascii_digit() || matches!(bytes[end], b'.' | b'_') || exponent || sign) {
            break;
        }
        end += 1;
    }
    text.split_at(end)
}
