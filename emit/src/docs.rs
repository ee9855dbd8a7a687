//! Documentation of the emitted items: the equations as text, the quantities as tables.

use assur_model::checked::{ConstantInfo, Model, QuantityInfo};
use assur_model::token::Span;
use proc_macro2::TokenStream;
use quote::quote;

use crate::layout::Layout;
use crate::{Origin, values};

/// A text as documentation, line by line.
pub fn lines(text: &str) -> TokenStream {
    text.trim_end()
        .lines()
        .map(|line| {
            let line = if line.is_empty() { String::new() } else { format!(" {line}") };
            quote!(#[doc = #line])
        })
        .collect()
}

/// Documentation of a method: how many operations it does.
pub fn operations(count: usize) -> TokenStream {
    match count {
        1 => lines("1 operation."),
        _ => lines(&format!("{count} operations.")),
    }
}

/// Documentation of the mechanism.
pub fn mechanism(model: &Model, origin: &Origin<'_>) -> String {
    let mut text = format!("{}\n", plain(&title(&model.documentation, &model.name)));
    if !model.source.is_empty() {
        text += &format!("\nSource: {}.\n", plain(&model.source));
    }
    text += &format!("\nPrinted from `{}` by Assur.\n", origin.file);
    text
}

fn title(documentation: &str, name: &str) -> String {
    let documentation = documentation.trim();
    if documentation.is_empty() {
        format!("The mechanism `{name}`.")
    } else {
        documentation.to_owned()
    }
}

/// Documentation of a scene: what it shows, its equations, its quantities.
pub fn scene(layout: &Layout<'_>, model: &Model, origin: &Origin<'_>) -> String {
    let scene = layout.scene;
    let mut text = format!("{}\n", plain(&title(&model.documentation, &model.name)));
    text += &format!("\nScene `{}`", scene.name);
    if !scene.summary.is_empty() {
        text += &format!(": {}", plain(scene.summary.trim().trim_end_matches('.')));
    }
    text += ".\n";
    let effects = scene.effects.iter().map(|name| {
        let known = model.effects.iter().find(|effect| effect.name == *name);
        format!("* `{name}`: {}\n", plain(known.map_or("", |effect| &effect.summary)))
    });
    let choices = scene.choices.iter().map(|(choice, held)| {
        let known = model.choices.iter().find(|info| info.name == *choice);
        format!("* `{choice}.{held}`: {}\n", plain(known.map_or("", |info| &info.summary)))
    });
    let selected: String = effects.chain(choices).collect();
    if !selected.is_empty() {
        text += &format!("\n{selected}");
    }
    text += &equations(layout, origin);
    let constants = scene.constants.iter().map(constant_row);
    text += &table("Parameters", &["name", "value", "", ""], constants);
    text += &table("Drivers", QUANTITY, scene.drivers.iter().map(quantity_row));
    text += &table("State", QUANTITY, scene.states.iter().map(quantity_row));
    text += &table("Outputs", QUANTITY, scene.outputs.iter().map(quantity_row));
    let count = layout.counts;
    let (evaluation, jacobian) = match &scene.linkage {
        Some(_) => ("per position", "for all influence coefficients"),
        None => ("per evaluation", "per Jacobian"),
    };
    text += &format!(
        "\nOperations: {} once per parameter set, {} per instant, {} {evaluation}, {} {jacobian}.\n",
        count.prepare, count.instant, count.derivative, count.jacobian
    );
    if let Some(literal) = &scene.literal {
        text += &format!(
            "\nUnits: `{}` in {} is no constant, so no test states the scene in other units.\n",
            literal.text,
            place(origin, literal.span)
        );
    }
    text
}

/// The equations with their units and lines.
fn equations(layout: &Layout<'_>, origin: &Origin<'_>) -> String {
    let equations = &layout.scene.equations;
    if equations.is_empty() {
        return String::new();
    }
    let longest =
        equations.iter().map(|equation| equation.text.chars().count()).max().unwrap_or(0).min(80);
    let mut text = String::from("\n```text\n");
    for equation in equations {
        let unit = if equation.unit.is_empty() { "1" } else { &equation.unit };
        text += &format!(
            "{:longest$}   [{unit}]  {}\n",
            equation.text.replace('\n', " "),
            place(origin, equation.span)
        );
    }
    text + "```\n"
}

/// File and line of a place.
fn place(origin: &Origin<'_>, span: Span) -> String {
    match (origin.part_of)(span) {
        Some((file, line)) => format!("{file}:{line}"),
        None => format!("{}:{}", origin.file, (origin.line_of)(span)),
    }
}

const QUANTITY: &[&str] = &["name", "unit", ""];

fn quantity_row(quantity: &QuantityInfo) -> String {
    let unit = if quantity.unit.is_empty() { "1" } else { &quantity.unit };
    format!("| `{}` | {} | {} |\n", quantity.name, code(unit), cell(&quantity.summary))
}

fn constant_row(constant: &ConstantInfo) -> String {
    let name = &constant.quantity.name;
    format!(
        "| `{name}` | {} | {} | {} |\n",
        code(&values::value(constant)),
        code(&values::range(constant)),
        cell(&constant.quantity.summary)
    )
}

fn table(title: &str, heads: &[&str], rows: impl Iterator<Item = String>) -> String {
    let rows: String = rows.collect();
    if rows.is_empty() {
        return String::new();
    }
    let heads: String = heads
        .iter()
        .map(|head| if head.is_empty() { "|  ".to_owned() } else { format!("| {head} ") })
        .collect();
    let rule: String = "|---".repeat(heads.matches('|').count());
    format!("\n{title}:\n\n{heads}|\n{rule}|\n{rows}")
}

fn code(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("`{}`", text.replace('|', "\\|")) }
}

fn cell(text: &str) -> String {
    plain(text).replace('|', "\\|").replace('\n', " ")
}

/// A text of the user's in which brackets mean nothing to rustdoc.
pub fn plain(text: &str) -> String {
    text.replace('[', "\\[").replace(']', "\\]").replace('<', "\\<")
}
