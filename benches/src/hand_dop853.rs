//! A step of DOP853 written out by hand: each stage one expression, as in a program made for one purpose.
//! Numbers are plain, or fused where the loop around it is dispatched.
//!
//! Hairer, Nørsett, Wanner: *Solving Ordinary Differential Equations I*, section II.5. `I` is what the equations need of
//! a time, computed for all stages beforehand.

use assur::scalar::Scalar;

/// Times of stages 2 to 12, in parts of the step.
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
/// Times of the three stages of the continuous solution.
const EXTRA_NODES: [f64; 3] = [0.1, 0.2, 0.7777777777777778];

/// A step that was tried: what its end, its error and its continuous solution need.
#[derive(Clone, Copy, Debug)]
pub struct Attempt<const N: usize, S = f64> {
    /// State at the end.
    pub end: [S; N],
    /// The error in tolerances.
    pub error: f64,
    /// The slopes of stages 1 and 6 to 12.
    slopes: [[S; N]; 8],
}

/// The times of the stages.
#[inline(always)]
pub fn times(t: f64, h: f64) -> [f64; 11] {
    NODES.map(|node| t + node * h)
}

/// The times of the stages of the continuous solution.
#[inline(always)]
pub fn extra_times(t: f64, h: f64) -> [f64; 3] {
    EXTRA_NODES.map(|node| t + node * h)
}

/// A weighted sum of slopes in one component: `a·k + …`. `Scalar` is named, since a number's own `mul_add` would call a
/// function where the processor was not asked for fused products.
macro_rules! weighted {
    ($i:ident, ($a:literal, $k:ident) $(, ($b:literal, $l:ident))* $(,)?) => {{
        let sum = S::from_f64($a) * $k[$i];
        $(let sum = Scalar::mul_add(S::from_f64($b), $l[$i], sum);)*
        sum
    }};
}

/// One stage: `y + h·(a·k + …)`.
macro_rules! stage {
    ($y:ident, $h:ident, $($term:tt),* $(,)?) => {{
        let mut stage = *$y;
        for (i, stage) in stage.iter_mut().enumerate() {
            *stage = Scalar::mul_add(weighted!(i, $($term),*), $h, *stage);
        }
        stage
    }};
}

/// A weighted sum of slopes: `h·(a·k + …)`.
macro_rules! sum {
    ($h:ident, $($term:tt),* $(,)?) => {
        std::array::from_fn(|i| $h * weighted!(i, $($term),*))
    };
}

