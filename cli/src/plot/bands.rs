//! Modes of a motion: bands behind the curves, a strip below them that names the modes, and a legend of those that the
//! strip has no room to name.

use std::collections::BTreeMap;

use super::legend::{ROW, text_width};
use super::scale::Scale;
use super::svg::{Anchor, Svg};

/// Number of colours.
const COLOURS: usize = 8;
/// Height of the strip with the names, its gap included.
const STRIP: f64 = 22.0;
/// A sample of a colour in the legend.
const SAMPLE: (f64, f64) = (18.0, 10.0);
/// Between a sample and its name, and from a name to the next sample.
const GAPS: (f64, f64) = (6.0, 16.0);

/// A stretch in one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Horizontal position of its ends.
    pub ends: (f64, f64),
    /// Number of the mode.
    pub mode: usize,
    /// Name of the mode.
    pub name: String,
}

/// The bands of a column.
pub struct Bands<'a> {
    all: &'a [Band],
    scale: Scale,
    colours: BTreeMap<usize, usize>,
}

impl<'a> Bands<'a> {
    /// Bands on a horizontal scale.
    pub fn new(all: &'a [Band], scale: Scale) -> Self {
        Self { all, scale, colours: colours(all) }
    }

    /// Height of the strip.
    pub fn strip_height(&self) -> f64 {
        match self.all.is_empty() {
            true => 0.0,
            false => STRIP,
        }
    }

    /// Height of the legend; none where the strip names all modes.
    pub fn legend_height(&self) -> f64 {
        let rows = self.entries().last().map_or(0, |(_, _, row)| row + 1);
        rows as f64 * ROW
    }

    /// Fills the background of a panel.
    pub fn behind(&self, svg: &mut Svg, (top, height): (f64, f64)) {
        for band in self.all {
            let (left, right) = self.place(band);
            svg.rectangle(&self.class(band.mode), (left, top), (right - left, height));
        }
    }

    /// Draws the strip, each name where it has room.
    pub fn strip(&self, svg: &mut Svg, top: f64) {
        self.behind(svg, (top, STRIP - 6.0));
        for band in self.all.iter().filter(|band| self.has_room(band)) {
            let (left, right) = self.place(band);
            let middle = ((left + right) / 2.0, top + STRIP - 10.0);
            svg.text("number", middle, Anchor::Middle, &band.name);
        }
    }

    /// Draws the legend downwards from this height.
    pub fn legend(&self, svg: &mut Svg, top: f64) {
        for (band, x, row) in self.entries() {
            let base = top + (row + 1) as f64 * ROW - 4.0;
            let corner = (x, base - SAMPLE.1 + 1.0);
            svg.rectangle(&self.class(band.mode), corner, SAMPLE);
            svg.rectangle("frame", corner, SAMPLE);
            let place = (x + SAMPLE.0 + GAPS.0, base);
            svg.text("number", place, Anchor::Start, &band.name);
        }
    }

    /// The entries of the legend: a band of each mode in the order of the motion, its left end and its row.
    fn entries(&self) -> Vec<(&'a Band, f64, usize)> {
        let mut firsts: Vec<&Band> = Vec::new();
        for band in self.all {
            if firsts.iter().all(|first| first.mode != band.mode) {
                firsts.push(band);
            }
        }
        if firsts.iter().all(|first| self.is_named(first.mode)) {
            return Vec::new();
        }
        let (left, right) = self.scale.pixels;
        let (mut x, mut row) = (left, 0);
        let place = |band: &'a Band| {
            let width = SAMPLE.0 + GAPS.0 + text_width(&band.name);
            if x + width > right && x > left {
                (x, row) = (left, row + 1);
            }
            let entry = (band, x, row);
            x += width + GAPS.1;
            entry
        };
        firsts.into_iter().map(place).collect()
    }

    /// Whether the strip names a mode somewhere.
    fn is_named(&self, mode: usize) -> bool {
        let mut alike = self.all.iter().filter(|band| band.mode == mode);
        alike.any(|band| self.has_room(band))
    }

    fn has_room(&self, band: &Band) -> bool {
        let (left, right) = self.place(band);
        right - left > text_width(&band.name) + 6.0
    }

    fn place(&self, band: &Band) -> (f64, f64) {
        let [a, b] = [band.ends.0, band.ends.1].map(|end| self.scale.pixel(end));
        let (low, high) = self.scale.pixels;
        (a.min(b).clamp(low, high), a.max(b).clamp(low, high))
    }

    fn class(&self, mode: usize) -> String {
        format!("b{}", self.colours.get(&mode).unwrap_or(&mode) % COLOURS)
    }
}

