//! The search for extremes against the largest and smallest of very many positions, for linkages of random dimensions.
//!
//! `ASSUR_EXTREMES=200 cargo test --release --test suite extremes` tries 200 of each scene at 20 000 positions.

use assur::closure::{Along, AnyLinkage, Stroke};
use assur::problem::Span;
use assur::registry::SceneEntry;
use assur::study::each;
use assur_equations::REGISTRY;

/// How far a dimension may be from its default, as a part of it.
const SPREAD: f64 = 0.2;
/// Beside the stroke, and beside the size of the value, this part of them is rounding.
const ROUNDING: f64 = 1e-11;
/// What is nothing, over the largest value.
const NOTHING: f64 = 1e-14;

/// Random numbers from 0 to 1 (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A linkage of a scene with other dimensions; none if the mechanism refuses them.
fn varied(scene: &SceneEntry, random: &mut Random) -> Option<Box<dyn AnyLinkage>> {
    let one = |constant: &assur::shape::Constant| match constant.is_dimension {
        true => constant.default * (1.0 + SPREAD * (2.0 * random.next() - 1.0)),
        false => constant.default,
    };
    let values: Vec<f64> = scene.constants.iter().map(one).collect();
    scene.bind.linkage(&values).ok()
}

/// The tasks with one axis: the time, or each driver that is swept.
fn tasks(run: &dyn AnyLinkage) -> Vec<Along> {
    match run.span() {
        Span::Open => {
            let ranges = run.ranges().into_iter().enumerate();
            let moving = ranges.filter(|(_, range)| range.from < range.to);
            moving.map(|(index, range)| Along::Driver(index, (range.from, range.to))).collect()
        }
        span => vec![Along::Time(span.limits().0, span.limits().1)],
    }
}

/// The values of outputs and dependent coordinates at very many positions, as far as the linkage gets on both sides of its
/// start.
fn many(run: &dyn AnyLinkage, along: Along, count: usize) -> Vec<Vec<f64>> {
    let standing: Vec<f64> = run.ranges().iter().map(|range| range.start).collect();
    let (from, to) = along.bounds();
    let start = match along {
        Along::Driver(index, _) => standing[index].clamp(from, to),
        Along::Time(..) => from,
    };
    let place = |at: f64| match along {
        Along::Driver(index, _) => {
            let mut place = standing.clone();
            place[index] = at;
            place
        }
        Along::Time(..) => run.drive(at).expect("its drivers move"),
    };
    let towards = |end: f64| {
        let at = |k: usize| start + (end - start) * k as f64 / count as f64;
        let places: Vec<_> = (0..=count).map(|k| place(at(k))).collect();
        run.follow(&places).map_or(Vec::new(), |path| path.samples)
    };
    let samples = [from, to].into_iter().flat_map(towards);
    samples.map(|sample| [sample.outputs, sample.dependents].concat()).collect()
}

/// Checks that no value lies beyond the extremes of its stroke.
fn check(label: &str, strokes: &[Stroke], rows: &[Vec<f64>]) {
    let all = rows.iter().flatten().filter(|value| value.is_finite());
    let largest = all.fold(0.0_f64, |most, value| most.max(value.abs()));
    for (channel, stroke) in strokes.iter().enumerate() {
        let (low, high) = (stroke.least.value, stroke.greatest.value);
        let length = Some(high - low).filter(|length| length.is_finite()).unwrap_or(0.0);
        // What has to vanish is nothing but rounding, and has no extremes.
        if low.abs().max(high.abs()) < NOTHING * largest {
            continue;
        }
        let values = rows.iter().map(|row| row[channel]).filter(|value| value.is_finite());
        for value in values {
            let rounding = ROUNDING * (length + value.abs());
            assert!(
                low - rounding <= value && value <= high + rounding,
                "{label}, value {channel}: {value:e} lies beyond {stroke:?}"
            );
        }
    }
}

#[test]
fn no_position_lies_beyond_the_extremes() {
    let tries = std::env::var("ASSUR_EXTREMES").ok().and_then(|text| text.parse().ok());
    let count = if tries.is_some() { 20_000 } else { 250 };
    let scenes = REGISTRY.iter().flat_map(|one| one.scenes.iter().map(move |scene| (one, scene)));
    let scenes: Vec<_> = scenes.filter(|(_, scene)| scene.linkage.is_some()).collect();
    let compared = each(scenes.len(), 0, &|_| (), &|index| {
        let (mechanism, scene) = scenes[index];
        let (mut random, mut compared) = (Random(1), 0);
        for number in 0..tries.unwrap_or(3) {
            let Some(run) = varied(scene, &mut random) else {
                continue;
            };
            for along in tasks(&*run) {
                // Some dimensions do not assemble.
                let Ok(strokes) = run.strokes(along) else {
                    continue;
                };
                let label = format!("{} {} {number} {along:?}", mechanism.name, scene.name);
                check(&label, &strokes, &many(&*run, along, count));
                compared += 1;
            }
        }
        compared
    });
    let compared: i32 = compared.into_iter().sum();
    assert!(compared >= 30, "{compared} compared");
}
