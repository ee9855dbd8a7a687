//! `assur list`: what there is.

use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::output;
use crate::show::style;
use crate::show::text::{Align, Columns, wrap};

/// Widest line of prose.
const WIDTH: usize = 96;

/// Prints every mechanism with its source and its scenes.
///
/// # Errors
/// When standard output cannot be written.
pub fn execute(registry: Registry) -> Result<(), Failure> {
    let style = style::stdout();
    let mut text = String::new();
    for mechanism in registry.0 {
        text += &format!("{}\n", style.heading(mechanism.name));
        for line in wrap(mechanism.summary, WIDTH) {
            text += &format!("  {line}\n");
        }
        if !mechanism.source.is_empty() {
            text += &format!("  {}\n", style.faint(&format!("source: {}", mechanism.source)));
        }
        let mut table = Columns::new([("", Align::Left); 3]);
        for (index, scene) in mechanism.scenes.iter().enumerate() {
            let lead = if index == 0 { "scenes" } else { "" };
            table.row([lead.to_owned(), scene.name.to_owned(), describe(scene)]);
        }
        for (index, preset) in mechanism.presets.iter().enumerate() {
            let lead = if index == 0 { "presets" } else { "" };
            table.row([lead.to_owned(), preset.name.to_owned(), preset.summary.to_owned()]);
        }
        text += &table.render(style);
        text.push('\n');
    }
    match registry.0.first() {
        Some(first) => text += &format!("run one:  assur run {}\n", first.name),
        None => text += "there is no mechanism yet: add a file to equations/\n",
    }
    output::print(&text)
}

/// A scene in a few words: its own, or what is in it.
pub fn describe(scene: &assur::registry::SceneEntry) -> String {
    if let Some(line) = scene.summary.lines().next().filter(|line| !line.is_empty()) {
        return line.to_owned();
    }
    let drivers: Vec<_> = scene.drivers.iter().map(|driver| driver.name).collect();
    match scene.linkage.is_some() && !drivers.is_empty() {
        true => format!("{}, moved by {}", composition(scene), drivers.join(" and ")),
        false => composition(scene),
    }
}

/// Effects and choices of a scene, `torsion + bending + crank.exact`.
pub fn composition(scene: &assur::registry::SceneEntry) -> String {
    let effects = scene.effects.iter().map(|effect| (*effect).to_owned());
    let choices = scene.choices.iter().map(|(choice, made)| format!("{choice}.{made}"));
    let parts: Vec<_> = effects.chain(choices).collect();
    if parts.is_empty() { "no effect".to_owned() } else { parts.join(" + ") }
}
