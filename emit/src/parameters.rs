//! The type that a user fills in: the parameters of a scene, and what the solvers ask of it.

use assur_model::checked::{Model, SpanKind};
use assur_model::program::Value;
use proc_macro2::TokenStream;
use quote::quote;

use crate::body::{Body, Scope};
use crate::expression::size;
use crate::layout::Layout;
use crate::{Origin, docs, linkage, requirements, scene, subjects, values};

/// The parameter struct of a scene with its methods.
pub fn items(layout: &Layout<'_>, model: &Model, origin: &Origin<'_>) -> TokenStream {
    let (name, constants) = (&layout.parameters, &layout.scene.constants);
    let text = docs::lines(&docs::scene(layout, model, origin));
    let fields = layout.constants.iter().zip(constants).map(|(field, constant)| {
        let text = docs::lines(&values::field(constant));
        quote!(#text pub #field: f64)
    });
    let inherent = inherent(layout);
    let implementation = match &layout.scene.linkage {
        Some(loops) => linkage::implementation(layout, loops),
        None => implementation(layout),
    };
    quote! {
        #text
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name { #(#fields),* }

        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self::from_values(&shapes_::#name.defaults())
            }
        }

        #inherent
        #implementation
    }
}

/// Methods of the struct's own: its values as an array, and what is computed from them alone.
fn inherent(layout: &Layout<'_>) -> TokenStream {
    let (name, fields) = (&layout.parameters, &layout.constants);
    let count = size(fields.len());
    let places = (0..fields.len()).map(size);
    let results = &layout.program().results;
    let requirements = computed(
        layout,
        "requirements_",
        &results.requirements,
        quote!(S::Mask),
        "The conditions on the values.",
    );
    let span = computed(
        layout,
        "span_",
        &results.span,
        quote!(S),
        "The period, or the first and the last time.",
    );
    let start = computed(layout, "start_", &results.start, quote!(S), "The declared start values.");
    let motion = linkage::motion(layout);
    let subjects = subjects::items(layout);
    quote! {
        impl #name {
            #subjects

            /// What the scene is made of.
            pub const fn shape() -> &'static ::assur::shape::Shape {
                &shapes_::#name
            }

            /// Sets all values, SI units, in the order of the fields.
            pub fn from_values(values: &[f64; #count]) -> Self {
                Self { #(#fields: values[#places]),* }
            }

            /// All values, SI units, in the order of the fields.
            pub fn values(&self) -> [f64; #count] {
                [#(self.#fields),*]
            }

            #requirements
            #span
            #start
            #motion
        }
    }
}

/// A method that computes some values from the parameters; nothing when there are none.
fn computed(
    layout: &Layout<'_>,
    name: &str,
    wanted: &[Value],
    kind: TokenStream,
    text: &str,
) -> TokenStream {
    if wanted.is_empty() {
        return TokenStream::new();
    }
    let (name, text) = (crate::names::identifier(name), docs::lines(text));
    let body = Body::new(layout, Scope::Parameters, wanted, &[]);
    let (statements, count) = (body.statements(wanted), size(wanted.len()));
    let values = wanted.iter().map(|value| body.value(*value));
    quote! {
        #text
        fn #name<S: ::assur::scalar::Scalar>(&self) -> [#kind; #count] {
            #statements
            [#(#values),*]
        }
    }
}

/// What the solvers ask of a scene.
fn implementation(layout: &Layout<'_>) -> TokenStream {
    let (name, equations) = (&layout.parameters, &layout.equations);
    let is_smooth = layout.modes.is_empty();
    let events = (!is_smooth).then(|| {
        quote! {
            fn events<S: ::assur::scalar::Scalar>(
                equations: &Self::Equations<S>,
            ) -> ::core::option::Option<&dyn ::assur::problem::Events<S>> {
                ::core::option::Option::Some(equations)
            }
        }
    });
    let smooth = is_smooth.then(|| quote!(impl ::assur::problem::Smooth for #name {}));
    let prepare = prepare(layout);
    let (check, span, start) = (requirements::check(layout), span(layout), start(layout));
    let unreduced = unreduced(layout);
    let unreduced_type = match &unreduced {
        Some(_) => scene::unreduced(name),
        None => name.clone(),
    };
    quote! {
        impl ::assur::problem::Scene for #name {
            type Equations<S: ::assur::scalar::Scalar> = #equations<S>;
            type Unreduced = #unreduced_type;
            const SMOOTH: bool = #is_smooth;

            fn shape(&self) -> &'static ::assur::shape::Shape {
                &shapes_::#name
            }

            #prepare
            #events
            #check
            #span
            #start
            #unreduced
        }

        #smooth
    }
}

/// The method that computes what depends on the parameters alone.
fn prepare(layout: &Layout<'_>) -> TokenStream {
    let body = match layout.modes.as_slice() {
        [] => layout.body(prepared(layout)),
        modes => {
            let equations = &layout.equations;
            let fields = modes.iter().map(|mode| {
                let (field, body) = (&mode.field, layout.body(prepared(mode)));
                quote!(#field: { #body })
            });
            quote!(#equations { #(#fields),* })
        }
    };
    quote! {
        #[inline(always)]
        fn prepare<S: ::assur::scalar::Scalar>(&self) -> Self::Equations<S> {
            #body
        }
    }
}

/// What depends on the parameters alone, stored where later stages use it.
fn prepared(layout: &Layout<'_>) -> TokenStream {
    let wanted: Vec<Value> = layout.staging.prepared.iter().copied().collect();
    let body = Body::new(layout, Scope::Parameters, &wanted, &[]);
    let (statements, fields) =
        (body.statements(&wanted), layout.stored(&layout.staging.prepared, &body));
    let equations = &layout.equations;
    quote!(#statements #equations { #fields })
}

/// The method that states the task.
pub fn span(layout: &Layout<'_>) -> TokenStream {
    let body = match (layout.scene.span, layout.program().results.span.len()) {
        (SpanKind::Periodic, 1) => quote! {
            let [period] = self.span_::<f64>();
            ::assur::problem::Span::Periodic(period)
        },
        (SpanKind::Periodic, 0) => quote!(::assur::problem::Span::Autonomous),
        (SpanKind::Rest, _) => quote!(::assur::problem::Span::Rest),
        (SpanKind::Run, 2) => quote! {
            let [from, to] = self.span_::<f64>();
            ::assur::problem::Span::Run(from, to)
        },
        _ => quote!(::assur::problem::Span::Open),
    };
    quote!(fn span(&self) -> ::assur::problem::Span { #body })
}

fn start(layout: &Layout<'_>) -> TokenStream {
    let body = match layout.program().results.start.is_empty() {
        true => quote!(::std::vec::Vec::new()),
        false if layout.scene.augmented.is_some() => {
            quote!(::assur::model::begin(self, self.start_::<f64>().to_vec()))
        }
        false => quote!(self.start_::<f64>().to_vec()),
    };
    quote!(fn start(&self) -> ::std::vec::Vec<f64> { #body })
}

/// The same motion with all positions as coordinates, where this one may come to a dead point.
fn unreduced(layout: &Layout<'_>) -> Option<TokenStream> {
    let other = layout.scene.unreduced.as_ref()?;
    let name = scene::unreduced(&layout.parameters);
    let own = &layout.scene.constants;
    let places = other
        .constants
        .iter()
        .map(|constant| own.iter().position(|one| one.quantity.name == constant.quantity.name));
    let names =
        crate::names::distinct(other.constants.iter().map(|one| one.quantity.name.as_str()));
    let fields = names.into_iter().zip(places).filter_map(|(field, place)| {
        let value = &layout.constants[place?];
        Some(quote!(#field: self.#value,))
    });
    Some(quote! {
        fn unreduced(&self) -> ::core::option::Option<Self::Unreduced> {
            ::core::option::Option::Some(#name { #(#fields)* ..#name::default() })
        }
    })
}
