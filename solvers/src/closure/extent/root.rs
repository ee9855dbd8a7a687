//! Roots of functions of one variable, and polynomials through points.

/// Finds a zero of `f` between `a` and `b`, where it has values `fa` and `fb` of different signs, to the last bits (R.
/// Brent: *Algorithms for Minimization without Derivatives*, 1973, chapter 4).
///
/// Gives the end of the last bracket where `f` is nearer to zero. A NaN ends the search where it stands.
pub(in crate::closure) fn brent(
    mut f: impl FnMut(f64) -> f64,
    (a, fa): (f64, f64),
    (b, fb): (f64, f64),
) -> f64 {
    let ((mut a, mut fa), (mut b, mut fb)) = ((a, fa), (b, fb));
    let ((mut c, mut fc), mut before, mut step) = ((a, fa), b - a, b - a);
    for _ in 0..200 {
        if (fb > 0.0) == (fc > 0.0) {
            (c, fc, before, step) = (a, fa, b - a, b - a);
        }
        if fc.abs() < fb.abs() {
            (a, fa, b, fb, c, fc) = (b, fb, c, fc, b, fb);
        }
        let least = 2.0 * f64::EPSILON * b.abs() + f64::MIN_POSITIVE;
        let half = 0.5 * (c - b);
        if half.abs() <= least || fb == 0.0 || fb.is_nan() {
            break;
        }
        let guess = interpolate((a, fa), (b, fb), (c, fc), half);
        if before.abs() >= least && fa.abs() > fb.abs() && guess.abs() < 0.5 * before.abs() {
            (before, step) = (step, guess);
        } else {
            (before, step) = (half, half);
        }
        (a, fa) = (b, fb);
        b += if step.abs() > least { step } else { least.copysign(half) };
        fb = f(b);
    }
    b
}

/// The step of the secant, or of inverse quadratic interpolation through three points, from `b`; infinite if it leads
/// out of the bracket.
fn interpolate((a, fa): (f64, f64), (b, fb): (f64, f64), (c, fc): (f64, f64), half: f64) -> f64 {
    let s = fb / fa;
    let (mut p, mut q) = if a == c {
        (2.0 * half * s, 1.0 - s)
    } else {
        let (q, r) = (fa / fc, fb / fc);
        let p = s * (2.0 * half * q * (q - r) - (b - a) * (r - 1.0));
        (p, (q - 1.0) * (r - 1.0) * (s - 1.0))
    };
    if p > 0.0 {
        q = -q;
    } else {
        p = -p;
    }
    if 2.0 * p < 3.0 * half * q { p / q } else { f64::INFINITY }
}

/// Value at `x` of the polynomial through points `(nodes[k], values[k])` (Neville).
pub(in crate::closure) fn through<const N: usize>(
    nodes: [f64; N],
    mut values: [f64; N],
    x: f64,
) -> f64 {
    for width in 1..N {
        for k in 0..N - width {
            let (left, right) = (nodes[k], nodes[k + width]);
            values[k] = ((x - right) * values[k] + (left - x) * values[k + 1]) / (left - right);
        }
    }
    values[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_to_the_last_bits() {
        let f = |x: f64| x.cos() - x;
        let root = brent(f, (0.0, f(0.0)), (1.0, f(1.0)));
        assert!((root - 0.739_085_133_215_160_6).abs() < 2e-16);
        let steep = |x: f64| (x - 1e-9).cbrt();
        assert!((brent(steep, (-1.0, steep(-1.0)), (2.0, steep(2.0))) - 1e-9).abs() < 1e-24);
    }

    #[test]
    fn polynomials_pass_through_their_points() {
        let f = |x: f64| 1.0 - x + 2.0 * x * x * x;
        let nodes = [-1.0, 0.5, 2.0, 3.0];
        assert!((through(nodes, nodes.map(f), 1.25) - f(1.25)).abs() < 1e-14);
    }
}
