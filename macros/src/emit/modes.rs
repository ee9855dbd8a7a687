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
        let slopes = slopes::of_mode(mode);
        quote!(#equations #instant #outputs #events #slopes)
    });
    let composite = composite(layout);
    let slopes = slopes::of_scene(layout, &parts(layout));
    quote!(#(#modes)* #composite #slopes)
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

fn composite(layout: &Layout<'_>) -> TokenStream {
    let (name, instant) = (&layout.equations, &layout.instant);
    let (variants, fields) = parts(layout);
    let equations: Vec<&Ident> = layout.modes.iter().map(|mode| &mode.equations).collect();
    let instants: Vec<&Ident> = layout.modes.iter().map(|mode| &mode.instant).collect();
    let numbers: Vec<_> = (0..fields.len()).map(size).collect();
    let states = size(layout.states());
    let first = &fields[layout.scene.first];
    let margins = (!layout.scene.carried.is_empty()).then(|| {
        quote! {
            #[inline(always)]
            fn margins(&self, time: S, values: &mut [S]) {
                self.#first.margins(time, values);
            }
        }
    });
    let measures = (!layout.scene.measures.is_empty()).then(|| {
        quote! {
            #[inline(always)]
            fn measured(&self, time: S, state: &Self::State, values: &mut [S]) {
                match self.mode_ {
                    #(#numbers => self.#fields.measured(time, state, values),)*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn measures(&self, found: &[S], values: &mut [S]) {
                self.#first.measures(found, values);
            }
        }
    });
    let texts = layout
        .scene
        .modes
        .iter()
        .map(|mode| match mode.name.as_str() {
            "" => docs::lines("The only mode."),
            name => docs::lines(&format!("In the mode `{name}`.")),
        });
    let text = docs::lines(&format!(
        "Equations of [`{}`], prepared for a scalar type: those of the mode that it is in.",
        layout.parameters
    ));
    let other = docs::lines(&format!(
        "What the equations of [`{}`] need of one time.",
        layout.parameters
    ));
    quote! {
        #text
        #[derive(Clone, Copy, Debug)]
        pub struct #name<S: ::assur::scalar::Scalar> {
            mode_: usize,
            #(#fields: #equations<S>),*
        }

        #other
        #[derive(Clone, Copy, Debug)]
        pub enum #instant<S: ::assur::scalar::Scalar> {
            #(#texts #variants(#instants<S>)),*
        }

        impl<S: ::assur::scalar::Scalar> ::assur::problem::Equations<S> for #name<S> {
            type State = [S; #states];
            type Instant = #instant<S>;

            #[inline(always)]
            fn states(&self) -> usize {
                #states
            }

            #[inline(always)]
            fn instant(&self, time: S) -> Self::Instant {
                match self.mode_ {
                    #(#numbers => #instant::#variants(self.#fields.instant(time)),)*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn instants<const K_: usize>(&self, times: [S; K_]) -> [Self::Instant; K_] {
                match self.mode_ {
                    #(#numbers => {
                        let instants = self.#fields.instants(times);
                        ::core::array::from_fn(|k_| #instant::#variants(instants[k_]))
                    })*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn derivative(&self, instant: &Self::Instant, state: &Self::State, rate: &mut Self::State) {
                match instant {
                    #(#instant::#variants(instant) => self.#fields.derivative(instant, state, rate),)*
                }
            }

            #[inline(always)]
            fn sweep(&self, times: &[S], stages: &mut dyn ::assur::problem::Stages<S>) -> bool {
                match self.mode_ {
                    #(#numbers => self.#fields.sweep(times, stages),)*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn series(&self, time: S, length: S, rows: &mut [S]) -> bool {
                match self.mode_ {
                    #(#numbers => self.#fields.series(time, length, rows),)*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn variation(
                &self,
                instant: &Self::Instant,
                state: &Self::State,
                rate: &mut Self::State,
                columns: &[Self::State],
                products: &mut [Self::State],
            ) {
                match instant {
                    #(#instant::#variants(instant) => {
                        self.#fields.variation(instant, state, rate, columns, products)
                    })*
                }
            }

            #[inline(always)]
            fn jacobian(&self, instant: &Self::Instant, state: &Self::State, columns: &mut [Self::State]) {
                match instant {
                    #(#instant::#variants(instant) => self.#fields.jacobian(instant, state, columns),)*
                }
            }

            #[inline(always)]
            fn outputs(&self, time: S, state: &Self::State, values: &mut [S]) {
                match self.mode_ {
                    #(#numbers => self.#fields.outputs(time, state, values),)*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn drivers(&self, time: S, values: &mut [S]) {
                match self.mode_ {
                    #(#numbers => self.#fields.drivers(time, values),)*
                    _ => ::core::unreachable!(),
                }
            }

            #margins
            #measures
        }

        impl<S: ::assur::scalar::Scalar> ::assur::hybrid::Modes<S> for #name<S> {
            #[inline(always)]
            fn mode(&self) -> usize {
                self.mode_
            }

            #[inline(always)]
            fn enter(&mut self, mode: usize) {
                self.mode_ = mode;
            }

            #[inline(always)]
            fn side(&mut self, surface: usize, side: S) {
                match self.mode_ {
                    #(#numbers => self.#fields.side_(surface, side),)*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn guards(&self, instant: &Self::Instant, state: &Self::State, values: &mut [S], rates: &mut [S]) {
                match instant {
                    #(#instant::#variants(instant) => self.#fields.guards_(instant, state, values, rates),)*
                }
            }

            #[inline(always)]
            fn look(&self, time: S, state: &Self::State, values: &mut [S], rates: &mut [S]) {
                match self.mode_ {
                    #(#numbers => {
                        let instant = ::assur::problem::Equations::instant(&self.#fields, time);
                        self.#fields.guards_(&instant, state, values, rates)
                    })*
                    _ => ::core::unreachable!(),
                }
            }

            #[inline(always)]
            fn permits(&self, event: usize, instant: &Self::Instant, state: &Self::State) -> bool {
                match instant {
                    #(#instant::#variants(instant) => self.#fields.permits_(event, instant, state),)*
                }
            }

            #[inline(always)]
            fn jump(&self, event: usize, instant: &Self::Instant, state: &Self::State, after: &mut Self::State) {
                match instant {
                    #(#instant::#variants(instant) => self.#fields.jump_(event, instant, state, after),)*
                }
            }
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

/// The methods of a mode's equations for its events.
fn events(layout: &Layout<'_>) -> TokenStream {
    let events = &layout.program().results.events;
    let (name, instant) = (&layout.equations, &layout.instant);
    let states = size(layout.states());
    let values: Vec<Value> = events
        .iter()
        .flat_map(|event| [event.guard, event.rate])
        .collect();
    let guards = match values.is_empty() {
        true => TokenStream::new(),
        false => {
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
            quote!(#some #others #statements #(#writes)*)
        }
    };
    let conditions = each(events, |event| {
        let condition = event.condition?;
        let body = Body::new(layout, Place::Evaluation, &[condition], &[]);
        let (statements, value) = (body.statements(&[condition]), body.value(condition));
        Some(quote!({ #statements S::holds(#value) }))
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
    let sides = layout
        .has_sides()
        .then(|| quote!(self.sides_[surface] = side;));
    let guards = layout.body(guards);
    let conditions = layout.body(quote!(match event { #conditions _ => true, }));
    let jumps = layout.body(quote!(match event { #jumps _ => *after = *state, }));
    quote! {
        impl<S: ::assur::scalar::Scalar> #name<S> {
            #[inline(always)]
            fn side_(&mut self, surface: usize, side: S) {
                #sides
            }

            #[inline(always)]
            fn guards_(&self, instant: &#instant<S>, state: &[S; #states], values: &mut [S], rates: &mut [S]) {
                #guards
            }

            #[inline(always)]
            fn permits_(&self, event: usize, instant: &#instant<S>, state: &[S; #states]) -> bool {
                #conditions
            }

            #[inline(always)]
            fn jump_(&self, event: usize, instant: &#instant<S>, state: &[S; #states], after: &mut [S; #states]) {
                #jumps
            }
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
