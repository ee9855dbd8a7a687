//! Where a surface is seen from: without perspective, so that lengths can be compared.

use super::vector::{Vector, inner};
use crate::ask::values;
use crate::error::Failure;
use crate::plot::name;
use crate::show::number;
use assur::shape::Quantity;

/// The view unless another one is asked for, degrees.
const VIEW: (f64, f64) = (35.0, 25.0);

/// A direction of view, by its axes in space.
pub struct View {
    /// The angles, degrees.
    angles: (f64, f64),
    /// Right, upwards, towards the viewer.
    pub axes: [Vector; 3],
}

impl View {
    /// Reads a `--view`.
    ///
    /// # Errors
    /// What is no pair of angles, or looks from farther above than from above.
    pub fn read(text: Option<&str>) -> Result<Self, Failure> {
        let Some(text) = text else { return Ok(Self::at(VIEW.0, VIEW.1)) };
        let placed = |failure: Failure| failure.place(format!("--view {text}"));
        let wrong =
            |what: &str| placed(Failure::request(what)).remedy("for example: --view 35deg,25deg");
        let Some((turned, raised)) = text.split_once(',') else {
            return Err(wrong("--view takes two angles"));
        };
        let angle = |name: &'static str, text: &str| {
            let degree = 1f64.to_radians();
            let angle =
                Quantity { name, summary: "", unit: "deg", factor: degree, dimension: [(0, 1); 7] };
            values::quantity(text.trim(), &angle).map(f64::to_degrees)
        };
        let turned = angle("turned", turned).map_err(placed)?;
        let raised = angle("raised", raised).map_err(placed)?;
        if raised.abs() > 90.0 {
            return Err(wrong(
                "the second angle of a view is between -90 deg, from below, and 90 deg, from above",
            ));
        }
        Ok(Self::at(turned, raised))
    }

    /// From the front, turned to the right and raised by these angles in degrees.
    pub fn at(turned: f64, raised: f64) -> Self {
        let (sine, cosine) = turned.to_radians().sin_cos();
        let (up, level) = raised.to_radians().sin_cos();
        let axes = [
            [cosine, sine, 0.0],
            [-up * sine, up * cosine, level],
            [level * sine, -level * cosine, up],
        ];
        Self { angles: (turned, raised), axes }
    }

    /// A place or direction, seen: to the right, upwards, towards the viewer.
    pub fn seen(&self, place: Vector) -> Vector {
        self.axes.map(|axis| inner(axis, place))
    }

    /// The view in words.
    pub fn in_words(&self) -> String {
        let degrees =
            |angle: f64| number::short(number::rounded(angle.abs(), 4)) + &name::unit("deg");
        let (turned, raised) = self.angles;
        let side = if turned < 0.0 { "left" } else { "right" };
        let end = if raised < 0.0 { "below" } else { "above" };
        format!("from the front, {} to the {side} and {} {end}", degrees(turned), degrees(raised))
    }
}

#[cfg(test)]
mod tests {
    use super::super::vector::cross;
    use super::*;

    #[track_caller]
    fn check(view: (f64, f64), axes: [Vector; 3]) {
        let found = View::at(view.0, view.1).axes;
        for (found, expected) in found.iter().flatten().zip(axes.iter().flatten()) {
            assert!((found - expected).abs() < 1e-15, "{view:?}: {found} {expected}");
        }
    }

    #[test]
    fn views_are_those_of_a_drawing() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let minus = |axis: Vector| axis.map(|component| -component);
        check((0.0, 0.0), [x, z, minus(y)]);
        check((90.0, 0.0), [y, z, x]);
        check((0.0, 90.0), [x, y, z]);
        let [right, up, towards] = View::at(35.0, 25.0).axes;
        assert!((inner(cross(right, up), towards) - 1.0).abs() < 1e-15, "a mirror image");
        assert!(towards.iter().zip([1.0, -1.0, 1.0]).all(|(part, sign)| part * sign > 0.0));
    }

    #[test]
    fn angles_are_read_with_their_units() {
        let words = |text| View::read(Some(text)).map(|view| view.in_words());
        let expected = "from the front, 30° to the left and 20° below";
        assert_eq!(words("-30deg, -20deg").as_deref(), Ok(expected));
        assert!(words("30,20").is_err(), "radians beyond a quarter of a turn");
        assert!(words("30deg").is_err() && words("1deg,2deg,3deg").is_err());
    }
}