/// Tries a step of length `h` from `y`, where the slope is `k1`; absolute tolerances `rtol·scale`.
#[inline(always)]
pub fn attempt<S: Scalar, const N: usize, I>(
    f: impl Fn(&I, &[S; N]) -> [S; N],
    at: &[I; 11],
    (y, k1): (&[S; N], &[S; N]),
    length: f64,
    (rtol, scale): (f64, f64),
) -> Attempt<N, S> {
    let h = S::from_f64(length);
    let stage = stage!(y, h, (0.05260015195876773, k1));
    let k2 = f(&at[0], &stage);
    let stage = stage!(y, h, (0.0197250569845379, k1), (0.0591751709536137, k2));
    let k3 = f(&at[1], &stage);
    let stage = stage!(y, h, (0.02958758547680685, k1), (0.08876275643042054, k3));
    let k4 = f(&at[2], &stage);
    let stage =
        stage!(y, h, (0.2413651341592667, k1), (-0.8845494793282861, k3), (0.924834003261792, k4));
    let k5 = f(&at[3], &stage);
    let stage = stage!(
        y,
        h,
        (0.037037037037037035, k1),
        (0.17082860872947386, k4),
        (0.12546768756682242, k5)
    );
    let k6 = f(&at[4], &stage);
    let stage = stage!(
        y,
        h,
        (0.037109375, k1),
        (0.17025221101954405, k4),
        (0.06021653898045596, k5),
        (-0.017578125, k6)
    );
    let k7 = f(&at[5], &stage);
    let stage = stage!(
        y,
        h,
        (0.03709200011850479, k1),
        (0.17038392571223998, k4),
        (0.10726203044637328, k5),
        (-0.015319437748624402, k6),
        (0.008273789163814023, k7)
    );
    let k8 = f(&at[6], &stage);
    let stage = stage!(
        y,
        h,
        (0.6241109587160757, k1),
        (-3.3608926294469414, k4),
        (-0.868219346841726, k5),
        (27.59209969944671, k6),
        (20.154067550477894, k7),
        (-43.48988418106996, k8)
    );
    let k9 = f(&at[7], &stage);
    let stage = stage!(
        y,
        h,
        (0.47766253643826434, k1),
        (-2.4881146199716677, k4),
        (-0.590290826836843, k5),
        (21.230051448181193, k6),
        (15.279233632882423, k7),
        (-33.28821096898486, k8),
        (-0.020331201708508627, k9)
    );
    let k10 = f(&at[8], &stage);
    let stage = stage!(
        y,
        h,
        (-0.9371424300859873, k1),
        (5.186372428844064, k4),
        (1.0914373489967295, k5),
        (-8.149787010746927, k6),
        (-18.52006565999696, k7),
        (22.739487099350505, k8),
        (2.4936055526796523, k9),
        (-3.0467644718982196, k10)
    );
    let k11 = f(&at[9], &stage);
    let stage = stage!(
        y,
        h,
        (2.273310147516538, k1),
        (-10.53449546673725, k4),
        (-2.0008720582248625, k5),
        (-17.9589318631188, k6),
        (27.94888452941996, k7),
        (-2.8589982771350235, k8),
        (-8.87285693353063, k9),
        (12.360567175794303, k10),
        (0.6433927460157636, k11)
    );
    let k12 = f(&at[10], &stage);
    let next = stage!(
        y,
        h,
        (0.054293734116568765, k1),
        (4.450312892752409, k6),
        (1.8915178993145003, k7),
        (-5.801203960010585, k8),
        (0.3111643669578199, k9),
        (-0.1521609496625161, k10),
        (0.20136540080403034, k11),
        (0.04471061572777259, k12)
    );
    let (mut sum5, mut sum3) = (0.0, 0.0);
    for i in 0..N {
        let tolerance = rtol * (scale + y[i].to_f64().abs().max(next[i].to_f64().abs()));
        let e5 = weighted!(
            i,
            (0.01312004499419488, k1),
            (-1.2251564463762044, k6),
            (-0.4957589496572502, k7),
            (1.6643771824549864, k8),
            (-0.35032884874997366, k9),
            (0.3341791187130175, k10),
            (0.08192320648511571, k11),
            (-0.022355307863886294, k12)
        )
        .to_f64();
        let e3 = weighted!(
            i,
            (-0.18980075407240762, k1),
            (4.450312892752409, k6),
            (1.8915178993145003, k7),
            (-5.801203960010585, k8),
            (-0.4226823213237919, k9),
            (-0.1521609496625161, k10),
            (0.20136540080403034, k11),
            (0.02265179219836082, k12)
        )
        .to_f64();
        sum5 += (e5 / tolerance) * (e5 / tolerance);
        sum3 += (e3 / tolerance) * (e3 / tolerance);
    }
    let denominator = sum5 + 0.01 * sum3;
    let error =
        if denominator > 0.0 { length * sum5 / (N as f64 * denominator).sqrt() } else { 0.0 };
    Attempt { end: next, error, slopes: [*k1, k6, k7, k8, k9, k10, k11, k12] }
}

