//! DOP853 written out by hand for six states: each stage one expression, as in a program made for one purpose.
//!
//! Hairer, Nørsett, Wanner: *Solving Ordinary Differential Equations I*, section II.5.

use crate::hand::Batten;

/// What a run gives.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// State at the end.
    pub end: [f64; 6],
    /// Evaluations of the derivative.
    pub evaluations: usize,
}

/// One stage: `y + h·(a·k + …)`.
macro_rules! stage {
    ($y:ident, $h:ident, $(($a:literal, $k:ident)),*) => {{
        let mut next = [0.0; 6];
        for i in 0..6 {
            next[i] = $y[i] + $h * (0.0 $(+ $a * $k[i])*);
        }
        next
    }};
}

/// Integrates from 0 to `end` from `y`; absolute tolerances `rtol·scale`. `KERNEL` says which sine, see
/// [`Batten::instant_by`].
#[inline(never)]
pub fn run<const KERNEL: bool>(
    batten: &Batten,
    end: f64,
    mut y: [f64; 6],
    rtol: f64,
    scale: f64,
) -> Run {
    let f = |t: f64, y: &[f64; 6]| {
        let mut rate = [0.0; 6];
        batten.derivative(&batten.instant_by::<KERNEL>(t), y, &mut rate);
        rate
    };
    let (mut t, mut h) = (0.0, 1e-4);
    let mut k1 = f(t, &y);
    let mut evaluations = 1;
    while t < end {
        if t + 1.01 * h >= end {
            h = end - t;
        }
        let stage = stage!(y, h, (0.05260015195876773, k1));
        let k2 = f(t + 0.05260015195876773 * h, &stage);
        let stage = stage!(y, h, (0.0197250569845379, k1), (0.0591751709536137, k2));
        let k3 = f(t + 0.0789002279381516 * h, &stage);
        let stage = stage!(y, h, (0.02958758547680685, k1), (0.08876275643042054, k3));
        let k4 = f(t + 0.1183503419072274 * h, &stage);
        let stage = stage!(
            y,
            h,
            (0.2413651341592667, k1),
            (-0.8845494793282861, k3),
            (0.924834003261792, k4)
        );
        let k5 = f(t + 0.2816496580927726 * h, &stage);
        let stage = stage!(
            y,
            h,
            (0.037037037037037035, k1),
            (0.17082860872947386, k4),
            (0.12546768756682242, k5)
        );
        let k6 = f(t + 0.3333333333333333 * h, &stage);
        let stage = stage!(
            y,
            h,
            (0.037109375, k1),
            (0.17025221101954405, k4),
            (0.06021653898045596, k5),
            (-0.017578125, k6)
        );
        let k7 = f(t + 0.25 * h, &stage);
        let stage = stage!(
            y,
            h,
            (0.03709200011850479, k1),
            (0.17038392571223998, k4),
            (0.10726203044637328, k5),
            (-0.015319437748624402, k6),
            (0.008273789163814023, k7)
        );
        let k8 = f(t + 0.3076923076923077 * h, &stage);
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
        let k9 = f(t + 0.6512820512820513 * h, &stage);
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
        let k10 = f(t + 0.6 * h, &stage);
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
        let k11 = f(t + 0.8571428571428571 * h, &stage);
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
        let k12 = f(t + 1.0 * h, &stage);
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
        for i in 0..6 {
            let tolerance = rtol * (scale + y[i].abs().max(next[i].abs()));
            let e5 = 0.01312004499419488 * k1[i]
                + -1.2251564463762044 * k6[i]
                + -0.4957589496572502 * k7[i]
                + 1.6643771824549864 * k8[i]
                + -0.35032884874997366 * k9[i]
                + 0.3341791187130175 * k10[i]
                + 0.08192320648511571 * k11[i]
                + -0.022355307863886294 * k12[i];
            let e3 = -0.18980075407240762 * k1[i]
                + 4.450312892752409 * k6[i]
                + 1.8915178993145003 * k7[i]
                + -5.801203960010585 * k8[i]
                + -0.4226823213237919 * k9[i]
                + -0.1521609496625161 * k10[i]
                + 0.20136540080403034 * k11[i]
                + 0.02265179219836082 * k12[i];
            sum5 += (e5 / tolerance) * (e5 / tolerance);
            sum3 += (e3 / tolerance) * (e3 / tolerance);
        }
        let denominator = sum5 + 0.01 * sum3;
        let error = if denominator > 0.0 {
            h * sum5 / (6.0 * denominator).sqrt()
        } else {
            0.0
        };
        evaluations += 11;
        let factor = (0.9 * error.powf(-1.0 / 8.0)).clamp(1.0 / 3.0, 6.0);
        if error <= 1.0 {
            t = if t + h >= end { end } else { t + h };
            k1 = f(t, &next);
            evaluations += 1;
            y = next;
            h *= factor;
        } else {
            h *= factor.min(1.0);
        }
    }
    Run {
        end: y,
        evaluations,
    }
}
