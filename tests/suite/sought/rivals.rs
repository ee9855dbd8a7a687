//! Designs judged beside rivals: some places of a way tell which of them lose, and they do lose.

use assur::prelude::*;
use assur::study::Design;
use assur::synthesis::{Judge, Score};

assur::mechanism! {
    /// A four-bar with a dyad on its coupler.
    SixBar from "tests";
    dimension a = 10 mm in 2 mm .. 30 mm, b = 40 mm in 10 mm .. 60 mm, c = 40 mm in 10 mm .. 60 mm, d = 45 mm in 10 mm .. 60 mm;
    dimension u = 30 mm in -60 mm .. 60 mm, v = 20 mm in -60 mm .. 60 mm, e = 50 mm in 10 mm .. 90 mm, f = 30 mm in 10 mm .. 90 mm;
    parameter first = 1 in -1 .. 1, second = 1 in -1 .. 1;

    driver phi ~ 0 deg in -180 deg .. 180 deg;
    let s = [d, 0 mm] - a*dir(phi), t0 = atan2(s.y, s.x) + first*acos((b^2 + norm(s)^2 - c^2)/(2*b*norm(s)));
    let w = a*dir(phi) + rot(t0)*[u, v] - [60 mm, 60 mm];
    let p0 = atan2(w.y, w.x) + second*acos((f^2 + norm(w)^2 - e^2)/(2*f*norm(w)));
    dependent theta ~ t0, rho: rad, sigma: rad, psi ~ p0;
    point A = a*dir(phi), P = A + rot(theta)*[u, v], D = [60 mm, 60 mm] + f*dir(psi);
    closure bars: A + b*dir(theta) = [d, 0 mm] + c*dir(rho);
    closure dyad: P + e*dir(sigma) = D;
    output psi, rho;

    /// Extremes of all kinds, everywhere and where something holds.
    scene swings {
        sweep phi;
        vary a, b, c, d, u, v, e, f, first in {-1, 1}, second in {-1, 1};
        require a + d < b + c "it turns";
        require peak(D.x) < 80 mm;
        require lowest(D.y, abs(phi) < 90 deg) > 50 mm;
        prefer peak(abs(cos(psi - sigma))) < 0.8 weight 0.2;
        minimise peak(abs(sin(psi)), phi > 0 deg) - lowest(sin(psi))/2;
    }
    /// What depends on the turns that angles have made.
    scene turns {
        sweep phi;
        vary a, b, c, d, first in {-1, 1}, u, v, e, f, second in {-1, 1};
        require peak(theta) < 400 deg;
        minimise peak(rho) - lowest(theta);
    }
}

mod parallelogram {
    assur::mechanism! {
        /// A parallelogram, which passes change points.
        Parallelogram from "tests";
        dimension a = 10 mm in 5 mm .. 20 mm, d = 30 mm in 25 mm .. 60 mm;
        driver phi ~ 90 deg in -150 deg .. 143 deg;
        dependent theta ~ 0 deg, rho ~ 90 deg;
        closure bars: a*dir(phi) + d*dir(theta) = [d, 0 mm] + a*dir(rho);
        output rho;
        scene best {
            sweep phi;
            vary a, d;
            require lowest(d*cos(theta) - a) > 18 mm;
            minimise peak(abs(a*sin(rho) - 8 mm));
        }
    }
}

/// Numbers between 0 and 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Judges random designs alone, then each beside the score of another one and beside one that is slightly better or worse than its
/// own. How many of those that lose are told without their score, and of how many that keep what follows from their constants, beside
/// rivals that get through their ways.
fn judged(scene: &assur::registry::SceneEntry, count: usize) -> (usize, usize) {
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let design = Design::of(scene, &values, &Settings::default()).expect("it seeks");
    let (mut numbers, sought) = (Numbers(7), design.sought());
    let designs: Vec<f64> = (0..count)
        .flat_map(|_| {
            sought.iter().map(|one| one.low + numbers.next() * one.width()).collect::<Vec<_>>()
        })
        .collect();
    let mut alone = vec![Score::WORST; count];
    design.judge(&designs, &mut alone);
    let conditions = design.synthesis().conditions.len() as f64;
    let (mut told, mut losing) = (0, 0);
    let others = (0..count).map(|_| alone[(numbers.next() * count as f64) as usize]).collect();
    let beside = |by: f64| {
        alone.iter().map(move |score| Score {
            missed: score.missed * (1.0 + by),
            value: score.value + by * score.value.abs(),
        })
    };
    for rivals in
        [others, beside(1e-6).collect(), beside(-1e-6).collect(), beside(-0.5).collect::<Vec<_>>()]
    {
        let mut scores = rivals.clone();
        design.judge(&designs, &mut scores);
        for ((score, own), rival) in scores.iter().zip(&alone).zip(&rivals) {
            match own.is_as_good_as(rival) {
                true => assert_eq!(score, own, "beside {rival:?}"),
                false => {
                    let is_compared = rival.missed < conditions && own.missed < conditions + 1.0;
                    losing += usize::from(is_compared);
                    told += usize::from(score != own);
                    assert!(
                        !score.is_as_good_as(rival),
                        "{score:?} beside {rival:?} instead of {own:?}"
                    );
                }
            }
        }
    }
    (told, losing)
}

#[test]
fn designs_that_lose_are_told_by_some_places() {
    let (told, losing) = judged(&MECHANISM.scenes[0], 3000);
    assert!(5 * told > 4 * losing, "{told} of {losing}");
}

/// Angles within half a turn say nothing of how often they have turned.
#[test]
fn turns_that_angles_have_made_are_not_taken_for_less() {
    let (told, losing) = judged(&MECHANISM.scenes[1], 3000);
    assert!(told > 0 && losing > 0, "{told} of {losing}");
}

/// Beyond a change point the other of two modes may be the one that a linkage is in.
#[test]
fn nothing_is_told_of_modes_near_change_points() {
    let (told, losing) = judged(&parallelogram::MECHANISM.scenes[0], 1000);
    assert!(told <= losing && losing > 0, "{told} of {losing}");
}
