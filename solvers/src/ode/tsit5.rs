//! The coefficients of the 5(4) pair of Tsitouras.
//!
//! Ch. Tsitouras: *Runge–Kutta pairs of order 5(4) satisfying only the first column simplifying assumption*, Computers
//! and Mathematics with Applications 62 (2011) 770–775. Its free interpolant of order 4 meets value and slope at both
//! ends, so it is the cubic Hermite polynomial plus `θ²(1-θ)² h Σ dᵢ kᵢ`; `dᵢ` are the leading coefficients of the
//! published polynomials `bᵢ(θ)`.

use super::tableau::{Row, Tableau};

/// The pair.
pub(super) const TSIT5: Tableau = Tableau {
    order: 5,
    stages: 6,
    nodes: &NODES,
    extra_nodes: &[],
    rows: &[ROW_2, ROW_3, ROW_4, ROW_5, ROW_6],
    weights: WEIGHTS,
    extra_rows: &[],
    error: ERROR,
    second_error: &[],
    error_uses_last: true,
    dense_rows: &[DENSE_4],
    beta: 0.04,
    factors: (0.2, 10.0),
};

/// Stage times of stages 2 to 6, in parts of the step.
const NODES: [f64; 5] = [0.161, 0.327, 0.9, 0.9800255409045097, 1.0];

/// Coefficients of stage 2.
const ROW_2: Row = &[(0, 0.161)];

/// Coefficients of stage 3.
const ROW_3: Row = &[(0, -0.008480655492356989), (1, 0.335480655492357)];

/// Coefficients of stage 4.
const ROW_4: Row = &[(0, 2.8971530571054935), (1, -6.359448489975075), (2, 4.3622954328695815)];

/// Coefficients of stage 5.
const ROW_5: Row = &[
    (0, 5.325864828439257),
    (1, -11.748883564062828),
    (2, 7.4955393428898365),
    (3, -0.09249506636175525),
];

/// Coefficients of stage 6.
const ROW_6: Row = &[
    (0, 5.86145544294642),
    (1, -12.92096931784711),
    (2, 8.159367898576159),
    (3, -0.071584973281401),
    (4, -0.028269050394068383),
];

/// Weights of the solution of order 5.
const WEIGHTS: Row = &[
    (0, 0.09646076681806523),
    (1, 0.01),
    (2, 0.4798896504144996),
    (3, 1.379008574103742),
    (4, -3.290069515436081),
    (5, 2.324710524099774),
];

/// Weights of the difference from the embedded solution of order 4.
const ERROR: Row = &[
    (0, -0.001780011052225777),
    (1, -0.0008164344596567469),
    (2, 0.007880878010261995),
    (3, -0.1447110071732629),
    (4, 0.5823571654525552),
    (5, -0.45808210592918697),
    (6, 0.015151515151515152),
];

/// Weights of coefficient 4 of the dense output.
const DENSE_4: Row = &[
    (0, -1.0530884977290216),
    (1, 0.1017),
    (2, 2.490627285651253),
    (3, -16.548102889244902),
    (4, 47.37952196281928),
    (5, -34.87065786149661),
    (6, 2.5),
];
