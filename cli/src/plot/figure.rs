//! The layout of a figure: panels one below the other in one or two columns, with common positions marked.

use super::across::Across;
use super::bands::Band;
use super::column::Column;
use super::legend::CHARACTER;
use super::marks::Mark;
use super::name;
use super::panels::Panel;
use super::scale::Scale;
use super::svg::{Anchor, Svg};
use crate::ask::constants::Constants;
use crate::show::number;
use crate::show::text;

/// Left of the plotting area of a column: numbers of the axis.
const LEFT: f64 = 66.0;
/// Width of the plotting area of a column.
const WIDTH: f64 = 452.0;
/// Width of the plotting area when there is one column only.
const WIDTH_ALONE: f64 = 620.0;
/// Right of the plotting area of a column.
const RIGHT: f64 = 24.0;
/// Most panels in a single column.
const ALONE: usize = 3;
/// Most panels in a single column where some would have a column of their own otherwise.
const STACKED: usize = 7;

/// What a figure shows.
pub struct Figure {
    /// The title.
    pub title: String,
    /// What is shown, a sentence or two.
    pub lead: String,
    /// The horizontal axis.
    pub across: Across,
    /// Positions of the samples on it.
    pub positions: Vec<f64>,
    /// The panels.
    pub panels: Vec<Panel>,
    /// Panels below these, or in a column of their own beside them if there are many.
    pub beside: Vec<Panel>,
    /// Stretches in one mode, behind the curves.
    pub bands: Vec<Band>,
    /// Marked positions.
    pub marks: Vec<Mark>,
    /// How the curves were made.
    pub made: String,
}

impl Figure {
    /// Draws it.
    pub fn draw(self) -> String {
        let mut all = self.panels.iter().chain(&self.beside);
        let has_facts = all.any(|panel| !panel.facts.is_empty());
        let panels = match self.beside.is_empty() {
            true => arrange(self.panels),
            false => stack(self.panels, self.beside),
        };
        let width = if panels.len() == 1 { WIDTH_ALONE } else { WIDTH };
        let whole = panels.len().max(1) as f64 * (LEFT + width + RIGHT);
        let limit = ((whole - LEFT - RIGHT) / CHARACTER) as usize;
        let lead = text::wrap(&self.lead, limit);
        let top = 52.0 + 18.0 * lead.len() as f64;
        let ends = Across::ends(&self.positions);
        let columns = panels.iter().enumerate().map(|(index, panels)| {
            let left = index as f64 * (LEFT + width + RIGHT) + LEFT;
            let scale = Scale { values: ends, pixels: (left, left + width) };
            let axis = self.across.axis(ends.0, ends.1, width);
            Column::new(panels, scale, axis, &self.marks, &self.bands)
        });
        let columns: Vec<_> = columns.collect();
        let bottoms = columns.iter().map(|column| column.bottom(top));
        let bottom = bottoms.fold(top, f64::max);
        let mut svg = Svg::new(whole, bottom + 34.0);
        svg.rectangle("paper", (0.0, 0.0), (whole, bottom + 34.0));
        svg.text("title", (LEFT, 34.0), Anchor::Start, &self.title);
        for (index, line) in lead.iter().enumerate() {
            let y = 56.0 + 18.0 * index as f64;
            svg.text("lead", (LEFT, y), Anchor::Start, line);
        }
        for column in &columns {
            column.draw(&mut svg, top, &self.positions, &self.across.title);
        }
        foot(&mut svg, &self.made, has_facts, bottom + 16.0);
        svg.finish(&self.title, &lead.join(" "))
    }
}

/// Panels in one or two columns of similar length: translations on the left, rotations on the right, others where there
/// is room.
fn arrange(panels: Vec<Panel>) -> Vec<Vec<Panel>> {
    if panels.len() <= ALONE {
        return vec![panels];
    }
    let count = panels.len();
    let (mut columns, mut others) = ([Vec::new(), Vec::new()], Vec::new());
    for panel in panels {
        match panel.kind.rank().0 {
            Some(column) => columns[column].push(panel),
            None => others.push(panel),
        }
    }
    // What makes a column longer than half of all goes to the end of the other one.
    let half = count.div_ceil(2);
    for column in [0, 1] {
        let from = columns[column].len().min(half);
        let surplus = columns[column].split_off(from);
        columns[1 - column].extend(surplus);
    }
    for panel in others {
        let shorter = usize::from(columns[1].len() < columns[0].len());
        columns[shorter].push(panel);
    }
    columns.into()
}

/// Panels one below the other, of many the second ones in a column of their own.
fn stack(first: Vec<Panel>, second: Vec<Panel>) -> Vec<Vec<Panel>> {
    match first.is_empty() || first.len() + second.len() <= STACKED {
        true => vec![first.into_iter().chain(second).collect()],
        false => vec![first, second],
    }
}

/// What the scene is, and which values were changed.
pub fn lead(constants: &Constants) -> String {
    let scene = constants.scene;
    let mut sentence = format!("Scene {}", scene.name);
    if let Some(line) = scene.summary.lines().next().filter(|line| !line.is_empty()) {
        sentence += &format!(": {}", line.trim_end_matches('.'));
    }
    format!("{sentence}. {}", changed(constants)).trim_end().to_owned()
}

/// Which values were changed, as a sentence; empty where none were.
pub fn changed(constants: &Constants) -> String {
    let all = constants.scene.constants.iter().enumerate();
    let changed = all.filter(|(index, _)| constants.is_changed(*index)).map(|(index, constant)| {
        let quantity = &constant.quantity;
        let value = number::declared(constants.values[index] / quantity.factor);
        format!("{} = {value} {}", name::set(quantity.name).text, name::unit(quantity.unit))
            .trim_end()
            .to_owned()
    });
    match changed.collect::<Vec<_>>() {
        none if none.is_empty() => String::new(),
        changed => format!("With {}.", changed.join(", ")),
    }
}

/// How the curves were made, and what the circles are.
fn foot(svg: &mut Svg, made: &str, has_facts: bool, y: f64) {
    let mut x = LEFT;
    if has_facts {
        svg.circle("c fact", (x + 4.0, y - 4.0), 3.6);
        svg.text("unit", (x + 14.0, y), Anchor::Start, "published value");
        x += 132.0;
    }
    svg.text("number", (x, y), Anchor::Start, made);
}
