//! The measures of a scene as data.

use assur_model::checked::{
    ModeModel, Moment, Primitive, PrimitiveKind, SceneModel, SolvedInfo, SynthesisInfo,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::expression::{number, size};

/// The call that puts the measures into a shape, where the scene has any.
pub fn call(scene: &SceneModel, measures: &TokenStream) -> Option<TokenStream> {
    if scene.measures.is_empty() {
        return None;
    }
    let program = scene.modes.get(scene.first).map(|mode| &mode.program);
    let count = size(program.unwrap_or(&scene.program).results.measured.len());
    let primitives = scene.primitives.iter();
    let primitives = primitives.map(|one| primitive(one, &scene.modes));
    let uses = scene.measures.iter().map(|measure| {
        let uses = measure.uses.iter().map(|index| size(*index));
        quote!(&[#(#uses),*])
    });
    let sought = scene.synthesis.as_ref().map(sought);
    Some(quote!(.measures(#measures, &[#(#uses),*], &[#(#primitives),*], #count) #sought))
}

/// The call that says what the scene seeks.
fn sought(synthesis: &SynthesisInfo) -> TokenStream {
    let varied = synthesis.varied.iter().map(|one| {
        let (constant, from, to) = (size(one.constant), number(one.from), number(one.to));
        let values = one.values.iter().map(|value| number(*value));
        quote!(Varied::new(#constant, (#from, #to), &[#(#values),*]))
    });
    let conditions = synthesis.conditions.iter().map(|index| size(*index));
    let preferences = synthesis.preferences.iter().map(|(index, weight)| {
        let (index, weight) = (size(*index), number(*weight));
        quote!((#index, #weight))
    });
    let objective = size(synthesis.objective);
    let squares = synthesis.squares.iter().map(|index| size(*index));
    let solved = match &synthesis.solved {
        Some(solved) => {
            let solved = solved_for(solved);
            quote!(::core::option::Option::Some(#solved))
        }
        None => quote!(::core::option::Option::None),
    };
    quote! {
        .synthesis(Synthesis {
            varied: &[#(#varied),*],
            conditions: &[#(#conditions),*],
            preferences: &[#(#preferences),*],
            objective: #objective,
            squares: &[#(#squares),*],
            solved: #solved,
        })
    }
}

/// What follows from a condition.
fn solved_for(solved: &SolvedInfo) -> TokenStream {
    let unknowns = solved.unknowns.iter().map(|index| size(*index));
    let terms = solved.terms.iter().map(|term| {
        let (quantity, moves) = (size(term.quantity), term.moves);
        let powers = term.powers.iter().map(|power| Literal::u32_unsuffixed(*power));
        quote!(Term::new(#quantity, #moves, &[#(#powers),*]))
    });
    let one = |index: Option<usize>| match index.map(size) {
        Some(index) => quote!(::core::option::Option::Some(#index)),
        None => quote!(::core::option::Option::None),
    };
    let (text, scanned, free) = (&solved.text, one(solved.scanned), one(solved.free));
    let groups = solved.groups.iter().map(|group| size(*group));
    quote! {
        Solved {
            text: #text,
            unknowns: &[#(#unknowns),*],
            terms: &[#(#terms),*],
            scanned: #scanned,
            free: #free,
            groups: &[#(#groups),*],
        }
    }
}

fn primitive(primitive: &Primitive, modes: &[ModeModel]) -> TokenStream {
    let argument = size(primitive.argument);
    let window = primitive.window.map(|index| {
        let index = size(index);
        quote!(.within(#index))
    });
    let harmonic = |angle: usize, rate: usize, order: u32| {
        let (angle, rate, order) = (size(angle), size(rate), size(order as usize));
        quote!({ angle: (#angle, #rate), order: #order })
    };
    let kind = match &primitive.kind {
        PrimitiveKind::Peak => quote!(Peak),
        PrimitiveKind::Lowest => quote!(Lowest),
        PrimitiveKind::Mean => quote!(Mean),
        PrimitiveKind::Rms => quote!(Rms),
        PrimitiveKind::Integral => quote!(Integral),
        PrimitiveKind::Duration => quote!(Duration),
        PrimitiveKind::Travel => quote!(Travel),
        PrimitiveKind::Straightness(along) => {
            let along = size(*along);
            quote!(Straightness(#along))
        }
        PrimitiveKind::Value(when) => {
            let moment = moment(when, modes);
            quote!(Value(#moment))
        }
        PrimitiveKind::Count(when) => {
            let moment = moment(when, modes);
            quote!(Count(#moment))
        }
        PrimitiveKind::Cosine(angle, rate, order) => {
            let fields = harmonic(*angle, *rate, *order);
            quote!(Cosine #fields)
        }
        PrimitiveKind::Sine(angle, rate, order) => {
            let fields = harmonic(*angle, *rate, *order);
            quote!(Sine #fields)
        }
        PrimitiveKind::Frequency(number) => {
            let number = size(*number as usize);
            quote!(Frequency(#number))
        }
        PrimitiveKind::Damping(number) => {
            let number = size(*number as usize);
            quote!(Damping(#number))
        }
        PrimitiveKind::Multiplier(number) => {
            let number = size(*number as usize);
            quote!(Multiplier(#number))
        }
        PrimitiveKind::Detuning(number) => {
            let number = size(*number as usize);
            quote!(Detuning(#number))
        }
    };
    quote!(Primitive::of(Kind::#kind, #argument) #window)
}

fn moment(moment: &Moment, modes: &[ModeModel]) -> TokenStream {
    let of = |mode: &usize, last: &bool| {
        let mode = size(*mode);
        quote!({ mode: #mode, last: #last })
    };
    let at = |name: &str, last: &bool| {
        let event = named(name, modes);
        quote!({ event: #event, last: #last })
    };
    let moment = match moment {
        Moment::Start => quote!(Start),
        Moment::End => quote!(End),
        Moment::Passes(index, last) => {
            let index = size(*index);
            quote!(Passes { index: #index, last: #last })
        }
        Moment::Enter(mode, last) => {
            let fields = of(mode, last);
            quote!(Enter #fields)
        }
        Moment::Leave(mode, last) => {
            let fields = of(mode, last);
            quote!(Leave #fields)
        }
        Moment::Before(event, last) => {
            let fields = at(event, last);
            quote!(Before #fields)
        }
        Moment::After(event, last) => {
            let fields = at(event, last);
            quote!(After #fields)
        }
    };
    quote!(Moment::#moment)
}

/// The events of a name.
fn named(name: &str, modes: &[ModeModel]) -> TokenStream {
    let places = modes.iter().enumerate().flat_map(|(mode, one)| {
        let events = one.events.iter().enumerate();
        let own = events.filter(|(_, event)| event.label.as_deref() == Some(name));
        own.map(move |(event, _)| {
            let (mode, event) = (size(mode), size(event));
            quote!((#mode, #event))
        })
    });
    quote!(NamedEvent { name: #name, places: &[#(#places),*] })
}
