//! The coefficients of the method of order 8 of Dormand and Prince, as Hairer, Nørsett and Wanner publish them.
//!
//! E. Hairer, S. P. Nørsett, G. Wanner: *Solving Ordinary Differential Equations I*, 2nd edition, section II.5 and
//! appendix, program DOP853. Twelve stages give the step of order 8 and error estimates of order 5 and 3; the slope at
//! the end and three further stages give the continuous solution of order 7.

use super::system::System;
use super::tableau::{Method, Row, stage_times};
use crate::scalar::Scalar;

/// Explicit Runge–Kutta method of order 8 with error estimates of order 5 and 3, and dense output of order 7.
#[derive(Clone, Copy, Debug)]
pub struct Dop853;

impl Method for Dop853 {
    type Slopes<T> = [T; 16];
    type Nodes<T> = [T; 11];
    type ExtraNodes<T> = [T; 3];
    type Polynomial<T> = [T; 7];

    const ORDER: usize = 8;
    const STAGES: usize = 12;
    const NODES: &'static [f64] = &NODES;
    const EXTRA_NODES: &'static [f64] = &EXTRA_NODES;
    const ROWS: &'static [Row] = &[
        ROW_2, ROW_3, ROW_4, ROW_5, ROW_6, ROW_7, ROW_8, ROW_9, ROW_10, ROW_11, ROW_12,
    ];
    const WEIGHTS: Row = WEIGHTS;
    const EXTRA_ROWS: &'static [Row] = &[ROW_14, ROW_15, ROW_16];
    const ERROR: Row = ERROR_5;
    const SECOND_ERROR: Row = ERROR_3;
    const ERROR_USES_LAST: bool = false;
    const DENSE_ROWS: &'static [Row] = &[DENSE_4, DENSE_5, DENSE_6, DENSE_7];
    const BETA: f64 = 0.0;
    const FACTORS: (f64, f64) = (1.0 / 3.0, 6.0);

    fn slopes<T>(make: impl FnMut(usize) -> T) -> [T; 16] {
        std::array::from_fn(make)
    }

    fn polynomial<T>(make: impl FnMut(usize) -> T) -> [T; 7] {
        std::array::from_fn(make)
    }

    #[inline(always)]
    fn instants<S: Scalar, Y: System<S>>(system: &Y, time: S, step: S) -> [Y::Instant; 11] {
        system.instants(stage_times(NODES, time, step))
    }

    #[inline(always)]
    fn extra_instants<S: Scalar, Y: System<S>>(system: &Y, time: S, step: S) -> [Y::Instant; 3] {
        system.instants(stage_times(EXTRA_NODES, time, step))
    }
}

/// Stage times of stages 2 to 12, in parts of the step.
const NODES: [f64; 11] = [
    0.05260015195876773,
    0.0789002279381516,
    0.1183503419072274,
    0.2816496580927726,
    0.3333333333333333,
    0.25,
    0.3076923076923077,
    0.6512820512820513,
    0.6,
    0.8571428571428571,
    1.0,
];

/// Stage times of the three stages of the dense output.
const EXTRA_NODES: [f64; 3] = [0.1, 0.2, 0.7777777777777778];

/// Coefficients of stage 2.
const ROW_2: Row = &[(0, 0.05260015195876773)];

/// Coefficients of stage 3.
const ROW_3: Row = &[(0, 0.0197250569845379), (1, 0.0591751709536137)];

/// Coefficients of stage 4.
const ROW_4: Row = &[(0, 0.02958758547680685), (2, 0.08876275643042054)];

/// Coefficients of stage 5.
const ROW_5: Row = &[
    (0, 0.2413651341592667),
    (2, -0.8845494793282861),
    (3, 0.924834003261792),
];

/// Coefficients of stage 6.
const ROW_6: Row = &[
    (0, 0.037037037037037035),
    (3, 0.17082860872947386),
    (4, 0.12546768756682242),
];

/// Coefficients of stage 7.
const ROW_7: Row = &[
    (0, 0.037109375),
    (3, 0.17025221101954405),
    (4, 0.06021653898045596),
    (5, -0.017578125),
];

/// Coefficients of stage 8.
const ROW_8: Row = &[
    (0, 0.03709200011850479),
    (3, 0.17038392571223998),
    (4, 0.10726203044637328),
    (5, -0.015319437748624402),
    (6, 0.008273789163814023),
];

/// Coefficients of stage 9.
const ROW_9: Row = &[
    (0, 0.6241109587160757),
    (3, -3.3608926294469414),
    (4, -0.868219346841726),
    (5, 27.59209969944671),
    (6, 20.154067550477894),
    (7, -43.48988418106996),
];

/// Coefficients of stage 10.
const ROW_10: Row = &[
    (0, 0.47766253643826434),
    (3, -2.4881146199716677),
    (4, -0.590290826836843),
    (5, 21.230051448181193),
    (6, 15.279233632882423),
    (7, -33.28821096898486),
    (8, -0.020331201708508627),
];

