//! A six-bar of two dyads: positions over a revolution, and how its output follows twelve dimensions.
//!
//! Emitted code stands here in two ways: its loops closed with fixed modes, which is what the hand-written code does,
//! and as [`Assembly`] moves it, which looks at every position whether a mode can have been left and continues angles
//! over whole turns.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::marker::PhantomData;

use assur::closure::{Assembly, Closure, Linkage};
use assur::dispatch::{Task, dispatch};
use assur::scalar::Scalar;

use crate::count::{Case, Measure, measure};
use crate::hand_linkage::{Assur, DIMENSIONS, Functions, SixBar as Hand, Std};
use crate::table::{Table, number, ratio, verdict};

assur::mechanism! {
    /// Crank-rocker O1-A-B-O2 with a dyad C-D-O3 on its coupler, as in `dwell_six_bar.eqn`.
    SixBar from "the lift rocker of a sewing feed";

    /// Crank O1-A, coupler A-B, rocker B-O2, frame O1-O2 and its direction.
    dimension L1 = 8 mm +- 0.05 mm, L2 = 60 mm +- 0.05 mm, L3 = 50 mm +- 0.05 mm, L4 = 70 mm +- 0.05 mm;
    dimension eta = 0.9 rad +- 0.1 deg;
    /// Joint C on the coupler, rod C-D, arm D-O3, its pivot.
    dimension X_C = 40 mm +- 0.05 mm, Y_C = 30 mm +- 0.05 mm;
    dimension L6 = 60 mm +- 0.05 mm, L7 = 36 mm +- 0.05 mm;
    dimension X_3 = 36 mm +- 0.05 mm, Y_3 = 96 mm +- 0.05 mm;
    /// The angle at which the crank is fastened to its shaft.
    dimension phi0 = 0.6 rad +- 0.1 deg;

    driver phi ~ 0 deg in -180 deg .. 180 deg;
    dependent theta ~ 5.6 deg, rho ~ -63 deg, sigma ~ 133 deg, Psi ~ -158 deg;

    let A = L1*dir(phi0 + phi);
    closure four_bar: A + L2*dir(theta) = L4*dir(eta) + L3*dir(rho);
    closure dyad: A + rot(theta)*[X_C, Y_C] + L6*dir(sigma) = [X_3, Y_3] + L7*dir(Psi);

    output Psi;
}

/// Revolutions in one run.
const TURNS: usize = 40;
/// Positions in one revolution.
const PLACES: usize = 360;
/// Largest ratio of the emitted code to the hand-written code.
const GOAL: f64 = 1.1;
/// Positions in a second on a core of 3 GHz.
const RATE: f64 = 2.5e6;
/// The output's coefficients: by the dimensions, and by the driver.
const VARIABLES: usize = DIMENSIONS + 1;

/// The four angles, and how the output follows each variable.
type Found<S> = ([S; 4], [S; VARIABLES]);

/// The six-bar, by whomever it is written.
trait Side<S: Scalar> {
    /// What is found at an angle of the crank, with the coefficients or without.
    fn find(&mut self, angle: S, influence: bool, found: &mut Found<S>);
}

/// By hand, with the functions of Assur or of the standard library.
struct ByHand<S, F>(Hand<S>, PhantomData<F>);

impl<S: Scalar, F: Functions<S>> ByHand<S, F> {
    #[inline(always)]
    fn new() -> Self {
        let (dimensions, modes) = nominal();
        Self(Hand::new(dimensions.map(S::from_f64), modes), PhantomData)
    }
}

impl<S: Scalar, F: Functions<S>> Side<S> for ByHand<S, F> {
    #[inline(always)]
    fn find(&mut self, angle: S, influence: bool, (angles, values): &mut Found<S>) {
        let pose = self.0.pose::<F>(angle);
        *angles = pose.angles::<F>();
        if influence {
            self.0.influence(&pose, values);
        }
    }
}

/// The emitted loops, their modes fixed.
struct Emitted<S: Scalar> {
    loops: <SixBar as Linkage>::Closure<S>,
    modes: [S; 2],
}

impl<S: Scalar> Emitted<S> {
    #[inline(always)]
    fn new() -> Self {
        let values = Linkage::values(&SixBar::default());
        let numbers: Vec<S> = values.into_iter().map(S::from_f64).collect();
        Self {
            loops: Linkage::prepare(&SixBar::default(), &numbers),
            modes: modes().map(S::from_f64),
        }
    }
}

