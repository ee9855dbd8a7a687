//! Problems that several tests use.

use super::Hand;

/// `y' = -2 t y² `, whose solution from `y(0) = 1` is `1 / (1 + t²)`, beside an oscillator that it drives: not linear and
/// not autonomous.
pub const SMOOTH: Hand<3> = Hand::new(
    |time, [y, place, speed]| {
        let force = -place + y - 1.0 / (1.0 + time * time);
        [-2.0 * time * y * y, speed, force]
    },
    |time, [y, _, _]| [[-4.0 * time * y, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, -1.0, 0.0]],
);

/// The solution of [`SMOOTH`] from `1, 0, 1`.
pub fn smooth(time: f64) -> [f64; 3] {
    [1.0 / (1.0 + time * time), time.sin(), time.cos()]
}

/// The oscillator of van der Pol with `μ = 1000` in its own time, so that `ε = μ⁻² = 1e-6`: Hairer, Wanner II, (IV.10.3).
pub const VAN_DER_POL: Hand<2> = Hand::new(
    |_, [x, v]| [v, ((1.0 - x * x) * v - x) / 1e-6],
    |_, [x, v]| [[0.0, 1.0], [(-2.0 * x * v - 1.0) / 1e-6, (1.0 - x * x) / 1e-6]],
);

/// The kinetics of Robertson: Hairer, Wanner II, (IV.10.2).
pub const ROBERTSON: Hand<3> = Hand::new(
    |_, y| {
        let (first, last) = (-0.04 * y[0] + 1e4 * y[1] * y[2], 3e7 * y[1] * y[1]);
        [first, -first - last, last]
    },
    |_, y| {
        [
            [-0.04, 1e4 * y[2], 1e4 * y[1]],
            [0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1]],
            [0.0, 6e7 * y[1], 0.0],
        ]
    },
);

/// High irradiance response of plants: Hairer, Wanner II, (IV.10.4).
pub const HIRES: Hand<8> = Hand::new(
    |_, y| {
        let meeting = 280.0 * y[5] * y[7];
        let last = meeting - 1.81 * y[6];
        [
            -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007,
            1.71 * y[0] - 8.75 * y[1],
            -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4],
            8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3],
            -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6],
            -meeting + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6],
            last,
            -last,
        ]
    },
    |_, y| {
        let (a, b) = (280.0 * y[7], 280.0 * y[5]);
        [
            [-1.71, 0.43, 8.32, 0.0, 0.0, 0.0, 0.0, 0.0],
            [1.71, -8.75, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, -10.03, 0.43, 0.035, 0.0, 0.0, 0.0],
            [0.0, 8.32, 1.71, -1.12, 0.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, -1.745, 0.43, 0.43, 0.0],
            [0.0, 0.0, 0.0, 0.69, 1.71, -a - 0.43, 0.69, -b],
            [0.0, 0.0, 0.0, 0.0, 0.0, a, -1.81, b],
            [0.0, 0.0, 0.0, 0.0, 0.0, -a, 1.81, -b],
        ]
    },
);
