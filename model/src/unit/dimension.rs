//! Dimensions: exponents of the seven base units of the SI.

/// Exponents of m, kg, s, A, K, mol, cd, each a fraction in lowest terms. An angle is a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension([(i8, i8); 7]);

/// Symbols of the base units, in the order of the exponents.
pub const BASES: [&str; 7] = ["m", "kg", "s", "A", "K", "mol", "cd"];

impl Dimension {
    /// That of a pure number.
    pub const NONE: Dimension = Dimension([(0, 1); 7]);

    /// That of a base unit: 0 m, 1 kg, 2 s, 3 A, 4 K, 5 mol, 6 cd.
    pub const fn base(index: usize) -> Self {
        let mut exponents = [(0, 1); 7];
        exponents[index] = (1, 1);
        Self(exponents)
    }

    /// With whole exponents.
    pub const fn whole(exponents: [i8; 7]) -> Self {
        let mut list = [(0, 1); 7];
        let mut index = 0;
        while index < 7 {
            list[index].0 = exponents[index];
            index += 1;
        }
        Self(list)
    }

    /// With these exponents, numerator and denominator.
    pub const fn of(exponents: [(i8, i8); 7]) -> Self {
        Self(exponents)
    }

    /// The dimension of a product; none if an exponent would be absurdly large.
    pub fn mul(&self, other: &Self) -> Option<Self> {
        self.combine(other, 1)
    }

    /// The dimension of a quotient; none if an exponent would be absurdly large.
    pub fn div(&self, other: &Self) -> Option<Self> {
        self.combine(other, -1)
    }

    fn combine(&self, other: &Self, sign: i32) -> Option<Self> {
        let mut exponents = [(0, 1); 7];
        for (index, slot) in exponents.iter_mut().enumerate() {
            let ((a, b), (c, d)) = (self.0[index], other.0[index]);
            let (a, b, c, d) = (i32::from(a), i32::from(b), i32::from(c), i32::from(d));
            *slot = lowest(a * d + sign * c * b, b * d)?;
        }
        Some(Self(exponents))
    }

    /// The dimension of a power with the exponent `numerator/denominator`.
    pub fn pow(&self, numerator: i8, denominator: i8) -> Option<Self> {
        let mut exponents = [(0, 1); 7];
        for (slot, (a, b)) in exponents.iter_mut().zip(self.0) {
            *slot =
                lowest(i32::from(a) * i32::from(numerator), i32::from(b) * i32::from(denominator))?;
        }
        Some(Self(exponents))
    }

    /// Whether it contains a length, a mass or a time.
    pub fn is_mechanical(&self) -> bool {
        self.0[..3].iter().any(|(numerator, _)| *numerator != 0)
    }

    /// The exponents, numerator and denominator.
    pub fn exponents(&self) -> [(i8, i8); 7] {
        self.0
    }
}

/// A fraction in lowest terms with a positive denominator.
fn lowest(numerator: i32, denominator: i32) -> Option<(i8, i8)> {
    if denominator == 0 {
        return None;
    }
    let divisor = common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs()) as i32
        * denominator.signum();
    let (numerator, denominator) = (numerator / divisor, denominator / divisor);
    Some((i8::try_from(numerator).ok()?, i8::try_from(denominator).ok()?))
}

fn common_divisor(mut a: u32, mut b: u32) -> u32 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

#[cfg(test)]
mod tests {
    use super::Dimension;

    #[test]
    fn exponents_are_fractions_in_lowest_terms() {
        let area = Dimension::base(0).pow(2, 1).unwrap();
        assert_eq!(area.pow(1, 2), Some(Dimension::base(0)));
        assert_eq!(Dimension::base(0).pow(1, 2).unwrap().exponents()[0], (1, 2));
        assert_eq!(area.div(&area), Some(Dimension::NONE));
        assert!(area.is_mechanical() && !Dimension::NONE.is_mechanical());
        assert!(!Dimension::base(4).is_mechanical());
    }

    #[test]
    fn absurd_exponents_are_refused() {
        let large = Dimension::base(0).pow(100, 1).unwrap();
        assert_eq!(large.mul(&large), None);
        assert_eq!(large.pow(1, 0), None);
    }
}
