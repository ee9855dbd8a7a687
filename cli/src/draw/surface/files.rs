//! Meshes as files for other programs: Wavefront OBJ and binary STL, both in millimetres.

use std::fmt::Write;

use super::mesh::Mesh;
use super::vector::{Vector, norm};
use crate::show::unit;

/// A millimetre.
const MILLIMETRE: f64 = 1e-3;
/// Length of what comes first in a binary STL file.
const HEADER: usize = 80;

/// A mesh as Wavefront OBJ, an object for each scene; `about` says what it is.
pub fn obj(mesh: &Mesh, about: &str) -> String {
    let mut text =
        format!("# {about}\n# lengths in mm; facets anticlockwise as seen from outside\n");
    for corner in &mesh.corners {
        let [x, y, z] = millimetres(*corner);
        let _ = writeln!(text, "v {x:?} {y:?} {z:?}");
    }
    for part in &mesh.parts {
        let _ = writeln!(text, "o {}", part.scene);
        for facet in mesh.facets(part) {
            let [a, b, c] = facet.map(|corner| corner + 1);
            let _ = writeln!(text, "f {a} {b} {c}");
        }
    }
    text
}

/// A mesh as binary STL; `about` says what it is, as far as there is room.
pub fn stl(mesh: &Mesh, about: &str) -> Vec<u8> {
    // A file that begins with `solid` would be taken for one in letters.
    let header = format!("mm; {about}").into_bytes().into_iter().chain(std::iter::repeat(0));
    let mut bytes: Vec<u8> = header.take(HEADER).collect();
    let facets: Vec<_> = mesh.parts.iter().flat_map(|part| mesh.facets(part)).collect();
    bytes.extend((facets.len() as u32).to_le_bytes());
    for facet in &facets {
        let area = mesh.area(facet);
        let normal = area.map(|component| component / norm(area));
        let corners = facet.map(|corner| millimetres(mesh.corners[corner]));
        let numbers = [normal].into_iter().chain(corners).flatten();
        bytes.extend(numbers.flat_map(|number| (number as f32).to_le_bytes()));
        bytes.extend([0, 0]);
    }
    bytes
}

/// A place in millimetres.
pub fn millimetres(place: Vector) -> Vector {
    place.map(|component| unit::stated(component, MILLIMETRE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::surface::patch::Patch;

    fn square() -> Mesh {
        Mesh::new(&[Patch::made([2, 2], |u, v| [0.01 * u, 0.02 * v, 0.5])], &[])
    }

    #[test]
    fn an_object_has_its_corners_in_millimetres() {
        let text = obj(&square(), "a square");
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[0], "# a square");
        assert!(lines[1].contains("mm"));
        assert_eq!(
            lines[2..6],
            ["v 0.0 0.0 500.0", "v 10.0 0.0 500.0", "v 0.0 20.0 500.0", "v 10.0 20.0 500.0"]
        );
        assert_eq!(lines[6..], ["o made", "f 1 2 4", "f 1 4 3"]);
    }

    #[test]
    fn a_binary_file_has_fifty_bytes_a_facet() {
        let bytes = stl(&square(), &"a long name ".repeat(20));
        assert_eq!(bytes.len(), 84 + 2 * 50);
        assert!(bytes.starts_with(b"mm; a long"));
        assert_eq!(bytes[80..84], [2, 0, 0, 0]);
        let number = |index: usize| {
            let four = bytes[84 + 4 * index..].first_chunk().copied();
            f32::from_le_bytes(four.expect("four bytes"))
        };
        let first: Vec<_> = (0..12).map(number).collect();
        let corners = [0.0, 0.0, 500.0, 10.0, 0.0, 500.0, 10.0, 20.0, 500.0];
        assert_eq!((&first[..3], &first[3..]), (&[0.0, 0.0, 1.0][..], &corners[..]));
    }
}