/// The colour of each mode: its number, so that it keeps it in other figures; where numbers go beyond the colours, its
/// place among the modes that occur.
fn colours(bands: &[Band]) -> BTreeMap<usize, usize> {
    let mut colours: BTreeMap<_, _> = bands.iter().map(|band| (band.mode, band.mode)).collect();
    if colours.keys().any(|mode| *mode >= COLOURS) {
        for (place, colour) in colours.values_mut().enumerate() {
            *colour = place;
        }
    }
    colours
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCALE: Scale = Scale { values: (0.0, 100.0), pixels: (0.0, 400.0) };

    fn band(mode: usize, name: &str, ends: (f64, f64)) -> Band {
        Band { ends, mode, name: name.to_owned() }
    }

    fn drawn(all: &[Band]) -> (String, String) {
        let bands = Bands::new(all, SCALE);
        let (mut strip, mut legend) = (Svg::new(400.0, 100.0), Svg::new(400.0, 100.0));
        bands.strip(&mut strip, 0.0);
        bands.legend(&mut legend, 0.0);
        (strip.finish("", ""), legend.finish("", ""))
    }

    #[test]
    fn names_without_room_go_to_a_legend_of_all_modes() {
        let narrow =
            [band(0, "gap", (0.0, 2.0)), band(1, "wind", (2.0, 4.0)), band(2, "run", (4.0, 100.0))];
        let (strip, legend) = drawn(&narrow);
        assert!(strip.contains(">run<"), "{strip}");
        assert!(!strip.contains(">gap<") && !strip.contains(">wind<"));
        for name in [">gap<", ">wind<", ">run<"] {
            assert!(legend.contains(name), "{legend}");
        }
        assert_eq!(Bands::new(&narrow, SCALE).legend_height(), ROW);
    }

    #[test]
    fn there_is_no_legend_where_each_mode_is_named_somewhere() {
        let wide = [
            band(0, "gap", (0.0, 40.0)),
            band(1, "run", (40.0, 99.0)),
            band(0, "gap", (99.0, 100.0)),
        ];
        let (strip, legend) = drawn(&wide);
        assert_eq!(strip.matches(">gap<").count(), 1, "{strip}");
        assert!(!legend.contains("<text") && Bands::new(&wide, SCALE).legend_height() == 0.0);
    }

    #[test]
    fn eight_modes_have_eight_colours_whatever_their_numbers() {
        for numbers in [(0..8), (5..13)] {
            let all: Vec<_> = numbers.map(|mode| band(mode, "m", (0.0, 1.0))).collect();
            let mut found: Vec<usize> = colours(&all).into_values().collect();
            found.sort_unstable();
            assert_eq!(found, [0, 1, 2, 3, 4, 5, 6, 7]);
        }
    }

    #[test]
    fn a_long_legend_has_several_rows() {
        let names = ["first mode", "second mode", "third mode", "fourth mode", "fifth mode"];
        let all = names.iter().enumerate();
        let all: Vec<_> = all.map(|(mode, name)| band(mode, name, (0.0, 1.0))).collect();
        assert_eq!(Bands::new(&all, SCALE).legend_height(), 2.0 * ROW);
    }
}