impl<const N: usize> Attempt<N> {
    /// The coefficients of the continuous solution: `at` holds its three times, and `k13` is the slope at the end.
    #[inline(always)]
    pub fn dense<I>(
        &self,
        f: impl Fn(&I, &[f64; N]) -> [f64; N],
        at: &[I; 3],
        (y, k13): (&[f64; N], &[f64; N]),
        h: f64,
    ) -> [[f64; N]; 7] {
        type S = f64;
        let [k1, k6, k7, k8, k9, k10, k11, k12] = self.slopes;
        let stage = stage!(
            y,
            h,
            (0.056167502283047954, k1),
            (0.25350021021662483, k7),
            (-0.2462390374708025, k8),
            (-0.12419142326381637, k9),
            (0.15329179827876568, k10),
            (0.00820105229563469, k11),
            (0.007567897660545699, k12),
            (-0.008298, k13)
        );
        let k14 = f(&at[0], &stage);
        let stage = stage!(
            y,
            h,
            (0.03183464816350214, k1),
            (0.028300909672366776, k6),
            (0.053541988307438566, k7),
            (-0.05492374857139099, k8),
            (-0.00010834732869724932, k11),
            (0.0003825710908356584, k12),
            (-0.00034046500868740456, k13),
            (0.1413124436746325, k14)
        );
        let k15 = f(&at[1], &stage);
        let stage = stage!(
            y,
            h,
            (-0.42889630158379194, k1),
            (-4.697621415361164, k6),
            (7.683421196062599, k7),
            (4.06898981839711, k8),
            (0.3567271874552811, k9),
            (-0.0013990241651590145, k13),
            (2.9475147891527724, k14),
            (-9.15095847217987, k15)
        );
        let k16 = f(&at[2], &stage);
        let change: [f64; N] = std::array::from_fn(|i| self.end[i] - y[i]);
        let second: [f64; N] = std::array::from_fn(|i| h * k1[i] - change[i]);
        let third = std::array::from_fn(|i| change[i] - h * k13[i] - second[i]);
        [
            change,
            second,
            third,
            sum!(
                h,
                (-8.428938276109013, k1),
                (0.5667149535193777, k6),
                (-3.0689499459498917, k7),
                (2.38466765651207, k8),
                (2.117034582445028, k9),
                (-0.871391583777973, k10),
                (2.2404374302607883, k11),
                (0.6315787787694688, k12),
                (-0.08899033645133331, k13),
                (18.148505520854727, k14),
                (-9.194632392478356, k15),
                (-4.436036387594894, k16)
            ),
            sum!(
                h,
                (10.427508642579134, k1),
                (242.28349177525817, k6),
                (165.20045171727028, k7),
                (-374.5467547226902, k8),
                (-22.113666853125306, k9),
                (7.733432668472264, k10),
                (-30.674084731089398, k11),
                (-9.332130526430229, k12),
                (15.697238121770845, k13),
                (-31.139403219565178, k14),
                (-9.35292435884448, k15),
                (35.81684148639408, k16)
            ),
            sum!(
                h,
                (19.985053242002433, k1),
                (-387.0373087493518, k6),
                (-189.17813819516758, k7),
                (527.8081592054236, k8),
                (-11.57390253995963, k9),
                (6.8812326946963, k10),
                (-1.0006050966910838, k11),
                (0.7777137798053443, k12),
                (-2.778205752353508, k13),
                (-60.19669523126412, k14),
                (84.32040550667716, k15),
                (11.99229113618279, k16)
            ),
            sum!(
                h,
                (-25.69393346270375, k1),
                (-154.18974869023643, k6),
                (-231.5293791760455, k7),
                (357.6391179106141, k8),
                (93.40532418362432, k9),
                (-37.45832313645163, k10),
                (104.0996495089623, k11),
                (29.8402934266605, k12),
                (-43.53345659001114, k13),
                (96.32455395918828, k14),
                (-39.17726167561544, k15),
                (-149.72683625798564, k16)
            ),
        ]
    }
}

/// The continuous solution at a part of the step, from 0 to 1.
#[inline(always)]
pub fn at_part<const N: usize>(y: &[f64; N], dense: &[[f64; N]; 7], part: f64) -> [f64; N] {
    let rest = 1.0 - part;
    std::array::from_fn(|i| {
        let [f1, f2, f3, f4, f5, f6, f7] = dense.map(|row| row[i]);
        let inner = f4 + part * (f5 + rest * (f6 + part * f7));
        y[i] + part * (f1 + rest * (f2 + part * (f3 + rest * inner)))
    })
}
