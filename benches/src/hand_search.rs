//! What a design of the dwell six-bar is worth, written for it alone: 72 positions, as many designs side by side as a pack holds.
//!
//! Both dyads are closed without a sine, by vectors; angles are compared by their sines and cosines, and taken once for each
//! design. What the lift rocker has to do is the same for all designs and known before. What happens between two positions is
//! not seen.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_3, TAU};

use assur::dispatch::{Task, dispatch_packs};
use assur::scalar::{Pack, Scalar, WIDTH};
use assur::synthesis::{Judge, Score, Sought};

pub const PLACES: usize = 72;
/// Numbers of a design: L1 to L4, eta, X_C, Y_C, L6, L7, phi0, psi0, M1, M2.
const NUMBERS: usize = 13;
/// Pivot of the lift rocker.
const PIVOT: [f64; 2] = [36e-3, 96e-3];
/// Conditions, the first two of which follow from the dimensions alone.
const CONDITIONS: f64 = 4.0;
const WEIGHT: f64 = 0.2;

/// The problem.
pub struct Search {
    pub sought: Vec<Sought>,
    /// Cosine and sine of what the lift rocker has to swing by at each place.
    pub wanted: [[f64; 2]; PLACES],
}

type Vector<S> = [S; 2];

#[inline(always)]
fn turned<S: Scalar>(a: Vector<S>, by: Vector<S>) -> Vector<S> {
    [a[0].mul_add(by[0], -(a[1] * by[1])), a[0].mul_add(by[1], a[1] * by[0])]
}

#[inline(always)]
fn inner<S: Scalar>(a: Vector<S>, b: Vector<S>) -> S {
    a[0].mul_add(b[0], a[1] * b[1])
}

#[inline(always)]
fn cross<S: Scalar>(a: Vector<S>, b: Vector<S>) -> S {
    a[0].mul_add(b[1], -(a[1] * b[0]))
}

/// The direction of the first of two links that are put between two joints so far apart; NaN where they do not reach.
#[inline(always)]
fn dyad<S: Scalar>(apart: Vector<S>, first: S, [first2, second2]: [S; 2], mode: S) -> Vector<S> {
    let square = inner(apart, apart);
    let along = (first2 + square - second2) / (square + square);
    let across = mode * (first2 / square - along * along).sqrt();
    let turn = [along / first, across / first];
    turned(apart, turn)
}

struct Judging<'a> {
    search: &'a Search,
    designs: &'a [f64],
    scores: &'a mut [Score],
}

impl Task for Judging<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Pack>(self) {
        let blocks = self.designs.chunks(NUMBERS * P::WIDTH).zip(self.scores.chunks_mut(P::WIDTH));
        for (designs, scores) in blocks {
            let count = scores.len();
            let pack = |index: usize| {
                let mut lanes = [0.0; WIDTH];
                for (lane, value) in lanes.iter_mut().enumerate() {
                    *value = designs[lane.min(count - 1) * NUMBERS + index];
                }
                P::load(&lanes)
            };
            let [l1, l2, l3, l4] = [pack(0), pack(1), pack(2), pack(3)];
            let [x, y, l6, l7] = [pack(5), pack(6), pack(7), pack(8)];
            let sign = |value: P| P::select(P::less(value, P::ZERO), -P::ONE, P::ONE);
            let [m1, m2] = [sign(pack(11)), sign(pack(12))];
            let ([se, sp, ss], [ce, cp, cs]) = P::sin_cos_all([pack(4), pack(9), pack(10)]);
            let squares = [l2, l3, l6, l7].map(|length| length * length);
            let frame = [l4 * ce, l4 * se];
            let step = TAU / PLACES as f64;
            let (s0, c0) = (0.5 * step - 0.5 * TAU).sin_cos();
            let mut crank = turned([l1 * cp, l1 * sp], [P::from_f64(c0), P::from_f64(s0)]);
            let (s, c) = step.sin_cos();
            let turn = [P::from_f64(c), P::from_f64(s)];
            let (mut most, mut least) = (P::ZERO, P::from_f64(f64::INFINITY));
            let (mut across, mut along) = (P::ZERO, P::ONE);
            let [mut first, mut second] = [P::ONE; 2];
            let mut open = P::ZERO;
            for wanted in &self.search.wanted {
                let apart = [frame[0] - crank[0], frame[1] - crank[1]];
                let u = dyad(apart, l2, [squares[0], squares[1]], m1);
                let rocker = [l2.mul_add(u[0], -apart[0]), l2.mul_add(u[1], -apart[1])];
                first = first.min((cross(rocker, u) / l3).abs());
                let joint = turned([x, y], u);
                let w = [
                    crank[0] + joint[0] - P::from_f64(PIVOT[0]),
                    crank[1] + joint[1] - P::from_f64(PIVOT[1]),
                ];
                let square = inner(w, w);
                (most, least) = (most.max(square), least.min(square));
                let q = dyad(w, l7, [squares[3], squares[2]], m2);
                let rod = [l7.mul_add(q[0], -w[0]), l7.mul_add(q[1], -w[1])];
                let sine = cross(q, rod) / l6;
                second = second.min(sine.abs());
                // Against the direction psi0 - wanted.
                let aim = turned([cs, ss], [P::from_f64(wanted[0]), P::from_f64(-wanted[1])]);
                across = across.max(cross(aim, q).abs());
                along = along.min(inner(aim, q));
                open = open + P::select(P::equal(sine, sine), P::ZERO, P::ONE);
                crank = turned(crank, turn);
            }
            // Beyond a quarter turn sines fall again.
            let off = P::select(P::less(along, P::ZERO), along.acos(), across.asin());
            let limit = P::from_f64(FRAC_PI_3);
            let missed = |sine: P| (sine.acos() - limit).max(P::ZERO) * P::from_f64(WEIGHT);
            let worth = off + missed(first) + missed(second);
            let mut lanes = [[0.0; WIDTH]; 6];
            let margins = [
                l2 + l3 - l1 - l4,
                (l4 - l1).abs() - (l2 - l3).abs(),
                l6 + l7 - most.sqrt(),
                least.sqrt() - (l6 - l7).abs(),
                open,
                worth,
            ];
            margins.iter().zip(&mut lanes).for_each(|(pack, lanes)| pack.store(lanes));
            for (lane, score) in scores.iter_mut().enumerate() {
                *score = ranked(lanes.map(|one| one[lane]));
            }
        }
    }
}

/// The score of a design, its conditions in the order of the equation file.
#[inline(always)]
fn ranked([turns, rocks, reaches, folds, open, worth]: [f64; 6]) -> Score {
    let missing = |place: f64, margin: f64| {
        Score::missing(CONDITIONS - 1.0 - place + FRAC_2_PI * (-margin).atan())
    };
    match () {
        () if turns < 0.0 => Score::missing(CONDITIONS + 1.0 + missing(0.0, turns).missed),
        () if rocks < 0.0 => Score::missing(CONDITIONS + 1.0 + missing(1.0, rocks).missed),
        () if open > 0.0 => Score::missing(CONDITIONS + open / (1.0 + PLACES as f64)),
        () if reaches < 0.0 => missing(2.0, reaches),
        () if folds < 0.0 => missing(3.0, folds),
        () => Score::kept(worth),
    }
}

impl Judge for Search {
    fn sought(&self) -> &[Sought] {
        &self.sought
    }

    fn judge(&self, designs: &[f64], scores: &mut [Score]) {
        dispatch_packs(Judging { search: self, designs, scores });
    }
}
