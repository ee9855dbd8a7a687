//! Radau IIA of order 5 written out for small autonomous systems: the arrays are on the stack, their lengths known, so that
//! all loops are unrolled.
//!
//! E. Hairer, G. Wanner: *Solving Ordinary Differential Equations II*, section IV.8, and their program RADAU5, whose rules for
//! steps, Jacobians and decompositions are kept.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Equations `y' = f(y)`.
pub trait System<const N: usize> {
    /// `f(y)`.
    fn rates(&self, y: &[f64; N]) -> [f64; N];
    /// `∂f_i/∂y_j`, row by row.
    fn slopes(&self, y: &[f64; N]) -> [[f64; N]; N];
}

/// What came out.
#[derive(Clone, Copy, Debug)]
pub struct Run<const N: usize> {
    pub end: [f64; N],
    pub evaluations: usize,
}

const ROUNDING: f64 = 1e-16;
/// Newton iterations, safety, and the rate of convergence up to which the Jacobian is kept.
const MOST: usize = 7;
const SAFE: f64 = 0.9;
const KEPT: f64 = 1e-3;
/// Transformation to the eigenvectors of the inverse of the coefficients, and back.
const T: [[f64; 3]; 3] = [
    [9.123_239_487_089_295e-2, -0.141_255_295_020_954_2, -3.002_919_410_514_742_4e-2],
    [0.241_717_932_707_107, 0.204_129_352_293_799_93, 0.382_942_112_757_261_9],
    [0.966_048_182_615_093, 1.0, 0.0],
];
const BACK: [[f64; 3]; 3] = [
    [4.325_579_890_063_155, 0.339_199_251_815_809_9, 0.541_770_539_935_874_9],
    [-4.178_718_591_551_905, -0.327_682_820_761_062_4, 0.476_623_554_500_550_44],
    [-0.502_872_634_945_786_9, 2.571_926_949_855_605, -0.596_039_204_828_224_9],
];

/// A complex number.
#[derive(Clone, Copy)]
struct Complex(f64, f64);

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0 - self.1 * other.1, self.0 * other.1 + self.1 * other.0)
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let size = 1.0 / (other.0 * other.0 + other.1 * other.1);
        let product = self * Self(other.0, -other.1);
        Self(product.0 * size, product.1 * size)
    }
}

/// Numbers of both kinds.
trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn size(self) -> f64;
}

impl Number for f64 {
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Number for Complex {
    fn size(self) -> f64 {
        self.0.abs() + self.1.abs()
    }
}

/// A matrix decomposed with pivots in its columns.
struct Decomposed<V, const N: usize> {
    rows: [[V; N]; N],
    pivots: [usize; N],
}

impl<V: Number, const N: usize> Decomposed<V, N> {
    #[inline(always)]
    fn of(mut rows: [[V; N]; N]) -> Self {
        let mut pivots = [0; N];
        for k in 0..N {
            let mut pivot = k;
            for i in k + 1..N {
                if rows[i][k].size() > rows[pivot][k].size() {
                    pivot = i;
                }
            }
            pivots[k] = pivot;
            rows.swap(k, pivot);
            for i in k + 1..N {
                let factor = rows[i][k] / rows[k][k];
                rows[i][k] = factor;
                let above = rows[k];
                for (entry, above) in rows[i].iter_mut().zip(above).skip(k + 1) {
                    *entry = *entry - factor * above;
                }
            }
        }
        Self { rows, pivots }
    }

