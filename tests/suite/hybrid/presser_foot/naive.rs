//! What one would write at first.

use super::*;

/// A turn of the shaft with steps of equal length by the method of Runge and Kutta, the force switched in each stage by
/// a rule of compression and force: no event is located. The state at the end, and the smallest force that was applied.
pub(super) fn turn(
    foot: &Elliptic,
    start: &[f64],
    steps: usize,
    presses: impl Fn(f64, f64) -> bool,
) -> ([f64; 2], f64) {
    let edge = (foot.phi_p / 2.0).cos();
    let mut smallest = f64::INFINITY;
    let mut rate = |time: f64, [w, v]: [f64; 2]| {
        let phi = foot.omega * time - PI;
        let height = foot.rise / (1.0 - edge);
        let (s, ds) = match phi.cos() > edge {
            true => (height * (phi.cos() - edge), -height * foot.omega * phi.sin()),
            false => (0.0, 0.0),
        };
        let f = foot.c2 * (s - w) + foot.mu2 * (ds - v);
        let pressed = if presses(s - w, f) { f } else { 0.0 };
        smallest = smallest.min(pressed);
        [v, (pressed - foot.F10 - foot.c1 * w - foot.mu1 * v - foot.m * foot.g) / foot.m]
    };
    let h = foot.period() / steps as f64;
    let mut state = [start[0], start[1]];
    for step in 0..steps {
        let time = h * step as f64;
        let moved = |by: f64, slope: [f64; 2]| [state[0] + by * slope[0], state[1] + by * slope[1]];
        let a = rate(time, state);
        let b = rate(time + h / 2.0, moved(h / 2.0, a));
        let c = rate(time + h / 2.0, moved(h / 2.0, b));
        let d = rate(time + h, moved(h, c));
        state = std::array::from_fn(|i| state[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
    (state, smallest)
}