impl<S: Scalar> Side<S> for Emitted<S> {
    #[inline(always)]
    fn find(&mut self, angle: S, influence: bool, (angles, values): &mut Found<S>) {
        let mut position = self.loops.zeros();
        let instant = self.loops.instant(&[angle]);
        let mut sines = [S::ZERO; 2];
        self.loops.close_all(&instant, &self.modes, &mut position, &mut sines, true);
        angles.copy_from_slice(&position[..4]);
        if influence {
            self.loops.influence(&instant, &position, values);
        }
    }
}

/// The emitted loops, their modes kept.
struct Kept<S: Scalar>(Assembly<SixBar, S>);

impl<S: Scalar> Kept<S> {
    #[inline(always)]
    fn new() -> Self {
        let mut assembly = Assembly::new(&SixBar::default());
        assembly.start().expect("it assembles");
        Self(assembly)
    }
}

impl<S: Scalar> Side<S> for Kept<S> {
    #[inline(always)]
    fn find(&mut self, angle: S, influence: bool, (angles, values): &mut Found<S>) {
        self.0.move_to(&[angle]).expect("the crank turns");
        angles.copy_from_slice(&self.0.position()[..4]);
        if influence {
            self.0.influence(values);
        }
    }
}

/// Positions along revolutions, by whatever code finds them; gives the last one.
#[inline(always)]
fn revolve<S: Scalar>(mut side: impl Side<S>, influence: bool) -> Flat {
    let mut found = ([S::ZERO; 4], [S::ZERO; VARIABLES]);
    for place in 0..TURNS * PLACES {
        let angle = black_box(TAU * place as f64 / PLACES as f64);
        side.find(S::from_f64(angle), influence, &mut found);
        black_box(&mut found);
    }
    flat(&found)
}

/// The codes that are compared.
#[derive(Clone, Copy)]
enum Code {
    Hand,
    Emitted,
    Kept,
}

/// Code, and whether the coefficients are wanted.
#[derive(Clone, Copy)]
struct Work(Code, bool);

impl Task for Work {
    type Output = Flat;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Flat {
        match self.0 {
            Code::Hand => revolve(ByHand::<S, Assur>::new(), self.1),
            Code::Emitted => revolve(Emitted::<S>::new(), self.1),
            Code::Kept => revolve(Kept::<S>::new(), self.1),
        }
    }
}

/// The modes of the emitted loops.
fn modes() -> [f64; 2] {
    let mut assembly = Assembly::<SixBar, f64>::new(&SixBar::default());
    assembly.start().expect("it assembles");
    [assembly.mode(0), assembly.mode(1)]
}

/// Dimensions and modes as by hand, where a mode is the sign of another product.
pub fn nominal() -> ([f64; DIMENSIONS], [f64; 2]) {
    let mut dimensions = [0.0; DIMENSIONS];
    dimensions.copy_from_slice(&Linkage::values(&SixBar::default()));
    (dimensions, modes().map(|mode| -mode))
}

/// What is found, as plain numbers.
type Flat = [f64; 4 + VARIABLES];

#[inline(always)]
fn flat<S: Scalar>((angles, values): &Found<S>) -> Flat {
    let mut all = [0.0; 4 + VARIABLES];
    for (slot, value) in all.iter_mut().zip(angles.iter().chain(values)) {
        *slot = value.to_f64();
    }
    all
}

#[inline(never)]
fn plain(work: Work) -> Flat {
    work.run::<f64>()
}

#[inline(never)]
fn dispatched(work: Work) -> Flat {
    dispatch(work)
}

#[inline(never)]
fn by_std(work: Work) -> Flat {
    revolve(ByHand::<f64, Std>::new(), work.1)
}

