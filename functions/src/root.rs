//! Where a function passes zero between 0 and 1, by Brent's method. (R. P. Brent: *Algorithms for Minimization without
//! Derivatives*, 1973, chapter 4.)

/// Steps at most; bisection alone takes 60 to any number above 1e-18, and Brent's method rarely more than a dozen.
const MOST: usize = 200;
/// What a function leaves beside its zero, over what it is at the ends, must be less: else it jumps there, or has a pole.
const LEFT: f64 = 1e-3;

/// Where a function passes zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Root {
    /// The place.
    At(f64),
    /// It has one sign at both ends.
    OneSign {
        /// Its values there.
        ends: (f64, f64),
    },
    /// It changes its sign without being zero.
    Jumps {
        /// Where.
        at: f64,
        /// From what to what.
        sides: (f64, f64),
    },
    /// It is no number at a place.
    NotFinite(f64),
}

impl Root {
    /// The place; NaN where there is none.
    pub fn place(self) -> f64 {
        match self {
            Self::At(place) => place,
            _ => f64::NAN,
        }
    }
}

/// Where a function passes zero between 0 and 1, to rounding.
pub fn root(f: &mut dyn FnMut(f64) -> f64) -> Root {
    let (mut a, mut b) = (0.0_f64, 1.0_f64);
    let (mut at_a, mut at_b) = (f(a), f(b));
    let ends = (at_a, at_b);
    match ends {
        _ if at_a == 0.0 => return Root::At(0.0),
        _ if at_b == 0.0 => return Root::At(1.0),
        _ if at_a.is_nan() => return Root::NotFinite(0.0),
        _ if at_b.is_nan() => return Root::NotFinite(1.0),
        _ if (at_a > 0.0) == (at_b > 0.0) => return Root::OneSign { ends },
        _ => {}
    }
    // `b` is the best place, `c` lies on the other side of the zero; `d` is the last step, `e` the one before.
    let (mut c, mut at_c) = (a, at_a);
    let (mut d, mut e) = (b - a, b - a);
    for _ in 0..MOST {
        if (at_b > 0.0) == (at_c > 0.0) {
            (c, at_c) = (a, at_a);
            (d, e) = (b - a, b - a);
        }
        if at_c.abs() < at_b.abs() {
            (a, b, c) = (b, c, b);
            (at_a, at_b, at_c) = (at_b, at_c, at_b);
        }
        let least = f64::EPSILON * b.abs() + f64::MIN_POSITIVE;
        let half = 0.5 * (c - b);
        if half.abs() <= least || at_b == 0.0 {
            break;
        }
        let by_bisection = (half, half);
        (d, e) = match e.abs() >= least && at_a.abs() > at_b.abs() {
            true => interpolated([(a, at_a), (b, at_b), (c, at_c)], (d, e), least)
                .unwrap_or(by_bisection),
            false => by_bisection,
        };
        (a, at_a) = (b, at_b);
        b += if d.abs() > least { d } else { least.copysign(half) };
        at_b = f(b);
        if at_b.is_nan() {
            return Root::NotFinite(b);
        }
    }
    match at_b.abs() <= LEFT * f64::max(ends.0.abs(), ends.1.abs()) {
        true => Root::At(b),
        false => Root::Jumps { at: b, sides: (at_c, at_b) },
    }
}

/// The step of the secant or of the inverse parabola, and the step before; none where it leads too far.
fn interpolated(
    [(a, at_a), (b, at_b), (c, at_c)]: [(f64, f64); 3],
    (d, e): (f64, f64),
    least: f64,
) -> Option<(f64, f64)> {
    let half = 0.5 * (c - b);
    let s = at_b / at_a;
    let (p, q) = match a == c {
        true => (2.0 * half * s, 1.0 - s),
        false => {
            let (q, r) = (at_a / at_c, at_b / at_c);
            let p = s * (2.0 * half * q * (q - r) - (b - a) * (r - 1.0));
            (p, (q - 1.0) * (r - 1.0) * (s - 1.0))
        }
    };
    let (p, q) = (p.abs(), if p > 0.0 { -q } else { q });
    let is_short = 2.0 * p < f64::min(3.0 * half * q - (least * q).abs(), (e * q).abs());
    is_short.then(|| (p / q, d))
}

/// How often a function changes its sign between 0 and 1, as far as so many equal parts show it.
pub fn sign_changes(f: &mut dyn FnMut(f64) -> f64, parts: usize) -> usize {
    let mut last = 0.0;
    let mut count = 0;
    for index in 0..=parts {
        let here = f(index as f64 / parts as f64);
        if here == 0.0 || here.is_nan() {
            continue;
        }
        count += usize::from(last != 0.0 && (here > 0.0) != (last > 0.0));
        last = here;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(f: impl Fn(f64) -> f64, expected: f64) -> usize {
        let mut asked = 0;
        let found = root(&mut |x| {
            asked += 1;
            f(x)
        });
        let error = (found.place() - expected).abs();
        assert!(error <= 4.0 * f64::EPSILON * expected.abs(), "{found:?}, expected {expected}");
        asked
    }

    #[test]
    fn roots_are_known_to_rounding() {
        assert!(check(|x| x.exp() - 1.5, 1.5f64.ln()) < 12);
        check(|x| x - 1e-12, 1e-12);
        check(|x| (x - 0.1).powi(3), 0.1);
        check(|x| (1e6 * (x - 0.3)).tanh(), 0.3);
        assert!(check(|x| x.powi(20) - 1e-15, 1e-15f64.powf(0.05)) < 60);
        check(|x| x, 0.0);
        check(|x| 1.0 - x, 1.0);
    }

    #[test]
    fn what_is_no_root_is_told() {
        let found = |f: fn(f64) -> f64| root(&mut |x| f(x));
        // A double root: no sign changes. Newton's method would creep to it, and give half of the digits.
        assert_eq!(found(|x| (x - 0.5).powi(2)), Root::OneSign { ends: (0.25, 0.25) });
        assert!(matches!(found(|x| (x - 0.25) * (x - 0.5)), Root::OneSign { .. }));
        assert!(
            matches!(found(|x| 1.0 / (x - 0.3)), Root::Jumps { at, .. } if (at - 0.3).abs() < 1e-15)
        );
        assert!(matches!(found(|x| if x < 0.7 { -1.0 } else { 2.0 }), Root::Jumps { .. }));
        assert!(matches!(found(|x| (x - 0.4).sqrt() - 0.1), Root::NotFinite(_)));
        let changes = sign_changes(&mut |x| (x - 0.25) * (x - 0.5), 64);
        assert_eq!(changes, 2);
    }
}
