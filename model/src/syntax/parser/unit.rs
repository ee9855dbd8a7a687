//! Units: `mm`, `[kg m^2/s]`, `[1/(m^2 s^2)]`.

use super::{Parser, Read};
use crate::syntax::tree::{Name, UnitTerm};
use crate::token::TokenKind;

impl Parser<'_> {
    /// The unit of a declaration: one name, a bracket, or `1` for a pure number.
    pub(super) fn declared_unit(&mut self) -> Read<UnitTerm> {
        if self.is_open_ahead(0, '[') {
            return self.bracketed_unit();
        }
        let start = self.here();
        if self
            .cursor
            .ahead(0)
            .is_some_and(|token| token.kind == TokenKind::Number && token.text == "1")
        {
            self.advance();
            return Ok(UnitTerm { span: start, factors: Vec::new() });
        }
        let name = self.name("a unit, as in `: rad` or `: [kg m^2]`")?;
        if self.is_operator("/") || self.is_operator("*") || self.is_operator("^") {
            return self.wrong(
                format!("found {} after a unit", self.found()),
                Some("a unit that is more than one name stands in brackets: `v: [m/s]`"),
            );
        }
        Ok(UnitTerm { span: start, factors: vec![(name, (1, 1))] })
    }

    /// `[kg m^2/s]`
    pub(super) fn bracketed_unit(&mut self) -> Read<UnitTerm> {
        let start = self.here();
        self.open('[')?;
        let mut unit = self.unit_factors()?;
        self.close(']')?;
        unit.span = self.since(start);
        Ok(unit)
    }

    /// The factors inside a bracket. After `/` only the next name or parenthesis is below the line, and nothing may
    /// follow it but another `/`: what `J/kg K` means differs from book to book.
    pub(super) fn unit_factors(&mut self) -> Read<UnitTerm> {
        let start = self.here();
        let mut factors = Vec::new();
        if self
            .cursor
            .ahead(0)
            .is_some_and(|token| token.kind == TokenKind::Number && token.text == "1")
        {
            self.advance();
        }
        let mut divided = false;
        loop {
            if self.take_operator("/") {
                divided = true;
                if self.take_open('(') {
                    let before = factors.len();
                    while !self.is_close(')') {
                        let factor = self.unit_factor(-1)?;
                        factors.push(factor);
                    }
                    if factors.len() == before {
                        return self.expected("a unit");
                    }
                    self.close(')')?;
                } else {
                    let factor = self.unit_factor(-1)?;
                    factors.push(factor);
                }
                continue;
            }
            let _ = self.take_operator("*");
            if !self.is_any_word() {
                break;
            }
            if divided {
                return self.wrong(
                    "it is not clear whether this belongs above or below the line",
                    Some("write what is below in parentheses, as in `J/(kg K)`, or put this before the `/`"),
                );
            }
            let factor = self.unit_factor(1)?;
            factors.push(factor);
        }
        if factors.is_empty() {
            return self.expected("a unit");
        }
        Ok(UnitTerm { span: self.since(start), factors })
    }

    /// A name with its exponent.
    fn unit_factor(&mut self, sign: i8) -> Read<(Name, (i8, i8))> {
        let name = self.name("a unit")?;
        if !self.take_operator("^") {
            return Ok((name, (sign, 1)));
        }
        let exponent = if self.take_open('(') {
            let numerator = self.exponent()?;
            let denominator = if self.take_operator("/") { self.exponent()? } else { 1 };
            self.close(')')?;
            (numerator, denominator)
        } else {
            (self.exponent()?, 1)
        };
        if exponent.1 <= 0 || exponent.0 == 0 {
            return self.wrong_at(
                name.span,
                "this exponent has no meaning",
                Some("an exponent is a whole number or a fraction, as in `m^2` or `m^(1/2)`"),
            );
        }
        Ok((name, (sign * exponent.0, exponent.1)))
    }

    fn exponent(&mut self) -> Read<i8> {
        let minus = self.take_operator("-");
        let number = self
            .cursor
            .ahead(0)
            .filter(|token| token.kind == TokenKind::Number)
            .map(|token| token.text.parse());
        match number {
            Some(Ok(value @ 0..=99_i8)) => {
                self.advance();
                Ok(if minus { -value } else { value })
            }
            _ => self.expected("an exponent, a whole number"),
        }
    }
}
