//! The loops of a linkage prepared for a scalar type: closed forms, trial positions, derivatives.

use assur_model::checked::LinkageInfo;
use assur_model::program::{ClosedForm, Input, OperationKind, Stage, Value};
use proc_macro2::TokenStream;
use quote::quote;

use crate::blocks::blocks;
use crate::body::{Body, Scope};
use crate::expression::size;
use crate::layout::{Layout, outlined};
use crate::{docs, instant};

/// Operations from which on a method is long.
const LONG: usize = 200;

/// The struct and its implementation of `Closure`.
pub fn items(layout: &Layout<'_>, linkage: &LinkageInfo) -> TokenStream {
    let (name, parameters) = (&layout.equations, &layout.parameters);
    let (instants, instant) = instant::of_drivers(layout);
    let fields = layout.fields(&layout.staging.prepared);
    let text =
        docs::lines(&format!("Loops of [`{}`], prepared for a scalar type.", layout.parameters));
    let largest = linkage.groups.iter().map(|group| group.unknowns.len()).max().unwrap_or(0);
    let [position, row, matrix] =
        [layout.program().results.closing.position(), largest, largest * largest].map(size);
    let closing = &layout.program().results.closing;
    let lists = [
        ("residual", quote!(residual), closing.residuals.clone()),
        ("outputs", quote!(values), layout.program().results.outputs.clone()),
        ("influence", quote!(values), closing.influence.clone()),
        ("second_influence", quote!(values), closing.second.clone()),
        ("points", quote!(values), closing.points.clone()),
    ];
    let lists = lists.iter().map(|(method, target, values)| list(layout, method, target, values));
    let measures = measures(layout);
    let methods = [
        instants,
        close(layout),
        close_all(layout),
        margin(layout),
        trial(layout, linkage),
        coefficients(layout, linkage),
    ];
    quote! {
        #text
        #[derive(Clone, Copy, Debug)]
        pub struct #name<S: ::assur::scalar::Scalar> { #fields }

        impl<S: ::assur::scalar::Scalar> ::assur::closure::Closure<S> for #name<S> {
            type Position = [S; #position];
            type Instant = [S; #instant];
            type Row = [S; #row];
            type Matrix = [S; #matrix];

            #[inline(always)]
            fn shape(&self) -> &'static ::assur::shape::Shape {
                &shapes_::#parameters
            }

            #[inline(always)]
            fn zeros(&self) -> Self::Position {
                [S::ZERO; #position]
            }

            #(#methods)*
            #(#lists)*
            #measures
        }
    }
}

/// The methods for measures, where the scene has any.
fn measures(layout: &Layout<'_>) -> Option<TokenStream> {
    let results = &layout.program().results;
    let measured = list(layout, "measured", &quote!(values), &results.measured);
    let wanted = &results.measures;
    let body = Body::new(layout, Scope::Evaluation, wanted, &[]);
    let statements = body.statements(wanted);
    let values: Vec<TokenStream> = wanted.iter().map(|value| body.value(*value)).collect();
    let places = (0..wanted.len()).map(size);
    (!wanted.is_empty()).then(|| {
        quote! {
            #measured

            fn measures(&self, found: &[S], values: &mut [S]) {
                #statements
                #(values[#places] = #values;)*
            }
        }
    })
}

/// A match on the number of the group; groups with nothing to do give NaN.
fn by_group(arms: Vec<Option<TokenStream>>, otherwise: TokenStream) -> TokenStream {
    let arms = arms.into_iter().enumerate().filter_map(|(group, arm)| {
        let (group, arm) = (size(group), arm?);
        Some(quote!(#group => { #arm }))
    });
    quote!(match group { #(#arms)* _ => #otherwise })
}

fn close(layout: &Layout<'_>) -> TokenStream {
    let groups = &layout.program().results.closing.groups;
    let arms = groups.iter().map(|closed| {
        let form = form(layout, closed.as_ref()?);
        let angles = angles(layout, &form.angles);
        let (statements, sine) = (form.statements, form.sine);
        Some(quote!(#statements #angles #sine))
    });
    let arms = by_group(arms.collect(), quote!(S::from_f64(f64::NAN)));
    quote! {
        #[inline(always)]
        fn close(&self, group: usize, instant: &Self::Instant, mode: S, position: &mut Self::Position) -> S {
            #arms
        }
    }
}

/// All groups in one, with their angles taken together or not at all; nothing where one is iterated or reads an angle of
/// another.
fn close_all(layout: &Layout<'_>) -> TokenStream {
    let groups = &layout.program().results.closing.groups;
    let forms: Option<Vec<Form>> =
        groups.iter().map(|closed| Some(form(layout, closed.as_ref()?))).collect();
    let Some(forms) = forms else {
        return TokenStream::new();
    };
    let mut found = Vec::new();
    for form in &forms {
        if found.iter().any(|angle| form.reads.contains(angle)) {
            return TokenStream::new();
        }
        found.extend(&form.angles);
    }
    let angles = match found.is_empty() {
        true => TokenStream::new(),
        false => {
            let angles = angles(layout, &found);
            quote!(if angles { #angles })
        }
    };
    let blocks = forms.iter().enumerate().map(|(group, form)| {
        let (group, statements, sine) = (size(group), &form.statements, &form.sine);
        quote!({ let mode = modes[#group]; #statements sines[#group] = #sine; })
    });
    let count = size(forms.len());
    let first = crate::equations::exact(&[(quote!(mut sines), forms.len())]);
    quote! {
        #[inline(always)]
        fn close_all(
            &self,
            instant: &Self::Instant,
            modes: &[S],
            position: &mut Self::Position,
            sines: &mut [S],
            angles: bool,
        ) {
            #first
            ::assur::exact!(modes, #count);
            #(#blocks)*
            #angles
        }
    }
}

/// A closed form but for its angles, of which the position has the cosines and sines.
struct Form {
    statements: TokenStream,
    sine: TokenStream,
    /// The unknowns that are such angles.
    angles: Vec<usize>,
    /// The entries of the position that are read.
    reads: Vec<usize>,
}

fn form(layout: &Layout<'_>, closed: &ClosedForm<Value>) -> Form {
    let program = layout.program();
    let has = |place: usize| closed.values.iter().any(|entry| entry.0 == place);
    let is_angle = |place: usize| {
        let cosine = program.results.closing.cosines.get(place).copied();
        cosine.flatten().is_some_and(has)
    };
    let (angles, others): (Vec<_>, Vec<_>) =
        closed.values.iter().copied().partition(|entry| is_angle(entry.0));
    let wanted: Vec<Value> = others.iter().map(|entry| entry.1).chain([closed.sine]).collect();
    let body = Body::new(layout, Scope::Evaluation, &wanted, &[]);
    let statements = body.statements(&wanted);
    let writes = others.iter().map(|(place, value)| {
        let (place, value) = (size(*place), body.value(*value));
        quote!(position[#place] = #value;)
    });
    let read = program.needed(&wanted, &|_| false);
    let reads =
        read.into_iter().filter_map(|value| match program.operations[value.0 as usize].kind {
            OperationKind::Input(Input::Position(place)) => Some(place as usize),
            _ => None,
        });
    Form {
        statements: quote!(#statements #(#writes)*),
        sine: body.value(closed.sine),
        angles: angles.iter().map(|entry| entry.0).collect(),
        reads: reads.collect(),
    }
}

/// Writes angles whose cosines and sines are there.
fn angles(layout: &Layout<'_>, angles: &[usize]) -> TokenStream {
    let cosines = &layout.program().results.closing.cosines;
    let (mut x, mut y, mut targets) = (Vec::new(), Vec::new(), Vec::new());
    for angle in angles {
        if let Some(place) = cosines[*angle] {
            x.push(size(place));
            y.push(size(place + 1));
            targets.push(size(*angle));
        }
    }
    match targets.as_slice() {
        [] => TokenStream::new(),
        [target] => quote!(position[#target] = S::atan2(#(position[#y])*, #(position[#x])*);),
        _ => {
            let names = (0..targets.len()).map(size);
            quote! {
                let angles_ = S::atan2_all([#(position[#y]),*], [#(position[#x]),*]);
                #(position[#targets] = angles_[#names];)*
            }
        }
    }
}

fn margin(layout: &Layout<'_>) -> TokenStream {
    let groups = &layout.program().results.closing.groups;
    let arms = groups.iter().map(|closed| {
        let wanted = [closed.as_ref()?.margin];
        let body = Body::new(layout, Scope::Evaluation, &wanted, &[]);
        let (statements, value) = (body.statements(&wanted), body.value(wanted[0]));
        Some(quote!(#statements #value))
    });
    let body = outlined(by_group(arms.collect(), quote!(S::from_f64(f64::NAN))));
    quote! {
        #[inline(always)]
        fn margin(&self, group: usize, instant: &Self::Instant, position: &Self::Position) -> S {
            #body
        }
    }
}

fn trial(layout: &Layout<'_>, linkage: &LinkageInfo) -> TokenStream {
    let closing = &layout.program().results.closing;
    let arms = linkage.groups.iter().map(|group| {
        let count = group.unknowns.len();
        let slope = |row: usize, column: usize| {
            let found = closing.slopes.iter().find(|entry| (entry.0, entry.1) == (row, column));
            found.map(|entry| entry.2)
        };
        let residuals: Vec<Value> =
            group.equations.iter().map(|row| closing.residuals[*row]).collect();
        let slopes: Vec<Option<Value>> = group
            .equations
            .iter()
            .flat_map(|row| group.unknowns.iter().map(|column| slope(*row, *column)))
            .collect();
        let wanted: Vec<Value> =
            residuals.iter().copied().chain(slopes.iter().flatten().copied()).collect();
        let body = Body::new(layout, Scope::Evaluation, &wanted, &[]);
        let statements = body.statements(&wanted);
        let sines = sines(layout, &group.unknowns);
        let rows = residuals.iter().enumerate().map(|(index, value)| {
            let (index, value) = (size(index), body.value(*value));
            quote!(residual[#index] = #value;)
        });
        let entries = slopes.iter().enumerate().map(|(index, value)| {
            let value = value.map_or(quote!(S::ZERO), |value| body.value(value));
            let index = size(index);
            quote!(jacobian[#index] = #value;)
        });
        debug_assert_eq!(slopes.len(), count * count);
        Some(quote!(#sines #statements #(#rows)* #(#entries)*))
    });
    let arms = by_group(arms.collect(), quote!({}));
    quote! {
        #[inline(always)]
        fn trial(
            &self,
            group: usize,
            instant: &Self::Instant,
            position: &mut Self::Position,
            residual: &mut Self::Row,
            jacobian: &mut Self::Matrix,
        ) {
            #arms
        }
    }
}

/// Takes sines and cosines of the angles among some dependent coordinates.
fn sines(layout: &Layout<'_>, unknowns: &[usize]) -> TokenStream {
    let cosines = &layout.program().results.closing.cosines;
    let kept: Vec<(usize, usize)> =
        unknowns.iter().filter_map(|one| Some((*one, cosines[*one]?))).collect();
    if kept.is_empty() {
        return TokenStream::new();
    }
    let angles = kept.iter().map(|(one, _)| size(*one));
    let (mut cos, mut sin) = (Vec::new(), Vec::new());
    for (_, place) in &kept {
        cos.push(size(*place));
        sin.push(size(*place + 1));
    }
    let names: Vec<_> = (0..kept.len()).map(size).collect();
    quote! {
        let (sines_, cosines_) = S::sin_cos_all([#(position[#angles]),*]);
        #(position[#cos] = cosines_[#names]; position[#sin] = sines_[#names];)*
    }
}

fn coefficients(layout: &Layout<'_>, linkage: &LinkageInfo) -> TokenStream {
    let entries = &layout.program().results.closing.coefficients;
    let wanted: Vec<Value> = entries.iter().map(|entry| entry.2).collect();
    let body = Body::new(layout, Scope::Evaluation, &wanted, &[]);
    let statements = body.statements(&wanted);
    let mut writes = Vec::new();
    for driver in 0..layout.scene.drivers.len() {
        for dependent in 0..linkage.dependents.len() {
            let entry = entries.iter().find(|entry| (entry.0, entry.1) == (dependent, driver));
            let value = entry.map_or(quote!(S::ZERO), |entry| body.value(entry.2));
            let (dependent, driver) = (size(dependent), size(driver));
            writes.push(quote!(columns[#driver][#dependent] = #value;));
        }
    }
    let first = crate::equations::exact(&[(quote!(mut columns), layout.scene.drivers.len())]);
    let writes = blocks(&writes);
    quote! {
        #[inline(always)]
        fn coefficients(&self, instant: &Self::Instant, position: &Self::Position, columns: &mut [Self::Position]) {
            #first
            #statements
            #writes
        }
    }
}

/// A method that writes some values one after the other.
fn list(layout: &Layout<'_>, method: &str, target: &TokenStream, wanted: &[Value]) -> TokenStream {
    let method = crate::names::identifier(method);
    let body = Body::new(layout, Scope::Evaluation, wanted, &[]);
    let statements = body.statements(wanted);
    let writes: Vec<TokenStream> = wanted
        .iter()
        .enumerate()
        .map(|(index, value)| {
            let (index, value) = (size(index), body.value(*value));
            quote!(#target[#index] = #value;)
        })
        .collect();
    let first = (!wanted.is_empty())
        .then(|| crate::equations::exact(&[(quote!(mut #target), wanted.len())]));
    let writes = blocks(&writes);
    // A long method is compiled once for each scalar type, not once for each solver that calls it.
    let is_long = layout.program().count(wanted, Stage::State) > LONG;
    let body = quote!(#first #statements #writes);
    let body = if is_long { outlined(body) } else { body };
    quote! {
        #[inline(always)]
        fn #method(&self, instant: &Self::Instant, position: &Self::Position, #target: &mut [S]) {
            #body
        }
    }
}
