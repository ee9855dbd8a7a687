//! What of a scene is stored where: in the prepared equations, in the instant, or nowhere.

use std::collections::BTreeSet;

use assur_model::checked::SceneModel;
use assur_model::program::{Counts, OperationKind, Program, Shape, Stage, Staging, Value};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::body::Body;
use crate::expression::{self, size as whole};
use crate::names::{self, Locals};
use crate::{docs, formula};

/// Operations of an evaluation with its Jacobian, in all modes together, from which on functions are long.
const LONG: usize = 1000;

/// A scene with the names of its types and the fields that its values are stored in.
pub struct Layout<'a> {
    /// The scene.
    pub scene: &'a SceneModel,
    /// Local names of its values.
    pub names: Locals,
    /// Fields of the parameter struct.
    pub constants: Vec<Ident>,
    /// The parameter struct, `Elastic`.
    pub parameters: Ident,
    /// The prepared equations, `ElasticEquations`.
    pub equations: Ident,
    /// What the prepared equations and the instant store.
    pub staging: Staging,
    /// How many operations its functions do.
    pub counts: Counts,
    /// The modes, each laid out like a scene of its own; empty where there are none.
    pub modes: Vec<Layout<'a>>,
    /// Of a mode the field that holds its prepared values.
    pub field: Option<Ident>,
    /// Whether it is another scene with all positions as coordinates.
    pub is_unreduced: bool,
}

/// The body of a function that is not inlined: what stands in it is, into a function that is compiled for the
/// instructions of its numbers. An attribute `#[inline(never)]` would leave these out.
pub fn outlined(body: TokenStream) -> TokenStream {
    quote!(S::outline(#[inline(always)] || { #body }))
}

/// Whether a name stands in code.
fn mentions(code: &TokenStream, name: &str) -> bool {
    code.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == name,
        TokenTree::Group(group) => mentions(&group.stream(), name),
        _ => false,
    })
}

impl<'a> Layout<'a> {
    /// Lays out a scene whose type has this name.
    pub fn new(scene: &'a SceneModel, type_name: &str) -> Self {
        let program = &scene.program;
        let staging = program.staging();
        let names = scene.constants.iter().map(|constant| constant.quantity.name.as_str());
        Self {
            scene,
            names: Locals::new(scene),
            constants: names::distinct(names),
            parameters: names::identifier(type_name),
            equations: format_ident!("{type_name}Equations"),
            counts: scene.counts(&staging),
            staging,
            modes: Vec::new(),
            field: None,
            is_unreduced: false,
        }
    }

    /// Lays out a scene with its modes.
    pub fn with_modes(scene: &'a SceneModel, modes: &'a [SceneModel], type_name: &str) -> Self {
        let parameters = names::identifier(type_name);
        let own = modes.iter().zip(names::mode_types(scene));
        let modes = own.map(|(mode, name)| Layout {
            parameters: parameters.clone(),
            field: Some(names::identifier(&names::snake(&name))),
            ..Layout::new(mode, &format!("{type_name}{name}"))
        });
        Self { modes: modes.collect(), ..Self::new(scene, type_name) }
    }

    /// Whether the functions are too long to be written out wherever they are called: rustc would take minutes, and what
    /// they take is not the call. All modes of a scene stand in the same places.
    fn is_long(&self) -> bool {
        let operations = self.each_mode().iter().map(|mode| {
            let results = &mode.program().results;
            let all: Vec<Value> =
                results.derivative.iter().copied().chain(results.slopes()).collect();
            mode.program().count(&all, Stage::State)
        });
        operations.sum::<usize>() > LONG
    }

    /// Whether the Jacobian is written as products with columns, by the function that writes these: where it is long, and where
    /// a mode has no entries of it.
    pub fn has_products_alone(&self) -> bool {
        let is_along = |mode: &Layout<'_>| !mode.program().results.along.is_empty();
        self.is_long() || self.each_mode().iter().any(is_along)
    }

