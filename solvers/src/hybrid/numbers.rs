//! A few numbers in place.

use std::fmt;
use std::ops::Deref;

/// Numbers that need no memory of their own: three coordinates with their speeds.
const FEW: usize = 6;

/// Some numbers, a slice of them. Up to six of them lie in place, so that an event is recorded without an allocation.
#[derive(Clone, Default)]
pub struct Numbers {
    few: [f64; FEW],
    count: usize,
    /// All of them, if they are more.
    many: Vec<f64>,
}

impl Numbers {
    /// Copies numbers.
    #[inline]
    pub fn new(numbers: &[f64]) -> Self {
        let mut copy = Self::default();
        match copy.few.get_mut(..numbers.len()) {
            Some(few) => {
                few.copy_from_slice(numbers);
                copy.count = numbers.len();
            }
            None => copy.many = numbers.to_vec(),
        }
        copy
    }
}

impl Deref for Numbers {
    type Target = [f64];

    #[inline]
    fn deref(&self) -> &[f64] {
        match self.many.is_empty() {
            true => &self.few[..self.count],
            false => &self.many,
        }
    }
}

impl AsMut<[f64]> for Numbers {
    fn as_mut(&mut self) -> &mut [f64] {
        match self.many.is_empty() {
            true => &mut self.few[..self.count],
            false => &mut self.many,
        }
    }
}

impl<'a> IntoIterator for &'a Numbers {
    type Item = &'a f64;
    type IntoIter = std::slice::Iter<'a, f64>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl PartialEq for Numbers {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl fmt::Debug for Numbers {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, formatter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_count_is_kept() {
        for count in 0..20 {
            let all: Vec<f64> = (0..count).map(f64::from).collect();
            let kept = Numbers::new(&all);
            assert_eq!(*kept, *all);
            assert_eq!(kept, kept.clone());
            assert_eq!(format!("{kept:?}"), format!("{all:?}"));
        }
    }
}
