//! Names and units as a book sets them: `dot(phi2)` as φ̇₂, `m/s^2` as m/s².

/// A name for a figure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The text.
    pub text: String,
    /// Whether it is a letter, which is set in italics.
    pub italic: bool,
}

const GREEK: [(&str, char); 24] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Omega", 'Ω'),
];

/// The base name under any `dot(…)`, with the number of dots: `ddot(x3)` gives `x3` and 2.
pub fn base(name: &str) -> (&str, usize) {
    for (front, dots) in [("dot(", 1), ("ddot(", 2)] {
        if let Some(inner) = name.strip_prefix(front).and_then(|rest| rest.strip_suffix(')')) {
            return (inner, dots);
        }
    }
    (name, 0)
}

/// A name of an equation file as a book sets it.
pub fn set(name: &str) -> Name {
    let (inner, dots) = base(name);
    let stem =
        inner.trim_end_matches(|character: char| character.is_ascii_digit() || character == '_');
    let index = inner[stem.len()..].trim_start_matches('_');
    let letter =
        GREEK.iter().find(|(word, _)| *word == stem).map(|(_, letter)| *letter).or_else(|| {
            let mut characters = stem.chars();
            characters
                .next()
                .filter(|character| characters.next().is_none() && character.is_alphabetic())
        });
    let Some(letter) = letter.filter(|_| index.chars().all(|character| character.is_ascii_digit()))
    else {
        // The name of a quantity of a part stays as the equation file has it.
        let words = match inner.contains('.') {
            true => inner.to_owned(),
            false => inner.replace('_', " "),
        };
        let text = match dots {
            0 => words,
            1 => format!("rate of {words}"),
            _ => format!("acceleration of {words}"),
        };
        return Name { text, italic: false };
    };
    let mut text = String::from(letter);
    match dots {
        0 => {}
        1 => text.push('\u{307}'),
        _ => text.push('\u{308}'),
    }
    text.extend(index.chars().filter_map(|digit| char::from_u32(0x2080 + digit.to_digit(10)?)));
    Name { text, italic: true }
}

/// A unit as a book sets it.
pub fn unit(unit: &str) -> String {
    let mut text = String::new();
    let mut raised = false;
    for character in unit.chars() {
        match character {
            '^' => raised = true,
            '0'..='9' | '-' if raised => text.push(raise(character)),
            ' ' | '*' => {
                raised = false;
                text.push('·');
            }
            _ => {
                raised = false;
                text.push(character);
            }
        }
    }
    match text.as_str() {
        "deg" => "°".to_owned(),
        "deg/s" => "°/s".to_owned(),
        "um" => "µm".to_owned(),
        _ => text,
    }
}

/// A digit or sign as a superscript.
pub fn raise(character: char) -> char {
    match character {
        '-' | '−' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => {
            digit.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(digit)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(name: &str, text: &str, italic: bool) {
        assert_eq!(set(name), Name { text: text.to_owned(), italic });
    }

    #[test]
    fn letters_have_indices_and_dots() {
        check("x3", "x₃", true);
        check("phi2", "φ₂", true);
        check("phi_12", "φ₁₂", true);
        check("dot(phi2)", "φ\u{307}₂", true);
        check("ddot(x3)", "x\u{308}₃", true);
        check("φ2", "φ₂", true);
    }

    #[test]
    fn words_stay_words() {
        check("rod_force_1", "rod force 1", false);
        check("dot(lag)", "rate of lag", false);
        check("x[1]", "x[1]", false);
        check("stitch.O1_x", "stitch.O1_x", false);
    }

    #[test]
    fn units_have_raised_powers() {
        assert_eq!(unit("m/s^2"), "m/s²");
        assert_eq!(unit("kg m^2"), "kg·m²");
        assert_eq!(unit("s^-1"), "s⁻¹");
        assert_eq!(unit("deg"), "°");
    }
}
