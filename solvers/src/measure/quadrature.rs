//! Integrals over a part of a step.

use super::grid::{Grid, Sampler};

/// Positive nodes of Kronrod's rule of 15 points on −1 to 1, and its weights; Gauss's of 7 points are every second one
/// (R. Piessens et al.: *QUADPACK*, 1983, routine QK15).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_19,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_89,
    0.209_482_141_084_727_82,
];
const GAUSS: [f64; 4] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_64,
    0.381_830_050_505_118_9,
    0.417_959_183_673_469_4,
];

/// Relative accuracy that is asked for.
const RELATIVE: f64 = 1e-13;
/// Halvings of a part of a step at most: a kink is then closed in on to a millionth of it.
const DEEPEST: usize = 24;

/// The integral of what is made of the quantities, and that of its size. `before` is the size of what it is added to.
pub(super) fn integral(
    times: (f64, f64),
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
    before: f64,
    of: &dyn Fn(&[f64]) -> f64,
) -> (f64, f64) {
    halved(times, grid, sampler, before, of, 0)
}

fn halved(
    (from, to): (f64, f64),
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
    before: f64,
    of: &dyn Fn(&[f64]) -> f64,
    depth: usize,
) -> (f64, f64) {
    let (middle, half) = (from + (to - from) / 2.0, (to - from) / 2.0);
    let (mut kronrod, mut gauss, mut size) = (0.0, 0.0, 0.0);
    for (index, node) in NODES.iter().enumerate() {
        let sides: &[f64] = match *node == 0.0 {
            true => &[0.0],
            false => &[-1.0, 1.0],
        };
        for side in sides {
            let value = of(sampler.at(grid.piece, middle + side * node * half));
            kronrod += KRONROD[index] * value;
            size += KRONROD[index] * value.abs();
            if index % 2 == 1 {
                gauss += GAUSS[index / 2] * value;
            }
        }
    }
    let (sum, size) = (half * kronrod, half * size);
    let error = half * (kronrod - gauss).abs();
    // The error of the better rule is far below the difference of both (QUADPACK takes its power 1.5).
    let estimate = match size > 0.0 {
        true => size * (200.0 * error / size).powf(1.5).min(1.0),
        false => 0.0,
    };
    let is_known = estimate <= RELATIVE * (before + size) || !sum.is_finite();
    if is_known || depth >= DEEPEST || !sampler.may_split() {
        return (sum, size);
    }
    let left = halved((from, middle), grid, sampler, before, of, depth + 1);
    let right = halved((middle, to), grid, sampler, before + left.1, of, depth + 1);
    (left.0 + right.0, left.1 + right.1)
}
