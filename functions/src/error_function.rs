//! The error function and the normal distribution function.
//!
//! Near zero `erf x = x + x P(x²)`. Elsewhere `erfc x = exp(-x²) Q(x)`, where `exp(-x²)` comes from a square that is
//! split so that nothing of it is lost, and `Q` falls smoothly. The polynomials are Chebyshev fits of relative error
//! below 2⁻⁵⁷, in a variable that runs from −1 to 1 (from 0 to 1 near zero).

/// `erf x / x - 1` in `x²` for `|x| <= 1`.
const NEAR: [f64; 13] = [
    0.1283791670955126,
    -0.3761263890318375,
    0.11283791670954879,
    -0.026866170645076792,
    0.0052239776248180145,
    -0.000854832698083379,
    0.0001205533111164271,
    -1.4925595266831182e-5,
    1.6461000484121368e-6,
    -1.6350312701054695e-7,
    1.4659775274047436e-8,
    -1.1372848856791674e-9,
    5.957176147748911e-11,
];
/// `(x + 5/8) exp(x²) erfc x` in `(x - 5/4) / (3/4)`, for `x` from 1/2 to 2.
const MIDDLE: [f64; 21] = [
    0.689667968348177,
    -0.017788575735961775,
    -0.004826350917273997,
    0.005330942017427714,
    -0.0028308760955843815,
    0.0011825634010675904,
    -0.0004306273060119632,
    0.00014246293541250615,
    -4.375821368409402e-5,
    1.2645784363187151e-5,
    -3.469399372741363e-6,
    9.094892760424828e-7,
    -2.2893214891744403e-7,
    5.5543875423375874e-8,
    -1.3031743829451795e-8,
    2.9684350249278287e-9,
    -6.5588133456639e-10,
    1.376759501357541e-10,
    -2.8937893924138537e-11,
    7.446321158476598e-12,
    -1.4783026528737434e-12,
];
/// `x exp(x²) erfc x` in `(1/x - 5/16) / (3/16)`, for `x` from 2 to 8.
const FAR: [f64; 19] = [
    0.5399299097980298,
    -0.025855074842178936,
    -0.004495097886328547,
    0.001343149383110613,
    -0.00011206041847332939,
    -3.099568809507917e-5,
    1.3789510575652098e-5,
    -2.2752947527575796e-6,
    -1.4016938276141057e-7,
    2.0162664277161825e-7,
    -6.212034345694924e-8,
    7.845316966566721e-9,
    1.967693087905208e-9,
    -1.474886201135755e-9,
    4.543695282838879e-10,
    -6.363242091567425e-11,
    -1.850188509293996e-11,
    1.5457077158723856e-11,
    -3.6086458528897353e-12,
];
/// `x exp(x²) erfc x` in `(1/x - 5/64) / (3/64)`, for `x` from 8 to 32.
const FARTHEST: [f64; 12] = [
    0.5624833413264874,
    -0.0020291341566415822,
    -0.0005870377550716067,
    1.2639091938431872e-5,
    1.6183877048794873e-6,
    -9.234646460605119e-8,
    -5.711618700980449e-9,
    7.660122964120575e-10,
    1.1140855731311715e-11,
    -6.699706584472046e-12,
    2.0555702252556044e-13,
    5.429276333995775e-14,
];

/// 1/√2
const ROOT: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// First 26 bits of 1/√2.
const ROOT_HIGH: f64 = 0.7071067690849304;
/// The rest of it.
const ROOT_LOW: f64 = 1.210161710447897e-8;

/// Error function.
pub fn erf(x: f64) -> f64 {
    let size = x.abs();
    if size <= 1.0 {
        x + x * horner(&NEAR, x * x)
    } else if size < 6.0 {
        (1.0 - tail(size, 0.0)).copysign(x)
    } else if x.is_nan() {
        x
    } else {
        1f64.copysign(x)
    }
}

/// Distribution function of the standard normal distribution, `erfc(-x/√2) / 2`.
pub fn normal_cdf(x: f64) -> f64 {
    // What is lost in the product matters in the tail, where a relative error e of the argument u becomes 2 u² e.
    let high = -x * ROOT;
    let (a, b) = split(-x);
    let low = ((a * ROOT_HIGH - high) + b * ROOT_HIGH) + a * ROOT_LOW + b * ROOT_LOW;
    if high > 28.0 {
        0.0
    } else if high >= 0.5 {
        0.5 * tail(high, low)
    } else if high > -0.5 {
        0.5 - 0.5 * (high + high * horner(&NEAR, high * high))
    } else if high > -6.0 {
        1.0 - 0.5 * tail(-high, -low)
    } else if x.is_nan() {
        x
    } else {
        1.0
    }
}

