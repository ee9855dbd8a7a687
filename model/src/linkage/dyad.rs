//! The groups of two links in closed form.
//!
//! Unit vectors of the links come from squares and one root, never from the arc cosine of a rounded number; the root is
//! taken of a product of two factors, of which one vanishes where the group ceases to assemble. `m` is the assembly mode.

use super::group::{Affine, Complex, Share, TurningSlide, link};
use super::{Closed, Slot};
use crate::checked::GroupKind;
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::program::Function;

/// The group that affine equations are.
pub fn affine(
    graph: &mut Graph,
    equations: &Affine,
    unknowns: &[usize],
    mode: u32,
) -> Option<(GroupKind, Closed)> {
    let rest = equations.rest.as_slice();
    match (equations.shares.as_slice(), unknowns) {
        ([Share::Slide(slopes)], [unknown]) => {
            Some((GroupKind::Linear, one_slide(graph, slopes[0], rest[0], *unknown)))
        }
        ([Share::Turn(rows)], [unknown]) => {
            Some((GroupKind::Angle, angle(graph, rows[0], rest[0], *unknown, mode)))
        }
        ([Share::Slide(a), Share::Slide(b)], [first, second]) => {
            Some((GroupKind::Linear, two_slides(graph, [a, b], rest, [*first, *second])))
        }
        ([Share::Turn(a), Share::Turn(b)], [first, second]) => {
            let links = [link(graph, a)?, link(graph, b)?];
            let target = target(graph, rest);
            Some((GroupKind::Rrr, rrr(graph, links, target, [*first, *second], mode)))
        }
        ([Share::Turn(rows), Share::Slide(slopes)], [turn, slide])
        | ([Share::Slide(slopes), Share::Turn(rows)], [slide, turn]) => {
            let link = link(graph, rows)?;
            let direction = [slopes[0], slopes[1]];
            let target = target(graph, rest);
            Some((GroupKind::Rrp, rrp(graph, link, direction, target, [*turn, *slide], mode)))
        }
        _ => None,
    }
}

/// What the links have to reach: the rest of the equations, on the other side.
fn target(graph: &mut Graph, rest: &[Expression]) -> Complex {
    [graph.neg(rest[0]), graph.neg(rest[1])]
}

/// `slope·s + rest = 0`
fn one_slide(graph: &mut Graph, slope: Expression, rest: Expression, unknown: usize) -> Closed {
    let negated = graph.neg(rest);
    let value = graph.div(negated, slope);
    let (sine, margin) = (graph.one(), graph.one());
    Closed { values: vec![(Slot::Value(unknown), value)], links: None, sine, margin }
}

/// Two displacements along `a` and `b`.
fn two_slides(
    graph: &mut Graph,
    [a, b]: [&[Expression]; 2],
    rest: &[Expression],
    unknowns: [usize; 2],
) -> Closed {
    let (a, b) = ([a[0], a[1]], [b[0], b[1]]);
    let target = target(graph, rest);
    let determinant = cross(graph, a, b);
    let numerators = [cross(graph, target, b), cross(graph, a, target)];
    let values = [0, 1].map(|k| (Slot::Value(unknowns[k]), graph.div(numerators[k], determinant)));
    let lengths = [length(graph, a), length(graph, b)];
    let product = graph.mul(lengths[0], lengths[1]);
    let (sine, margin) = (graph.div(determinant, product), graph.one());
    Closed { values: values.to_vec(), links: None, sine, margin }
}

