//! Sheets: what has no loops and does not move, evaluated at many places, emitted against hand-written.
//!
//! The map of burnishing, the flank of a gear with its normal and curvatures, and curves through a thousand points.

mod curves;
pub mod gear;

use std::hint::black_box;
use std::marker::PhantomData;

use assur::closure::{Closure, Linkage};
use assur::dispatch::{Task, dispatch};
use assur::scalar::Scalar;
use assur_equations::burnishing::Map;

use self::gear::{Flank, Still};
use crate::count::{Case, Measure, measure};
use crate::hand_curve::{Both, Even, Read, Slope, Uneven, Value};
use crate::hand_flank::ByHand;
use crate::hand_map::{Reduced, Stated};
use crate::table::{Table, number, ratio, verdict};

/// Rows that are kept at a time.
const ROWS: usize = 500;
/// Places of the flank and of the curves.
const PLACES: usize = 100_000;
/// Places along each side of the map.
const SIDE: usize = 200;

/// Something that has `O` outputs at a place with `I` coordinates, in SI units.
pub trait Sheet<S: Scalar, const I: usize, const O: usize> {
    /// The outputs at a place.
    fn row(&self, place: [S; I]) -> [S; O];
}

/// By whomever a sheet is written.
pub trait Code<const I: usize, const O: usize>: 'static {
    /// The sheet with what is constant computed.
    type Sheet<S: Scalar>: Sheet<S, I, O>;
    /// Computes what is constant.
    fn prepare<S: Scalar>() -> Self::Sheet<S>;
}

/// The emitted code of a scene.
struct Emitted<L>(PhantomData<L>);

/// An emitted scene with what is constant computed.
pub struct Prepared<C>(C);

impl<L: Linkage + Default, const I: usize, const O: usize> Code<I, O> for Emitted<L> {
    type Sheet<S: Scalar> = Prepared<L::Closure<S>>;

    #[inline(always)]
    fn prepare<S: Scalar>() -> Self::Sheet<S> {
        let values = black_box(Linkage::values(&L::default()));
        let numbers: Vec<S> = values.into_iter().map(S::from_f64).collect();
        Prepared(L::default().prepare(&numbers))
    }
}

impl<S: Scalar, C: Closure<S>, const I: usize, const O: usize> Sheet<S, I, O> for Prepared<C> {
    #[inline(always)]
    fn row(&self, place: [S; I]) -> [S; O] {
        let instant = self.0.instant(&place);
        let mut row = [S::ZERO; O];
        self.0.outputs(&instant, &self.0.zeros(), &mut row);
        row
    }
}

/// The rows of a sheet at many places, in room for some of them.
struct Filling<'a, C, const I: usize, const O: usize> {
    places: &'a [[f64; I]],
    rows: &'a mut [[f64; O]],
    code: PhantomData<C>,
}

impl<C: Code<I, O>, const I: usize, const O: usize> Task for Filling<'_, C, I, O> {
    type Output = ();

    #[inline(always)]
    fn run<S: Scalar>(self) {
        let sheet = C::prepare::<S>();
        for places in self.places.chunks(self.rows.len()) {
            for (place, row) in places.iter().zip(&mut *self.rows) {
                let mut at = [S::ZERO; I];
                for (slot, number) in at.iter_mut().zip(place) {
                    *slot = S::from_f64(*number);
                }
                for (slot, number) in row.iter_mut().zip(sheet.row(at)) {
                    *slot = number.to_f64();
                }
            }
            black_box(&mut *self.rows);
        }
    }
}

#[inline(never)]
fn fill<C: Code<I, O>, const I: usize, const O: usize>(
    is_plain: bool,
    places: &[[f64; I]],
    rows: &mut [[f64; O]],
) {
    let filling = Filling { places, rows, code: PhantomData::<C> };
    if is_plain { filling.run::<f64>() } else { dispatch(filling) }
}

