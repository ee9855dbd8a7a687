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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;
    use std::f64::consts::{PI, TAU};

    fn mesh(patch: Patch) -> Mesh {
        Mesh::new(&[patch], &[])
    }

    fn facets(mesh: &Mesh) -> Vec<[usize; 3]> {
        mesh.parts.iter().flat_map(|part| mesh.facets(part)).collect()
    }

    fn area(mesh: &Mesh) -> f64 {
        facets(mesh).iter().map(|facet| norm(mesh.area(facet)) / 2.0).sum()
    }

    /// Above zero if the facets of a closed surface are turned outwards.
    fn volume(mesh: &Mesh) -> f64 {
        let part = |facet: &[usize; 3]| inner(mesh.area(facet), mesh.corners[facet[0]]) / 6.0;
        facets(mesh).iter().map(part).sum()
    }

    /// No edge is gone the same way by two facets, and so many belong to one facet alone.
    #[track_caller]
    fn check_edges(mesh: &Mesh, rim: usize) {
        let facets = facets(mesh);
        let ways = facets.iter().flat_map(|[a, b, c]| [(*a, *b), (*b, *c), (*c, *a)]);
        let ways: Vec<_> = ways.collect();
        let all: HashSet<_> = ways.iter().copied().collect();
        assert_eq!(all.len(), ways.len(), "an edge is gone twice the same way");
        assert_eq!(ways.iter().filter(|(from, to)| !all.contains(&(*to, *from))).count(), rim);
    }

    #[test]
    fn facets_on_both_sides_of_an_edge_go_it_opposite_ways() {
        let open = Patch::made([7, 5], |u, v| [u, v, (9.0 * u * v).sin()]);
        check_edges(&mesh(open), 2 * (6 + 4));
        let tube = Patch::made([13, 5], |u, v| [(TAU * u).cos(), (TAU * u).sin(), v]);
        check_edges(&mesh(tube), 2 * 12);
        check_edges(&mesh(Patch::torus([13, 9])), 0);
        check_edges(&mesh(Patch::sphere([13, 9], (0.0, -PI / 2.0), (TAU, PI))), 0);
    }

    #[test]
    fn patches_that_meet_share_their_corners() {
        let half = |from: f64| Patch::sphere([13, 9], (from, -PI / 2.0), (PI, PI));
        let both = Mesh::new(&[half(0.0), half(PI)], &[]);
        check_edges(&both, 0);
        assert_eq!(both.corners.len(), 24 * 7 + 2);
    }

    #[test]
    fn facets_without_area_are_left_out() {
        let globe = mesh(Patch::sphere([13, 9], (0.0, -PI / 2.0), (TAU, PI)));
        assert_eq!((globe.parts[0].cells.len(), facets(&globe).len()), (96, 2 * 96 - 24));
    }

    #[track_caller]
    fn check_area(exact: f64, of: impl Fn(usize) -> Patch) {
        let error = |count: usize| exact - area(&mesh(of(count)));
        let (coarse, fine) = (error(17), error(33));
        assert!(coarse.abs() < 0.01 * exact, "{coarse}");
        assert!((3.9..4.1).contains(&(coarse / fine)), "{coarse} {fine}");
    }

    #[test]
    fn areas_err_by_the_square_of_the_step() {
        check_area(PI / 2.0, |count| Patch::sphere([count; 2], (0.0, 0.0), (PI / 2.0, PI / 2.0)));
        check_area(PI, |count| Patch::made([count, 4], |u, v| [(PI * u).cos(), (PI * u).sin(), v]));
    }

    #[test]
    fn outside_is_where_the_normal_says_or_else_the_order_of_what_is_swept() {
        let globe = || Patch::sphere([25, 13], (0.0, -PI / 2.0), (TAU, PI));
        let exact = 4.0 / 3.0 * PI;
        let near = |mesh: Mesh, exact: f64| (volume(&mesh) / exact - 1.0).abs() < 0.05;
        assert!(near(mesh(globe()), exact));
        assert!(near(Mesh::new(&[globe()], &["made".to_owned()]), -exact));
        let mut hollow = globe();
        let inwards = hollow.places.iter().map(|place| place.map(|component| -component));
        // A direction that is none of the surface does not count.
        let up = vec![[0.0, 0.0, 1.0]; hollow.places.len()];
        hollow.normals = vec![("up", up), ("inwards", inwards.collect())];
        let hollow = mesh(hollow);
        assert_eq!(hollow.parts[0].outside, "inwards");
        assert!(near(hollow, -exact));
    }

    #[test]
    fn a_place_without_a_value_is_a_hole() {
        let holed = |hole: (f64, f64)| {
            Patch::made([5, 5], move |u, v| [u, v, if (u, v) == hole { f64::NAN } else { 0.0 }])
        };
        for (hole, missing, rim) in [((0.5, 0.5), 4, 16 + 8), ((0.0, 0.0), 1, 16)] {
            let mesh = mesh(holed(hole));
            assert_eq!(mesh.parts[0].missing, missing);
            assert_eq!(facets(&mesh).len(), 2 * (16 - missing));
            check_edges(&mesh, rim);
            assert!((area(&mesh) - (16 - missing) as f64 / 16.0).abs() < 1e-12);
        }
    }
}