/// `erfc(x + low)` for `x` from 1/2 to 32, where `low` is a correction below the last digit of `x`.
fn tail(x: f64, low: f64) -> f64 {
    let smooth = if x < 2.0 {
        horner(&MIDDLE, (x - 1.25) / 0.75) / (x + 0.625)
    } else if x < 8.0 {
        horner(&FAR, (1.0 / x - 0.3125) / 0.1875) / x
    } else {
        horner(&FARTHEST, (1.0 / x - 0.078125) / 0.046875) / x
    };
    let (high, rest) = split(x);
    let correction = -(rest * (x + high) + 2.0 * x * low);
    (-high * high).exp() * (smooth + smooth * correction.exp_m1())
}

/// The number as the sum of its first 26 bits, whose square is exact, and the rest.
fn split(x: f64) -> (f64, f64) {
    let high = f64::from_bits(x.to_bits() & !((1 << 27) - 1));
    (high, x - high)
}

/// Value of a polynomial whose coefficients begin with the constant.
fn horner(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |value, coefficient| value * x + coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest distance of the values from known ones, counted in doubles.
    fn distance(function: fn(f64) -> f64, known: &[(f64, f64)]) -> u64 {
        known
            .iter()
            .map(|&(x, value)| function(x).to_bits().abs_diff(value.to_bits()))
            .fold(0, u64::max)
    }

    #[test]
    fn known_values_of_the_error_function() {
        // Rounded from 50 digits.
        let known = [
            (1e-300, 1.1283791670955126e-300),
            (1e-9, 1.1283791670955127e-9),
            (0.1, 0.1124629160182849),
            (0.3, 0.3286267594591274),
            (0.55, 0.563323366325109),
            (0.8, 0.7421009647076605),
            (0.99, 0.8385080695553698),
            (1.01, 0.8468104962282768),
            (1.5, 0.9661051464753108),
            (1.9, 0.9927904292352575),
            (2.1, 0.997020533343667),
            (3.0, 0.9999779095030014),
            (4.5, 0.9999999998033839),
            (5.5, 0.9999999999999927),
            (5.9, 0.9999999999999999),
        ];
        let distance = distance(erf, &known);
        println!("erf: {distance} ulp");
        assert!(distance <= 1);
        for (x, value) in known {
            assert_eq!(erf(-x), -erf(x), "{x}: {value}");
        }
        assert_eq!((erf(f64::INFINITY), erf(-7.0)), (1.0, -1.0));
        assert!(erf(f64::NAN).is_nan());
        assert!(erf(-0.0).is_sign_negative());
    }

    #[test]
    fn known_values_of_the_normal_distribution() {
        let known = [
            (-37.2, 3.412054343470239e-303),
            (-30.0, 4.906713927148187e-198),
            (-20.0, 2.7536241186062337e-89),
            (-12.3, 4.5287069561587846e-35),
            (-11.2, 2.0386675035448917e-29),
            (-8.0, 6.220960574271784e-16),
            (-5.1, 1.6982674071476014e-7),
            (-3.3, 0.0004834241423837775),
            (-2.0, 0.02275013194817921),
            (-1.0, 0.15865525393145705),
            (-0.7, 0.24196365222307303),
            (-0.25, 0.4012936743170763),
            (-0.01, 0.4960106436853684),
            (0.0, 0.5),
            (0.3, 0.6179114221889527),
            (0.7, 0.758036347776927),
            (1.1, 0.8643339390536173),
            (2.0, 0.9772498680518208),
            (3.7, 0.9998922002665226),
            (9.0, 1.0),
        ];
        let distance = distance(normal_cdf, &known);
        println!("normal_cdf: {distance} ulp");
        assert!(distance <= 4);
        assert_eq!((normal_cdf(-1e300), normal_cdf(1e300)), (0.0, 1.0));
        assert_eq!((normal_cdf(f64::NEG_INFINITY), normal_cdf(f64::INFINITY)), (0.0, 1.0));
        assert!(normal_cdf(f64::NAN).is_nan());
    }

    #[test]
    fn pieces_meet() {
        for x in [0.5, 1.0, 2.0, 8.0f64] {
            for end in [x, -x] {
                let step = erf(end.next_up()) - erf(end.next_down());
                assert!(step.abs() < 5e-16);
            }
            let before = x.next_down();
            let (before, after) = (tail(before, x - before), tail(x, 0.0));
            assert!((before / after - 1.0).abs() < 1e-15);
        }
    }
}
