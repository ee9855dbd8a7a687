//! Positions that are marked across the panels: those of the equation file and those that were asked for.

use super::legend::text_width;
use super::scale::Scale;

/// Marks nearer than this part of the width are one.
const NEAR: f64 = 0.006;
/// Between two labels.
const GAP: f64 = 8.0;
/// How far labels may reach beyond the frame on the left and on the right.
const MARGIN: (f64, f64) = (60.0, 20.0);

/// A vertical line with its label.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Horizontal position.
    pub at: f64,
    /// What is there.
    pub label: String,
    /// Whether the user asked for it.
    pub asked: bool,
}

/// Marks from left to right; one where several would touch.
pub fn sort(all: impl Iterator<Item = Mark>, positions: &[f64]) -> Vec<Mark> {
    let (Some(first), Some(last)) = (positions.first(), positions.last()) else {
        return Vec::new();
    };
    let width = (last - first).abs();
    let mut marks: Vec<Mark> = Vec::new();
    for mark in all {
        if marks.iter().all(|other| (other.at - mark.at).abs() > NEAR * width) {
            marks.push(mark);
        }
    }
    marks.sort_by(|a, b| a.at.total_cmp(&b.at));
    marks
}

/// Where the label of a mark stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Label<'a> {
    /// The mark.
    pub mark: &'a Mark,
    /// Left end of the text, in pixels.
    pub left: f64,
    /// Its row, from the bottom.
    pub row: usize,
}

/// Places the labels so that neither they nor the lines below them touch: in one row, each over its mark, or else like
/// flags, as many rows high as it takes.
pub fn labels<'a>(marks: &'a [Mark], scale: &Scale) -> Vec<Label<'a>> {
    let inside = marks.iter().filter(|mark| scale.contains(mark.at));
    let mut labels: Vec<_> = inside
        .map(|mark| Label {
            mark,
            left: scale.pixel(mark.at) - text_width(&mark.label) / 2.0,
            row: 0,
        })
        .collect();
    let apart = |pair: &[Label<'_>]| pair[0].left + room(pair[0].mark) <= pair[1].left;
    let within = |label: &Label<'_>| {
        label.left >= scale.pixels.0 - MARGIN.0
            && label.left + text_width(&label.mark.label) <= scale.pixels.1 + MARGIN.1
    };
    if labels.windows(2).all(apart) && labels.iter().all(within) {
        return labels;
    }
    let last = scale.pixels.1 + MARGIN.1;
    for index in (0..labels.len()).rev() {
        let mark = labels[index].mark;
        let left = scale.pixel(mark.at).min(last - text_width(&mark.label));
        let right = left + room(mark);
        let under = labels[index + 1..].iter();
        let under = under.filter(|other| scale.pixel(other.mark.at).min(other.left) < right);
        let row = under.map(|other| other.row + 1).max().unwrap_or(0);
        labels[index] = Label { mark, left, row };
    }
    labels
}

/// Width of a label with the gap beside it.
fn room(mark: &Mark) -> f64 {
    text_width(&mark.label) + GAP
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(at: f64, label: &str) -> Mark {
        Mark { at, label: label.to_owned(), asked: false }
    }

    #[test]
    fn labels_do_not_touch() {
        let scale = Scale { values: (0.0, 360.0), pixels: (60.0, 510.0) };
        let marks = [
            mark(0.0, "rear dead centre"),
            mark(20.0, "locks"),
            mark(25.0, "somewhere"),
            mark(360.0, "rear dead centre again"),
        ];
        let labels = labels(&marks, &scale);
        assert_eq!(labels.len(), marks.len());
        for (index, one) in labels.iter().enumerate() {
            assert!(one.left + text_width(&one.mark.label) <= 531.0, "{one:?}");
            for other in &labels[index + 1..] {
                let touch = one.left + room(one.mark) > other.left;
                assert!(!touch || one.row > other.row, "{one:?} {other:?}");
            }
        }
    }

    #[test]
    fn labels_with_room_stand_in_one_row() {
        let scale = Scale { values: (0.0, 360.0), pixels: (60.0, 510.0) };
        let marks = [mark(0.0, "rear dead centre"), mark(110.0, "locks")];
        assert!(labels(&marks, &scale).iter().all(|label| label.row == 0));
    }
}
