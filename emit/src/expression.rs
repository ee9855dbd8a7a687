//! One operation as a Rust expression, with the parentheses that it needs and no others.

use std::collections::BTreeSet;

use crate::tables;
use assur_model::program::{Form, Function, Input, Line, OperationKind, Relation, Search, Value};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// How tightly an expression holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    /// `a + b`
    Sum,
    /// `a * b`
    Product,
    /// `-a`
    Sign,
    /// A name, a call, anything in parentheses.
    Whole,
}

/// A Rust expression.
#[derive(Clone)]
pub struct Expression {
    /// Its text.
    pub tokens: TokenStream,
    /// How tightly it holds together.
    pub binding: Binding,
    /// Local values that it reads.
    pub reads: BTreeSet<Value>,
    /// The text of the same without its sign, which holds together like a whole, if it is `-…`.
    pub opposite: Option<TokenStream>,
    /// The texts of both factors, if it is a product that is written where it is read.
    pub factors: Option<[Factor; 2]>,
}

/// The text of a factor, and how it is written after a minus.
#[derive(Clone)]
pub struct Factor {
    text: TokenStream,
    negated: TokenStream,
}

impl Expression {
    /// A name or call.
    pub fn whole(tokens: TokenStream) -> Self {
        Self {
            tokens,
            binding: Binding::Whole,
            reads: BTreeSet::new(),
            opposite: None,
            factors: None,
        }
    }