    /// The body of a function of the equations: as it is, or as a function of its own where it is long.
    pub fn body(&self, body: TokenStream) -> TokenStream {
        match self.is_long() {
            true => outlined(body),
            false => body,
        }
    }

    /// Documentation of a function of so many operations, where all modes do not share it.
    pub fn counted(&self, operations: usize) -> Option<TokenStream> {
        self.modes.is_empty().then(|| docs::operations(operations))
    }

    /// What holds the prepared values where equations are evaluated; of a mode inside of [`Layout::owning`].
    pub fn owner(&self) -> TokenStream {
        match &self.field {
            Some(_) => quote!(own_),
            None => quote!(self),
        }
    }

    /// Code of a mode, to which its prepared values have a short name.
    pub fn owning(&self, code: TokenStream) -> TokenStream {
        match &self.field {
            Some(field) if mentions(&code, "own_") => quote!(let own_ = &self.#field; #code),
            _ => code,
        }
    }

    /// The modes, or the scene itself where it has none.
    pub fn each_mode(&self) -> &[Layout<'a>] {
        match self.modes.as_slice() {
            [] => std::slice::from_ref(self),
            modes => modes,
        }
    }

    /// The mode in which the motion begins, or the scene itself where it has none.
    pub fn first_mode(&self) -> &Layout<'a> {
        self.modes.get(self.scene.first).unwrap_or(self)
    }