    #[inline(always)]
    fn solve(&self, right: &mut [V; N]) {
        for k in 0..N {
            right.swap(k, self.pivots[k]);
            for i in k + 1..N {
                right[i] = right[i] - self.rows[i][k] * right[k];
            }
        }
        for k in (0..N).rev() {
            for j in k + 1..N {
                right[k] = right[k] - self.rows[k][j] * right[j];
            }
            right[k] = right[k] / self.rows[k][k];
        }
    }
}

/// Three stages, turned by a matrix.
#[inline(always)]
fn turned<const N: usize>(by: &[[f64; 3]; 3], rows: &[[f64; N]; 3]) -> [[f64; N]; 3] {
    let row = |m: &[f64; 3]| -> [f64; N] {
        std::array::from_fn(|i| m[0] * rows[0][i] + m[1] * rows[1][i] + m[2] * rows[2][i])
    };
    [row(&by[0]), row(&by[1]), row(&by[2])]
}

/// The state at `end`, from `start` at time 0; none where no step is short enough.
#[inline(always)]
pub fn run<const N: usize>(
    system: &impl System<N>,
    (end, first): (f64, f64),
    start: [f64; N],
    rtol: f64,
    atol: [f64; N],
) -> Option<Run<N>> {
    let root = 6.0f64.sqrt();
    let nodes = [(4.0 - root) / 10.0, (4.0 + root) / 10.0, 1.0];
    let weights = [-(13.0 + 7.0 * root) / 3.0, (-13.0 + 7.0 * root) / 3.0, -1.0 / 3.0];
    let (nine, eighty) = (9.0f64.cbrt(), 81.0f64.cbrt());
    let gamma = 30.0 / (6.0 + eighty - nine);
    let (alpha, beta) = ((12.0 - eighty + nine) / 60.0, (eighty + nine) * 3.0f64.sqrt() / 60.0);
    let size = alpha * alpha + beta * beta;
    let (alpha, beta) = (alpha / size, beta / size);

    let own = 0.1 * rtol.powf(2.0 / 3.0);
    let enough = (10.0 * ROUNDING / own).max(own.sqrt().min(0.03));
    let tolerances = |y: &[f64; N]| -> [f64; N] {
        std::array::from_fn(|i| 1.0 / (own * (y[i].abs() + atol[i] / rtol)))
    };

    let (mut time, mut y, mut h) = (0.0, start, first.min(end));
    let mut rate = system.rates(&y);
    let mut per = tolerances(&y);
    let mut evaluations = 1;
    // Divided differences of the last step, by which the next begins.
    let mut past: Option<(f64, [[f64; N]; 3])> = None;
    let (mut accepted, mut is_rejected) = (0, false);
    let (mut last_length, mut last_error) = (h, 1e-2);
    let mut contraction = 1.0f64;
    let mut theta: f64;
    let mut slopes = system.slopes(&y);
    let mut is_fresh = true;
    let mut decomposed = None;
    for _ in 0..1_000_000 {
        if h <= ROUNDING * time || h.is_nan() {
            return None;
        }
        let (real, pair) = decomposed.get_or_insert_with(|| {
            let (g, a, b) = (gamma / h, alpha / h, beta / h);
            let real: [[f64; N]; N] = std::array::from_fn(|i| {
                std::array::from_fn(|j| if i == j { g - slopes[i][j] } else { -slopes[i][j] })
            });
            let pair: [[Complex; N]; N] = std::array::from_fn(|i| {
                std::array::from_fn(|j| match i == j {
                    true => Complex(a - slopes[i][j], b),
                    false => Complex(-slopes[i][j], 0.0),
                })
            });
            (Decomposed::of(real), Decomposed::of(pair))
        });
        let (g, a, b) = (gamma / h, alpha / h, beta / h);
        let mut z = [[0.0; N]; 3];
        if let Some((length, differences)) = &past {
            for (row, node) in z.iter_mut().zip(nodes) {
                let q = node * h / length;
                for i in 0..N {
                    let inner = differences[1][i] + (q - (nodes[0] - 1.0)) * differences[2][i];
                    row[i] = q * (differences[0][i] + (q - (nodes[1] - 1.0)) * inner);
                }
            }
        }
        let mut w = turned(&BACK, &z);
        contraction = contraction.max(ROUNDING).powf(0.8);
        theta = KEPT;
        let (mut before, mut last_ratio) = (0.0, 0.0);
        let mut iteration = 0;
        // Some factor where the step is to be shorter.
        let shorter = loop {
            if iteration == MOST {
                break Some(0.5);
            }
            let f = z.map(|row| system.rates(&std::array::from_fn(|i| y[i] + row[i])));
            evaluations += 3;
            let f = turned(&BACK, &f);
            let mut first: [f64; N] = std::array::from_fn(|i| f[0][i] - g * w[0][i]);
            real.solve(&mut first);
            let mut second: [Complex; N] = std::array::from_fn(|i| {
                Complex(f[1][i] - a * w[1][i] + b * w[2][i], f[2][i] - a * w[2][i] - b * w[1][i])
            });
            pair.solve(&mut second);
            iteration += 1;
            let mut sum = 0.0;
            for i in 0..N {
                let (p, q, r) = (first[i] * per[i], second[i].0 * per[i], second[i].1 * per[i]);
                sum += p * p + q * q + r * r;
                w[0][i] += first[i];
                w[1][i] += second[i].0;
                w[2][i] += second[i].1;
            }
            let change = (sum / (3 * N) as f64).sqrt();
            if iteration > 1 && iteration < MOST {
                let ratio = change / before;
                theta = if iteration == 2 { ratio } else { (ratio * last_ratio).sqrt() };
                last_ratio = ratio;
                if theta >= 0.99 || theta.is_nan() {
                    break Some(0.5);
                }
                contraction = theta / (1.0 - theta);
                let left = MOST - 1 - iteration;
                let expected = contraction * change * theta.powi(left as i32) / enough;
                if expected >= 1.0 {
                    let power = -1.0 / (4 + left) as f64;
                    break Some(0.8 * expected.clamp(1e-4, 20.0).powf(power));
                }
            }
            before = change.max(ROUNDING);
            z = turned(&T, &w);
            if contraction * change <= enough {
                break None;
            }
        };
        if let Some(factor) = shorter {
            h *= factor;
            is_rejected = true;
            decomposed = None;
            if !is_fresh {
                (slopes, is_fresh) = (system.slopes(&y), true);
            }
            continue;
        }
        // The error estimate, filtered by the real matrix.
        let combined: [f64; N] = std::array::from_fn(|i| {
            (weights[0] * z[0][i] + weights[1] * z[1][i] + weights[2] * z[2][i]) / h
        });
        let norm = |e: &[f64; N]| -> f64 {
            let squares: f64 = e.iter().zip(&per).map(|(e, per)| (e * per) * (e * per)).sum();
            (squares / N as f64).sqrt().max(1e-10)
        };
        let mut off: [f64; N] = std::array::from_fn(|i| rate[i] + combined[i]);
        real.solve(&mut off);
        let mut error = norm(&off);
        if error >= 1.0 && (accepted == 0 || is_rejected) {
            let again = system.rates(&std::array::from_fn(|i| y[i] + off[i]));
            evaluations += 1;
            off = std::array::from_fn(|i| again[i] + combined[i]);
            real.solve(&mut off);
            error = norm(&off);
        }
        let most = (1 + 2 * MOST) as f64;
        let factor = SAFE.min(SAFE * most / (iteration + 2 * MOST) as f64);
        let mut quotient = (error.powf(0.25) / factor).clamp(0.125, 5.0);
        if error >= 1.0 || error.is_nan() {
            h = if accepted == 0 { 0.1 * h } else { h / quotient };
            is_rejected = true;
            decomposed = None;
            if !is_fresh {
                (slopes, is_fresh) = (system.slopes(&y), true);
            }
            continue;
        }
        accepted += 1;
        if accepted > 1 {
            let predicted = (last_length / h) * (error * error / last_error).powf(0.25) / SAFE;
            quotient = quotient.max(predicted.clamp(0.125, 5.0));
        }
        (last_length, last_error) = (h, error.max(1e-2));
        let mut differences = [[0.0; N]; 3];
        for i in 0..N {
            let (one, two) = (nodes[0], nodes[1]);
            let slope = (z[0][i] - z[1][i]) / (one - two);
            differences[0][i] = (z[1][i] - z[2][i]) / (two - 1.0);
            differences[1][i] = (slope - differences[0][i]) / (one - 1.0);
            differences[2][i] = differences[1][i] - (slope - z[0][i] / one) / two;
            y[i] += z[2][i];
        }
        past = Some((h, differences));
        time += h;
        if time >= end * (1.0 - 1e-14) {
            return Some(Run { end: y, evaluations });
        }
        per = tolerances(&y);
        rate = system.rates(&y);
        evaluations += 1;
        let mut next = h / quotient;
        if is_rejected {
            next = next.min(h);
        }
        is_rejected = false;
        is_fresh = false;
        let is_last = time + next * (1.0 + 1e-10) >= end;
        let ratio = next / h;
        if !is_last && theta <= KEPT && (1.0..=1.2).contains(&ratio) {
            continue;
        }
        h = if is_last { end - time } else { next };
        decomposed = None;
        if theta > KEPT {
            (slopes, is_fresh) = (system.slopes(&y), true);
        }
    }
    None
}
