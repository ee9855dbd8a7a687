//! Vectors in space.

/// A place or a direction.
pub type Vector = [f64; 3];

/// `a + factor*b`.
pub fn sum(a: Vector, factor: f64, b: Vector) -> Vector {
    [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]]
}

/// From `b` to `a`.
pub fn difference(a: Vector, b: Vector) -> Vector {
    sum(a, -1.0, b)
}

/// The inner product.
pub fn inner(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length.
pub fn norm(a: Vector) -> f64 {
    inner(a, a).sqrt()
}

/// Whether all components are.
pub fn is_finite(a: &Vector) -> bool {
    a.iter().all(|component| component.is_finite())
}

/// Lowest and highest components of places, those that are not finite left out; the origin where there are no others.
pub fn corners<'a>(places: impl Iterator<Item = &'a Vector>) -> (Vector, Vector) {
    let mut places = places.filter(|place| is_finite(place));
    let first = places.next().copied().unwrap_or_default();
    places.fold((first, first), |(low, high), place| {
        let axes = [0, 1, 2];
        (axes.map(|axis| low[axis].min(place[axis])), axes.map(|axis| high[axis].max(place[axis])))
    })
}