    /// Code for each mode: what a method does in the mode that a phase is in, and otherwise.
    pub fn in_mode(
        &self,
        otherwise: &TokenStream,
        code: &dyn Fn(&Layout<'a>) -> TokenStream,
    ) -> TokenStream {
        if self.modes.is_empty() {
            return code(self);
        }
        let arms = self.modes.iter().enumerate().map(|(index, mode)| {
            let (index, code) = (whole(index), mode.owning(code(mode)));
            match code.is_empty() {
                true => code,
                false => quote!(#index => { #code }),
            }
        });
        quote!(match phase.mode { #(#arms)* _ => #otherwise })
    }

    /// What stands in a row, each with its name and formula where that is not long.
    pub fn row_formulas(&self) -> Vec<String> {
        let mut place = 0;
        let entry = |value: &Value| {
            let at = place;
            place += self.numbers(*value);
            let formula = formula::of(self, *value, &self.staging.prepared)?;
            Some(match &self.program().operations[value.0 as usize].name {
                Some(name) => format!("`instant[{at}]`: `{name} = {formula}`"),
                None => format!("`instant[{at}]`: `{formula}`"),
            })
        };
        self.staging.timed.iter().filter_map(entry).collect()
    }

    /// Length of a row of what depends on the time alone.
    pub fn row(&self) -> usize {
        let modes = self.each_mode().iter();
        let own =
            modes.map(|mode| mode.staging.timed.iter().map(|value| mode.numbers(*value)).sum());
        own.max().unwrap_or(0)
    }

    /// How many numbers of a row a value takes.
    fn numbers(&self, value: Value) -> usize {
        match self.program().shape(value) {
            Shape::Number | Shape::Mask | Shape::Factor(..) => 1,
            Shape::Vector(size) => size,
        }
    }

    /// A value that depends on the time alone, read from a row.
    pub fn read_row(&self, value: Value) -> TokenStream {
        let before = self.staging.timed.range(..value);
        let begin: usize = before.map(|value| self.numbers(*value)).sum();
        let at = |index: usize| whole(begin + index);
        match self.program().shape(value) {
            // Factors are found at each evaluation.
            Shape::Number | Shape::Factor(..) => {
                let at = at(0);
                quote!(instant[#at])
            }
            Shape::Mask => {
                let at = at(0);
                quote!(S::less(S::ZERO, instant[#at]))
            }
            Shape::Vector(size) => {
                let entries = (0..size).map(at);
                quote!([#(instant[#entries]),*])
            }
        }
    }

    /// The numbers of a row, as a body has computed them.
    pub fn row_of(&self, body: &Body<'_>) -> Vec<TokenStream> {
        let timed = self.staging.timed.iter();
        let numbers = timed.flat_map(|value| {
            let text = body.value(*value);
            match self.program().shape(*value) {
                Shape::Number | Shape::Factor(..) => vec![text],
                Shape::Mask => vec![quote!(S::select(#text, S::ONE, S::ZERO))],
                Shape::Vector(size) => (0..size)
                    .map(|index| {
                        let index = whole(index);
                        quote!(#text[#index])
                    })
                    .collect(),
            }
        });
        numbers.collect()
    }

    /// The program of the scene.
    pub fn program(&self) -> &'a Program {
        &self.scene.program
    }

    /// Length of the state vector.
    pub fn states(&self) -> usize {
        self.scene.states.len()
    }

    /// Fields that store values, `name: type`, and one for the scalar type when nothing is stored.
    pub fn fields(&self, stored: &BTreeSet<Value>) -> TokenStream {
        let fields = stored.iter().map(|value| {
            let (name, kind) = (self.names.of(*value), self.type_of(*value));
            let text = self.explanation(*value, stored);
            quote!(#text #name: #kind)
        });
        if stored.is_empty() {
            quote!(scalar_: ::core::marker::PhantomData<S>)
        } else {
            quote!(#(#fields),*)
        }
    }

    /// Documentation of a field: its formula, unless it is a quantity of the file as it stands.
    fn explanation(&self, value: Value, stored: &BTreeSet<Value>) -> Option<TokenStream> {
        let program = self.program();
        let kind = &program.operations[value.0 as usize].kind;
        if matches!(kind, OperationKind::Input(_)) {
            return None;
        }
        let text = formula::of(self, value, stored).map(|text| format!("`{text}`"));
        let entries = &program.results.jacobian;
        let slope = entries.iter().find(|entry| entry.2 == value).map(|entry| {
            let name = |index: u32| &self.scene.states[index as usize].name;
            let (row, column) = (name(entry.0), name(entry.1));
            format!("Jacobian, rate of `{row}` by `{column}`")
        });
        let text = match (slope, text) {
            (Some(slope), Some(text)) => format!("{slope}: {text}"),
            (slope, text) => slope.or(text)?,
        };
        Some(docs::lines(&text))
    }

    /// The fields with their values, `name: value`.
    pub fn stored(&self, stored: &BTreeSet<Value>, body: &Body<'_>) -> TokenStream {
        self.filled(stored, &|value| body.value(value))
    }

    fn filled(&self, stored: &BTreeSet<Value>, text: &dyn Fn(Value) -> TokenStream) -> TokenStream {
        if stored.is_empty() {
            return quote!(scalar_: ::core::marker::PhantomData);
        }
        let fields = stored.iter().map(|value| {
            let (name, text) = (self.names.of(*value), text(*value));
            if *name == text.to_string() { text } else { quote!(#name: #text) }
        });
        quote!(#(#fields),*)
    }

    /// The type of a value.
    fn type_of(&self, value: Value) -> TokenStream {
        match self.program().shape(value) {
            Shape::Number => quote!(S),
            Shape::Mask => quote!(S::Mask),
            Shape::Factor(form, size) => expression::factors(form, size),
            Shape::Vector(size) => {
                let size = whole(size);
                quote!([S; #size])
            }
        }
    }

    /// Any value of the right type.
    pub fn placeholder(&self, value: Value) -> TokenStream {
        match self.program().shape(value) {
            Shape::Number => quote!(S::ZERO),
            Shape::Mask => quote!(S::less(S::ZERO, S::ZERO)),
            Shape::Factor(form, size) => {
                let (factor, size) = (expression::factoring(form, size), whole(size));
                quote!(#factor([[S::ONE; #size]; #size]))
            }
            Shape::Vector(size) => {
                let size = whole(size);
                quote!([S::ZERO; #size])
            }
        }
    }
}
