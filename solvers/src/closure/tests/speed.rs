//! What keeping the modes costs, against the same closed form without a look at them.

use super::linkages::SixBar;
use crate::closure::{Assembly, AtDeadPoint, Axis, Closure, Linkage, sweep};
use std::f64::consts::TAU;
use std::hint::black_box;

/// A revolution as one would write it by hand: the same closed form, modes fixed, nothing looked at.
#[inline(never)]
pub fn by_hand(turns: usize) -> f64 {
    let linkage = black_box(SixBar::default());
    let loops = SixBar::prepare::<f64>(&linkage.values());
    let modes = black_box([-1.0, 1.0]);
    let mut sum = 0.0;
    let mut z = Closure::<f64>::zeros(&loops);
    for k in 0..360 * turns {
        let at = TAU * k as f64 / 360.0;
        let instant = loops.instant(&[at]);
        loops.close(0, &instant, modes[0], &mut z);
        loops.close(1, &instant, modes[1], &mut z);
        sum += z[0] + z[1] + z[2] + z[3];
    }
    sum
}

/// The same with modes that are kept.
#[inline(never)]
pub fn kept(turns: usize) -> f64 {
    let mut assembly = Assembly::<SixBar, f64>::new(&black_box(SixBar::default()));
    assembly.start().expect("the linkage assembles");
    let mut sum = 0.0;
    for k in 0..360 * turns {
        let at = TAU * k as f64 / 360.0;
        assembly.move_to(&[at]).expect("the crank turns");
        let z = assembly.position();
        sum += z[0] + z[1] + z[2] + z[3];
    }
    sum
}

#[test]
fn sweeps_over_a_revolution() {
    let axis = Axis {
        from: 0.0,
        to: TAU,
        count: 361,
    };
    let positions = sweep(&SixBar::default(), &[axis], AtDeadPoint::Stop).expect("it assembles");
    assert_eq!(positions.len(), 361);
    assert!(positions.end.is_none() && positions.events.is_empty());
    for j in 0..4 {
        let (first, last) = (positions.coordinates(0)[j], positions.coordinates(360)[j]);
        assert!((first - last).abs() < 1e-12);
    }
    assert!((by_hand(1) - kept(1)).abs() < 1e-9);
}

/// Run under `perf stat -e instructions:u` or callgrind, with ASSUR_SPEED=hand or kept.
#[test]
#[ignore = "a measurement"]
fn measure() {
    let turns = 2000;
    let clock = std::time::Instant::now();
    let sum = match std::env::var("ASSUR_SPEED").as_deref() {
        Ok("hand") => by_hand(turns),
        _ => kept(turns),
    };
    eprintln!(
        "{} ns a position, {sum}",
        clock.elapsed().as_nanos() as f64 / (360 * turns) as f64
    );
}
