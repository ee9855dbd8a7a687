//! Error bands to second order.
//!
//! An output errs by `K δ + ½ δᵀ H δ`. For independent errors without a mean, with variances `v`, third moments `w` (zero of
//! symmetric distributions) and fourth moments `m`,
//!
//! ```text
//! mean      ½ Σ H_pp v_p
//! variance  Σ K_p² v_p + Σ K_p H_pp w_p + ¼ Σ H_pp² (m_p - v_p²) + Σ_{p<q} H_pq² v_p v_q
//! third     Σ K_p³ w_p + 3/2 Σ K_p² H_pp (m_p - v_p²) + 6 Σ_{p<q} K_p K_q H_pq v_p v_q + O(H²)
//! ```

use super::influence::influence_at;
use super::variation::Stand;
use crate::closure::{AnyLinkage, Guide, Linkage};
use crate::dense::Singular;
use crate::tolerance::error::ToleranceError;
use crate::tolerance::made::nominal::Nominal;
use crate::tolerance::source::{Source, Study};

/// An output near the nominal linkage, as a quadratic form of the errors of the sources.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadratic {
    /// The output without any error.
    pub value: f64,
    /// First derivatives by the sources.
    pub gradient: Vec<f64>,
    /// Second derivatives, row by row.
    pub hessian: Vec<f64>,
}

/// The distribution of an error to second order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Mean: how far the output is shifted.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Third central moment over the cube of the standard deviation.
    pub skewness: f64,
}

impl Quadratic {
    /// The error of the output to first order.
    pub fn linear(&self, errors: &[f64]) -> f64 {
        self.gradient.iter().zip(errors).map(|(k, e)| k * e).sum()
    }

    /// The error of the output to second order.
    pub fn error(&self, errors: &[f64]) -> f64 {
        let rows = self.hessian.chunks_exact(errors.len()).zip(errors);
        let square: f64 = rows
            .map(|(row, error)| {
                let product: f64 = row.iter().zip(errors).map(|(h, e)| h * e).sum();
                product * error
            })
            .sum();
        self.linear(errors) + 0.5 * square
    }

    /// The distribution of the error.
    pub fn moments(&self, sources: &[Source]) -> Moments {
        let variances: Vec<f64> = sources.iter().map(Source::variance).collect();
        let n = sources.len();
        let (mut mean, mut variance, mut third) = (0.0, 0.0, 0.0);
        for p in 0..n {
            let (k, h, v) = (self.gradient[p], self.hessian[p * n + p], variances[p]);
            let (skew, excess) = (sources[p].third_moment(), sources[p].fourth_moment() - v * v);
            mean += 0.5 * h * v;
            variance += k * k * v + k * h * skew + 0.25 * h * h * excess;
            third += k * k * k * skew + 1.5 * k * k * h * excess;
            for (q, other) in variances[..p].iter().enumerate() {
                let h = self.hessian[p * n + q];
                variance += h * h * v * other;
                third += 6.0 * k * self.gradient[q] * h * v * other;
            }
        }
        let deviation = variance.sqrt();
        Moments {
            mean,
            deviation,
            skewness: match deviation > 0.0 {
                true => third / deviation.powi(3),
                false => 0.0,
            },
        }
    }
}

/// The quadratic form of an output at every place of a study.
///
/// # Errors
/// [`ToleranceError`] if the question makes no sense or the nominal linkage does not get to a place.
pub fn quadratics<L: Linkage>(
    linkage: &L,
    study: &Study,
) -> Result<Vec<Quadratic>, ToleranceError> {
    quadratics_of(linkage, study)
}

