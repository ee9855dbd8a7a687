//! The Taylor series of a motion, as the model says how its terms follow from each other.

use std::collections::BTreeMap;

use assur_model::program::{Function, Input, OperationKind, Pair, Series, Step, Value};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::expression::{self, Expression, scalar, size};
use crate::layout::{Layout, outlined};

/// The method of `Equations`; none where the equations are too long in all modes.
pub fn method(layout: &Layout<'_>) -> Option<TokenStream> {
    let bodies: Vec<Option<TokenStream>> = layout.each_mode().iter().map(body).collect();
    if bodies.iter().all(Option::is_none) {
        return None;
    }
    let body = match bodies.as_slice() {
        [Some(body)] if layout.modes.is_empty() => body.clone(),
        _ => {
            let modes = layout.modes.iter().zip(bodies).enumerate();
            let arms = modes.filter_map(|(index, (mode, body))| {
                let (index, body) = (size(index), mode.owning(outlined(body?)));
                Some(quote!(#index => { #body }))
            });
            quote!(match phase.mode { #(#arms)* _ => false })
        }
    };
    Some(quote! {
        #[inline(never)]
        fn series(&self, phase: ::assur::problem::Phase<'_, S>, time: S, length: S, rows: &mut [S]) -> bool {
            if !S::SINGLE {
                return false;
            }
            #body
        }
    })
}

/// What it does in a mode; none where the equations are too long.
fn body(layout: &Layout<'_>) -> Option<TokenStream> {
    let rates = &layout.program().results.derivative;
    if rates.is_empty() {
        return Some(quote!(true));
    }
    let series = layout.program().series(rates)?;
    let writer = Writer::new(layout, &series, rates)?;
    let (makers, statements) = (&writer.makers, &writer.statements);
    let values = rates.iter().map(|value| writer.term(*value));
    let states = size(layout.states());
    Some(quote! {
        let (rows_, _) = rows.as_chunks_mut::<#states>();
        #(#makers)*
        for k_ in 0..rows_.len().saturating_sub(1).min(::assur::series::TERMS) {
            let state = rows_[k_];
            let one_: S = ::assur::series::one(k_);
            #(#statements)*
            let step_ = length * ::assur::series::inverse(k_ + 1);
            let rates_ = [#(#values),*];
            for (next_, rate_) in rows_[k_ + 1].iter_mut().zip(rates_) {
                *next_ = step_ * rate_;
            }
        }
        true
    })
}

/// The statements of one order, and before all orders those that make what remembers the terms.
struct Writer<'a> {
    layout: &'a Layout<'a>,
    series: &'a Series<'a>,
    makers: Vec<TokenStream>,
    statements: Vec<TokenStream>,
    /// Values that are written where they are read.
    written: BTreeMap<Value, TokenStream>,
}

impl<'a> Writer<'a> {
    fn new(layout: &'a Layout<'a>, series: &'a Series<'a>, wanted: &[Value]) -> Option<Self> {
        let mut writer = Self {
            layout,
            series,
            makers: Vec::new(),
            statements: Vec::new(),
            written: BTreeMap::new(),
        };
        for step in series.steps(wanted) {
            let statement = match step {
                Step::Decided(value) => writer.decided(value),
                Step::Pair(pair, is_even) => writer.pair(pair, is_even),
                Step::Term(value) => {
                    let (name, text) = (layout.names.of(value), writer.operation(value)?);
                    quote!(let #name = #text;)
                }
                Step::Factor(value) => {
                    let text = writer.operation(value)?;
                    writer.written.insert(value, text);
                    continue;
                }
            };
            writer.statements.push(statement);
        }
        Some(writer)
    }

    /// The statement for a value that the first terms decide.
    fn decided(&mut self, value: Value) -> TokenStream {
        let name = self.layout.names.of(value);
        if let OperationKind::Input(Input::Side(index)) = self.kind(value) {
            let index = size(*index as usize);
            return quote!(let #name = phase.side(#index););
        }
        let first = |operand: Value| {
            let (name, is_constant) =
                (self.layout.names.of(operand), self.series.is_constant(operand));
            Expression::whole(match is_constant {
                true => self.constant(operand),
                false => quote!(#name),
            })
        };
        let text = expression::operation(self.kind(value), &first).tokens;
        let placeholder = self.layout.placeholder(value);
        self.makers.push(quote!(let mut #name = #placeholder;));
        quote!(if k_ == 0 { #name = #text; })
    }

    /// A condition of the first terms, which the statements are to keep.
    fn kept(&mut self, condition: TokenStream) -> Ident {
        let name = format_ident!("kept_{}_", self.makers.len());
        self.makers.push(quote!(let mut #name = S::less(S::ZERO, S::ZERO);));
        self.statements.push(quote!(if k_ == 0 { #name = #condition; }));
        name
    }

    fn kind(&self, value: Value) -> &'a OperationKind {
        self.layout.program().kind(value)
    }

    /// The text of a constant.
    fn constant(&self, value: Value) -> TokenStream {
        match self.kind(value) {
            OperationKind::Number(number) => scalar(*number).tokens,
            _ => {
                let (name, owner) = (self.layout.names.of(value), self.layout.owner());
                quote!(#owner.#name)
            }
        }
    }

    /// The text of a term.
    fn term(&self, value: Value) -> TokenStream {
        let name = self.layout.names.of(value);
        match self.kind(value) {
            OperationKind::Number(0.0) => quote!(S::ZERO),
            OperationKind::Number(1.0) => quote!(one_),
            _ if self.series.is_steady(value) => {
                let steady = self.steady(value);
                quote!(one_ * #steady)
            }
            _ => self.written.get(&value).cloned().unwrap_or(quote!(#name)),
        }
    }

    /// The text of something steady, a condition among them.
    fn steady(&self, value: Value) -> TokenStream {
        match self.series.is_constant(value) {
            true => self.constant(value),
            false => {
                let name = self.layout.names.of(value);
                quote!(#name)
            }
        }
    }

    /// Makes something that remembers terms.
    fn made(&mut self, kind: TokenStream) -> Ident {
        let name = format_ident!("memory_{}_", self.makers.len());
        self.makers.push(quote!(let mut #name = ::assur::series::#kind::default();));
        name
    }

    /// The statement for sine and cosine of an angle.
    fn pair(&mut self, pair: Pair, is_even: bool) -> TokenStream {
        let text = |value: Option<Value>| match value {
            Some(value) => {
                let name = self.layout.names.of(value);
                quote!(#name)
            }
            None => quote!(_),
        };
        let (sine, cosine, term) = (text(pair.sine), text(pair.cosine), self.term(pair.angle));
        let memory = match is_even {
            true => self.made(quote!(Turn)),
            false => self.made(quote!(Sine)),
        };
        quote!(let (#sine, #cosine) = #memory.next(k_, #term);)
    }

    fn product(&mut self, a: Value, b: Value) -> TokenStream {
        let Some((factor, value)) = self.series.scaled(a, b) else {
            let (first, second) = (self.term(a), self.term(b));
            let memory = self.made(quote!(Product));
            return quote!(#memory.next(k_, #first, #second));
        };
        let (factor, term) = (self.steady(factor), self.term(value));
        match self.written.contains_key(&value) {
            true => quote!(#factor * ::assur::series::unless_zero(#factor, || #term)),
            false => quote!(#factor * #term),
        }
    }

    /// The text of the next term of an operation; none where it has no series.
    fn operation(&mut self, value: Value) -> Option<TokenStream> {
        use OperationKind as Kind;
        let read = self.kind(value).operands();
        let terms: Vec<TokenStream> = read.iter().map(|value| self.term(*value)).collect();
        Some(match self.kind(value) {
            Kind::Number(_) | Kind::Factor { .. } | Kind::Search { .. } | Kind::Table { .. } => {
                return None;
            }
            Kind::Input(Input::Time) => quote!(::assur::series::time(k_, time, length)),
            Kind::Input(Input::State(index)) => {
                let index = size(*index as usize);
                quote!(state[#index])
            }
            Kind::Input(_) => return None,
            Kind::Add(..) => quote!(#(#terms)+*),
            Kind::Subtract(..) => quote!(#(#terms)-*),
            Kind::Negate(_) => quote!(-#(#terms)*),
            Kind::Multiply(a, b) => self.product(*a, *b),
            Kind::MultiplyAdd(a, b, c) => {
                let (product, term) = (self.product(*a, *b), self.term(*c));
                quote!(#product + #term)
            }
            Kind::MultiplySubtract(a, b, c) => {
                let (product, term) = (self.product(*a, *b), self.term(*c));
                quote!(#product - #term)
            }
            Kind::NegateMultiplyAdd(a, b, c) => {
                let (product, term) = (self.product(*a, *b), self.term(*c));
                quote!(#term - #product)
            }
            Kind::Divide(_, below) if self.series.is_steady(*below) => {
                let (above, below) = (&terms[0], self.steady(*below));
                quote!(#above / #below)
            }
            Kind::Divide(..) => {
                let memory = self.made(quote!(Quotient));
                quote!(#memory.next(k_, #(#terms),*))
            }
            Kind::Call(function, _) => self.call(*function, &read, &terms)?,
            Kind::Compare(..) | Kind::And(..) | Kind::Or(..) | Kind::Not(_) => return None,
            Kind::Select { condition, .. } => {
                let (condition, terms) = (self.steady(*condition), &terms[1..]);
                quote!(S::select(#condition, #(#terms),*))
            }
            Kind::Solve { factor, right } => self.solve(*factor, right),
            Kind::Element { solution, index } => {
                let (solution, index) = (self.steady(*solution), size(*index as usize));
                quote!(#solution[#index])
            }
        })
    }

    /// The solution of a system.
    fn solve(&mut self, factor: Value, right: &[Value]) -> TokenStream {
        let right: Vec<TokenStream> = right.iter().map(|value| self.term(*value)).collect();
        let OperationKind::Factor { form, size: rows, entries } = self.kind(factor) else {
            let factor = self.constant(factor);
            return quote!(#factor.solve([#(#right),*]));
        };
        if self.series.is_constant(factor) {
            let factor = self.constant(factor);
            return quote!(#factor.solve([#(#right),*]));
        }
        let (form, rows) = (*form, *rows as usize);
        let matrix = (0..rows).map(|i| {
            let row = (0..rows).map(|j| self.term(entries[form.place(rows, i, j)]));
            quote!([#(#row),*])
        });
        let matrix: Vec<TokenStream> = matrix.collect();
        let (count, factors) = (size(rows), expression::factors(form, rows));
        let memory = self.made(quote!(Matrix::<S, #factors, #count>));
        quote!(#memory.next(k_, [#(#matrix),*], [#(#right),*]))
    }

    /// The next term of a function.
    fn call(
        &mut self,
        function: Function,
        read: &[Value],
        terms: &[TokenStream],
    ) -> Option<TokenStream> {
        let kind = match function {
            Function::Abs => {
                let term = &terms[0];
                let is_below = self.kept(quote!(S::less(#term, S::ZERO)));
                return Some(quote!(S::select(#is_below, -#term, #term)));
            }
            Function::Max | Function::Min => {
                let (first, second) = (&terms[0], &terms[1]);
                let is_first = self.kept(match function {
                    Function::Max => quote!(S::less_equal(#second, #first)),
                    _ => quote!(S::less_equal(#first, #second)),
                });
                return Some(quote!(S::select(#is_first, #first, #second)));
            }
            Function::Power if !self.series.is_steady(read[1]) => {
                let (logarithm, product) = (self.made(quote!(Ln)), self.made(quote!(Product)));
                let (power, base, exponent) = (self.made(quote!(Exp)), &terms[0], &terms[1]);
                return Some(quote! {{
                    let logarithm_ = #logarithm.next(k_, #base);
                    let exponent_ = #product.next(k_, #exponent, logarithm_);
                    #power.next(k_, exponent_)
                }});
            }
            Function::Power => {
                let (memory, base) = (self.made(quote!(Power)), &terms[0]);
                let exponent = self.steady(read[1]);
                return Some(quote!(#memory.next(k_, #base, #exponent)));
            }
            // Those of an angle are taken together, and these are steady.
            Function::Sin | Function::Cos | Function::Sign | Function::Floor => return None,
            Function::Tan => quote!(Tan),
            Function::Asin => quote!(Asin),
            Function::Acos => quote!(Acos),
            Function::Atan => quote!(Atan),
            Function::Atan2 => quote!(Atan2),
            Function::Sinh => quote!(Sinh),
            Function::Cosh => quote!(Cosh),
            Function::Tanh => quote!(Tanh),
            Function::Exp => quote!(Exp),
            Function::Ln => quote!(Ln),
            Function::Log10 => quote!(Log10),
            Function::Sqrt => quote!(Sqrt),
            Function::Hypot => quote!(Hypot),
            Function::Erf => quote!(Erf),
            Function::NormalCdf => quote!(NormalCdf),
            Function::ExpM1 => quote!(ExpM1),
            Function::Ln1p => quote!(Ln1p),
        };
        let memory = self.made(kind);
        Some(quote!(#memory.next(k_, #(#terms),*)))
    }
}
