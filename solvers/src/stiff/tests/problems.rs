//! Problems that several tests use.

use super::Problem;

/// `y' = -2 t y² `, whose solution from `y(0) = 1` is `1 / (1 + t²)`, beside an oscillator that it drives: not linear and
/// not autonomous.
pub const SMOOTH: Problem<3> = Problem {
    rate: |time, state, rate| {
        rate[0] = -2.0 * time * state[0] * state[0];
        rate[1] = state[2];
        rate[2] = -state[1] + state[0] - 1.0 / (1.0 + time * time);
    },
    rows: |time, state| {
        [
            [-4.0 * time * state[0], 0.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, -1.0, 0.0],
        ]
    },
};

/// The solution of [`SMOOTH`] from `1, 0, 1`.
pub fn smooth(time: f64) -> [f64; 3] {
    [1.0 / (1.0 + time * time), time.sin(), time.cos()]
}

/// The oscillator of van der Pol with `μ = 1000` in its own time, so that `ε = μ⁻² = 1e-6`: Hairer, Wanner II, (IV.10.3).
pub const VAN_DER_POL: Problem<2> = Problem {
    rate: |_, state, rate| {
        rate[0] = state[1];
        rate[1] = ((1.0 - state[0] * state[0]) * state[1] - state[0]) / 1e-6;
    },
    rows: |_, state| {
        [
            [0.0, 1.0],
            [
                (-2.0 * state[0] * state[1] - 1.0) / 1e-6,
                (1.0 - state[0] * state[0]) / 1e-6,
            ],
        ]
    },
};

/// The kinetics of Robertson: Hairer, Wanner II, (IV.10.2).
pub const ROBERTSON: Problem<3> = Problem {
    rate: |_, y, rate| {
        rate[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
        rate[2] = 3e7 * y[1] * y[1];
        rate[1] = -rate[0] - rate[2];
    },
    rows: |_, y| {
        [
            [-0.04, 1e4 * y[2], 1e4 * y[1]],
            [0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1]],
            [0.0, 6e7 * y[1], 0.0],
        ]
    },
};

/// High irradiance response of plants: Hairer, Wanner II, (IV.10.4).
pub const HIRES: Problem<8> = Problem {
    rate: |_, y, rate| {
        let meeting = 280.0 * y[5] * y[7];
        rate[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
        rate[1] = 1.71 * y[0] - 8.75 * y[1];
        rate[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
        rate[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
        rate[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
        rate[5] = -meeting + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
        rate[6] = meeting - 1.81 * y[6];
        rate[7] = -rate[6];
    },
    rows: |_, y| {
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
};
