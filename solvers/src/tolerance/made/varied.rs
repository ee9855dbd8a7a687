//! Quantities that err, for several samples at once.
//!
//! What is the same sum for every sample is added up sample beside sample, so that the compiler packs it: a loop over
//! the sources of one sample has a length that only the run knows.

use crate::closure::Variable;
use crate::scalar::Scalar;
use crate::tolerance::source::Source;

/// Values of `W` samples.
pub(super) type Lanes<S, const W: usize> = [S; W];

/// One quantity that errs.
pub(super) struct Varied<S, const W: usize> {
    /// Where it stands among the constants, or the drivers.
    pub index: usize,
    nominal: S,
    /// The sources that it has.
    sources: Vec<usize>,
    /// Its values.
    pub made: Lanes<S, W>,
}

impl<S: Scalar, const W: usize> Varied<S, W> {
    /// The constants that err.
    pub fn constants(variables: &[Variable], sources: &[Source], nominal: &[S]) -> Vec<Self> {
        Self::among(sources, nominal, |source| match variables[source.variable] {
            Variable::Constant(index) => Some(index),
            Variable::Driver(_) => None,
        })
    }

    /// The drivers whose positions err.
    pub fn drivers(variables: &[Variable], sources: &[Source], nominal: &[S]) -> Vec<Self> {
        Self::among(sources, nominal, |source| match variables[source.variable] {
            Variable::Driver(index) => Some(index),
            Variable::Constant(_) => None,
        })
    }

    fn among(
        sources: &[Source],
        nominal: &[S],
        place: impl Fn(&Source) -> Option<usize>,
    ) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for (source, index) in sources.iter().map(place).enumerate() {
            let Some(index) = index else { continue };
            match all.iter_mut().find(|one| one.index == index) {
                Some(one) => one.sources.push(source),
                None => all.push(Self {
                    index,
                    nominal: nominal[index],
                    sources: vec![source],
                    made: [nominal[index]; W],
                }),
            }
        }
        all
    }

    /// Takes the errors of the sources.
    #[inline(always)]
    pub fn make(&mut self, errors: &[Lanes<S, W>]) {
        self.made = [self.nominal; W];
        for &source in &self.sources {
            add(S::ONE, &errors[source], &mut self.made);
        }
    }
}

/// Adds a multiple.
#[inline(always)]
pub(super) fn add<S: Scalar, const W: usize>(
    factor: S,
    terms: &Lanes<S, W>,
    sums: &mut Lanes<S, W>,
) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum = factor.mul_add(*term, *sum);
    }
}
