//! Functions of series.

use super::{Product, Quotient, TERMS, Terms, inverse, none, one, sum};
use crate::scalar::Scalar;

/// `f(u)` from the series of its derivative `g = f'(u)`.
#[derive(Clone, Debug)]
struct Through<S> {
    /// `j u_j`
    argument: Terms<S>,
    slope: Terms<S>,
}

impl<S: Scalar> Default for Through<S> {
    fn default() -> Self {
        Self { argument: none(), slope: none() }
    }
}

impl<S: Scalar> Through<S> {
    /// The next term, from the terms of the slope before it.
    #[inline]
    fn next(&mut self, k: usize, argument: S, first: impl FnOnce(S) -> S) -> S {
        self.argument[k] = S::from_f64(k as f64) * argument;
        match k {
            0 => first(argument),
            _ => inverse::<S>(k) * sum(&self.argument, &self.slope, (1, k), k),
        }
    }
}

/// Declares functions of one quantity: what they remember beside their slopes, their first value, and the next term of the
/// slope.
macro_rules! functions {
    ($($text:literal $name:ident { $($part:ident: $kind:ident),* } $first:expr;
       ($this:ident, $k:ident, $u:ident, $value:ident) $slope:expr;)*) => {$(
        #[doc = $text]
        #[derive(Clone, Debug)]
        pub struct $name<S> {
            through: Through<S>,
            $($part: $kind<S>),*
        }

        impl<S: Scalar> Default for $name<S> {
            fn default() -> Self {
                Self { through: Through::default(), $($part: $kind::default()),* }
            }
        }

        impl<S: Scalar> $name<S> {
            /// The next term.
            #[inline(never)]
            pub fn next(&mut self, $k: usize, $u: S) -> S {
                let $value = self.through.next($k, $u, $first);
                let $this = &mut *self;
                $this.through.slope[$k] = $slope;
                $value
            }
        }
    )*};
}

functions! {
    "`e^u`" Exp {} S::exp;
    (this, k, u, value) { let _ = (&this, u); value };

    "`e^u - 1`" ExpM1 {} S::exp_m1;
    (this, k, u, value) { let _ = (&this, u); value + one(k) };

    "Natural logarithm." Ln { slope: Quotient } S::ln;
    (this, k, u, value) { let _ = value; this.slope.next(k, one(k), u) };

    "`ln(1 + u)`" Ln1p { slope: Quotient } S::ln_1p;
    (this, k, u, value) { let _ = value; this.slope.next(k, one(k), u + one(k)) };

    "Decimal logarithm." Log10 { slope: Quotient } S::log10;
    (this, k, u, value) {
        let _ = value;
        S::from_f64(std::f64::consts::LOG10_E) * this.slope.next(k, one(k), u)
    };

    "Tangent." Tan { square: Product } S::tan;
    (this, k, u, value) { let _ = u; this.square.next(k, value, value) + one(k) };

    "Hyperbolic tangent." Tanh { square: Product } S::tanh;
    (this, k, u, value) { let _ = u; one::<S>(k) - this.square.next(k, value, value) };

    "Angle with a sine." Asin { square: Product, root: Sqrt, slope: Quotient } S::asin;
    (this, k, u, value) {
        let _ = value;
        let rest = one::<S>(k) - this.square.next(k, u, u);
        let root = this.root.next(k, rest);
        this.slope.next(k, one(k), root)
    };

    "Angle with a cosine." Acos { square: Product, root: Sqrt, slope: Quotient } S::acos;
    (this, k, u, value) {
        let _ = value;
        let rest = one::<S>(k) - this.square.next(k, u, u);
        let root = this.root.next(k, rest);
        -this.slope.next(k, one(k), root)
    };

    "Angle with a tangent." Atan { square: Product, slope: Quotient } S::atan;
    (this, k, u, value) {
        let _ = value;
        let below = this.square.next(k, u, u) + one(k);
        this.slope.next(k, one(k), below)
    };

    "Error function." Erf { square: Product, bell: Exp } S::erf;
    (this, k, u, value) {
        let _ = value;
        let square = this.square.next(k, u, u);
        S::from_f64(std::f64::consts::FRAC_2_SQRT_PI) * this.bell.next(k, -square)
    };

    "Distribution function of the normal distribution." NormalCdf { square: Product, bell: Exp } S::normal_cdf;
    (this, k, u, value) {
        let _ = value;
        let square = this.square.next(k, u, u);
        let height = 0.5 * std::f64::consts::FRAC_2_SQRT_PI * std::f64::consts::FRAC_1_SQRT_2;
        S::from_f64(height) * this.bell.next(k, S::from_f64(-0.5) * square)
    };
}

/// Square root.
#[derive(Clone, Debug)]
pub struct Sqrt<S>(Terms<S>);

impl<S: Scalar> Default for Sqrt<S> {
    fn default() -> Self {
        Self(none())
    }
}

impl<S: Scalar> Sqrt<S> {
    /// The next term.
    #[inline(never)]
    pub fn next(&mut self, k: usize, u: S) -> S {
        self.0[k] = match k {
            0 => S::sqrt(u),
            _ => {
                let known = sum(&self.0, &self.0, (1, k - 1), k);
                (u - known) / (self.0[0] + self.0[0])
            }
        };
        self.0[k]
    }
}

/// Sine and cosine of an angle.
#[derive(Clone, Debug)]
pub struct Sine<S> {
    sine: Through<S>,
    cosine: Through<S>,
}

