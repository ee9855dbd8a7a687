//! A scene with modes: equations for each, and the equations of the scene, which are those of the mode that it is in.

use assur_model::checked::{Model, SceneModel};
use assur_model::program::{Event, Value};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, Place};
use super::equations::first;
use super::expression::size;
use super::layout::Layout;
use super::{docs, equations, instant, names, outputs, parameters, slopes};

/// For each scene its modes as scenes of their own; none where there are none.
pub fn split(model: &Model) -> Vec<Vec<SceneModel>> {
    let mode = |scene: &SceneModel, index: usize| {
        let mut program = scene.modes[index].program.clone();
        // What is made of a whole run, or of the time alone, is no matter of modes: the first one computes it.
        if index != scene.first {
            program.results.measures.clear();
            program.results.margins.clear();
        }
        SceneModel {
            program,
            equations: scene.modes[index].equations.clone(),
            modes: Vec::new(),
            ..scene.clone()
        }
    };
    let scenes = model.scenes.iter();
    scenes
        .map(|scene| {
            (0..scene.modes.len())
                .map(|index| mode(scene, index))
                .collect()
        })
        .collect()
}

/// The items of a scene with modes, its parameters apart.
pub fn items(layout: &Layout<'_>) -> TokenStream {
    let modes = layout.modes.iter().map(|mode| {
        let (equations, instant) = (equations::items(mode), instant::items(mode));
        let (outputs, events) = (outputs::inherent(mode), events(mode));
        quote!(#equations #instant #outputs #events)
    });
    let composite = composite(layout);
    quote!(#(#modes)* #composite)
}

/// The variants of the instant, and the fields of the equations.
fn parts(layout: &Layout<'_>) -> (Vec<Ident>, Vec<Ident>) {
    let names = names::mode_types(layout.scene);
    let fields = names
        .iter()
        .map(|name| names::identifier(&names::snake(name)));
    (
        names.iter().map(|name| names::identifier(name)).collect(),
        fields.collect(),
    )
}

/// The equations of the scene: a macro of the library goes on to those of the modes.
fn composite(layout: &Layout<'_>) -> TokenStream {
    let (name, instant) = (&layout.equations, &layout.instant);
    let (variants, fields) = parts(layout);
    let modes = layout.modes.iter().zip(&layout.scene.modes).enumerate();
    let modes = modes.zip(variants.iter().zip(&fields));
    let modes = modes.map(|((index, (mode, own)), (variant, field))| {
        let text = match own.name.as_str() {
            "" => docs::lines("The only mode."),
            name => docs::lines(&format!("In the mode `{name}`.")),
        };
        let (index, of, equations) = (size(index), &mode.instant, &mode.equations);
        quote!(#text #index #variant(#of) #field: #equations,)
    });
    let cyclic = slopes::has(layout).then(|| quote!(cyclic));
    let [text, other] = [
        "Equations of [`{}`], prepared for a scalar type: those of the mode that it is in.",
        "What the equations of [`{}`] need of one time.",
    ]
    .map(|text| docs::lines(&text.replace("{}", &layout.parameters.to_string())));
    let states = size(layout.states());
    let (begin, first) = (&variants[layout.scene.first], &fields[layout.scene.first]);
    quote! {
        ::assur::composite! {
            #cyclic
            #text
            #name,
            #other
            #instant,
            states #states,
            first #begin #first,
            #(#modes)*
        }
    }
}

/// What the solvers ask of the parameters.
pub fn implementation(layout: &Layout<'_>) -> TokenStream {
    let (name, equations) = (&layout.parameters, &layout.equations);
    quote! {
        impl ::assur::hybrid::Hybrid for #name {
            type Modal<S: ::assur::scalar::Scalar> = #equations<S>;

            fn modal<S: ::assur::scalar::Scalar>(&self) -> Self::Modal<S> {
                <Self as ::assur::problem::Scene>::prepare(self)
            }
        }
    }
}

/// The method of `Scene` that prepares the modes, and what prepares each.
pub fn prepare(layout: &Layout<'_>) -> (TokenStream, TokenStream) {
    let (name, equations) = (&layout.parameters, &layout.equations);
    let (_, fields) = parts(layout);
    let functions: Vec<Ident> = fields
        .iter()
        .map(|field| format_ident!("prepare_{}_", names::bare(field)))
        .collect();
    let each = layout.modes.iter().zip(&functions);
    let each = each.map(|(mode, function)| {
        let (body, equations) = (layout.body(parameters::prepared(mode)), &mode.equations);
        quote! {
            #[inline(always)]
            fn #function<S: ::assur::scalar::Scalar>(&self) -> #equations<S> {
                #body
            }
        }
    });
    let start = size(layout.scene.first);
    (
        quote! {
            #[inline(always)]
            fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
                #equations { mode_: #start, #(#fields: self.#functions()),* }
            }
        },
        quote!(impl #name { #(#each)* }),
    )
}

/// What the equations of a mode say of its events.
fn events(layout: &Layout<'_>) -> TokenStream {
    let events = &layout.program().results.events;
    let name = &layout.equations;
    let values: Vec<Value> = events
        .iter()
        .flat_map(|event| [event.guard, event.rate])
        .collect();
    let guards = (!values.is_empty()).then(|| {
        let body = Body::new(layout, Place::Evaluation, &values, &[]);
        let statements = body.statements(&values);
        let (some, others) = (
            first(quote!(values), events.len()),
            first(quote!(rates), events.len()),
        );
        let writes = events.iter().enumerate().map(|(index, event)| {
            let (index, value, rate) =
                (size(index), body.value(event.guard), body.value(event.rate));
            quote!(values[#index] = #value; rates[#index] = #rate;)
        });
        let guards = layout.body(quote!(#some #others #statements #(#writes)*));
        quote! {
            #[inline(always)]
            fn guards(&self, instant: &Self::Instant, state: &Self::State, values: &mut [S], rates: &mut [S]) {
                #guards
            }
        }
    });
    let conditions = each(events, |event| {
        let condition = event.condition?;
        let body = Body::new(layout, Place::Evaluation, &[condition], &[]);
        let (statements, value) = (body.statements(&[condition]), body.value(condition));
        Some(quote!({ #statements S::holds(#value) }))
    });
    let conditions = (!conditions.is_empty()).then(|| {
        let conditions = layout.body(quote!(match event { #conditions _ => true, }));
        quote! {
            #[inline(always)]
            fn permits(&self, event: usize, instant: &Self::Instant, state: &Self::State) -> bool {
                #conditions
            }
        }
    });
    let jumps = each(events, |event| {
        if event.after.is_empty() {
            return None;
        }
        let body = Body::new(layout, Place::Evaluation, &event.after, &[]);
        let statements = body.statements(&event.after);
        let values = event.after.iter().map(|value| body.value(*value));
        Some(quote!({ #statements *after = [#(#values),*]; }))
    });
    let jumps = (!jumps.is_empty()).then(|| {
        let jumps = layout.body(quote!(match event { #jumps _ => *after = *state, }));
        quote! {
            #[inline(always)]
            fn jump(&self, event: usize, instant: &Self::Instant, state: &Self::State, after: &mut Self::State) {
                #jumps
            }
        }
    });
    let sides = layout.has_sides().then(|| {
        quote! {
            #[inline(always)]
            fn side(&mut self, surface: usize, side: S) {
                self.sides_[surface] = side;
            }
        }
    });
    let slopes = slopes::of_mode(layout);
    quote! {
        impl<S: ::assur::scalar::Scalar> ::assur::hybrid::InMode<S> for #name<S> {
            #sides
            #guards
            #conditions
            #jumps
            #slopes
        }
    }
}

/// An arm for each event that has something to say.
pub fn each(
    events: &[Event<Value>],
    arm: impl Fn(&Event<Value>) -> Option<TokenStream>,
) -> TokenStream {
    let arms = events.iter().enumerate();
    let arms = arms.filter_map(|(index, event)| {
        let (index, arm) = (size(index), arm(event)?);
        Some(quote!(#index => #arm))
    });
    arms.collect()
}
