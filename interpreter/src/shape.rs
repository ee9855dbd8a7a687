//! What a scene is made of, from the checked model.
//!
//! A shape is borrowed for ever, as that of emitted code is, which is a constant: what is made here is never given back.

use assur_model::checked::{
    AugmentedInfo, ConstantInfo, Direction, Distribution, ExpectInfo, ExpectPlace, GroupKind,
    LinkageInfo, LoopInfo, ModeModel, Moment, Primitive, PrimitiveKind, QuantityInfo, SceneModel,
    SolvedInfo, Subject, SynthesisInfo, VariableInfo,
};
use assur_model::token::Span;
use assur_solvers::shape::{self, Shape, Text};

/// Says in which line a place of the file stands.
pub type Lines<'a> = &'a dyn Fn(Span) -> u32;

/// A text that stays.
pub fn text(text: &str) -> Text {
    match text {
        "" => "",
        text => Box::leak(text.to_owned().into_boxed_str()),
    }
}

/// A list that stays.
pub fn list<T>(items: impl IntoIterator<Item = T>) -> &'static [T] {
    Box::leak(items.into_iter().collect::<Vec<T>>().into_boxed_slice())
}

/// The shape of a scene.
pub fn shape(scene: &SceneModel, lines: Lines<'_>) -> &'static Shape {
    let quantities = |all: &[QuantityInfo]| list(all.iter().map(quantity));
    let program = scene.modes.get(scene.first).map_or(&scene.program, |mode| &mode.program);
    let uses = scene.measures.iter().map(|measure| list(measure.uses.iter().copied()));
    let primitives = scene.primitives.iter().map(|one| primitive(one, &scene.modes));
    let equations = scene.equations.iter();
    let equations = equations
        .map(|one| shape::EquationText::new(lines(one.span), text(&one.text), text(&one.unit)));
    let counts = scene.counts(&scene.program.staging());
    let marks = scene.marks.iter().map(|mark| shape::Mark::new(text(&mark.text), place(&mark.at)));
    let links = scene.links.iter();
    let links = links.map(|one| shape::Link::new(list(one.points.clone()), text(&one.text)));
    let entry = |linkage: &LinkageInfo| linkage_entry(scene, linkage, lines);
    Box::leak(Box::new(Shape {
        name: text(&scene.name),
        summary: text(&scene.summary),
        effects: list(scene.effects.iter().map(|one| text(one))),
        choices: list(scene.choices.iter().map(|(choice, held)| (text(choice), text(held)))),
        preset: text(&scene.preset),
        constants: list(scene.constants.iter().map(constant)),
        drivers: quantities(&scene.drivers),
        states: quantities(&scene.states),
        coordinates: scene.coordinates,
        scales: list(scene.scales.iter().copied()),
        outputs: quantities(&scene.outputs),
        measures: list(scene.measures.iter().map(|one| quantity(&one.quantity))),
        uses: list(uses),
        primitives: list(primitives),
        measured: program.results.measured.len(),
        synthesis: scene.synthesis.as_ref().map(synthesis),
        equations: list(equations),
        operations: shape::Operations::of(counts.all()),
        marks: list(marks),
        expectations: list(scene.expectations.iter().map(|one| expectation(one, lines))),
        is_linear: scene.program.linear,
        modes: list(scene.modes.iter().map(|mode| mode_entry(mode, scene.coordinates, lines))),
        first: scene.first,
        linkage: scene.linkage.as_ref().map(entry),
        reduced: scene.reduced.as_ref().map(entry),
        augmented: scene.augmented.as_ref().map(|one| augmented(one, scene.coordinates, lines)),
        felt: list(scene.felt.iter().map(|one| text(one))),
        points: list(scene.points.iter().map(|one| text(one))),
        links: list(links),
        arrows: list(scene.arrows.iter().copied()),
        carried: list(scene.carried.iter().map(|one| loop_entry(one, lines))),
    }))
}

fn quantity(info: &QuantityInfo) -> shape::Quantity {
    shape::Quantity {
        name: text(&info.name),
        summary: text(&info.summary),
        unit: text(&info.unit),
        factor: info.factor,
        dimension: info.dimension,
    }
}

fn constant(info: &ConstantInfo) -> shape::Constant {
    shape::Constant {
        quantity: quantity(&info.quantity),
        is_dimension: info.is_dimension,
        default: info.default,
        tolerance: info.tolerance,
        distribution: distribution((info.tolerance, info.distribution), info.default),
        range: info.range,
    }
}

fn synthesis(info: &SynthesisInfo) -> shape::Synthesis {
    let varied = info.varied.iter().map(|one| {
        let values = list(one.values.iter().copied());
        shape::Varied::new(one.constant, (one.from, one.to), values)
    });
    shape::Synthesis {
        varied: list(varied),
        conditions: list(info.conditions.iter().copied()),
        preferences: list(info.preferences.iter().copied()),
        objective: info.objective,
        squares: list(info.squares.iter().copied()),
        solved: info.solved.as_ref().map(solved),
    }
}

fn solved(info: &SolvedInfo) -> shape::Solved {
    let terms = info
        .terms
        .iter()
        .map(|term| shape::Term::new(term.quantity, term.moves, list(term.powers.iter().copied())));
    shape::Solved {
        text: text(&info.text),
        unknowns: list(info.unknowns.iter().copied()),
        terms: list(terms),
        scanned: info.scanned,
        free: info.free,
        groups: list(info.groups.iter().copied()),
    }
}

/// How what has a half-width errs about a mean.
fn distribution((half_width, distribution): (f64, Distribution), mean: f64) -> shape::Distribution {
    match distribution {
        Distribution::Normal => shape::Distribution::Normal,
        Distribution::Uniform => shape::Distribution::Uniform,
        Distribution::Truncated => shape::Distribution::Truncated,
        Distribution::Lognormal => shape::Distribution::Lognormal { ratio: half_width / mean },
    }
}

fn mode_entry(mode: &ModeModel, coordinates: usize, lines: Lines<'_>) -> shape::ModeEntry {
    let events = mode.events.iter().zip(&mode.program.results.events);
    let events = events.map(|(event, computed)| shape::EventEntry {
        text: text(&event.text),
        direction: match event.direction {
            Direction::Rises => shape::Direction::Rises,
            Direction::Falls => shape::Direction::Falls,
            Direction::Crosses => shape::Direction::Crosses,
        },
        unit: text(&event.unit),
        factor: event.factor,
        target: event.target,
        surface: event.surface,
        conditional: computed.condition.is_some(),
        sets: !computed.after.is_empty(),
        // A surface is no statement: its number, from the end, tells it from others.
        line: event.surface.map_or_else(|| lines(event.span), |index| u32::MAX - index as u32),
    });
    shape::ModeEntry {
        name: text(&mode.name),
        summary: text(&mode.summary),
        events: list(events),
        held: list(mode.held.iter().copied()),
        kinks: mode.program.kinks,
        turns: mode.program.turns,
        augmented: mode.augmented.as_ref().map(|one| augmented(one, coordinates, lines)),
    }
}

fn augmented(one: &AugmentedInfo, coordinates: usize, lines: Lines<'_>) -> shape::Augmented {
    shape::Augmented {
        coordinates,
        loops: list(one.loops.iter().map(|one| loop_entry(one, lines))),
        rank: one.rank,
        sizes: list(one.sizes.iter().copied()),
        kept: list(one.kept.iter().copied()),
        redundant: list(one.redundant.iter().copied()),
    }
}

fn loop_entry(one: &LoopInfo, lines: Lines<'_>) -> shape::Loop {
    shape::Loop::new(lines(one.span), text(&one.name), text(&one.unit), one.factor)
}

fn linkage_entry(
    scene: &SceneModel,
    linkage: &LinkageInfo,
    lines: Lines<'_>,
) -> shape::LinkageEntry {
    let closing = &scene.program.results.closing;
    let variables = linkage.variables.iter().map(|variable| match variable {
        VariableInfo::Constant(index) => shape::Variable::Constant(*index),
        VariableInfo::Driver(index) => shape::Variable::Driver(*index),
    });
    let groups = linkage.groups.iter().map(|group| shape::Group {
        kind: match group.kind {
            GroupKind::Linear => shape::GroupKind::Linear,
            GroupKind::Angle => shape::GroupKind::Angle,
            GroupKind::Distance => shape::GroupKind::Distance,
            GroupKind::Rrr => shape::GroupKind::Rrr,
            GroupKind::Rrp => shape::GroupKind::Rrp,
            GroupKind::Rpr => shape::GroupKind::Rpr,
            GroupKind::General => shape::GroupKind::General,
        },
        unknowns: list(group.unknowns.iter().copied()),
        equations: list(group.equations.iter().copied()),
    });
    let tolerances = linkage
        .ranges
        .iter()
        .map(|range| (range.tolerance.0, distribution(range.tolerance, range.start)));
    shape::LinkageEntry {
        dependents: list(linkage.dependents.iter().map(|one| quantity(&one.quantity))),
        loops: list(linkage.loops.iter().map(|one| loop_entry(one, lines))),
        angles: list(linkage.dependents.iter().map(|one| one.is_angle)),
        cosines: list(closing.cosines.iter().copied()),
        groups: list(groups),
        variables: list(variables),
        motion: if closing.rates.is_empty() { 0 } else { closing.rates.len() + 1 },
        second: !closing.second.is_empty(),
        tolerances: list(tolerances),
    }
}

fn primitive(one: &Primitive, modes: &[ModeModel]) -> shape::Primitive {
    let harmonic = |angle: usize, rate: usize| (angle, rate);
    let kind = match &one.kind {
        PrimitiveKind::Peak => shape::Kind::Peak,
        PrimitiveKind::Lowest => shape::Kind::Lowest,
        PrimitiveKind::Mean => shape::Kind::Mean,
        PrimitiveKind::Rms => shape::Kind::Rms,
        PrimitiveKind::Integral => shape::Kind::Integral,
        PrimitiveKind::Duration => shape::Kind::Duration,
        PrimitiveKind::Travel => shape::Kind::Travel,
        PrimitiveKind::Straightness(along) => shape::Kind::Straightness(*along),
        PrimitiveKind::Value(when) => shape::Kind::Value(moment(when, modes)),
        PrimitiveKind::Count(when) => shape::Kind::Count(moment(when, modes)),
        PrimitiveKind::Cosine(angle, rate, order) => {
            shape::Kind::Cosine { angle: harmonic(*angle, *rate), order: *order }
        }
        PrimitiveKind::Sine(angle, rate, order) => {
            shape::Kind::Sine { angle: harmonic(*angle, *rate), order: *order }
        }
        PrimitiveKind::Frequency(number) => shape::Kind::Frequency(*number),
        PrimitiveKind::Damping(number) => shape::Kind::Damping(*number),
        PrimitiveKind::Multiplier(number) => shape::Kind::Multiplier(*number),
        PrimitiveKind::Detuning(number) => shape::Kind::Detuning(*number),
    };
    shape::Primitive { kind, argument: one.argument, window: one.window }
}

fn moment(moment: &Moment, modes: &[ModeModel]) -> shape::Moment {
    let named = |name: &str| {
        let places = modes.iter().enumerate().flat_map(|(mode, one)| {
            let events = one.events.iter().enumerate();
            let own = events.filter(|(_, event)| event.label.as_deref() == Some(name));
            own.map(move |(event, _)| (mode, event))
        });
        shape::NamedEvent { name: text(name), places: list(places) }
    };
    match moment {
        Moment::Start => shape::Moment::Start,
        Moment::End => shape::Moment::End,
        Moment::Passes(index, last) => shape::Moment::Passes { index: *index, last: *last },
        Moment::Enter(mode, last) => shape::Moment::Enter { mode: *mode, last: *last },
        Moment::Leave(mode, last) => shape::Moment::Leave { mode: *mode, last: *last },
        Moment::Before(event, last) => shape::Moment::Before { event: named(event), last: *last },
        Moment::After(event, last) => shape::Moment::After { event: named(event), last: *last },
    }
}

fn place(place: &ExpectPlace) -> shape::At {
    match place {
        ExpectPlace::Time(time) => shape::At::Time(*time),
        ExpectPlace::Driver(index, position) => shape::At::Driver(*index, *position),
        ExpectPlace::Position(places) => shape::At::Position(list(places.iter().copied())),
        ExpectPlace::Maximum => shape::At::Maximum,
        ExpectPlace::Minimum => shape::At::Minimum,
        ExpectPlace::Amplitude => shape::At::Amplitude,
        ExpectPlace::Run => shape::At::Run,
    }
}

fn expectation(one: &ExpectInfo, lines: Lines<'_>) -> shape::Expectation {
    shape::Expectation {
        at: place(&one.at),
        subject: match one.quantity {
            Subject::State(index) => shape::Subject::State(index),
            Subject::Output(index) => shape::Subject::Output(index),
            Subject::Influence(output, variable) => shape::Subject::Influence(output, variable),
            Subject::Measure(index) => shape::Subject::Measure(index),
        },
        value: one.value,
        tolerance: one.tolerance,
        preset: text(&one.preset),
        remark: text(&one.remark),
        line: lines(one.span),
    }
}
