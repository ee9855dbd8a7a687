//! The body of an emitted function: the statements that lead to some values of the program.
//!
//! What the file names becomes a `let` of that name. A nameless value that is read once is written where it is read,
//! as long as that stays short. A long body is written in nested blocks, because rustc is slow on long scopes and in
//! debug builds fails on them.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{Input, Level, OperationKind, Stage, Value};
use proc_macro2::TokenStream;
use quote::quote;

use crate::blocks::BLOCK;
use crate::expression::{self, Expression};
use crate::layout::Layout;

/// Where a function stands, and so what it finds computed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// A method of the parameter struct.
    Parameters,
    /// A method of the equations that is given `time`, and perhaps `state`.
    Time,
    /// A method of the equations that is given an `instant` and the `state`, or the `position` of a linkage.
    Evaluation,
    /// A function that is given the `values` of the constants.
    Values,
    /// A method of the loops that is given the `independents` and the `motion`.
    Independents,
    /// A method of the parameter struct that is given the `time`.
    Drive,
}

/// A statement with what it defines and what it reads.
struct Statement {
    tokens: TokenStream,
    defines: Vec<Value>,
    reads: BTreeSet<Value>,
}

/// Statements, and the expressions that are written where they are read.
pub struct Body<'a> {
    layout: &'a Layout<'a>,
    place: Scope,
    statements: Vec<Statement>,
    written: BTreeMap<Value, Expression>,
}

impl<'a> Body<'a> {
    /// The statements that lead to the wanted values; with `named`, each of those gets a name of its own.
    pub fn new(layout: &'a Layout<'a>, place: Scope, wanted: &[Value], named: &[Value]) -> Self {
        let all: Vec<Value> = wanted.iter().chain(named).copied().collect();
        Self::with_given(layout, place, &all, named, BTreeMap::new())
    }

    /// A body where some values are already there.
    pub fn with_given(
        layout: &'a Layout<'a>,
        place: Scope,
        wanted: &[Value],
        named: &[Value],
        given: BTreeMap<Value, Expression>,
    ) -> Self {
        let mut body = Self { layout, place, statements: Vec::new(), written: given };
        let program = layout.program();
        let needed = program.needed(wanted, &|value| body.outside(value).is_some());
        let read: Vec<Value> = wanted.iter().chain(named).copied().collect();
        let short = program.written(&needed, &read);
        for Level { mut before, batch } in program.levels(&needed) {
            before.sort_by_key(|value| body.input_order(*value));
            for value in before {
                body.state(value, short.contains(&value));
            }
            body.state_sines(&batch);
        }
        body
    }

    /// Writes a product for a column: the values from those that do not change with it, which have a name here.
    pub fn beside(&self, steady: &[Value], products: &[Value]) -> TokenStream {
        let given = steady.iter().map(|value| (*value, self.expression(*value)));
        let inner = Self::with_given(self.layout, self.place, products, &[], given.collect());
        let (statements, values) =
            (inner.statements(products), products.iter().map(|value| inner.value(*value)));
        quote!(#statements *product_ = [#(#values),*];)
    }

    /// Components of the state come first, in their order; the sort is stable.
    fn input_order(&self, value: Value) -> u32 {
        match self.kind(value) {
            OperationKind::Input(Input::State(index)) => *index,
            _ => u32::MAX,
        }
    }

    fn kind(&self, value: Value) -> &'a OperationKind {
        self.layout.program().kind(value)
    }

