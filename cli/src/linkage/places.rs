//! What stands behind `--places`: how many there are along each value that is swept.

use super::case::Axis;
use crate::ask::lookup::suggestion;
use crate::ask::values::split;
use crate::error::Failure;

/// Reads how many places there are along each axis: one number for all, `41`, or one for each, `u=21,th=41`.
///
/// # Errors
/// What is no whole number from 2 to the most that there may be; a name that is none, is given twice, or lacks.
pub fn read(axes: &[Axis], text: &str, most: usize) -> Result<Vec<usize>, Failure> {
    let placed = |failure: Failure| failure.place(format!("--places {text}"));
    if !text.contains('=') {
        let count = count(text, most).map_err(placed)?;
        return Ok(vec![count; axes.len()]);
    }
    let mut counts = vec![None; axes.len()];
    for part in text.split(',') {
        let (index, count) = of_axis(axes, part, most).map_err(placed)?;
        if counts[index].replace(count).is_some() {
            let what = format!("`{}` is given twice", axes[index].quantity.name);
            return Err(placed(Failure::request(what).remedy("leave one of them out")));
        }
    }
    let named = axes.iter().zip(counts).map(|(axis, count)| count.ok_or(axis.quantity.name));
    named.collect::<Result<_, _>>().map_err(|name| {
        let what = format!("how many places along `{name}`?");
        placed(Failure::request(what).remedy(format!("add it: --places {text},{name}=25")))
    })
}

fn of_axis(axes: &[Axis], part: &str, most: usize) -> Result<(usize, usize), Failure> {
    let (name, number) = split(part, "--places", "u=21,th=41")?;
    let names: Vec<_> = axes.iter().map(|axis| axis.quantity.name).collect();
    let index = names.iter().position(|one| *one == name).ok_or_else(|| {
        Failure::request(format!("`{name}` is not swept")).remedy(suggestion(name, &names))
    })?;
    Ok((index, count(number, most)?))
}

fn count(text: &str, most: usize) -> Result<usize, Failure> {
    let number = text.trim().parse().ok();
    number.filter(|number| (2..=most).contains(number)).ok_or_else(|| {
        Failure::request(format!("`{}` is no number of places", text.trim()))
            .remedy(format!("give a whole number from 2 to {most}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ask::values::TIME;
    use assur::shape::Quantity;

    fn places(text: &str) -> Result<Vec<usize>, u8> {
        let axis = |name| Axis { quantity: Quantity { name, ..TIME }, from: 0.0, to: 1.0 };
        read(&[axis("u"), axis("th")], text, 100).map_err(|failure| failure.code())
    }

    #[test]
    fn one_number_or_one_for_each() {
        assert_eq!(places("41"), Ok(vec![41, 41]));
        assert_eq!(places("th=3, u=100"), Ok(vec![100, 3]));
        for wrong in ["", "1", "101", "2.5", "-3", "u=3", "u=3,u=4", "u=3,v=4", "u=3,th=", "3,4"] {
            assert_eq!(places(wrong), Err(2), "{wrong}");
        }
    }
}
