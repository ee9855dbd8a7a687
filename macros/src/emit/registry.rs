//! The mechanism as data: `MECHANISM`, and how a scene is bound to values without knowing its type.

use assur_model::checked::{
    Distribution, ExpectInfo, ExpectPlace, LinkageInfo, LoopInfo, Model, QuantityInfo, SceneModel,
    Subject, VariableInfo,
};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::expression::{number, size};
use super::layout::Layout;
use super::{Origin, counts, docs, names};

/// The static `MECHANISM` and the functions that its entries point to.
pub fn table(model: &Model, layouts: &[Layout<'_>], origin: &Origin<'_>) -> TokenStream {
    let (name, title) = (names::snake(&model.name), &model.name);
    let (summary, source, file) = (&model.documentation, &model.source, &origin.file);
    let (file, text, parts) = match origin.has_file {
        true => (
            quote!(#file),
            quote!(::core::include_str!(#file)),
            origin.parts.as_slice(),
        ),
        false => (quote!(""), quote!(""), [].as_slice()),
    };
    let effects = model.effects.iter().map(|effect| {
        let (name, summary) = (&effect.name, &effect.summary);
        quote!(::assur::registry::Named { name: #name, summary: #summary })
    });
    let choices = model.choices.iter().map(|choice| {
        let (name, summary, alternatives) = (&choice.name, &choice.summary, &choice.alternatives);
        quote!(::assur::registry::Choice { name: #name, summary: #summary, alternatives: &[#(#alternatives),*] })
    });
    let presets = model.presets.iter().map(|preset| {
        let (name, summary) = (&preset.name, &preset.summary);
        let values = preset.values.iter().map(|(name, value)| {
            let value = number(*value);
            quote!((#name, #value))
        });
        quote!(::assur::registry::Preset { name: #name, summary: #summary, values: &[#(#values),*] })
    });
    let entries = layouts.iter().map(|layout| entry(layout, origin));
    let binders = layouts.iter().map(binder);
    let lines = docs::lines(&format!("The mechanism `{title}` as data."));
    quote! {
        #lines
        pub static MECHANISM: ::assur::registry::Mechanism = ::assur::registry::Mechanism {
            name: #name,
            title: #title,
            summary: #summary,
            source: #source,
            file: #file,
            text: #text,
            parts: &[#((#parts, ::core::include_str!(#parts))),*],
            effects: &[#(#effects),*],
            choices: &[#(#choices),*],
            presets: &[#(#presets),*],
            scenes: &[#(#entries),*],
        };
        #(#binders)*
    }
}

fn entry(layout: &Layout<'_>, origin: &Origin<'_>) -> TokenStream {
    let scene = layout.scene;
    let (name, summary, effects, preset) =
        (&scene.name, &scene.summary, &scene.effects, &scene.preset);
    let choices = scene
        .choices
        .iter()
        .map(|(choice, held)| quote!((#choice, #held)));
    let (type_name, binder) = (&layout.parameters, binder_name(layout));
    let bind = match &scene.linkage {
        Some(_) => quote!(::assur::registry::Bind::Linkage(#binder)),
        None => quote!(::assur::registry::Bind::Motion(#binder)),
    };
    let modes = (0..scene.modes.len()).map(|index| {
        let (mode, place) = (&scene.modes[index], size(index));
        let (name, summary) = (&mode.name, &mode.summary);
        quote! {
            ::assur::registry::ModeEntry {
                name: #name,
                summary: #summary,
                events: <#type_name as ::assur::hybrid::Hybrid>::EVENTS[#place],
            }
        }
    });
    let carried = scene.carried.iter().map(|one| loop_entry(one, origin));
    let linkage = match &scene.linkage {
        Some(loops) => linkage(layout, loops, origin),
        None => quote!(::core::option::Option::None),
    };
    let [drivers, states, outputs] = [&scene.drivers, &scene.states, &scene.outputs]
        .map(|list| list.iter().map(quantity).collect::<Vec<_>>());
    let measures = scene.measures.iter().map(|one| quantity(&one.quantity));
    let equations = scene.equations.iter().map(|equation| {
        let (text, unit, line) = (&equation.text, &equation.unit, line(origin, equation.span));
        quote!(::assur::registry::EquationText { text: #text, unit: #unit, line: #line })
    });
    let marks = scene.marks.iter().map(|mark| {
        let (text, at) = (&mark.text, place(&mark.at));
        quote!(::assur::registry::Mark { text: #text, at: #at })
    });
    let expectations = scene
        .expectations
        .iter()
        .map(|one| expectation(one, origin));
    let counts = counts::of(layout);
    let [prepare, instant, derivative, jacobian, outputs_count] = [
        counts.prepare,
        counts.instant,
        counts.derivative,
        counts.jacobian,
        counts.outputs,
    ]
    .map(size);
    quote! {
        ::assur::registry::SceneEntry {
            name: #name,
            summary: #summary,
            effects: &[#(#effects),*],
            choices: &[#(#choices),*],
            preset: #preset,
            constants: #type_name::CONSTANTS,
            drivers: &[#(#drivers),*],
            states: &[#(#states),*],
            outputs: &[#(#outputs),*],
            measures: &[#(#measures),*],
            equations: &[#(#equations),*],
            operations: ::assur::registry::Operations {
                prepare: #prepare,
                instant: #instant,
                derivative: #derivative,
                jacobian: #jacobian,
                outputs: #outputs_count,
            },
            marks: &[#(#marks),*],
            expectations: &[#(#expectations),*],
            bind: #bind,
            linkage: #linkage,
            carried: &[#(#carried),*],
            modes: &[#(#modes),*],
        }
    }
}

/// The loops as data, for a linkage.
fn linkage(layout: &Layout<'_>, linkage: &LinkageInfo, origin: &Origin<'_>) -> TokenStream {
    let name = &layout.parameters;
    let dependents = linkage.dependents.iter().map(|one| quantity(&one.quantity));
    let loops = linkage.loops.iter().map(|one| loop_entry(one, origin));
    let tolerances = linkage.ranges.iter().map(|range| {
        let (half_width, kind) = (number(range.tolerance.0), distribution(range.tolerance.1));
        quote!((#half_width, #kind))
    });
    let points = &linkage.points;
    let links = linkage.links.iter().map(|link| {
        let (points, text) = (link.points.iter().map(|one| size(*one)), &link.text);
        quote!(::assur::registry::Link { points: &[#(#points),*], text: #text })
    });
    quote! {
        ::core::option::Option::Some(::assur::registry::LinkageEntry {
            dependents: &[#(#dependents),*],
            loops: &[#(#loops),*],
            groups: <#name as ::assur::closure::Linkage>::GROUPS,
            variables: <#name as ::assur::closure::Linkage>::VARIABLES,
            tolerances: &[#(#tolerances),*],
            points: &[#(#points),*],
            links: &[#(#links),*],
        })
    }
}

fn loop_entry(one: &LoopInfo, origin: &Origin<'_>) -> TokenStream {
    let (name, unit, factor) = (&one.name, &one.unit, number(one.factor));
    let line = line(origin, one.span);
    quote!(::assur::registry::Loop { name: #name, unit: #unit, factor: #factor, line: #line })
}

fn distribution(distribution: Distribution) -> TokenStream {
    let name = match distribution {
        Distribution::Normal => quote!(Normal),
        Distribution::Uniform => quote!(Uniform),
        Distribution::Truncated => quote!(Truncated),
    };
    quote!(::assur::registry::Distribution::#name)
}

fn binder_name(layout: &Layout<'_>) -> proc_macro2::Ident {
    format_ident!("bind_{}_", names::bare(&layout.parameters))
}

/// Whether anything in a linkage is made to a tolerance, or is a dimension and so may be.
fn is_made(linkage: &LinkageInfo) -> bool {
    let mut variables = linkage.variables.iter();
    let mut ranges = linkage.ranges.iter();
    variables.any(|one| matches!(one, VariableInfo::Constant(_)))
        || ranges.any(|range| range.tolerance.0 > 0.0)
}

fn binder(layout: &Layout<'_>) -> TokenStream {
    let (name, type_name) = (binder_name(layout), &layout.parameters);
    let expected = layout.constants.len();
    let reason = format!("found {{}}, expected {expected}");
    let (run, bind) = match &layout.scene.linkage {
        Some(linkage) if is_made(linkage) => (quote!(RunLinkage), quote!(bind_linkage)),
        Some(_) => (quote!(RunLinkage), quote!(bind_exact)),
        None if !layout.modes.is_empty() && super::slopes::has(layout) => {
            (quote!(Run), quote!(bind_cycle))
        }
        None if !layout.modes.is_empty() => (quote!(Run), quote!(bind_hybrid)),
        None => (quote!(Run), quote!(bind)),
    };
    quote! {
        fn #name(
            values: &[f64],
        ) -> ::core::result::Result<::std::boxed::Box<dyn ::assur::registry::#run>, ::assur::problem::Refused> {
            let ::core::result::Result::Ok(values) = values.try_into() else {
                return ::core::result::Result::Err(::assur::problem::Refused {
                    name: ::std::string::String::from("number of values"),
                    reason: ::std::format!(#reason, values.len()),
                });
            };
            ::assur::registry::#bind(#type_name::from_values(values))
        }
    }
}

/// The table of the constants of a scene.
pub fn constants(scene: &SceneModel) -> TokenStream {
    let entries = scene.constants.iter().map(|constant| {
        let (quantity, is_dimension) = (quantity(&constant.quantity), constant.is_dimension);
        let [default, tolerance, low, high] = [
            constant.default,
            constant.tolerance,
            constant.range.0,
            constant.range.1,
        ]
        .map(number);
        let distribution = distribution(constant.distribution);
        quote! {
            ::assur::registry::Constant {
                quantity: #quantity,
                is_dimension: #is_dimension,
                default: #default,
                tolerance: #tolerance,
                distribution: #distribution,
                range: (#low, #high),
            }
        }
    });
    quote!(&[#(#entries),*])
}

fn quantity(quantity: &QuantityInfo) -> TokenStream {
    let (name, summary, unit, factor) = (
        &quantity.name,
        &quantity.summary,
        &quantity.unit,
        number(quantity.factor),
    );
    let dimension = quantity.dimension.iter().map(|(above, below)| {
        let (above, below) = (number_of(*above), number_of(*below));
        quote!((#above, #below))
    });
    quote! {
        ::assur::registry::Quantity {
            name: #name,
            summary: #summary,
            unit: #unit,
            factor: #factor,
            dimension: [#(#dimension),*],
        }
    }
}

fn number_of(value: i8) -> TokenStream {
    let literal = Literal::u8_unsuffixed(value.unsigned_abs());
    if value < 0 {
        quote!(-#literal)
    } else {
        quote!(#literal)
    }
}

/// A place in a motion.
fn place(place: &ExpectPlace) -> TokenStream {
    let at = match place {
        ExpectPlace::Time(time) => {
            let time = number(*time);
            quote!(Time(#time))
        }
        ExpectPlace::Driver(index, position) => {
            let (index, position) = (size(*index), number(*position));
            quote!(Driver(#index, #position))
        }
        ExpectPlace::Position(places) => {
            let places = places.iter().map(|(index, position)| {
                let (index, position) = (size(*index), number(*position));
                quote!((#index, #position))
            });
            quote!(Position(&[#(#places),*]))
        }
        ExpectPlace::Maximum => quote!(Maximum),
        ExpectPlace::Minimum => quote!(Minimum),
        ExpectPlace::Amplitude => quote!(Amplitude),
        ExpectPlace::Run => quote!(Run),
    };
    quote!(::assur::registry::At::#at)
}

fn expectation(expected: &ExpectInfo, origin: &Origin<'_>) -> TokenStream {
    let at = place(&expected.at);
    let subject = match expected.quantity {
        Subject::State(index) => {
            let index = size(index);
            quote!(State(#index))
        }
        Subject::Output(index) => {
            let index = size(index);
            quote!(Output(#index))
        }
        Subject::Influence(output, variable) => {
            let (output, variable) = (size(output), size(variable));
            quote!(Influence(#output, #variable))
        }
        Subject::Measure(index) => {
            let index = size(index);
            quote!(Measure(#index))
        }
    };
    let (value, tolerance) = (number(expected.value), number(expected.tolerance));
    let (preset, remark, line) = (
        &expected.preset,
        &expected.remark,
        line(origin, expected.span),
    );
    quote! {
        ::assur::registry::Expectation {
            at: #at,
            subject: ::assur::registry::Subject::#subject,
            value: #value,
            tolerance: #tolerance,
            preset: #preset,
            remark: #remark,
            line: #line,
        }
    }
}

fn line(origin: &Origin<'_>, span: assur_model::token::Span) -> Literal {
    Literal::u32_unsuffixed((origin.line_of)(span))
}