/// `A cos φ + B sin φ + rest = 0`. With `R² = A² + B²` and `h² = (R − rest)(R + rest)`:
/// `cos φ = (m·B·h − A·rest)/R²`, `sin φ = −(m·A·h + B·rest)/R²`.
fn angle(
    graph: &mut Graph,
    [a, b]: [Expression; 2],
    rest: Expression,
    unknown: usize,
    mode: u32,
) -> Closed {
    let radius = length(graph, [a, b]);
    let height = height(graph, radius, rest);
    let signed = with_mode(graph, mode, 1.0, height);
    let square = squares(graph, [a, b]);
    let minus_rest = graph.neg(rest);
    let cosine = {
        let terms = [graph.mul(b, signed), graph.mul(a, minus_rest)];
        graph.sum(&terms)
    };
    let sine = {
        let turned = graph.neg(signed);
        let terms = [graph.mul(a, turned), graph.mul(b, minus_rest)];
        graph.sum(&terms)
    };
    let margin = {
        let size = graph.call(Function::Abs, &[rest]);
        graph.sub(radius, size)
    };
    let unit = [graph.div(cosine, square), graph.div(sine, square)];
    let (values, sine) = (turned(graph, unknown, unit, 1.0), graph.div(signed, radius));
    Closed { values, links: None, sine, margin }
}

/// `a s² + 2 b s + c = 0`, a distance for instance. With `h² = b² − a·c`: `s = (m·h − b)/a`, and the slope of the equation by
/// `s` is `2 m·h`. The sine is that slope over the gradient by all positions of its kind: how square the distance stands to
/// the displacement.
pub fn distance(
    graph: &mut Graph,
    residual: Expression,
    unknown: usize,
    mode: u32,
    alike: &[Symbol],
) -> Option<(GroupKind, Closed)> {
    let symbol = Symbol::Dependent(unknown as u32);
    let (zero, one) = (graph.zero(), graph.one());
    let along = Map::from_iter([(symbol, one)]);
    let slope = graph.tangent(&[residual], &along)[0];
    let twice = graph.tangent(&[slope], &along)[0];
    if twice == zero || graph.depends_on(twice, |one| one == symbol) {
        return None;
    }
    let at_zero = Map::from_iter([(symbol, zero)]);
    let rest = graph.substitute(&[slope, residual], &at_zero);
    let (a, b, c) = (graph.scale(0.5, twice), graph.scale(0.5, rest[0]), rest[1]);
    let square = {
        let terms = [graph.powi(b, 2), graph.mul(a, c)];
        graph.sub(terms[0], terms[1])
    };
    let height = graph.sqrt(square);
    let signed = with_mode(graph, mode, 1.0, height);
    let value = {
        let numerator = graph.sub(signed, b);
        graph.div(numerator, a)
    };
    let gradient = graph.gradient(&[(residual, one)], alike);
    let closed = Map::from_iter([(symbol, value)]);
    let gradient = graph.substitute(&gradient, &closed);
    let mut squares: Vec<_> = gradient.iter().map(|one| graph.powi(*one, 2)).collect();
    let own = graph.scale(2.0, signed);
    squares.push(graph.powi(own, 2));
    let sum = graph.sum(&squares);
    let size = graph.sqrt(sum);
    let margin = {
        let size = graph.call(Function::Abs, &[a]);
        graph.div(square, size)
    };
    let sine = graph.div(own, size);
    Some((
        GroupKind::Distance,
        Closed { values: vec![(Slot::Value(unknown), value)], links: None, sine, margin },
    ))
}

