//! One meaning of each function: that of the evaluator and that of the solvers' numbers.

use assur::scalar::Scalar;
use assur_model::program::Function;

const VALUES: [f64; 19] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    1e-300,
    0.3,
    -0.7,
    1.0,
    -1.0,
    1.5,
    2.0,
    -2.5,
    3.0,
    5.9,
    -7.0,
    31.0,
    -31.0,
    1e300,
];

/// Functions whose results are the same to the last bit, NaN and the sign of zero included.
fn exact(function: Function, x: f64, y: f64) -> Option<f64> {
    Some(match function {
        Function::Floor => Scalar::floor(x),
        Function::Abs => Scalar::abs(x),
        Function::Sign => Scalar::sign(x),
        Function::Max => Scalar::max(x, y),
        Function::Min => Scalar::min(x, y),
        Function::Erf => Scalar::erf(x),
        Function::NormalCdf => Scalar::normal_cdf(x),
        Function::Sqrt => Scalar::sqrt(x),
        _ => return None,
    })
}

/// Functions that are rounded, perhaps, in another way.
fn rounded(function: Function, x: f64, y: f64) -> Option<f64> {
    Some(match function {
        Function::Sin => Scalar::sin_cos(x).0,
        Function::Cos => Scalar::sin_cos(x).1,
        Function::Tan => Scalar::tan(x),
        Function::Asin => Scalar::asin(x),
        Function::Acos => Scalar::acos(x),
        Function::Atan => Scalar::atan(x),
        Function::Atan2 => Scalar::atan2(x, y),
        Function::Sinh => Scalar::sinh(x),
        Function::Cosh => Scalar::cosh(x),
        Function::Tanh => Scalar::tanh(x),
        Function::Exp => Scalar::exp(x),
        Function::Ln => Scalar::ln(x),
        Function::Log10 => Scalar::log10(x),
        Function::Hypot => Scalar::hypot(x, y),
        Function::Power => Scalar::powf(x, y),
        Function::ExpM1 => Scalar::exp_m1(x),
        Function::Ln1p => Scalar::ln_1p(x),
        _ => return None,
    })
}

#[test]
fn functions_mean_the_same() {
    use Function::*;
    let all = [
        Sin, Cos, Tan, Asin, Acos, Atan, Atan2, Sinh, Cosh, Tanh, Exp, Ln, Log10, Sqrt, Hypot, Erf,
        NormalCdf, Floor, Abs, Sign, Max, Min, Power, ExpM1, Ln1p,
    ];
    for function in all {
        for x in VALUES {
            for y in VALUES {
                let found = function.apply(&[x, y]);
                let both_nan = |other: f64| found.is_nan() && other.is_nan();
                let (same, expected) = match exact(function, x, y) {
                    Some(other) => (found.to_bits() == other.to_bits() || both_nan(other), other),
                    None => {
                        let other = rounded(function, x, y).expect("each function is listed");
                        let error = (found - other).abs();
                        let close = found == other || error <= super::DIFFERENCE * other.abs();
                        (close || both_nan(other), other)
                    }
                };
                assert!(same, "{function:?} of {x:e} and {y:e}: {found:e}, not {expected:e}");
            }
        }
    }
}