/// The code `C` on plain numbers and dispatched, under two names.
fn pair<C: Code<I, O>, const I: usize, const O: usize>(
    names: [&'static str; 2],
    places: fn() -> Vec<[f64; I]>,
) -> impl Iterator<Item = Case<'static>> {
    names.into_iter().zip([true, false]).map(move |(name, is_plain)| {
        let places = places();
        let mut rows = vec![[0.0; O]; ROWS];
        Case::new(name, places.len(), move || fill::<C, I, O>(is_plain, &places, &mut rows))
    })
}

/// Feeds and speeds of the map.
fn map() -> Vec<[f64; 2]> {
    let part = |index: usize| index as f64 / (SIDE - 1) as f64;
    let all = (0..SIDE * SIDE).map(|index| (part(index / SIDE), part(index % SIDE)));
    all.map(|(feed, speed)| [0.05e-3 + 0.15e-3 * feed, 0.5 + 4.5 * speed]).collect()
}

/// Places on the flank.
fn flank() -> Vec<[f64; 2]> {
    let inside =
        |range: [f64; 2], part: f64| (range[0] + (range[1] - range[0]) * part).to_radians();
    let all = (0..PLACES).map(|index| (share(index, 0.754_877_666), share(index, 0.569_840_291)));
    all.map(|(u, th)| [inside([7.5, 51.5], u), inside([-14.5, 3.5], th)]).collect()
}

/// Abscissas without order.
fn abscissas() -> Vec<[f64; 1]> {
    (0..PLACES).map(|index| [0.999 * share(index, 0.618_033_988_749)]).collect()
}

/// Numbers between 0 and 1 that leave no gaps.
fn share(index: usize, step: f64) -> f64 {
    (0.5 + index as f64 * step).fract()
}

/// A sheet and the codes of it: what they are called, the first one being what the others are compared with, and which of
/// them is the emitted one that has to keep the goal.
struct Group {
    title: &'static str,
    goal: f64,
    codes: &'static [&'static str],
    emitted: usize,
}

const GROUPS: [Group; 8] = [
    Group {
        title: "Map of burnishing, 200 feeds and 200 speeds",
        goal: 1.2,
        codes: &["hand, formulas as stated", "hand, reduced on paper", "emitted"],
        emitted: 2,
    },
    Group {
        title: "Gear flank: point, normal, curvatures",
        goal: 1.1,
        codes: &["hand", "emitted, forms of the turned flank", "emitted, as in gear_flank.eqn"],
        emitted: 2,
    },
    Group::curve("Curve through even points"),
    Group::curve("Derivative of that curve"),
    Group::curve("Curve through even points and its derivative"),
    Group::curve("Curve through uneven points"),
    Group::curve("Derivative of that curve"),
    Group::curve("Curve through uneven points and its derivative"),
];

impl Group {
    const fn curve(title: &'static str) -> Self {
        Self { title, goal: 1.1, codes: &["hand", "emitted"], emitted: 1 }
    }
}

/// Everything that is measured, in the order of the groups and their codes: each plain and dispatched.
pub fn cases() -> Vec<Case<'static>> {
    macro_rules! pairs {
        ($($name:literal: $code:ty, $inputs:literal, $outputs:literal, $places:ident;)*) => {{
            let mut cases = Vec::new();
            $(
                let names = [$name, concat!($name, "-dispatched")];
                cases.extend(pair::<$code, $inputs, $outputs>(names, $places));
            )*
            cases
        }};
    }
    pairs! {
        "map-stated": Stated, 2, 4, map;
        "map-reduced": Reduced, 2, 4, map;
        "map-emitted": Emitted<Map>, 2, 4, map;
        "flank-hand": ByHand, 2, 10, flank;
        "flank-emitted": Emitted<Flank>, 2, 10, flank;
        "flank-still": Emitted<Still>, 2, 10, flank;
        "even-hand": Read<Even, Value>, 1, 1, abscissas;
        "even-emitted": Emitted<curves::Even>, 1, 1, abscissas;
        "even-slope-hand": Read<Even, Slope>, 1, 1, abscissas;
        "even-slope-emitted": Emitted<curves::EvenSlope>, 1, 1, abscissas;
        "even-both-hand": Read<Even, Both>, 1, 2, abscissas;
        "even-both-emitted": Emitted<curves::EvenBoth>, 1, 2, abscissas;
        "uneven-hand": Read<Uneven, Value>, 1, 1, abscissas;
        "uneven-emitted": Emitted<curves::Uneven>, 1, 1, abscissas;
        "uneven-slope-hand": Read<Uneven, Slope>, 1, 1, abscissas;
        "uneven-slope-emitted": Emitted<curves::UnevenSlope>, 1, 1, abscissas;
        "uneven-both-hand": Read<Uneven, Both>, 1, 2, abscissas;
        "uneven-both-emitted": Emitted<curves::UnevenBoth>, 1, 2, abscissas;
    }
}

