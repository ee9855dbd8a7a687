//! Writes Scalable Vector Graphics: the few elements that a figure needs, no scripts, every text escaped.

use std::fmt::Write;

/// How the elements of all figures look, by their classes.
const STYLE: &str = include_str!("style.css");

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The point is its left end.
    Start,
    /// The point is its middle.
    Middle,
    /// The point is its right end.
    End,
}

/// A picture under construction. How elements look is said once, by the style sheet of all figures.
#[derive(Clone, Debug)]
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    /// An empty picture.
    pub fn new(width: f64, height: f64) -> Self {
        Self { width, height, body: String::new() }
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, from: (f64, f64), to: (f64, f64)) {
        let [x1, y1, x2, y2] = [from.0, from.1, to.0, to.1].map(short);
        self.push(&format!(r#"<line class="{class}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>"#));
    }

    /// A line through points; a gap where a point is not finite.
    pub fn path(&mut self, class: &str, points: &[(f64, f64)]) {
        let mut commands = String::new();
        let mut pen = 'M';
        for &(x, y) in points {
            if !(x.is_finite() && y.is_finite()) {
                pen = 'M';
                continue;
            }
            let _ = write!(commands, "{pen}{} {}", short(x), short(y));
            pen = 'L';
        }
        if !commands.is_empty() {
            self.push(&format!(r#"<path class="{class}" d="{commands}"/>"#));
        }
    }

    /// A closed shape with these corners.
    pub fn polygon(&mut self, class: &str, corners: &[(f64, f64)]) {
        if corners.iter().any(|(x, y)| !(x.is_finite() && y.is_finite())) {
            return;
        }
        let points = corners.iter().map(|(x, y)| format!("{},{}", short(*x), short(*y)));
        let points: Vec<_> = points.collect();
        self.push(&format!(r#"<polygon class="{class}" points="{}"/>"#, points.join(" ")));
    }

    /// An element as it stands; whoever writes it escapes its texts.
    pub fn raw(&mut self, element: &str) {
        self.push(element);
    }

    /// A rectangle from its upper left corner.
    pub fn rectangle(&mut self, class: &str, corner: (f64, f64), size: (f64, f64)) {
        let [x, y, width, height] = [corner.0, corner.1, size.0, size.1].map(short);
        self.push(&format!(
            r#"<rect class="{class}" x="{x}" y="{y}" width="{width}" height="{height}"/>"#
        ));
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, centre: (f64, f64), radius: f64) {
        let [x, y, radius] = [centre.0, centre.1, radius].map(short);
        self.push(&format!(r#"<circle class="{class}" cx="{x}" cy="{y}" r="{radius}"/>"#));
    }

    /// A text on its base line.
    pub fn text(&mut self, class: &str, place: (f64, f64), anchor: Anchor, text: &str) {
        let [x, y] = [place.0, place.1].map(short);
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        self.push(&format!(
            r#"<text class="{class}" x="{x}" y="{y}"{anchor}>{}</text>"#,
            escape(text)
        ));
    }

    /// Begins a part with a name for people who read the file; ends with [`Svg::end`].
    pub fn begin(&mut self, label: &str) {
        self.push(&format!(r#"<g aria-label="{}">"#, escape(label)));
    }

    /// Ends a part.
    pub fn end(&mut self) {
        self.push("</g>");
    }

    fn push(&mut self, element: &str) {
        self.body += element;
        self.body.push('\n');
    }

    /// The whole file.
    pub fn finish(self, title: &str, description: &str) -> String {
        let (width, height) = (short(self.width), short(self.height));
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
             <title>{}</title>\n<desc>{}</desc>\n<style>\n{STYLE}</style>\n{}</svg>\n",
            escape(title),
            escape(description),
            self.body
        )
    }
}

/// A coordinate to a hundredth of a pixel.
pub fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A text as XML may contain it: markup escaped, characters that XML forbids left out.
pub fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe += "&amp;",
            '<' => safe += "&lt;",
            '>' => safe += "&gt;",
            '"' => safe += "&quot;",
            '\'' => safe += "&#39;",
            '\n' | '\t' => safe.push(' '),
            _ if character.is_control() || matches!(character, '\u{fffe}' | '\u{ffff}') => {}
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_cannot_break_out() {
        assert_eq!(escape("a<b>&\"c\"\u{0}\n"), "a&lt;b&gt;&amp;&quot;c&quot; ");
    }

    #[test]
    fn a_gap_lifts_the_pen() {
        let mut svg = Svg::new(10.0, 10.0);
        svg.path("c", &[(0.0, 0.0), (1.0, 1.004), (f64::NAN, 0.0), (2.0, -0.001)]);
        assert!(svg.finish("", "").contains(r#"d="M0 0L1 1M2 0""#));
    }
}