impl<S: Scalar> Default for Sine<S> {
    fn default() -> Self {
        Self { sine: Through::default(), cosine: Through::default() }
    }
}

impl<S: Scalar> Sine<S> {
    /// The next terms of both.
    #[inline(never)]
    pub fn next(&mut self, k: usize, angle: S) -> (S, S) {
        let first = match k {
            0 => S::sin_cos(angle),
            _ => (S::ZERO, S::ZERO),
        };
        let sine = self.sine.next(k, angle, |_| first.0);
        let cosine = self.cosine.next(k, angle, |_| first.1);
        (self.sine.slope[k], self.cosine.slope[k]) = (cosine, -sine);
        (sine, cosine)
    }
}

/// Sine and cosine of an angle that grows evenly with the time.
#[derive(Clone, Copy, Debug)]
pub struct Turn<S> {
    last: (S, S),
    rate: S,
}

impl<S: Scalar> Default for Turn<S> {
    fn default() -> Self {
        Self { last: (S::ZERO, S::ZERO), rate: S::ZERO }
    }
}

impl<S: Scalar> Turn<S> {
    /// The next terms of both.
    #[inline]
    pub fn next(&mut self, k: usize, angle: S) -> (S, S) {
        if k == 0 {
            self.last = S::sin_cos(angle);
            return self.last;
        }
        if k == 1 {
            self.rate = angle;
        }
        let factor = self.rate * inverse(k);
        let (sine, cosine) = self.last;
        self.last = (factor * cosine, -(factor * sine));
        self.last
    }
}

/// Declares both hyperbolic functions, each of which is the slope of the other.
macro_rules! hyperbolic {
    ($($text:literal $name:ident $first:ident $other:ident;)*) => {$(
        #[doc = $text]
        #[derive(Clone, Debug)]
        pub struct $name<S> {
            value: Through<S>,
            other: Through<S>,
        }

        impl<S: Scalar> Default for $name<S> {
            fn default() -> Self {
                Self { value: Through::default(), other: Through::default() }
            }
        }

        impl<S: Scalar> $name<S> {
            /// The next term.
            #[inline(never)]
            pub fn next(&mut self, k: usize, u: S) -> S {
                let value = self.value.next(k, u, S::$first);
                let other = self.other.next(k, u, S::$other);
                (self.value.slope[k], self.other.slope[k]) = (other, value);
                value
            }
        }
    )*};
}

hyperbolic! {
    "Hyperbolic sine." Sinh sinh cosh;
    "Hyperbolic cosine." Cosh cosh sinh;
}

/// Distance of a point from zero.
#[derive(Clone, Debug)]
pub struct Hypot<S> {
    squares: (Product<S>, Product<S>),
    root: Sqrt<S>,
}

impl<S: Scalar> Default for Hypot<S> {
    fn default() -> Self {
        Self { squares: Default::default(), root: Sqrt::default() }
    }
}

impl<S: Scalar> Hypot<S> {
    /// The next term.
    #[inline(never)]
    pub fn next(&mut self, k: usize, x: S, y: S) -> S {
        let sum = self.squares.0.next(k, x, x) + self.squares.1.next(k, y, y);
        self.root.next(k, sum)
    }
}

/// Angle of a point: `a' = (x y' - y x') / (x² + y²)`.
#[derive(Clone, Debug)]
pub struct Atan2<S> {
    x: Terms<S>,
    y: Terms<S>,
    squares: (Product<S>, Product<S>),
    slope: Quotient<S>,
    square: S,
}

impl<S: Scalar> Default for Atan2<S> {
    fn default() -> Self {
        Self {
            x: none(),
            y: none(),
            squares: Default::default(),
            slope: Quotient::default(),
            square: S::ZERO,
        }
    }
}

impl<S: Scalar> Atan2<S> {
    /// The next term.
    #[inline(never)]
    pub fn next(&mut self, k: usize, y: S, x: S) -> S {
        (self.x[k], self.y[k]) = (x, y);
        let square = self.squares.0.next(k, x, x) + self.squares.1.next(k, y, y);
        let before = std::mem::replace(&mut self.square, square);
        if k == 0 {
            return S::atan2(y, x);
        }
        let mut above = S::ZERO;
        for j in 1..=k {
            let count = S::from_f64(j as f64);
            let turned = self.x[k - j] * self.y[j] - self.y[k - j] * self.x[j];
            above = count.mul_add(turned, above);
        }
        inverse::<S>(k) * self.slope.next(k - 1, above, before)
    }
}

/// A power with a constant exponent.
#[derive(Clone, Debug)]
pub struct Power<S> {
    base: Terms<S>,
    value: Terms<S>,
}

impl<S: Scalar> Default for Power<S> {
    fn default() -> Self {
        Self { base: [S::ZERO; TERMS], value: none() }
    }
}

impl<S: Scalar> Power<S> {
    /// The next term: `k u₀ f_k = Σ (j a - (k-j)) u_j f_(k-j)`.
    #[inline(never)]
    pub fn next(&mut self, k: usize, base: S, exponent: S) -> S {
        self.base[k] = base;
        let mut sum = S::ZERO;
        for j in 1..=k {
            let factor = S::from_f64(j as f64).mul_add(exponent, S::from_f64(-((k - j) as f64)));
            sum = (factor * self.base[j]).mul_add(self.value[k - j], sum);
        }
        self.value[k] = match k {
            0 => S::powf(base, exponent),
            _ => inverse::<S>(k) * sum / self.base[0],
        };
        self.value[k]
    }
}
