//! The linkage in motion, by the animation elements of SVG: any browser plays it.

use super::Picture;
use super::forces;
use super::geometry::{Frame, Moves, Point};
use super::joints::{self, PIVOT};
use super::names;
use super::sheet::{Sheet, colour};
use super::still::{frame, paths, pixels};
use crate::plot::svg::{Svg, short};

/// Draws it; the frames are evenly apart in time, and take so many seconds.
pub fn draw(picture: &Picture<'_>, frames: &[Frame], seconds: f64) -> String {
    let title = format!("{}: motion", picture.constants.mechanism.title);
    let sheet = Sheet::new(picture, &picture.pace);
    let mut svg = sheet.begin(&title);
    let arrows = forces::arrows(picture, &sheet, frames);
    let frames: Vec<_> = frames.iter().map(|frame| pixels(&sheet, frame)).collect();
    let clock = Clock { seconds };
    paths(&mut svg, picture, &sheet);
    if let Some(first) = frames.first() {
        svg.begin("the linkage");
        frame(&mut svg, picture, first);
        links(&mut svg, picture, &frames, &clock);
        pivots(&mut svg, picture, &frames, &clock);
        for shapes in &arrows {
            shape(&mut svg, "polygon", "force", shapes, &clock);
        }
        svg.end();
    }
    sheet.finish(svg, &title)
}

/// How long the motion takes.
struct Clock {
    seconds: f64,
}

impl Clock {
    /// An animation of an attribute through these values.
    fn animate(&self, attribute: &str, values: impl Iterator<Item = String>) -> String {
        let values: Vec<_> = values.collect();
        format!(
            r#"<animate attributeName="{attribute}" dur="{}s" repeatCount="indefinite" values="{}"/>"#,
            short(self.seconds),
            values.join(";")
        )
    }
}

/// Points as an attribute.
fn list(points: impl Iterator<Item = Point>) -> String {
    let texts = points.map(|(x, y)| format!("{},{}", short(x), short(y)));
    texts.collect::<Vec<_>>().join(" ")
}

/// A polygon or polyline through points that move.
fn shape(svg: &mut Svg, element: &str, class: &str, shapes: &[Vec<Point>], clock: &Clock) {
    let texts: Vec<_> = shapes.iter().map(|shape| list(shape.iter().copied())).collect();
    let Some(first) = texts.first() else { return };
    let opening = format!(r#"<{element} class="{class}" points="{first}">"#);
    let inside = clock.animate("points", texts.iter().cloned());
    svg.raw(&format!("{opening}{inside}</{element}>"));
}

fn links(svg: &mut Svg, picture: &Picture<'_>, frames: &[Vec<Point>], clock: &Clock) {
    for (index, link) in picture.scene().links.iter().enumerate() {
        if picture.geometry.is_frame(link.points) {
            continue;
        }
        let of = |frame: &Vec<Point>| link.points.iter().map(|&point| frame[point]).collect();
        let shapes: Vec<Vec<Point>> = frames.iter().map(of).collect();
        let colour = colour(picture, index);
        if link.points.len() > 2 {
            let class = format!("plate {}", colour.replace('c', "f"));
            shape(svg, "polygon", &class, &shapes, clock);
        }
        shape(svg, "polyline", &format!("link {colour}"), &shapes, clock);
    }
}

fn pivots(svg: &mut Svg, picture: &Picture<'_>, frames: &[Vec<Point>], clock: &Clock) {
    let named = names::names(picture, &frames[0]);
    for index in 0..picture.scene().points.len() {
        let at = |frame: &Vec<Point>| frame[index];
        if let Some(along) = joints::slides(picture, index) {
            let shapes = frames.iter().map(|frame| joints::slide(at(frame), along).to_vec());
            shape(svg, "polygon", "slide", &shapes.collect::<Vec<_>>(), clock);
        }
        if picture.geometry.moves[index] == Moves::Stands {
            svg.circle("pivot", frames[0][index], PIVOT);
            continue;
        }
        let first = frames[0][index];
        let x = clock.animate("cx", frames.iter().map(|frame| short(at(frame).0)));
        let y = clock.animate("cy", frames.iter().map(|frame| short(at(frame).1)));
        svg.raw(&format!(
            r#"<circle class="pivot" cx="{}" cy="{}" r="{PIVOT}">{x}{y}</circle>"#,
            short(first.0),
            short(first.1)
        ));
    }
    // The names of what stands; the others would have to dodge the links.
    for name in named {
        if picture.geometry.moves[name.index] == Moves::Stands {
            names::write(svg, &name);
        }
    }
}
