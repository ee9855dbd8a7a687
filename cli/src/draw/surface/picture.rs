//! The picture of a mesh: cells painted from the back to the front, shaded by their normals, within axes.

use std::collections::HashMap;

use super::axes::Frame;
use super::files::millimetres;
use super::mesh::Mesh;
use super::order::{Cell, back_to_front};
use super::vector::{Vector, corners, cross, difference, inner, norm};
use super::view::View;
use crate::draw::sheet::scale_bar;
use crate::plot::legend::text_width;
use crate::plot::svg::{Anchor, Svg, short};
use crate::show::text::wrap;

/// Largest width and height of the box of axes.
const LARGEST: (f64, f64) = (640.0, 500.0);
/// Around it: room for numbers and names.
const MARGIN: f64 = 94.0;
/// Above it.
const GAP: f64 = 34.0;
/// Below it: room for the scale bar besides.
const FOOT: f64 = 100.0;
/// Smallest width of the paper: room for the title.
const NARROWEST: f64 = 520.0;
/// Towards the light from the upper left, as seen.
const LIGHT: Vector = [-0.25, 0.40, 0.88];
/// Colours of scenes that can be told apart, red, green and blue.
const COLOURS: [[f64; 3]; 8] = [
    [112.0, 160.0, 200.0],
    [232.0, 178.0, 84.0],
    [124.0, 186.0, 158.0],
    [208.0, 138.0, 120.0],
    [178.0, 156.0, 202.0],
    [192.0, 180.0, 124.0],
    [150.0, 202.0, 230.0],
    [172.0, 180.0, 188.0],
];

/// What is shown.
pub struct Picture<'a> {
    /// The surface.
    pub mesh: &'a Mesh,
    /// Where it is seen from.
    pub view: View,
    /// What it is.
    pub title: String,
    /// More about it, in sentences.
    pub lead: String,
    /// What is said of each scene.
    pub legend: Vec<String>,
}

