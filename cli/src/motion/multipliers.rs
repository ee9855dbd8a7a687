//! What the Floquet multipliers of a steady state mean.
//!
//! A disturbance of the steady state is multiplied by them once a turn, which is a period, or as many of them as pass
//! until the motion repeats: it shrinks where the modulus is below one, grows where it is above, and lasts for ever
//! where it is one.

use assur::periodic;

use crate::motion::turn::Turn;
use crate::show::number;

/// What periods are counted by.
const ONCE: Turn = Turn { periods: 1 };
/// A modulus this near to one counts as one.
const CIRCLE: f64 = 1e-6;

/// A multiplier, or two conjugate ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// Real part.
    pub re: f64,
    /// Imaginary part, not negative where the conjugate is included.
    pub im: f64,
    /// Whether the conjugate is one as well.
    pub pair: bool,
    /// Its estimated error. Two that are almost the same are known to the square root of what they were computed from.
    pub error: f64,
}

impl Multiplier {
    /// Its modulus.
    pub fn modulus(&self) -> f64 {
        self.re.hypot(self.im)
    }

    /// Its angle in degrees.
    pub fn angle(&self) -> f64 {
        self.im.atan2(self.re).to_degrees()
    }

    /// Distance from +1 or −1.
    fn distance(&self, real: f64) -> f64 {
        (self.re - real).hypot(self.im)
    }

    /// How far from one its modulus has to be to be told from one.
    fn circle(&self) -> f64 {
        self.error.max(CIRCLE)
    }

    /// What it does to a disturbance, in a few words.
    pub fn meaning(&self, turn: Turn) -> String {
        let (modulus, circle) = (self.modulus(), self.circle());
        if circle > CIRCLE && (modulus - 1.0).abs() <= circle {
            return format!(
                "lasts, or grows or dies out more slowly than can be told: the modulus is 1 within its error, {}",
                number::error(self.error)
            );
        }
        if modulus > 1.0 + circle {
            return format!(
                "grows {} times each {}: unstable",
                number::short(number_of(modulus, 4)),
                turn.one()
            );
        }
        if modulus < 1.0 - circle {
            let halved = -std::f64::consts::LN_2 / modulus.ln();
            return if halved < 0.5 {
                format!("dies out within a {}", turn.one())
            } else {
                format!("dies out, halved every {}", turn.every(halved))
            };
        }
        if self.pair {
            format!("lasts, and comes round every {}", turn.every(360.0 / self.angle().abs()))
        } else if self.re > 0.0 {
            "lasts unchanged: resonance".to_owned()
        } else {
            format!("lasts, and comes round every {}", turn.every(2.0))
        }
    }
}

fn number_of(value: f64, digits: usize) -> f64 {
    number::significant(value, digits).parse().unwrap_or(value)
}

/// Joins conjugate pairs and sorts by falling modulus, then by angle.
pub fn read(values: &[periodic::Multiplier]) -> Vec<Multiplier> {
    let mut list = Vec::new();
    for &periodic::Multiplier { re, im, error } in values {
        let partner = values.iter().any(|other| {
            im != 0.0 && other.im == -im && (other.re - re).abs() <= 1e-9 * re.hypot(im)
        });
        match (im < 0.0, partner) {
            (true, true) => {}
            (_, pair) => list.push(Multiplier { re, im, pair, error }),
        }
    }
    // A modulus on the circle is one, so that rounding does not decide the order.
    let rank = |multiplier: &Multiplier| {
        let modulus = multiplier.modulus();
        if (modulus - 1.0).abs() <= multiplier.circle() { 1.0 } else { modulus }
    };
    list.sort_by(|a, b| rank(b).total_cmp(&rank(a)).then(a.angle().total_cmp(&b.angle())));
    list
}

/// What all of them together say about the steady state, one sentence a line. `free` motions are not determined; the
/// motion from the start values was `followed` for some periods to find it.
pub fn conclusions(
    list: &[Multiplier],
    turn: Turn,
    free: usize,
    followed: Option<usize>,
) -> Vec<String> {
    let mut lines = stability(list, turn);
    if let Some(periods) = followed {
        lines.push(format!(
            "the motion from the start values comes to it, after {}: where several motions attract, they pick one",
            ONCE.count(periods.max(1) as f64)
        ));
    }
    if free > 0 {
        lines.push(format!(
            "not unique: {free} free motion{} after the same period and nothing drives {}; of all steady states this is the smallest",
            if free == 1 { " repeats" } else { "s repeat" },
            if free == 1 { "it" } else { "them" },
        ));
    }
    lines
}

