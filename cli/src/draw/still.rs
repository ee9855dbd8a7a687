//! The linkage at some positions: the first one strong, the others pale, with the path of each moving point.

use super::Picture;
use super::forces;
use super::geometry::{Frame, Moves, Point};
use super::joints::{self, PIVOT};
use super::names;
use super::sheet::{Sheet, colour};
use crate::plot::curve::simplify;
use crate::plot::svg::Svg;

/// Draws it.
pub fn draw(picture: &Picture<'_>, positions: &[&Frame]) -> String {
    let title = format!("{}: positions", picture.constants.mechanism.title);
    let strong = match positions.len() {
        0 | 1 => "",
        _ => " (the first one strong)",
    };
    let sheet = Sheet::new(picture, &format!("{}{strong}.", picture.label));
    let mut svg = sheet.begin(&title);
    paths(&mut svg, picture, &sheet);
    if let Some((first, others)) = positions.split_first() {
        for other in others {
            pale(&mut svg, picture, &pixels(&sheet, other));
        }
        strong_position(&mut svg, picture, &pixels(&sheet, first));
        forces::still(&mut svg, picture, &sheet, first);
    }
    sheet.finish(svg, &title)
}

/// The pixels of the points at a position.
pub fn pixels(sheet: &Sheet, frame: &Frame) -> Vec<Point> {
    frame.points.iter().map(|point| sheet.pixel(*point)).collect()
}

/// The path of each moving point over the way, and the line of each slide.
pub fn paths(svg: &mut Svg, picture: &Picture<'_>, sheet: &Sheet) {
    svg.begin("paths of the points");
    for (index, paths) in picture.geometry.paths.iter().enumerate() {
        let pixels = |path: &Vec<Point>| -> Vec<Point> {
            path.iter().map(|point| sheet.pixel(*point)).collect()
        };
        match (picture.geometry.moves[index], joints::slides(picture, index)) {
            (Moves::Stands, _) => {}
            (_, Some(along)) => {
                let all: Vec<_> = paths.iter().flat_map(pixels).collect();
                joints::guide(svg, &all, along);
            }
            _ => {
                for path in paths {
                    svg.path("path", &simplify(&pixels(path)));
                }
            }
        }
    }
    svg.end();
}

/// A position as a background.
fn pale(svg: &mut Svg, picture: &Picture<'_>, at: &[Point]) {
    svg.begin("another position");
    for (index, link) in picture.scene().links.iter().enumerate() {
        if !picture.geometry.is_frame(link.points) {
            let points: Vec<_> = link.points.iter().map(|&point| at[point]).collect();
            svg.path(&format!("pale {}", colour(picture, index)), &points);
        }
    }
    for (index, place) in at.iter().enumerate() {
        if picture.geometry.moves[index] != Moves::Stands {
            svg.circle("dot", *place, 2.6);
        }
    }
    svg.end();
}

/// A position with everything.
fn strong_position(svg: &mut Svg, picture: &Picture<'_>, at: &[Point]) {
    svg.begin("the first position");
    frame(svg, picture, at);
    for (index, link) in picture.scene().links.iter().enumerate() {
        if picture.geometry.is_frame(link.points) {
            continue;
        }
        let points: Vec<_> = link.points.iter().map(|&point| at[point]).collect();
        let colour = colour(picture, index);
        if points.len() > 2 {
            svg.polygon(&format!("plate {}", colour.replace('c', "f")), &points);
        }
        svg.path(&format!("link {colour}"), &points);
    }
    for (index, place) in at.iter().enumerate() {
        if let Some(along) = joints::slides(picture, index) {
            svg.polygon("slide", &joints::slide(*place, along));
        }
        svg.circle("pivot", *place, PIVOT);
    }
    for name in names::names(picture, at) {
        names::write(svg, &name);
    }
    svg.end();
}

/// What stands: the points of the frame and lines between them.
pub fn frame(svg: &mut Svg, picture: &Picture<'_>, at: &[Point]) {
    for link in picture.scene().links {
        if picture.geometry.is_frame(link.points) {
            let points: Vec<_> = link.points.iter().map(|&point| at[point]).collect();
            svg.path("symbol", &points);
        }
    }
    for (index, place) in at.iter().enumerate() {
        let finite = place.0.is_finite() && place.1.is_finite();
        if finite && picture.geometry.moves[index] == Moves::Stands {
            joints::ground(svg, *place);
        }
    }
}