/// Everything that is measured: positions alone, then with the coefficients.
pub fn cases() -> Vec<Case<'static>> {
    let one = |name, code: fn(Work) -> Flat, work: Work| {
        Case::new(name, TURNS * PLACES, move || {
            black_box(code(black_box(work)));
        })
    };
    vec![
        one("position-std", by_std, Work(Code::Hand, false)),
        one("position-hand", plain, Work(Code::Hand, false)),
        one("position-emitted", plain, Work(Code::Emitted, false)),
        one("position-kept", plain, Work(Code::Kept, false)),
        one("position-hand-dispatched", dispatched, Work(Code::Hand, false)),
        one("position-emitted-dispatched", dispatched, Work(Code::Emitted, false)),
        one("position-kept-dispatched", dispatched, Work(Code::Kept, false)),
        one("influence-std", by_std, Work(Code::Hand, true)),
        one("influence-hand", plain, Work(Code::Hand, true)),
        one("influence-emitted", plain, Work(Code::Emitted, true)),
        one("influence-kept", plain, Work(Code::Kept, true)),
        one("influence-hand-dispatched", dispatched, Work(Code::Hand, true)),
        one("influence-emitted-dispatched", dispatched, Work(Code::Emitted, true)),
        one("influence-kept-dispatched", dispatched, Work(Code::Kept, true)),
    ]
}

/// Checks that all codes find the same all around, angles but for whole turns.
fn agree() {
    let mut sides: [Box<dyn Side<f64>>; 4] = [
        Box::new(ByHand::<f64, Std>::new()),
        Box::new(ByHand::<f64, Assur>::new()),
        Box::new(Emitted::new()),
        Box::new(Kept::new()),
    ];
    for place in 0..PLACES {
        let angle = TAU * place as f64 / PLACES as f64;
        let all = sides.each_mut().map(|side| {
            let mut found = ([0.0; 4], [0.0; VARIABLES]);
            side.find(angle, true, &mut found);
            flat(&found)
        });
        for (index, expected) in all[0].iter().enumerate() {
            for one in &all {
                let period = if index < 4 { TAU } else { f64::INFINITY };
                let difference = one[index] - expected;
                let turns = (difference / period).round();
                let wrong = if turns == 0.0 { difference } else { difference - turns * period };
                assert!(
                    wrong.abs() < 1e-12 * expected.abs().max(1.0),
                    "{index} at {angle}: {one:?}"
                );
            }
        }
    }
}

/// Seconds of a position with the coefficients: by hand and emitted, both dispatched.
#[cfg(feature = "peers")]
pub fn seconds() -> [f64; 2] {
    let mut cases = cases();
    let mut dispatched = cases.drain(11..13).collect::<Vec<_>>();
    let seconds = crate::count::shortest(&mut dispatched, 60);
    [seconds[0], seconds[1]]
}

/// Measures and prints.
pub fn report() {
    agree();
    let kinds = [
        "hand, functions of std",
        "hand, functions of Assur",
        "emitted",
        "emitted, modes kept",
        "hand, functions of Assur, dispatched",
        "emitted, dispatched",
        "emitted, modes kept, dispatched",
    ];
    let titles = [
        "Positions of a six-bar of two dyads",
        "Positions of the six-bar and 13 influence coefficients",
    ];
    let measures = measure("linkage", &mut cases(), 60);
    let groups = titles.into_iter().zip(["positions", "with coefficients"]);
    for ((title, which), group) in groups.zip(measures.chunks(kinds.len())) {
        let columns = ["code", "instructions", "ratio", "time, ns", "ratio"];
        let mut table = Table::new(title, &columns);
        for (index, (kind, one)) in kinds.into_iter().zip(group).enumerate() {
            let reference = &group[if index < 4 { 1 } else { 4 }];
            table.row([
                kind.to_owned(),
                number(one.instructions),
                ratio(one.instructions, reference.instructions),
                number(one.nanoseconds()),
                one.over(reference),
            ]);
        }
        table.print();
        for (what, found, reference) in [
            ("emitted, dispatched / hand on std", 5, 0),
            ("emitted / hand on Assur", 2, 1),
            ("emitted / hand on Assur, dispatched", 5, 4),
            ("modes kept / emitted, dispatched", 6, 5),
        ] {
            let pair = |of: fn(&Measure) -> Option<f64>| (of(&group[found]), of(&group[reference]));
            let (counts, times) = (pair(|one| one.instructions), pair(Measure::nanoseconds));
            verdict(&format!("{which}, {what}, instructions"), counts.0, counts.1, GOAL);
            verdict(&format!("{which}, {what}, time"), times.0, times.1, GOAL);
        }
        let emitted = [2, 3, 5, 6].map(|index| group[index].seconds);
        let slowest = emitted.into_iter().fold(0.0, f64::max);
        println!(
            "- emitted, the slowest: {:.1} million a second on this core (goal {:.1} at 3 GHz)",
            1e-6 / slowest,
            1e-6 * RATE
        );
    }
}