/// Checks that all codes of a sheet agree.
fn check() {
    agree::<Stated, Reduced, 2, 4>(&map());
    agree::<Stated, Emitted<Map>, 2, 4>(&map());
    agree::<ByHand, Emitted<Flank>, 2, 10>(&flank());
    agree::<ByHand, Emitted<Still>, 2, 10>(&flank());
    agree::<Read<Even, Both>, Emitted<curves::EvenBoth>, 1, 2>(&abscissas());
    agree::<Read<Even, Value>, Emitted<curves::Even>, 1, 1>(&abscissas());
    agree::<Read<Even, Slope>, Emitted<curves::EvenSlope>, 1, 1>(&abscissas());
    agree::<Read<Uneven, Both>, Emitted<curves::UnevenBoth>, 1, 2>(&abscissas());
    agree::<Read<Uneven, Value>, Emitted<curves::Uneven>, 1, 1>(&abscissas());
    agree::<Read<Uneven, Slope>, Emitted<curves::UnevenSlope>, 1, 1>(&abscissas());
}

/// Checks that two codes find the same, to a part of the largest value in a column.
fn agree<A: Code<I, O>, B: Code<I, O>, const I: usize, const O: usize>(places: &[[f64; I]]) {
    let [mut one, mut other] = [(); 2].map(|()| vec![[0.0; O]; places.len()]);
    for is_plain in [true, false] {
        fill::<A, I, O>(is_plain, places, &mut one);
        fill::<B, I, O>(is_plain, places, &mut other);
        for column in 0..O {
            let largest = one.iter().fold(0.0, |largest: f64, row| largest.max(row[column].abs()));
            for ((one, other), place) in one.iter().zip(&other).zip(places) {
                let wrong = (one[column] - other[column]).abs();
                let (one, other) = (one[column], other[column]);
                assert!(wrong <= 1e-11 * largest, "{column} at {place:?}: {one}, {other}");
            }
        }
    }
}

/// Measures and prints.
pub fn report() {
    check();
    let mut measures = &measure("sheets", &mut cases(), 60)[..];
    for Group { title, goal, codes, emitted } in GROUPS {
        let (group, rest) = measures.split_at(2 * codes.len());
        measures = rest;
        let columns = ["code", "instructions", "ratio", "time, ns", "ratio"];
        let mut table = Table::new(title, &columns);
        let kinds = [("", 0), (", dispatched", 1)];
        for (suffix, kind) in kinds {
            let reference = &group[kind];
            for (code, one) in codes.iter().zip(group.iter().skip(kind).step_by(2)) {
                table.row([
                    format!("{code}{suffix}"),
                    number(one.instructions),
                    ratio(one.instructions, reference.instructions),
                    number(one.nanoseconds()),
                    ratio(one.nanoseconds(), reference.nanoseconds()),
                ]);
            }
        }
        table.print();
        for (suffix, kind) in kinds {
            let pair = |of: fn(&Measure) -> Option<f64>| {
                (of(&group[2 * emitted + kind]), of(&group[kind]))
            };
            let (counts, times) = (pair(|one| one.instructions), pair(Measure::nanoseconds));
            verdict(&format!("emitted / hand{suffix}, instructions"), counts.0, counts.1, goal);
            verdict(&format!("emitted / hand{suffix}, time"), times.0, times.1, goal);
        }
    }
}