/// `w₁·e^{±iφ₁} + w₂·e^{±iφ₂} = V`. The first link as a vector is `u = (q·V + σ·h·V⊥)/V²` with `q = (V² + a² − b²)/2`, the
/// second `V − u`, and `h² = a²V² − q² = ((a+b)² − V²)·(V² − (a−b)²)/4`, twice the area of the triangle of the links.
fn rrr(
    graph: &mut Graph,
    links: [(Complex, f64); 2],
    target: Complex,
    unknowns: [usize; 2],
    mode: u32,
) -> Closed {
    let [a, b] = links.map(|(link, _)| length(graph, link));
    let squared = squares(graph, target);
    let sum = graph.add(a, b);
    let difference = graph.sub(a, b);
    let (outer, inner) = (graph.powi(sum, 2), graph.powi(difference, 2));
    let factors = [graph.sub(outer, squared), graph.sub(squared, inner)];
    let product = graph.product(&factors);
    let root = graph.sqrt(product);
    let height = graph.scale(0.5, root);
    // The determinant is −σ·h, and shall have the sign of the mode.
    let order = -links[0].1 * links[1].1;
    let signed = with_mode(graph, mode, order, height);
    let inverse = graph.powi(squared, -1);
    let across = graph.mul(signed, inverse);
    // The parts of both links along V, as sums that products leave alone: 1/2 ± (a² − b²)/(2 V²).
    let [along, beside] = {
        let half = graph.number(0.5);
        let product = graph.product(&[half, sum, difference, inverse]);
        [graph.add(half, product), graph.sub(half, product)]
    };
    let (x, y) = (target[0], target[1]);
    let (up, aside) = (graph.mul(across, y), graph.mul(across, x));
    let first = {
        let terms = [graph.mul(along, x), graph.mul(along, y)];
        [graph.sub(terms[0], up), graph.add(terms[1], aside)]
    };
    let second = {
        let terms = [graph.mul(beside, x), graph.mul(beside, y)];
        [graph.add(terms[0], up), graph.sub(terms[1], aside)]
    };
    let mut values = Vec::new();
    for ((vector, (link, sense)), unknown) in [first, second].into_iter().zip(links).zip(unknowns) {
        let unit = over(graph, vector, link);
        values.extend(turned(graph, unknown, unit, sense));
    }
    let margin = {
        let distance = graph.sqrt(squared);
        let far = graph.sub(sum, distance);
        let size = graph.call(Function::Abs, &[difference]);
        let near = graph.sub(distance, size);
        graph.call(Function::Min, &[far, near])
    };
    let sine = {
        let product = graph.mul(a, b);
        let quotient = graph.div(signed, product);
        graph.scale(order, quotient)
    };
    Closed { values, links: None, sine, margin }
}

/// `w·e^{±iφ} + s·U = V`. With `k = U × V` and `h² = (a·U − k)(a·U + k)`: `s = (V·U + σ·h)/U²`.
fn rrp(
    graph: &mut Graph,
    (link, sense): (Complex, f64),
    direction: Complex,
    target: Complex,
    [turn, slide]: [usize; 2],
    mode: u32,
) -> Closed {
    // The determinant of the columns (angle, displacement) is σ·h.
    let order = if turn < slide { sense } else { -sense };
    let [a, size] = [link, direction].map(|vector| length(graph, vector));
    let reach = graph.mul(a, size);
    let offset = cross(graph, direction, target);
    let height = height(graph, reach, offset);
    let signed = with_mode(graph, mode, order, height);
    let square = squares(graph, direction);
    let along = inner(graph, target, direction);
    let sum = graph.add(along, signed);
    let displacement = graph.div(sum, square);
    let vector = [0, 1].map(|k| {
        let moved = graph.mul(displacement, direction[k]);
        graph.sub(target[k], moved)
    });
    let unit = over(graph, vector, link);
    let mut values = vec![(Slot::Value(slide), displacement)];
    values.extend(turned(graph, turn, unit, sense));
    let margin = {
        let distance = graph.call(Function::Abs, &[offset]);
        let distance = graph.div(distance, size);
        graph.sub(a, distance)
    };
    let sine = {
        let quotient = graph.div(signed, reach);
        graph.scale(order, quotient)
    };
    Closed { values, links: None, sine, margin }
}