impl Picture<'_> {
    /// Draws it.
    pub fn draw(&self) -> String {
        let places = self.mesh.corners.iter().map(|place| millimetres(*place));
        let places: Vec<_> = places.collect();
        let frame = Frame::around(corners(places.iter()));
        let seen: Vec<_> = frame.corners().map(|corner| self.view.seen(corner)).collect();
        let (low, high) = corners(seen.iter());
        let size = (high[0] - low[0], high[1] - low[1]);
        let scale = (LARGEST.0 / size.0).min(LARGEST.1 / size.1);
        let width = (scale * size.0 + 2.0 * MARGIN).max(NARROWEST);
        let lead = wrap(&self.lead, ((width - 60.0) / 7.2) as usize);
        let legend = self.legend_places(width, 58.0 + 18.0 * lead.len() as f64);
        let below = legend.last().map_or(0.0, |(_, y)| *y);
        let height = below + GAP + scale * size.1 + FOOT;
        let origin =
            (width / 2.0 - scale * (low[0] + high[0]) / 2.0, height - FOOT + scale * low[1]);
        let mut svg = Svg::new(width, height);
        svg.rectangle("paper", (0.0, 0.0), (width, height));
        svg.text("title", (30.0, 34.0), Anchor::Start, &self.title);
        for (index, line) in lead.iter().enumerate() {
            svg.text("lead", (30.0, 56.0 + 18.0 * index as f64), Anchor::Start, line);
        }
        for (index, (place, text)) in legend.into_iter().zip(&self.legend).enumerate() {
            let (x, y) = place;
            let fill = colour(COLOURS[index % COLOURS.len()]);
            svg.raw(&format!(
                r#"<rect class="facet" fill="{fill}" x="{}" y="{}" width="20" height="11"/>"#,
                short(x),
                short(y - 10.0)
            ));
            svg.text("unit", (x + 28.0, y), Anchor::Start, text);
        }
        let pixel = |place: Vector| {
            let [x, y, _] = self.view.seen(place);
            (origin.0 + scale * x, origin.1 - scale * y)
        };
        frame.draw(&mut svg, &self.view, &pixel);
        self.surface(&mut svg, scale, origin);
        scale_bar(&mut svg, (width, height), scale * 1e3);
        svg.finish(&self.title, &lead.join(" "))
    }

    /// Where the entries of the legend stand: in columns as long as there is room.
    fn legend_places(&self, width: f64, top: f64) -> Vec<(f64, f64)> {
        let needed = self.legend.iter().map(|text| 28.0 + text_width(text) + 18.0);
        let column = needed.fold(1.0, f64::max);
        let columns = (((width - 30.0) / column) as usize).max(1);
        let place = |index: usize| {
            (30.0 + column * (index % columns) as f64, top + 19.0 * (index / columns) as f64)
        };
        (0..self.legend.len()).map(place).collect()
    }

    /// Paints the cells from the back to the front, each with its part of the lines of the mesh.
    fn surface(&self, svg: &mut Svg, scale: f64, origin: (f64, f64)) {
        let seen = |corner: &usize| {
            let seen = self.view.seen(millimetres(self.mesh.corners[*corner]));
            seen.map(|component| scale * component)
        };
        let parts = self.mesh.parts.iter().enumerate();
        let cells = parts.flat_map(|(part, of)| of.cells.iter().map(move |cell| (part, cell)));
        let cells: Vec<_> = cells.collect();
        let pixels: Vec<Cell> =
            cells.iter().map(|(_, [a, b, c, d])| [seen(a), seen(b), seen(c), seen(d)]).collect();
        let rims = rims(self.mesh);
        svg.begin("surface");
        for index in back_to_front(&pixels) {
            let (part, cell) = cells[index];
            let corners = pixels[index].map(|[x, y, _]| (origin.0 + x, origin.1 - y));
            let points = corners.map(|(x, y)| format!("{},{}", short(x), short(y))).join(" ");
            let fill = colour(shaded(COLOURS[part % COLOURS.len()], &pixels[index]));
            svg.raw(&format!(r#"<polygon class="facet" fill="{fill}" points="{points}"/>"#));
            for side in 0..4 {
                let next = (side + 1) % 4;
                if rims.get(&edge(cell[side], cell[next])) == Some(&1) {
                    svg.line("rim", corners[side], corners[next]);
                }
            }
        }
        svg.end();
    }
}

/// An edge, whichever way it is gone.
fn edge(from: usize, to: usize) -> (usize, usize) {
    (from.min(to), from.max(to))
}

/// In how many cells each edge is: those of one are on the rim.
fn rims(mesh: &Mesh) -> HashMap<(usize, usize), usize> {
    let mut rims = HashMap::new();
    for cell in mesh.parts.iter().flat_map(|part| &part.cells) {
        for side in 0..4 {
            let (from, to) = (cell[side], cell[(side + 1) % 4]);
            if from != to {
                *rims.entry(edge(from, to)).or_insert(0) += 1;
            }
        }
    }
    rims
}

/// A colour in the light that falls on a cell, from whichever side it is seen.
fn shaded(colour: [f64; 3], [a, b, c, d]: &Cell) -> [f64; 3] {
    let area = cross(difference(*c, *a), difference(*d, *b));
    let towards = if area[2] < 0.0 { -1.0 } else { 1.0 };
    let cosine = towards * inner(area, LIGHT) / (norm(area) * norm(LIGHT));
    let light = if cosine.is_finite() { cosine.max(0.0) } else { 0.0 };
    let shine = 40.0 * light.powi(14);
    colour.map(|part| part * (0.66 + 0.38 * light) + shine)
}

fn colour(parts: [f64; 3]) -> String {
    let [red, green, blue] = parts.map(|part| part.round().clamp(0.0, 255.0) as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::surface::patch::Patch;

    fn drawn(patches: &[Patch], view: (f64, f64)) -> String {
        let picture = Picture {
            mesh: &Mesh::new(patches, &[]),
            view: View::at(view.0, view.1),
            title: "a title".to_owned(),
            lead: "A sentence.".to_owned(),
            legend: vec!["one".to_owned(), "two".to_owned()],
        };
        picture.draw()
    }

    /// Colours of the cells as they are painted.
    fn fills(text: &str) -> Vec<&str> {
        let cells = text.lines().filter(|line| line.starts_with("<polygon class=\"facet\""));
        cells.filter_map(|line| line.split('"').nth(3)).collect()
    }

    #[test]
    fn what_is_behind_is_painted_first_from_either_side() {
        let sheet = |z: f64| Patch::made([2, 2], move |u, v| [u, v, z]);
        let above = drawn(&[sheet(0.2), sheet(0.1)], (0.0, 90.0));
        let below = drawn(&[sheet(0.2), sheet(0.1)], (0.0, -90.0));
        let (above, below) = (fills(&above), fills(&below));
        assert_eq!(above.len(), 2);
        assert_eq!([below[1], below[0]], [above[0], above[1]]);
        // The first patch, the upper one, is the last that is painted from above.
        let blue = |fill: &str| u8::from_str_radix(&fill[5..], 16).expect("a colour");
        assert!(blue(above[1]) > blue(above[0]));
    }

    #[test]
    fn a_surface_that_is_flat_or_looked_along_has_a_picture() {
        let flat = || [Patch::made([3, 3], |u, v| [u, v, 0.0])];
        for view in [(0.0, 0.0), (0.0, 90.0), (90.0, 0.0), (35.0, 25.0), (180.0, -90.0)] {
            let text = drawn(&flat(), view);
            assert!(!text.contains("NaN") && !text.contains("inf"), "{view:?}");
            assert!(text.contains(" mm</text>") && text.contains("a title"), "{view:?}");
        }
    }

    #[test]
    fn rims_are_where_a_mesh_ends() {
        let count = |patch: Patch| {
            let text = drawn(&[patch], (35.0, 25.0));
            text.lines().filter(|line| line.contains("class=\"rim\"")).count()
        };
        assert_eq!(count(Patch::made([5, 4], |u, v| [u, v, u * v])), 2 * (4 + 3));
        assert_eq!(count(Patch::torus([9, 7])), 0);
    }
}
