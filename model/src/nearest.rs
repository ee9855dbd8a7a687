//! The nearest known name to one that is unknown.

/// The known name that differs least from `wanted`, if it differs by little: by at most a third of its letters, one of
/// a short name. Letters that differ only in case count half.
///
/// What a part has in common with all its names says nothing: of `feed.lift.l1` only `l1` is compared.
pub fn nearest<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let Some(part) = wanted.rfind('.') else {
        return closest(wanted, known.into_iter().map(|name| (name, name)));
    };
    let known: Vec<&str> = known.into_iter().collect();
    let (part, own) = wanted.split_at(part + 1);
    let beside = known.iter().filter_map(|name| Some((name.strip_prefix(part)?, *name)));
    closest(own, beside).or_else(|| {
        let others = known.iter().filter(|name| !name.starts_with(part));
        closest(wanted, others.map(|name| (*name, *name)))
    })
}

/// Of names with what they stand for, what the name nearest to `wanted` stands for.
fn closest<'a>(
    wanted: &str,
    known: impl IntoIterator<Item = (&'a str, &'a str)>,
) -> Option<&'a str> {
    let letters = wanted.chars().count();
    // Of a single letter only its case may differ.
    let limit = if letters > 1 { 2 * (letters / 3).clamp(1, 4) } else { 1 };
    known
        .into_iter()
        // Each letter more or less counts two.
        .filter(|(name, _)| 2 * name.chars().count().abs_diff(letters) <= limit)
        .map(|(name, whole)| (distance(wanted, name), whole))
        .filter(|(distance, _)| *distance <= limit)
        .min()
        .map(|(_, whole)| whole)
}

/// Twice the number of letters that have to be put in, taken away, changed or swapped.
fn distance(left: &str, right: &str) -> usize {
    if left.to_lowercase() == right.to_lowercase() {
        return usize::from(left != right);
    }
    let (left, right): (Vec<char>, Vec<char>) = (left.chars().collect(), right.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=right.len()).map(|index| 2 * index).collect()];
    for (i, a) in left.iter().enumerate() {
        let mut row = vec![2 * (i + 1)];
        for (j, b) in right.iter().enumerate() {
            let change = match () {
                () if a == b => 0,
                () if a.to_lowercase().eq(b.to_lowercase()) => 1,
                () => 2,
            };
            let mut least = (rows[i][j] + change).min(rows[i][j + 1] + 2).min(row[j] + 2);
            if i > 0 && j > 0 && left[i - 1] == *b && *a == right[j - 1] {
                least = least.min(rows[i - 1][j - 1] + 2);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[left.len()][right.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_slip_of_the_finger_is_recognised() {
        let known = ["torsion", "bending", "damping", "F1"];
        assert_eq!(nearest("torsoin", known), Some("torsion"));
        assert_eq!(nearest("dampin", known), Some("damping"));
        assert_eq!(nearest("f1", known), Some("F1"));
    }

    #[test]
    fn names_of_a_part_are_compared_without_it() {
        let known = ["feed.lift.l1", "feed.lift.swing", "field.x", "swing"];
        assert_eq!(nearest("feed.lift.swign", known), Some("feed.lift.swing"));
        assert_eq!(nearest("feed.lift.clearance", known), None);
        assert_eq!(nearest("feeld.x", known), Some("field.x"));
    }

    #[test]
    fn a_different_word_is_not() {
        assert_eq!(nearest("clearance", ["torsion", "bending"]), None);
        assert_eq!(nearest("x", ["torsion", "y", "xy"]), None);
        assert_eq!(nearest("run", ["wind", "rest", "gap"]), None);
    }
}
