//! How far times over each other spread: codes take turns, and each round gives a ratio.

/// The median of ratios, and between what half of them lie.
pub struct Spread {
    median: f64,
    quartiles: [f64; 2],
}

impl Spread {
    /// Of times over those of the same rounds; none without any.
    pub fn of(times: &[f64], reference: &[f64]) -> Option<Self> {
        let mut ratios: Vec<f64> = times.iter().zip(reference).map(|(a, b)| a / b).collect();
        ratios.sort_by(f64::total_cmp);
        let last = ratios.len().checked_sub(1)?;
        let at = |share: f64| ratios[(share * last as f64).round() as usize];
        Some(Self { median: at(0.5), quartiles: [at(0.25), at(0.75)] })
    }

    /// As in `1.05 (1.03–1.08)`, a dash if there is none.
    pub fn text(spread: Option<&Self>) -> String {
        let Some(Self { median, quartiles: [low, high] }) = spread else {
            return "–".to_owned();
        };
        let digits = if *median < 99.5 { 2 } else { 0 };
        format!("{median:.digits$} ({low:.digits$}–{high:.digits$})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_ratios_lie_between_the_quartiles() {
        let spread = Spread::of(&[2.0, 6.0, 3.0, 8.0, 50.0], &[2.0, 2.0, 2.0, 2.0, 5.0]);
        assert_eq!(Spread::text(spread.as_ref()), "3.00 (1.50–4.00)");
        assert_eq!(Spread::text(Spread::of(&[], &[]).as_ref()), "–");
    }
}