/// `(m·s + n)·e^{±iφ} = V`. With `x = m × n` and `h² = (|m|·|V| − x)(|m|·|V| + x)`: `s = (σ·h − m·n)/m²`, and
/// `e^{iφ} = V·(m·s + n)*/V²`.
pub fn rpr(
    graph: &mut Graph,
    slide: &TurningSlide,
    turn: usize,
    displacement: usize,
    mode: u32,
) -> Option<(GroupKind, Closed)> {
    let (direction, offset) = (slide.direction, slide.offset);
    let target = [graph.neg(slide.rest[0]), graph.neg(slide.rest[1])];
    let [size, distance] = [direction, target].map(|vector| length(graph, vector));
    let reach = graph.mul(size, distance);
    let across = cross(graph, direction, offset);
    let height = height(graph, reach, across);
    // The determinant of the columns (angle, displacement) is −σ·h.
    let order = if turn < displacement { -slide.sense } else { slide.sense };
    let signed = with_mode(graph, mode, order, height);
    let along = inner(graph, direction, offset);
    let square = squares(graph, direction);
    let numerator = graph.sub(signed, along);
    let value = graph.div(numerator, square);
    let arm = [0, 1].map(|k| {
        let moved = graph.mul(value, direction[k]);
        graph.add(moved, offset[k])
    });
    let unit = over(graph, target, arm);
    let mut values = vec![(Slot::Value(displacement), value)];
    values.extend(turned(graph, turn, unit, slide.sense));
    let margin = {
        let needed = graph.call(Function::Abs, &[across]);
        let needed = graph.div(needed, size);
        graph.sub(distance, needed)
    };
    let sine = {
        let quotient = graph.div(signed, reach);
        graph.scale(order, quotient)
    };
    Some((GroupKind::Rpr, Closed { values, links: None, sine, margin }))
}

/// The entries of an angle whose unit vector is this one, turning in a sense.
fn turned(
    graph: &mut Graph,
    unknown: usize,
    [cosine, sine]: Complex,
    sense: f64,
) -> Vec<(Slot, Expression)> {
    let sine = graph.scale(sense, sine);
    let angle = graph.call(Function::Atan2, &[sine, cosine]);
    vec![
        (Slot::Value(unknown), angle),
        (Slot::Cosine(unknown), cosine),
        (Slot::Sine(unknown), sine),
    ]
}

/// `√((r − x)(r + x))`, without rounding the difference of squares.
fn height(graph: &mut Graph, r: Expression, x: Expression) -> Expression {
    let factors = [graph.sub(r, x), graph.add(r, x)];
    let product = graph.product(&factors);
    graph.sqrt(product)
}

fn with_mode(graph: &mut Graph, mode: u32, sign: f64, height: Expression) -> Expression {
    let mode = graph.symbol(Symbol::Mode(mode));
    let signed = graph.mul(mode, height);
    graph.scale(sign, signed)
}

/// The quotient of two complex numbers.
fn over(graph: &mut Graph, [x, y]: Complex, [a, b]: Complex) -> Complex {
    if graph.as_number(b) == Some(0.0) {
        return [graph.div(x, a), graph.div(y, a)];
    }
    if graph.as_number(a) == Some(0.0) {
        let minus_x = graph.neg(x);
        return [graph.div(y, b), graph.div(minus_x, b)];
    }
    let square = squares(graph, [a, b]);
    let (real, imaginary) = (inner(graph, [x, y], [a, b]), cross(graph, [a, b], [x, y]));
    [graph.div(real, square), graph.div(imaginary, square)]
}

fn inner(graph: &mut Graph, [a, b]: Complex, [c, d]: Complex) -> Expression {
    let terms = [graph.mul(a, c), graph.mul(b, d)];
    graph.sum(&terms)
}

fn cross(graph: &mut Graph, [a, b]: Complex, [c, d]: Complex) -> Expression {
    let terms = [graph.mul(a, d), graph.mul(b, c)];
    graph.sub(terms[0], terms[1])
}

fn squares(graph: &mut Graph, vector: Complex) -> Expression {
    inner(graph, vector, vector)
}

/// The length of a vector; of one along an axis without a root.
fn length(graph: &mut Graph, [x, y]: Complex) -> Expression {
    match (graph.as_number(x), graph.as_number(y)) {
        (_, Some(0.0)) => graph.call(Function::Abs, &[x]),
        (Some(0.0), _) => graph.call(Function::Abs, &[y]),
        _ => {
            let square = squares(graph, [x, y]);
            graph.sqrt(square)
        }
    }
}