    /// The text with a minus, as an argument.
    fn negated(&self) -> TokenStream {
        match &self.opposite {
            Some(positive) => positive.clone(),
            None => {
                let text = self.at_least(Binding::Whole);
                quote!(-#text)
            }
        }
    }

    /// The text, in parentheses if it holds together less tightly than asked.
    fn at_least(&self, binding: Binding) -> TokenStream {
        let tokens = &self.tokens;
        if self.binding < binding { quote!((#tokens)) } else { tokens.clone() }
    }
}

/// A number as a literal with all its digits.
pub fn number(value: f64) -> TokenStream {
    if value.is_nan() {
        return quote!(f64::NAN);
    }
    if value.is_infinite() {
        return if value > 0.0 { quote!(f64::INFINITY) } else { quote!(f64::NEG_INFINITY) };
    }
    let size = value.abs();
    let literal = format!("{size:?}").parse().unwrap_or_else(|_| Literal::f64_unsuffixed(size));
    if value.is_sign_negative() { quote!(-#literal) } else { quote!(#literal) }
}

/// A number as a scalar.
pub fn scalar(value: f64) -> Expression {
    if value < 0.0 {
        let size = scalar(-value).tokens;
        return Expression {
            binding: Binding::Sign,
            opposite: Some(size.clone()),
            ..Expression::whole(quote!(-#size))
        };
    }
    let literal = number(value);
    Expression::whole(match value {
        0.0 if value.is_sign_positive() => quote!(S::ZERO),
        1.0 => quote!(S::ONE),
        _ => quote!(S::from_f64(#literal)),
    })
}

/// A length or index.
pub fn size(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

/// An operation whose operands are written by `operand`.
pub fn operation(kind: &OperationKind, operand: &dyn Fn(Value) -> Expression) -> Expression {
    use Binding::{Product, Sign, Sum, Whole};
    use OperationKind as Kind;
    let read = kind.operands();
    let all: Vec<Expression> = read.iter().map(|value| operand(*value)).collect();
    let text: Vec<&TokenStream> = all.iter().map(|one| &one.tokens).collect();
    let at = |index: usize, binding: Binding| all[index].at_least(binding);
    let (tokens, binding) = match kind {
        Kind::Number(value) => return scalar(*value),
        // Inputs are given by whoever calls.
        Kind::Input(_) => (TokenStream::new(), Whole),
        Kind::Add(..) | Kind::Subtract(..) if all.iter().any(|one| one.factors.is_some()) => {
            (fused(matches!(kind, Kind::Add(..)), &all), Whole)
        }
        Kind::Add(..) | Kind::Subtract(..) => {
            let (a, b) = (at(0, Sum), at(1, Product));
            let adds = matches!(kind, Kind::Add(..));
            let sum = match (adds, &all[1].opposite, &all[0].opposite) {
                (true, Some(b), _) => quote!(#a - #b),
                (false, Some(b), _) => quote!(#a + #b),
                (true, None, Some(a)) => quote!(#b - #a),
                (true, None, None) => quote!(#a + #b),
                (false, None, _) => quote!(#a - #b),
            };
            (sum, Sum)
        }
        Kind::Multiply(..) => {
            let (a, b) = (at(0, Product), at(1, Sign));
            (quote!(#a * #b), Product)
        }
        Kind::Divide(..) => {
            let (a, b) = (at(0, Product), at(1, Sign));
            (quote!(#a / #b), Product)
        }
        Kind::Negate(_) => match &all[0].opposite {
            Some(a) => (a.clone(), Whole),
            None => {
                let a = at(0, Whole);
                (quote!(-#a), Sign)
            }
        },
        Kind::MultiplyAdd(..) => (quote!(S::mul_add(#(#text),*)), Whole),
        Kind::MultiplySubtract(..) => {
            let (a, b, c) = (text[0], text[1], all[2].negated());
            (quote!(S::mul_add(#a, #b, #c)), Whole)
        }
        Kind::NegateMultiplyAdd(..) => {
            let (a, b, c) = (all[0].negated(), text[1], text[2]);
            (quote!(S::mul_add(#a, #b, #c)), Whole)
        }
        Kind::Call(function, _) => (call(*function, &text), Whole),
        Kind::Compare(Relation::Less, ..) => (quote!(S::less(#(#text),*)), Whole),
        Kind::Compare(Relation::LessEqual, ..) => (quote!(S::less_equal(#(#text),*)), Whole),
        Kind::Compare(Relation::Equal, ..) => (quote!(S::equal(#(#text),*)), Whole),
        Kind::And(..) => (quote!(S::and(#(#text),*)), Whole),
        Kind::Or(..) => (quote!(S::or(#(#text),*)), Whole),
        Kind::Not(_) => (quote!(S::not(#(#text),*)), Whole),
        Kind::Select { .. } => (quote!(S::select(#(#text),*)), Whole),
        Kind::Factor { form, size, .. } => (factor(*form, *size as usize, &text), Whole),
        Kind::Solve { .. } => {
            let (factor, right) = (text[0], &text[1..]);
            (quote!(#factor.solve([#(#right),*])), Whole)
        }
        Kind::Table { spline, .. } => {
            let name = tables::name(spline);
            (quote!(S::table(#(#text),*, &#name)), Whole)
        }
        Kind::Search { search, text, lines, .. } => {
            (self::search((*search, text), lines, &all, 0), Whole)
        }
        Kind::Element { index, .. } => {
            let (solution, index) = (text[0], size(*index as usize));
            (quote!(#solution[#index]), Whole)
        }
    };
    let reads = all.iter().flat_map(|one| one.reads.iter().copied()).collect();
    let opposite = (binding == Sign).then(|| at(0, Whole));
    let factors = matches!(kind, Kind::Multiply(..)).then(|| {
        [0, 1]
            .map(|index| Factor { text: all[index].tokens.clone(), negated: all[index].negated() })
    });
    Expression { tokens, binding, reads, opposite, factors }
}

/// What is found of the functions that some lines are, inside so many others.
fn search(
    (search, text): (Search, &str),
    lines: &[Line],
    captured: &[Expression],
    depth: usize,
) -> TokenStream {
    let place = format_ident!("place{depth}_");
    let functions = lines.iter().map(|one| {
        let body = line(one, captured, depth);
        quote!(#[inline(always)] |#place: S| #body)
    });
    let name = match search {
        Search::Mean => quote!(mean),
        Search::Root => quote!(root),
        Search::Highest => quote!(highest),
        Search::HighestPlace => quote!(highest_place),
    };
    // Whatever is smooth has a largest value.
    let text = matches!(search, Search::Mean | Search::Root).then(|| quote!(#text,));
    quote!(S::#name(#text #(#functions),*))
}

/// A line as a block.
fn line(line: &Line, captured: &[Expression], depth: usize) -> TokenStream {
    let program = line.program();
    let needed = program.needed(&[line.result], &|_| false);
    let written = program.written(&needed, &[line.result]);
    let mut statements = Vec::new();
    let mut texts: Vec<Expression> = Vec::new();
    for (index, kind) in line.operations.iter().enumerate() {
        let at = |value: Value| texts[value.0 as usize].clone();
        let text = match kind {
            OperationKind::Input(Input::Captured(index)) => captured[*index as usize].clone(),
            OperationKind::Input(_) => {
                let place = format_ident!("place{depth}_");
                Expression::whole(quote!(#place))
            }
            OperationKind::Search { search, text, captured, lines } => {
                let captured: Vec<_> = captured.iter().map(|value| at(*value)).collect();
                Expression::whole(self::search((*search, text), lines, &captured, depth + 1))
            }
            kind => operation(kind, &at),
        };
        let is_given = matches!(kind, OperationKind::Input(_) | OperationKind::Number(_));
        if is_given || written.contains(&Value(index as u32)) {
            texts.push(text);
        } else {
            let (name, tokens) = (format_ident!("step{depth}_{index}_"), text.tokens);
            statements.push(quote!(let #name = #tokens;));
            texts.push(Expression::whole(quote!(#name)));
        }
    }
    let result = &texts[line.result.0 as usize].tokens;
    quote!({ #(#statements)* #result })
}

/// A sum or difference of two values of which one is a product that nothing else reads.
fn fused(adds: bool, all: &[Expression]) -> TokenStream {
    match (&all[0].factors, &all[1].factors) {
        (_, Some([first, second])) => {
            let factor = if adds { &first.text } else { &first.negated };
            let (second, term) = (&second.text, &all[0].tokens);
            quote!(S::mul_add(#factor, #second, #term))
        }
        (Some([first, second]), None) => {
            let (first, second, term) = (&first.text, &second.text, &all[1].tokens);
            let term = if adds { term.clone() } else { all[1].negated() };
            quote!(S::mul_add(#first, #second, #term))
        }
        (None, None) => TokenStream::new(),
    }
}

/// The factors of a matrix.
fn factor(form: Form, rows: usize, entries: &[&TokenStream]) -> TokenStream {
    let factoring = factoring(form, rows);
    if let Form::Bound { .. } = form {
        // Most of it is zero.
        let writes = (0..rows).flat_map(|i| (0..=i).map(move |j| (i, j))).filter_map(|(i, j)| {
            let entry = entries[form.place(rows, i, j)];
            let (i, j) = (size(i), size(j));
            (!is_zero(entry)).then(|| quote!(matrix_.put(#i, #j, #entry);))
        });
        return quote!(#factoring(|matrix_| { #(#writes)* }));
    }
    let row = |i: usize| {
        let entry = |j: usize| entries[form.place(rows, i, j)];
        let row = (0..rows).map(entry);
        quote!([#(#row),*])
    };
    let matrix = (0..rows).map(row);
    quote!(#factoring([#(#matrix),*]))
}

/// Whether a text is that of the number zero.
fn is_zero(text: &TokenStream) -> bool {
    text.to_string() == scalar(0.0).tokens.to_string()
}

/// The function that factors a matrix with so many rows.
pub fn factoring(form: Form, rows: usize) -> TokenStream {
    let rows = size(rows);
    match form {
        Form::Symmetric => quote!(::assur::dense::factor::<S, #rows>),
        Form::General => quote!(::assur::dense::factor_pivoted::<S, #rows>),
        Form::Bound { unknowns, rank } => {
            let (unknowns, rank) = (size(unknowns as usize), size(rank as usize));
            quote!(::assur::dense::factor_bound::<S, #rows, #unknowns, #rank>)
        }
    }
}

/// The type of the factors of a matrix with so many rows.
pub fn factors(form: Form, rows: usize) -> TokenStream {
    let rows = size(rows);
    match form {
        Form::Symmetric => quote!(::assur::dense::Factor<S, #rows>),
        Form::General => quote!(::assur::dense::Pivoted<S, #rows>),
        Form::Bound { unknowns, rank } => {
            let (unknowns, rank) = (size(unknowns as usize), size(rank as usize));
            quote!(::assur::dense::Bound<S, #rows, #unknowns, #rank>)
        }
    }
}

/// Where an entry of a lower triangle stands.
pub fn triangle(row: usize, column: usize) -> usize {
    row * (row + 1) / 2 + column
}

fn call(function: Function, arguments: &[&TokenStream]) -> TokenStream {
    let arguments = quote!(#(#arguments),*);
    match function {
        Function::Sin => quote!(S::sin_cos(#arguments).0),
        Function::Cos => quote!(S::sin_cos(#arguments).1),
        Function::Tan => quote!(S::tan(#arguments)),
        Function::Asin => quote!(S::asin(#arguments)),
        Function::Acos => quote!(S::acos(#arguments)),
        Function::Atan => quote!(S::atan(#arguments)),
        Function::Atan2 => quote!(S::atan2(#arguments)),
        Function::Sinh => quote!(S::sinh(#arguments)),
        Function::Cosh => quote!(S::cosh(#arguments)),
        Function::Tanh => quote!(S::tanh(#arguments)),
        Function::Exp => quote!(S::exp(#arguments)),
        Function::Ln => quote!(S::ln(#arguments)),
        Function::Log10 => quote!(S::log10(#arguments)),
        Function::Sqrt => quote!(S::sqrt(#arguments)),
        Function::Hypot => quote!(S::hypot(#arguments)),
        Function::Erf => quote!(S::erf(#arguments)),
        Function::NormalCdf => quote!(S::normal_cdf(#arguments)),
        Function::Floor => quote!(S::floor(#arguments)),
        Function::Abs => quote!(S::abs(#arguments)),
        Function::Sign => quote!(S::sign(#arguments)),
        Function::Max => quote!(S::max(#arguments)),
        Function::Min => quote!(S::min(#arguments)),
        Function::Power => quote!(S::powf(#arguments)),
        Function::ExpM1 => quote!(S::exp_m1(#arguments)),
        Function::Ln1p => quote!(S::ln_1p(#arguments)),
    }
}
