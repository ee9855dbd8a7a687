//! What the solvers ask of the parameters of a linkage.

use assur_model::checked::LinkageInfo;
use assur_model::program::Value;
use proc_macro2::TokenStream;
use quote::quote;

use crate::body::{Body, Scope};
use crate::expression::{number, size};
use crate::layout::Layout;
use crate::requirements;

/// The implementation of `Linkage`.
pub fn implementation(layout: &Layout<'_>, linkage: &LinkageInfo) -> TokenStream {
    let (name, closure) = (&layout.parameters, &layout.equations);
    let constants = size(layout.constants.len());
    let (prepare, check, drive) = (prepare(layout), requirements::check(layout), drive(layout));
    let ranges = linkage.ranges.iter().map(|range| {
        let [from, to, start, period] =
            [range.from, range.to, range.start, range.period].map(number);
        quote!(::assur::closure::Range { from: #from, to: #to, start: #start, period: #period })
    });
    let start = match linkage.dependents.is_empty() {
        true => quote!(::std::vec::Vec::new()),
        false => quote!(self.start_::<f64>().to_vec()),
    };
    let span = crate::parameters::span(layout);
    let packed = match is_packed(layout, linkage) {
        true => quote!(!cfg!(debug_assertions)),
        false => quote!(false),
    };
    let is_sought = layout.scene.synthesis.is_some();
    quote! {
        impl ::assur::closure::Linkage for #name {
            type Closure<S: ::assur::scalar::Scalar> = #closure<S>;

            const PACKED: bool = #packed;
            const IS_SOUGHT: bool = #is_sought;

            #[inline(always)]
            fn shape(&self) -> &'static ::assur::shape::Shape {
                &shapes_::#name
            }

            fn values(&self) -> ::std::vec::Vec<f64> {
                Self::values(self).to_vec()
            }

            fn with_values(&self, values: &[f64]) -> Self {
                let mut all = [0.0; #constants];
                all.copy_from_slice(values);
                Self::from_values(&all)
            }

            #prepare
            #check
            #span
            #drive

            fn ranges(&self) -> ::std::vec::Vec<::assur::closure::Range> {
                ::std::vec![#(#ranges),*]
            }

            fn start(&self) -> ::std::vec::Vec<f64> {
                #start
            }
        }
    }
}

/// Whether linkages made at random are closed several side by side: where a tolerance says that they are made, and they do not
/// go separate ways. Builds for debugging spare what that takes to compile.
fn is_packed(layout: &Layout<'_>, linkage: &LinkageInfo) -> bool {
    let is_made = layout.scene.constants.iter().any(|constant| constant.tolerance != 0.0)
        || linkage.ranges.iter().any(|range| range.tolerance.0 != 0.0);
    is_made && !layout.program().is_apart()
}

/// What depends on the constants alone, from constants of any scalar type.
fn prepare(layout: &Layout<'_>) -> TokenStream {
    let wanted: Vec<Value> = layout.staging.prepared.iter().copied().collect();
    let body = Body::new(layout, Scope::Values, &wanted, &[]);
    let (statements, fields) =
        (body.statements(&wanted), layout.stored(&layout.staging.prepared, &body));
    let closure = &layout.equations;
    quote! {
        #[inline(always)]
        fn prepare<S: ::assur::scalar::Scalar>(&self, values: &[S]) -> Self::Closure<S> {
            #statements
            #closure { #fields }
        }
    }
}

/// The motion of the drivers in time.
fn drive(layout: &Layout<'_>) -> TokenStream {
    let value = match layout.program().results.closing.rates.is_empty() {
        true => quote!(::core::option::Option::None),
        false => quote!(::core::option::Option::Some(self.drive_::<f64>(time).to_vec())),
    };
    quote! {
        fn drive(&self, time: f64) -> ::core::option::Option<::std::vec::Vec<f64>> {
            #value
        }
    }
}

/// The method that computes it: positions, speeds, accelerations, and the time itself.
pub fn motion(layout: &Layout<'_>) -> TokenStream {
    let results = &layout.program().results;
    if layout.scene.linkage.is_none() || results.closing.rates.is_empty() {
        return TokenStream::new();
    }
    let drivers = results.drivers.iter();
    let wanted: Vec<Value> = drivers.chain(&results.closing.rates).copied().collect();
    let body = Body::new(layout, Scope::Drive, &wanted, &[]);
    let statements = body.statements(&wanted);
    let values = wanted.iter().map(|value| body.value(*value));
    let count = size(wanted.len() + 1);
    quote! {
        /// Positions, speeds and accelerations of the drivers at a time, and the time.
        fn drive_<S: ::assur::scalar::Scalar>(&self, time: S) -> [S; #count] {
            #statements
            [#(#values,)* time]
        }
    }
}
