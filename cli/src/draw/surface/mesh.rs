//! Patches as one mesh: cells of four corners, and facets, which are the triangles of cells.
//!
//! Corners at one place are one corner, whether of a pole, of a seam where a surface closes, or of two patches that meet.

use std::collections::HashMap;

use super::patch::Patch;
use super::vector::{Vector, corners, cross, difference, inner, is_finite, norm, sum};

/// Corners nearer to each other than this part of the whole size are one.
const TOGETHER: f64 = 1e-9;
/// A facet is none whose height is less than this part of its longest edge.
const FLAT: f64 = 1e-9;
/// How far a normal vector may be from those of the facets: the mean cosine.
const NORMAL: f64 = 0.9;

/// Several patches together.
pub struct Mesh {
    /// Corners, metres.
    pub corners: Vec<Vector>,
    /// The patches.
    pub parts: Vec<Part>,
}

/// A patch of a mesh.
pub struct Part {
    /// Its scene.
    pub scene: &'static str,
    /// Its cells, anticlockwise as seen from where the normal points to.
    pub cells: Vec<[usize; 4]>,
    /// Cells that are left out: not all of their corners are anywhere.
    pub missing: usize,
    /// What says where the normal points to, in words.
    pub outside: String,
}

impl Mesh {
    /// Puts patches together, those of the scenes to flip turned over.
    pub fn new(patches: &[Patch], flip: &[String]) -> Self {
        let size = size(patches.iter().flat_map(|patch| &patch.places));
        let mut welded =
            Welded { size: TOGETHER * size, corners: Vec::new(), known: HashMap::new() };
        let mut parts = Vec::new();
        for patch in patches {
            let (normal, along) = normal(patch);
            let is_flipped = flip.iter().any(|scene| scene == patch.scene);
            let is_turned = (along < 0.0) != is_flipped;
            let swept =
                || format!("{}, then {}", patch.axes[0].quantity.name, patch.axes[1].quantity.name);
            let outside = normal.map_or_else(swept, str::to_owned);
            let outside = outside + if is_flipped { ", turned over" } else { "" };
            let place = |place: &Vector| is_finite(place).then(|| welded.corner(*place));
            let indices: Vec<_> = patch.places.iter().map(place).collect();
            let cell = |corners: [usize; 4]| {
                let [a, b, c, d] = corners.map(|corner| indices[corner]);
                let (a, b, c, d) = (a?, b?, c?, d?);
                Some(if is_turned { [a, d, c, b] } else { [a, b, c, d] })
            };
            let cells: Vec<_> = patch.cells().filter_map(cell).collect();
            let missing = patch.cells().count() - cells.len();
            parts.push(Part { scene: patch.scene, cells, missing, outside });
        }
        Self { corners: welded.corners, parts }
    }

    /// How large all of it is: from the lowest to the highest corner of a box around it.
    pub fn size(&self) -> f64 {
        size(self.corners.iter())
    }

    /// The facets of a part: two for each cell, divided along the shorter diagonal; those without an area are left out.
    pub fn facets(&self, part: &Part) -> Vec<[usize; 3]> {
        let facets = part.cells.iter().flat_map(|[a, b, c, d]| {
            let length =
                |from: &usize, to: &usize| norm(difference(self.corners[*from], self.corners[*to]));
            match length(a, c) <= length(b, d) {
                true => [[*a, *b, *c], [*a, *c, *d]],
                false => [[*a, *b, *d], [*b, *c, *d]],
            }
        });
        facets.filter(|facet| self.is_facet(facet)).collect()
    }

    /// Twice the area of a facet, as a vector along its normal.
    pub fn area(&self, facet: &[usize; 3]) -> Vector {
        let [a, b, c] = facet.map(|corner| self.corners[corner]);
        cross(difference(b, a), difference(c, a))
    }

    fn is_facet(&self, facet: &[usize; 3]) -> bool {
        let [a, b, c] = facet.map(|corner| self.corners[corner]);
        let edges = [difference(b, a), difference(c, b), difference(a, c)].map(norm);
        let longest = edges.into_iter().fold(0.0, f64::max);
        norm(self.area(facet)) > FLAT * longest * longest
    }
}

fn size<'a>(places: impl Iterator<Item = &'a Vector>) -> f64 {
    let (low, high) = corners(places);
    norm(difference(high, low))
}

/// Corners of which those at one place are one.
struct Welded {
    /// How near that is.
    size: f64,
    corners: Vec<Vector>,
    /// Corners by the cube of that size that they lie in.
    known: HashMap<[i64; 3], usize>,
}

impl Welded {
    fn corner(&mut self, place: Vector) -> usize {
        let cube =
            place.map(|component| (component / self.size.max(f64::MIN_POSITIVE)).floor() as i64);
        let around = (0..27).map(|number| {
            let steps = [number % 3, number / 3 % 3, number / 9];
            [0, 1, 2].map(|axis| cube[axis].saturating_add(steps[axis] - 1))
        });
        let mut near = around.filter_map(|cube| self.known.get(&cube).copied());
        let is_here = |known: &usize| norm(difference(self.corners[*known], place)) <= self.size;
        if let Some(known) = near.find(is_here) {
            return known;
        }
        self.corners.push(place);
        self.known.insert(cube, self.corners.len() - 1);
        self.corners.len() - 1
    }
}

/// The output of a patch that is the normal of its cells, with the mean cosine between them; below zero where it points to
/// the other side than the order of the swept values. One where there is none.
fn normal(patch: &Patch) -> (Option<&'static str>, f64) {
    let cosine = |normals: &[Vector]| {
        let mut sums = (0.0, 0.0);
        for [a, b, c, d] in patch.cells() {
            let place = |corner: usize| patch.places[corner];
            let area = cross(difference(place(c), place(a)), difference(place(d), place(b)));
            let mean = sum(sum(sum(normals[a], 1.0, normals[b]), 1.0, normals[c]), 1.0, normals[d]);
            let along = inner(area, mean) / 4.0;
            if along.is_finite() {
                sums = (sums.0 + along, sums.1 + norm(area));
            }
        }
        sums.0 / sums.1
    };
    let all = patch.normals.iter().map(|(name, normals)| (Some(*name), cosine(normals)));
    let near = all.filter(|(_, cosine)| cosine.abs() >= NORMAL);
    near.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs())).unwrap_or((None, 1.0))
}