/// [`quadratics`] of a linkage behind a pointer.
pub(crate) fn quadratics_of(
    linkage: &dyn AnyLinkage,
    study: &Study,
) -> Result<Vec<Quadratic>, ToleranceError> {
    let shape = linkage.shape();
    study.check(shape)?;
    let nominals = Nominal::along(linkage, &study.places, &[])?;
    let mut assembly = linkage.assemble();
    assembly.guide().start()?;
    let mut all = Vec::with_capacity(nominals.len());
    for (index, nominal) in nominals.iter().enumerate() {
        let place = &study.places[index];
        let (value, influence) = influence_at(&mut *assembly, study.output, place)?;
        let second = match shape.loops().second {
            true => Ok(emitted(&assembly.guide(), &nominal.stand(), study.output)),
            false => varied(linkage, &nominal.stand(), study.output),
        };
        let quadratic = second
            .ok()
            .map(|second| by_sources(value, &influence, &second, &study.sources))
            .filter(Quadratic::is_finite);
        all.push(
            quadratic
                .ok_or_else(|| ToleranceError::NotFinite { place: index, at: place.clone() })?,
        );
    }
    Ok(all)
}

impl Quadratic {
    fn is_finite(&self) -> bool {
        let mut all = self.gradient.iter().chain(&self.hessian);
        self.value.is_finite() && all.all(|one| one.is_finite())
    }
}

/// From derivatives by variables to derivatives by sources.
fn by_sources(value: f64, influence: &[f64], second: &[f64], sources: &[Source]) -> Quadratic {
    let variables = || sources.iter().map(|source| source.variable);
    let row = |p: usize| variables().map(move |q| second[p * influence.len() + q]);
    Quadratic {
        value,
        gradient: variables().map(|p| influence[p]).collect(),
        hessian: variables().flat_map(row).collect(),
    }
}

/// Second derivatives by all variables, from emitted code, which gives the lower triangle.
fn emitted(guide: &Guide<'_, f64>, stand: &Stand<'_>, output: usize) -> Vec<f64> {
    let (loops, shape) = (guide.loops, guide.loops.shape());
    let instant = loops.instant_row(stand.independents, stand.motion);
    let n = shape.loops().variables.len();
    let triangle = n * (n + 1) / 2;
    let mut values = vec![0.0; shape.outputs.len() * triangle];
    loops.second_influence(&instant, guide.position, &mut values);
    let values = &values[output * triangle..];
    let entry = |p: usize, q: usize| values[p.max(q) * (p.max(q) + 1) / 2 + p.min(q)];
    (0..n * n).map(|k| entry(k / n, k % n)).collect()
}

/// Second derivatives by dual numbers, from the first derivatives.
fn varied(
    linkage: &dyn AnyLinkage,
    stand: &Stand<'_>,
    output: usize,
) -> Result<Vec<f64>, Singular> {
    let variables = linkage.shape().loops().variables;
    let n = variables.len();
    let mut all = vec![0.0; n * n];
    for (q, variable) in variables.iter().enumerate() {
        let influence = stand.varied(linkage, *variable)?.influence();
        for p in 0..n {
            all[p * n + q] = influence[output * n + p];
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Distribution;

    /// `y = x²` of an error that is uniform within ±1: mean 1/3, variance 4/45, third central moment 16/945.
    #[test]
    fn moments_of_a_square() {
        let source = Source { variable: 0, half_width: 1.0, distribution: Distribution::Uniform };
        let square = Quadratic { value: 0.0, gradient: vec![0.0], hessian: vec![2.0] };
        let moments = square.moments(&[source]);
        assert!((moments.mean - 1.0 / 3.0).abs() < 1e-15);
        assert!((moments.deviation.powi(2) - 4.0 / 45.0).abs() < 1e-15);
        assert_eq!(square.error(&[0.5]), 0.25);
    }

    /// `y = x + x z` of two normal errors: the third moment is 6 cov = 6 · (K_x K_z H) = 0, the variance 1 + 1.
    #[test]
    fn moments_of_a_product() {
        let source =
            |variable| Source { variable, half_width: 3.0, distribution: Distribution::Normal };
        let product =
            Quadratic { value: 0.0, gradient: vec![1.0, 1.0], hessian: vec![0.0, 1.0, 1.0, 0.0] };
        let moments = product.moments(&[source(0), source(1)]);
        assert_eq!(moments.mean, 0.0);
        assert!((moments.deviation.powi(2) - 3.0).abs() < 1e-14);
        // E (x + z + x z)³ = 6
        assert!((moments.skewness - 6.0 / 3f64.powf(1.5)).abs() < 1e-14);
    }
}