    /// The text of a value that is there already.
    fn outside(&self, value: Value) -> Option<Expression> {
        if let Some(given) = self.written.get(&value) {
            return Some(given.clone());
        }
        let operation = &self.layout.program().operations[value.0 as usize];
        let name = self.layout.names.of(value);
        let stored = match (&operation.kind, self.place, operation.stage) {
            (OperationKind::Number(_), _, _) => return None,
            (OperationKind::Input(Input::Time), Scope::Time | Scope::Drive, _) => quote!(time),
            (_, Scope::Parameters | Scope::Values | Scope::Drive, _) => return None,
            (OperationKind::Input(Input::Position(place)), ..) => {
                let place = expression::size(*place as usize);
                quote!(position[#place])
            }
            (OperationKind::Input(Input::Mode(_)), ..) => quote!(mode),
            (_, _, Stage::Constant | Stage::Parameter) => {
                let owner = self.layout.owner();
                quote!(#owner.#name)
            }
            (_, Scope::Evaluation, Stage::Instant)
                if self.layout.staging.timed.contains(&value) =>
            {
                self.layout.read_row(value)
            }
            _ => return None,
        };
        Some(Expression::whole(stored))
    }

    /// The text of a value where it is read.
    fn expression(&self, value: Value) -> Expression {
        if let OperationKind::Number(number) = self.kind(value) {
            return expression::scalar(*number);
        }
        self.outside(value).unwrap_or_else(|| {
            let name = self.layout.names.of(value);
            Expression { reads: BTreeSet::from([value]), ..Expression::whole(quote!(#name)) }
        })
    }

    /// The text of a wanted value.
    pub fn value(&self, value: Value) -> TokenStream {
        self.expression(value).tokens
    }

    /// Adds the statement for an operation, or keeps it to be written where it is read.
    fn state(&mut self, value: Value, is_short: bool) {
        let text = match self.kind(value) {
            OperationKind::Number(_) => return,
            OperationKind::Input(input) => self.input(*input),
            kind => expression::operation(kind, &|operand| self.expression(operand)),
        };
        if is_short {
            self.written.insert(value, text);
        } else {
            let (name, tokens) = (self.layout.names.of(value), &text.tokens);
            let tokens = quote!(let #name = #tokens;);
            self.statements.push(Statement { tokens, defines: vec![value], reads: text.reads });
        }
    }

    fn input(&self, input: Input) -> Expression {
        Expression::whole(match input {
            Input::Parameter(index) if self.place == Scope::Values => {
                let index = expression::size(index as usize);
                quote!(values[#index])
            }
            Input::Parameter(index) => {
                let field = &self.layout.constants[index as usize];
                quote!(<S as ::assur::scalar::Scalar>::from_f64(self.#field))
            }
            Input::Time if self.place == Scope::Independents => {
                let last = expression::size(2 * self.layout.scene.drivers.len());
                quote!(motion[#last])
            }
            Input::Time => quote!(time),
            Input::Driver(index) => {
                let (index, count) = (index as usize, self.layout.scene.drivers.len());
                let place = expression::size(index % count);
                match index < count {
                    true => quote!(independents[#place]),
                    false => {
                        let place = expression::size(index - count);
                        quote!(motion[#place])
                    }
                }
            }
            Input::Position(place) => {
                let place = expression::size(place as usize);
                quote!(position[#place])
            }
            Input::Mode(_) => quote!(mode),
            Input::Side(index) => {
                let index = expression::size(index as usize);
                quote!(phase.side(#index))
            }
            Input::Measured(index) => {
                let index = expression::size(index as usize);
                quote!(found[#index])
            }
            Input::State(index) => {
                let index = expression::size(index as usize);
                quote!(state[#index])
            }
            // Of a line only, which is written as a whole.
            Input::Captured(_) | Input::Place => TokenStream::new(),
            Input::Change(index) => {
                let index = expression::size(index as usize);
                quote!(column_[#index])
            }
        })
    }

    /// Adds the statement that takes the sines and cosines of a batch.
    fn state_sines(&mut self, batch: &[Value]) {
        let pairs = self.layout.program().pairs(batch);
        let name = |value: &Option<Value>| match value {
            Some(value) => {
                let name = self.layout.names.of(*value);
                quote!(#name)
            }
            None => quote!(_),
        };
        let angles: Vec<Expression> =
            pairs.iter().map(|pair| self.expression(pair.angle)).collect();
        let texts: Vec<&TokenStream> = angles.iter().map(|angle| &angle.tokens).collect();
        let sines: Vec<_> = pairs.iter().map(|pair| name(&pair.sine)).collect();
        let cosines: Vec<_> = pairs.iter().map(|pair| name(&pair.cosine)).collect();
        let tokens = match pairs.len() {
            0 => return,
            1 => quote!(let (#(#sines)*, #(#cosines)*) = S::sin_cos(#(#texts)*);),
            _ => quote!(let ([#(#sines),*], [#(#cosines),*]) = S::sin_cos_all([#(#texts),*]);),
        };
        let reads = angles.into_iter().flat_map(|angle| angle.reads).collect();
        self.statements.push(Statement { tokens, defines: batch.to_vec(), reads });
    }

    /// The statements, in blocks when they are many. `wanted` are the values read after them.
    pub fn statements(&self, wanted: &[Value]) -> TokenStream {
        if self.statements.len() <= BLOCK {
            return self.statements.iter().map(|statement| statement.tokens.clone()).collect();
        }
        let mut read_later: BTreeSet<Value> =
            wanted.iter().flat_map(|value| self.expression(*value).reads).collect();
        let mut blocks = Vec::new();
        for block in self.statements.chunks(BLOCK).rev() {
            let kept: Vec<_> = block
                .iter()
                .flat_map(|statement| &statement.defines)
                .filter(|value| read_later.contains(value))
                .map(|value| self.layout.names.of(*value))
                .collect();
            let inner = block.iter().map(|statement| &statement.tokens);
            blocks.push(quote!(let (#(#kept,)*) = { #(#inner)* (#(#kept,)*) };));
            read_later.extend(block.iter().flat_map(|statement| statement.reads.iter().copied()));
        }
        blocks.into_iter().rev().collect()
    }
}
