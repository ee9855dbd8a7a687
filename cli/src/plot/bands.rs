//! Modes of a motion: bands behind the curves, with a strip below them that names the modes.

use super::legend::text_width;
use super::scale::Scale;
use super::svg::{Anchor, Svg};

/// Number of colours; modes beyond share them.
const COLOURS: usize = 5;
/// Height of the strip with the names, its gap included.
pub const STRIP: f64 = 22.0;

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

impl Band {
    fn place(&self, scale: &Scale) -> (f64, f64) {
        let (a, b) = (scale.pixel(self.ends.0), scale.pixel(self.ends.1));
        let (low, high) = (scale.pixels.0, scale.pixels.1);
        (a.min(b).clamp(low, high), a.max(b).clamp(low, high))
    }
}

/// Fills the background of a panel.
pub fn behind(svg: &mut Svg, bands: &[Band], scale: &Scale, (top, height): (f64, f64)) {
    for band in bands {
        let (left, right) = band.place(scale);
        let class = format!("b{}", band.mode % COLOURS);
        svg.rectangle(&class, (left, top), (right - left, height));
    }
}

/// Draws the strip, each name where it has room; a name without room anywhere stands at the widest band of its mode.
pub fn strip(svg: &mut Svg, bands: &[Band], scale: &Scale, top: f64) {
    behind(svg, bands, scale, (top, STRIP - 6.0));
    for (index, band) in bands.iter().enumerate() {
        let (left, right) = band.place(scale);
        let has_room = |band: &Band| {
            let (left, right) = band.place(scale);
            right - left > text_width(&band.name) + 6.0
        };
        let alike = || {
            bands
                .iter()
                .enumerate()
                .filter(|(_, one)| one.mode == band.mode)
        };
        let width = |one: &Band| {
            let (left, right) = one.place(scale);
            right - left
        };
        let widest = alike().max_by(|a, b| width(a.1).total_cmp(&width(b.1)));
        let alone = !alike().any(|(_, one)| has_room(one))
            && widest.is_some_and(|(widest, _)| widest == index);
        if has_room(band) || alone {
            let middle = ((left + right) / 2.0, top + STRIP - 10.0);
            svg.text("number", middle, Anchor::Middle, &band.name);
        }
    }
}
