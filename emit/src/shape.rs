//! The shapes of the scenes, in a module `shapes_` of their own: what several scenes have in common, units,
//! constants and lists of quantities, stands there once.

use std::collections::BTreeMap;

use assur_model::checked::{
    ConstantInfo, Direction, Distribution, ExpectInfo, ExpectPlace, GroupKind, LinkageInfo,
    LoopInfo, ModeModel, QuantityInfo, SceneModel, Subject, VariableInfo,
};
use assur_model::program::Program;
use assur_model::token::Span;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::expression::{number, size};
use crate::layout::Layout;
use crate::{Origin, measures};

/// The module with the shapes of all scenes, which have the names of their types.
pub fn module(layouts: &[Layout<'_>], origin: &Origin<'_>) -> TokenStream {
    let mut shared = Shared::default();
    let shapes: Vec<TokenStream> =
        layouts.iter().map(|layout| shape(layout, origin, &mut shared)).collect();
    let Shared { units, constants, lists } = &shared;
    let (units, constants, lists) = (units.items(), constants.items(), lists.items());
    let count = size(constants.len());
    let units = units.iter().enumerate().map(|(index, unit)| {
        let name = format_ident!("unit_{index}_");
        quote!(const #name: Unit = #unit;)
    });
    let lists = lists.iter().enumerate().map(|(index, list)| {
        let name = format_ident!("list_{index}_");
        quote!(static #name: &[Quantity] = &[#list];)
    });
    quote! {
        mod shapes_ {
            use ::assur::shape::tables::*;

            #(#units)*
            const constants_: [Constant; #count] = [#(#constants),*];
            #(#lists)*
            #(#shapes)*
        }
    }
}

/// Texts that occur several times, each once, in the order of their first occurrence.
#[derive(Default)]
struct Once(BTreeMap<String, (usize, TokenStream)>);

impl Once {
    /// The place of a text.
    fn place(&mut self, text: TokenStream) -> usize {
        let next = self.0.len();
        self.0.entry(text.to_string()).or_insert((next, text)).0
    }

    fn items(&self) -> Vec<TokenStream> {
        let mut items: Vec<_> = self.0.values().collect();
        items.sort_by_key(|one| one.0);
        items.into_iter().map(|one| one.1.clone()).collect()
    }
}

/// What scenes have in common.
#[derive(Default)]
struct Shared {
    units: Once,
    constants: Once,
    lists: Once,
}

impl Shared {
    fn unit(&mut self, quantity: &QuantityInfo) -> Ident {
        let (symbol, factor) = (&quantity.unit, number(quantity.factor));
        let [above, below] = [0, 1].map(|part| {
            let exponents = quantity.dimension.iter();
            let part = exponents.map(|(above, below)| [*above, *below][part]);
            let part = part.map(Literal::i8_unsuffixed);
            quote!([#(#part),*])
        });
        let whole = quantity.dimension.iter().all(|exponent| exponent.1 == 1);
        let unit = match whole {
            true => quote!(Unit::new(#symbol, #factor, #above)),
            false => quote!(Unit::over(#symbol, #factor, #above, #below)),
        };
        format_ident!("unit_{}_", self.units.place(unit))
    }

    fn quantity(&mut self, quantity: &QuantityInfo) -> TokenStream {
        let (name, summary, unit) = (&quantity.name, &quantity.summary, self.unit(quantity));
        quote!(Quantity::new(#name, #summary, #unit))
    }

    fn quantities<'a>(&mut self, list: impl Iterator<Item = &'a QuantityInfo>) -> TokenStream {
        let list: Vec<TokenStream> = list.map(|one| self.quantity(one)).collect();
        if list.is_empty() {
            return quote!(&[]);
        }
        let name = format_ident!("list_{}_", self.lists.place(quote!(#(#list),*)));
        quote!(#name)
    }

    fn constant(&mut self, constant: &ConstantInfo) -> usize {
        let quantity = self.quantity(&constant.quantity);
        let kind = match constant.is_dimension {
            true => quote!(dimension),
            false => quote!(parameter),
        };
        let (low, high) = (number(constant.range.0), number(constant.range.1));
        let made = (constant.tolerance != 0.0 || constant.distribution != Distribution::Normal)
            .then(|| {
                let tolerance = number(constant.tolerance);
                let made = (constant.tolerance, constant.distribution);
                let distribution = distribution(made, constant.default);
                quote!(.made(#tolerance, #distribution))
            });
        self.constants.place(quote!(Constant::#kind(#quantity, #low, #high) #made))
    }
}

/// A call that sets a list; nothing where it is empty.
fn list(name: &str, items: impl Iterator<Item = TokenStream>) -> Option<TokenStream> {
    let items: Vec<TokenStream> = items.collect();
    let name = format_ident!("{name}");
    (!items.is_empty()).then(|| quote!(.#name(&[#(#items),*])))
}

fn shape(layout: &Layout<'_>, origin: &Origin<'_>, shared: &mut Shared) -> TokenStream {
    let scene = layout.scene;
    let (type_name, name) = (&layout.parameters, &scene.name);
    let text = |name: &str, text: &str| {
        let name = format_ident!("{name}");
        (!text.is_empty()).then(|| quote!(.#name(#text)))
    };
    let (summary, preset) = (text("summary", &scene.summary), text("preset", &scene.preset));
    let effects = list("effects", scene.effects.iter().map(|one| quote!(#one)));
    let choices = scene.choices.iter().map(|(choice, held)| quote!((#choice, #held)));
    let choices = list("choices", choices);
    let constants = constants(scene, shared);
    let [drivers, outputs] =
        [("drivers", &scene.drivers), ("outputs", &scene.outputs)].map(|(name, quantities)| {
            let (name, some) = (format_ident!("{name}"), shared.quantities(quantities.iter()));
            (!quantities.is_empty()).then(|| quote!(.#name(#some)))
        });
    let states = (!scene.states.is_empty()).then(|| {
        let states = shared.quantities(scene.states.iter());
        let scales = scene.scales.iter().map(|value| number(*value));
        let coordinates = (scene.coordinates > 0).then(|| {
            let count = size(scene.coordinates);
            quote!(.coordinates(#count))
        });
        quote!(.states(#states, &[#(#scales),*]) #coordinates)
    });
    let measured = shared.quantities(scene.measures.iter().map(|one| &one.quantity));
    let measures = measures::call(scene, &measured);
    let equations = scene.equations.iter().map(|equation| {
        let (line, text, unit) = (line(origin, equation.span), &equation.text, &equation.unit);
        quote!(EquationText::new(#line, #text, #unit))
    });
    let equations = list("equations", equations);
    let operations = layout.counts.all().map(size);
    let marks = scene.marks.iter().map(|mark| {
        let (text, at) = (&mark.text, place(&mark.at));
        quote!(Mark::new(#text, #at))
    });
    let marks = list("marks", marks);
    let expectations = scene.expectations.iter().map(|one| expectation(one, origin));
    let expectations = list("expectations", expectations);
    let linear = layout.program().linear.then(|| quote!(.linear()));
    let modes = modes(layout, origin);
    let linkage = scene.linkage.as_ref();
    let linkage = linkage.map(|loops| linkage_entry(layout, ("linkage", loops), origin, shared));
    let reduced = scene.reduced.as_ref();
    let reduced = reduced.map(|loops| linkage_entry(layout, ("reduced", loops), origin, shared));
    let augmented = augmented(scene, origin);
    let points = list("points", scene.points.iter().map(|one| quote!(#one)));
    let links = scene.links.iter().map(|link| {
        let (points, text) = (link.points.iter().map(|one| size(*one)), &link.text);
        quote!(Link::new(&[#(#points),*], #text))
    });
    let links = list("links", links);
    let arrows = list(
        "arrows",
        scene.arrows.iter().map(|one| {
            let first = size(*one);
            quote!(#first)
        }),
    );
    let felt = list("felt", scene.felt.iter().map(|one| quote!(#one)));
    let carried = scene.carried.iter().map(|one| loop_entry(one, origin));
    let carried = list("carried", carried);
    // The loops of a linkage are unrolled by what its shape says: a constant is seen wherever they are compiled.
    let kind = match &linkage {
        Some(_) => quote!(const),
        None => quote!(static),
    };
    quote! {
        pub #kind #type_name: Shape = Shape::named(#name)
            #summary #effects #choices #preset #constants #drivers #states #linear #outputs #measures
            #equations .operations(Operations::of([#(#operations),*])) #marks #expectations
            #modes #linkage #reduced #augmented #felt #carried #points #links #arrows;
    }
}

/// The closures that hold the coordinates of a scene, or of a mode.
fn augmented(scene: &SceneModel, origin: &Origin<'_>) -> Option<TokenStream> {
    let one = scene.augmented.as_ref()?;
    let loops = one.loops.iter().map(|one| loop_entry(one, origin));
    let [kept, redundant] = [&one.kept, &one.redundant]
        .map(|list| list.iter().map(|one| size(*one)).collect::<Vec<_>>());
    let (coordinates, rank) = (size(scene.coordinates), size(one.rank));
    let sizes = one.sizes.iter().map(|size| number(*size));
    Some(quote!(.augmented(Augmented {
        coordinates: #coordinates,
        loops: &[#(#loops),*],
        rank: #rank,
        sizes: &[#(#sizes),*],
        kept: &[#(#kept),*],
        redundant: &[#(#redundant),*],
    })))
}

/// Those of the mechanism that the scene depends on, with its defaults.
fn constants(scene: &SceneModel, shared: &mut Shared) -> Option<TokenStream> {
    if scene.constants.is_empty() {
        return None;
    }
    let places = scene.constants.iter();
    let places: Vec<Literal> = places.map(|one| size(shared.constant(one))).collect();
    let defaults = scene.constants.iter().map(|one| number(one.default));
    Some(quote!(.constants(&Constant::some(&constants_, [#(#places),*], [#(#defaults),*]))))
}

fn modes(layout: &Layout<'_>, origin: &Origin<'_>) -> Option<TokenStream> {
    let modes = layout.scene.modes.iter().zip(&layout.modes);
    let modes = modes.map(|(mode, own)| {
        let (name, summary) = (&mode.name, &mode.summary);
        let events = events(mode, own.program(), origin);
        let held = mode.held.iter().map(|place| size(*place));
        let held = (!mode.held.is_empty()).then(|| quote!(.holds(&[#(#held),*])));
        let (kinks, turns) = (own.program().kinks, own.program().turns);
        let bends = (kinks + turns > 0).then(|| {
            let (kinks, turns) = (size(kinks), size(turns));
            quote!(.bends(#kinks, #turns))
        });
        let augmented = augmented(own.scene, origin);
        quote!(ModeEntry::new(#name, #summary, &[#(#events),*]) #held #bends #augmented)
    });
    let first = size(layout.scene.first);
    (!layout.modes.is_empty()).then(|| quote!(.modes(&[#(#modes),*], #first)))
}

fn events<'a>(
    mode: &'a ModeModel,
    program: &'a Program,
    origin: &'a Origin<'_>,
) -> impl Iterator<Item = TokenStream> + 'a {
    let entries = mode.events.iter().zip(&program.results.events);
    entries.map(|(event, computed)| {
        let direction = match event.direction {
            Direction::Rises => quote!(Direction::Rises),
            Direction::Falls => quote!(Direction::Falls),
            Direction::Crosses => quote!(Direction::Crosses),
        };
        let (text, unit, factor) = (&event.text, &event.unit, number(event.factor));
        let target = size(event.target);
        // A surface is no statement: its number, from the end, tells it from others.
        let line = Literal::u32_unsuffixed(match event.surface {
            Some(index) => u32::MAX - index as u32,
            None => (origin.line_of)(event.span),
        });
        let surface = event.surface.map(|index| {
            let index = size(index);
            quote!(.surface(#index))
        });
        let conditional = computed.condition.map(|_| quote!(.conditional()));
        let sets = (!computed.after.is_empty()).then(|| quote!(.sets()));
        quote! {
            EventEntry::new(#line, #text, #direction, #unit, #factor, #target) #conditional #sets #surface
        }
    })
}

/// The loops of a linkage, or of a motion.
fn linkage_entry(
    layout: &Layout<'_>,
    (setter, linkage): (&str, &LinkageInfo),
    origin: &Origin<'_>,
    shared: &mut Shared,
) -> TokenStream {
    let closing = &layout.program().results.closing;
    let motion = match closing.rates.len() {
        0 => 0,
        rates => rates + 1,
    };
    let (motion, second) = (size(motion), !closing.second.is_empty());
    let (angles, groups) = (linkage.dependents.iter().map(|one| one.is_angle), groups(linkage));
    let cosines = closing.cosines.iter().map(|place| match place.map(size) {
        Some(place) => quote!(Some(#place)),
        None => quote!(None),
    });
    let variables = linkage.variables.iter().map(|variable| match variable {
        VariableInfo::Constant(index) => {
            let index = size(*index);
            quote!(Variable::Constant(#index))
        }
        VariableInfo::Driver(index) => {
            let index = size(*index);
            quote!(Variable::Driver(#index))
        }
    });
    let dependents = shared.quantities(linkage.dependents.iter().map(|one| &one.quantity));
    let loops = linkage.loops.iter().map(|one| loop_entry(one, origin));
    let tolerances = linkage.ranges.iter().map(|range| {
        let half_width = number(range.tolerance.0);
        let kind = distribution(range.tolerance, range.start);
        quote!((#half_width, #kind))
    });
    let setter = format_ident!("{setter}");
    quote! {
        .#setter(LinkageEntry {
            dependents: #dependents,
            loops: &[#(#loops),*],
            angles: &[#(#angles),*],
            cosines: &[#(#cosines),*],
            groups: &[#(#groups),*],
            variables: &[#(#variables),*],
            motion: #motion,
            second: #second,
            tolerances: &[#(#tolerances),*],
        })
    }
}

fn groups(linkage: &LinkageInfo) -> impl Iterator<Item = TokenStream> + '_ {
    linkage.groups.iter().map(|group| {
        let kind = match group.kind {
            GroupKind::Linear => quote!(Linear),
            GroupKind::Angle => quote!(Angle),
            GroupKind::Distance => quote!(Distance),
            GroupKind::Rrr => quote!(Rrr),
            GroupKind::Rrp => quote!(Rrp),
            GroupKind::Rpr => quote!(Rpr),
            GroupKind::General => quote!(General),
        };
        let [unknowns, equations] = [&group.unknowns, &group.equations]
            .map(|list| list.iter().map(|one| size(*one)).collect::<Vec<_>>());
        quote! {
            Group {
                kind: GroupKind::#kind,
                unknowns: &[#(#unknowns),*],
                equations: &[#(#equations),*],
            }
        }
    })
}

fn loop_entry(one: &LoopInfo, origin: &Origin<'_>) -> TokenStream {
    let (line, name) = (line(origin, one.span), &one.name);
    let (unit, factor) = (&one.unit, number(one.factor));
    quote!(Loop::new(#line, #name, #unit, #factor))
}

/// How what has a half-width errs about a mean.
fn distribution((half_width, distribution): (f64, Distribution), mean: f64) -> TokenStream {
    match distribution {
        Distribution::Normal => quote!(Distribution::Normal),
        Distribution::Uniform => quote!(Distribution::Uniform),
        Distribution::Truncated => quote!(Distribution::Truncated),
        Distribution::Lognormal => {
            let ratio = number(half_width / mean);
            quote!(Distribution::Lognormal { ratio: #ratio })
        }
    }
}

/// A place in a motion.
fn place(place: &ExpectPlace) -> TokenStream {
    match place {
        ExpectPlace::Time(time) => {
            let time = number(*time);
            quote!(At::Time(#time))
        }
        ExpectPlace::Driver(index, position) => {
            let (index, position) = (size(*index), number(*position));
            quote!(At::Driver(#index, #position))
        }
        ExpectPlace::Position(places) => {
            let places = places.iter().map(|(index, position)| {
                let (index, position) = (size(*index), number(*position));
                quote!((#index, #position))
            });
            quote!(At::Position(&[#(#places),*]))
        }
        ExpectPlace::Maximum => quote!(At::Maximum),
        ExpectPlace::Minimum => quote!(At::Minimum),
        ExpectPlace::Amplitude => quote!(At::Amplitude),
        ExpectPlace::Run => quote!(At::Run),
    }
}

fn expectation(expected: &ExpectInfo, origin: &Origin<'_>) -> TokenStream {
    let (line, at) = (line(origin, expected.span), place(&expected.at));
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
    let text = |name: &str, text: &str| {
        let name = format_ident!("{name}");
        (!text.is_empty()).then(|| quote!(.#name(#text)))
    };
    let preset = text("preset", &expected.preset);
    let remark = text("remark", &expected.remark);
    quote!(Expectation::new(#line, Subject::#subject, #at, #value, #tolerance) #preset #remark)
}

fn line(origin: &Origin<'_>, span: Span) -> Literal {
    Literal::u32_unsuffixed((origin.line_of)(span))
}
