//! Quantities that err.

use crate::closure::Variable;
use crate::scalar::Scalar;
use crate::tolerance::source::Source;

/// One quantity that errs.
pub(super) struct Varied<S> {
    /// Where it stands among the constants, or the drivers.
    pub index: usize,
    nominal: S,
    /// The sources that it has.
    sources: Vec<usize>,
}

impl<S: Scalar> Varied<S> {
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
                None => all.push(Self { index, nominal: nominal[index], sources: vec![source] }),
            }
        }
        all
    }

    /// Its value with the errors of the sources.
    #[inline(always)]
    pub fn made(&self, errors: &[S]) -> S {
        self.sources.iter().fold(self.nominal, |sum, source| sum + errors[*source])
    }
}