fn stability(list: &[Multiplier], turn: Turn) -> Vec<String> {
    let Some(largest) = list.iter().map(Multiplier::modulus).max_by(f64::total_cmp) else {
        return Vec::new();
    };
    let off = |multiplier: &Multiplier| multiplier.modulus() - 1.0;
    let farthest = list.iter().map(|one| off(one).abs()).fold(0.0, f64::max);
    let is_on_circle = |one: &Multiplier| off(one).abs() <= one.circle();
    let mut lines = vec![if list.iter().all(is_on_circle) {
        format!(
            "all on the unit circle (to {}): undamped, the mechanism never forgets its start",
            number::error(farthest.max(f64::EPSILON))
        )
    } else if list.iter().any(|one| off(one) > one.circle()) {
        format!(
            "the largest modulus is {}: the steady state is unstable and will not be seen",
            number::significant(largest, 6)
        )
    } else if !list.iter().any(is_on_circle) {
        format!(
            "all inside the unit circle: the steady state attracts, a disturbance falls to a hundredth in {}",
            turn.count(number_of((0.01_f64.ln() / largest.ln()).max(1.0), 2))
        )
    } else {
        "some on the unit circle: part of a disturbance lasts for ever".to_owned()
    }];
    for (real, sign, words) in [
        (1.0, "+1", "at 0 there is resonance and no bounded steady state".to_owned()),
        (
            -1.0,
            "-1",
            format!("at 0 the motion may begin to repeat only every second {}", turn.one()),
        ),
    ] {
        let nearest = list.iter().min_by(|a, b| a.distance(real).total_cmp(&b.distance(real)));
        if let Some(nearest) = nearest {
            let angle = if nearest.pair {
                format!("the pair at ±{}°", number::short(number_of(nearest.angle(), 5)))
            } else {
                format!("the one at {}", number::short(number_of(nearest.re, 5)))
            };
            lines.push(format!(
                "nearest to {sign}: {angle}, distance {}; {words}",
                number::significant(nearest.distance(real), 3)
            ));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWICE: Turn = Turn { periods: 2 };

    /// Multipliers that are known well.
    fn list(values: &[(f64, f64)]) -> Vec<Multiplier> {
        let all = values.iter().map(|&(re, im)| periodic::Multiplier { re, im, error: 1e-12 });
        read(&all.collect::<Vec<_>>())
    }

    #[test]
    fn a_double_one_within_its_error_is_not_called_unstable() {
        // Mathieu's equation on the boundary of stability.
        let both =
            [1.0 + 3e-6, 1.0 - 3e-6].map(|re| periodic::Multiplier { re, im: 0.0, error: 2e-5 });
        let list = read(&both);
        assert!(
            list[0].meaning(ONCE).contains("within its error, 2e-5"),
            "{}",
            list[0].meaning(ONCE)
        );
        let lines = conclusions(&list, ONCE, 0, None);
        assert!(lines[0].starts_with("all on the unit circle"), "{lines:?}");
    }

    #[test]
    fn the_start_values_pick_one() {
        let lines = conclusions(&list(&[(0.5, 0.0)]), ONCE, 0, Some(12));
        let last = lines.last().expect("a line");
        assert!(last.contains("after 12 periods: where several motions attract"), "{last}");
    }

    #[test]
    fn conjugates_are_one_row() {
        let list = list(&[(0.6, 0.8), (0.6, -0.8), (-0.5, 0.0)]);
        assert_eq!(list.len(), 2);
        assert!(list[0].pair && !list[1].pair);
        assert_eq!(list[1].meaning(ONCE), "dies out, halved every period");
    }

    #[test]
    fn an_undamped_mechanism_never_forgets() {
        let lines = conclusions(&list(&[(0.6, 0.8), (0.6, -0.8)]), ONCE, 0, None);
        assert!(lines[0].contains("never forgets its start"), "{lines:?}");
        assert!(
            lines[1].starts_with("nearest to +1: the pair at ±53.13°, distance 0.894"),
            "{lines:?}"
        );
    }

    #[test]
    fn growth_is_called_unstable() {
        let lines = conclusions(&list(&[(-1.1, 0.0)]), ONCE, 0, None);
        assert!(lines[0].contains("unstable"), "{lines:?}");
    }

    #[test]
    fn a_motion_that_repeats_after_several_periods_is_counted_in_turns_of_them() {
        let read = list(&[(0.6, 0.0), (-0.95, 0.0)]);
        let all: Vec<String> = read.iter().map(|one| one.meaning(TWICE)).collect();
        assert_eq!(
            all,
            [
                "dies out, halved every 13.5 turns of 2 periods",
                "dies out, halved every 1.36 turns of 2 periods",
            ]
        );
        let lines = conclusions(&read, TWICE, 0, None);
        assert!(lines[0].ends_with("a hundredth in 90 turns of 2 periods"));
        assert!(lines[2].ends_with("only every second turn of 2 periods"));
        let quick = conclusions(&list(&[(0.01, 0.0)]), ONCE, 0, None);
        assert!(quick[0].ends_with("a hundredth in 1 period"), "{quick:?}");
    }
}