/// Coefficients of stage 11.
const ROW_11: Row = &[
    (0, -0.9371424300859873),
    (3, 5.186372428844064),
    (4, 1.0914373489967295),
    (5, -8.149787010746927),
    (6, -18.52006565999696),
    (7, 22.739487099350505),
    (8, 2.4936055526796523),
    (9, -3.0467644718982196),
];

/// Coefficients of stage 12.
const ROW_12: Row = &[
    (0, 2.273310147516538),
    (3, -10.53449546673725),
    (4, -2.0008720582248625),
    (5, -17.9589318631188),
    (6, 27.94888452941996),
    (7, -2.8589982771350235),
    (8, -8.87285693353063),
    (9, 12.360567175794303),
    (10, 0.6433927460157636),
];

/// Weights of the solution of order 8.
const WEIGHTS: Row = &[
    (0, 0.054293734116568765),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, 0.3111643669578199),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.04471061572777259),
];

/// Coefficients of stage 14, for the dense output.
const ROW_14: Row = &[
    (0, 0.056167502283047954),
    (6, 0.25350021021662483),
    (7, -0.2462390374708025),
    (8, -0.12419142326381637),
    (9, 0.15329179827876568),
    (10, 0.00820105229563469),
    (11, 0.007567897660545699),
    (12, -0.008298),
];

/// Coefficients of stage 15, for the dense output.
const ROW_15: Row = &[
    (0, 0.03183464816350214),
    (5, 0.028300909672366776),
    (6, 0.053541988307438566),
    (7, -0.05492374857139099),
    (10, -0.00010834732869724932),
    (11, 0.0003825710908356584),
    (12, -0.00034046500868740456),
    (13, 0.1413124436746325),
];

/// Coefficients of stage 16, for the dense output.
const ROW_16: Row = &[
    (0, -0.42889630158379194),
    (5, -4.697621415361164),
    (6, 7.683421196062599),
    (7, 4.06898981839711),
    (8, 0.3567271874552811),
    (12, -0.0013990241651590145),
    (13, 2.9475147891527724),
    (14, -9.15095847217987),
];

/// Weights of the error estimate of order 5.
const ERROR_5: Row = &[
    (0, 0.01312004499419488),
    (5, -1.2251564463762044),
    (6, -0.4957589496572502),
    (7, 1.6643771824549864),
    (8, -0.35032884874997366),
    (9, 0.3341791187130175),
    (10, 0.08192320648511571),
    (11, -0.022355307863886294),
];

/// Weights of the error estimate of order 3.
const ERROR_3: Row = &[
    (0, -0.18980075407240762),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, -0.4226823213237919),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.02265179219836082),
];

/// Weights of coefficient 4 of the dense output.
const DENSE_4: Row = &[
    (0, -8.428938276109013),
    (5, 0.5667149535193777),
    (6, -3.0689499459498917),
    (7, 2.38466765651207),
    (8, 2.117034582445028),
    (9, -0.871391583777973),
    (10, 2.2404374302607883),
    (11, 0.6315787787694688),
    (12, -0.08899033645133331),
    (13, 18.148505520854727),
    (14, -9.194632392478356),
    (15, -4.436036387594894),
];

/// Weights of coefficient 5 of the dense output.
const DENSE_5: Row = &[
    (0, 10.427508642579134),
    (5, 242.28349177525817),
    (6, 165.20045171727028),
    (7, -374.5467547226902),
    (8, -22.113666853125306),
    (9, 7.733432668472264),
    (10, -30.674084731089398),
    (11, -9.332130526430229),
    (12, 15.697238121770845),
    (13, -31.139403219565178),
    (14, -9.35292435884448),
    (15, 35.81684148639408),
];

/// Weights of coefficient 6 of the dense output.
const DENSE_6: Row = &[
    (0, 19.985053242002433),
    (5, -387.0373087493518),
    (6, -189.17813819516758),
    (7, 527.8081592054236),
    (8, -11.57390253995963),
    (9, 6.8812326946963),
    (10, -1.0006050966910838),
    (11, 0.7777137798053443),
    (12, -2.778205752353508),
    (13, -60.19669523126412),
    (14, 84.32040550667716),
    (15, 11.99229113618279),
];

/// Weights of coefficient 7 of the dense output.
const DENSE_7: Row = &[
    (0, -25.69393346270375),
    (5, -154.18974869023643),
    (6, -231.5293791760455),
    (7, 357.6391179106141),
    (8, 93.40532418362432),
    (9, -37.45832313645163),
    (10, 104.0996495089623),
    (11, 29.8402934266605),
    (12, -43.53345659001114),
    (13, 96.32455395918828),
    (14, -39.17726167561544),
    (15, -149.72683625798564),
];
