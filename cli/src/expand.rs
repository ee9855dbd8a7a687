//! `assur expand`: the Rust that an equation file becomes, as a person would lay it out.

use std::path::Path;

use assur_emit::Origin;
use assur_model::checked::Model;

use crate::arguments::ExpandArguments;
use crate::ask::For;
use crate::ask::file;
use crate::ask::lookup;
use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::output::{complain, print};
use crate::show::style;
use crate::source::{Checked, Source};

/// Prints the emitted Rust of a mechanism or of an equation file; of one scene when asked for it.
///
/// # Errors
/// An unknown mechanism or scene, or a file with errors.
pub fn execute(options: &ExpandArguments, registry: Registry) -> Result<(), Failure> {
    let source = match options.name.as_deref() {
        Some(name) if file::is_file(name) => file::read(name)?,
        _ => {
            let mechanism = registry.mechanism(options.name.as_deref(), "expand", For::All)?;
            if let Some(scene) = &options.scene {
                lookup::scene(mechanism, Some(scene))?;
            }
            Source::of(mechanism)?
        }
    };
    let style = style::stderr();
    let said = |messages: String| {
        complain(&messages);
        Failure::said()
    };
    let checked = source.compile(style).map_err(said)?;
    let Some(model) = &checked.compiled.model else {
        return Err(said(checked.messages(style)));
    };
    let file = match &options.scene {
        Some(scene) => of_scene(model, scene, &source, &checked)?,
        None => parsed(model, &source, &checked)?,
    };
    print(&prettyplease::unparse(&file))
}

/// The items of one scene: without the tables, the tests and the module around them all.
fn of_scene(
    model: &Model,
    name: &str,
    source: &Source,
    checked: &Checked<'_>,
) -> Result<syn::File, Failure> {
    let mut model = model.clone();
    let names = checked.compiled.scene_names.iter().map(String::as_str);
    let names: Vec<_> = names.collect();
    model.scenes.retain(|scene| scene.name == name);
    if model.scenes.is_empty() {
        return Err(Failure::request(format!("`{}` has no scene `{name}`", source.name()))
            .place(format!("--scene {name}"))
            .remedy(lookup::suggestion(name, &names)));
    }
    let mut file = parsed(&model, source, checked)?;
    let within = file.items.iter_mut().find_map(|item| match item {
        syn::Item::Mod(module) => module.content.take(),
        _ => None,
    });
    if let Some((_, items)) = within {
        file.items = items;
        file.items.retain(|item| {
            matches!(
                item,
                syn::Item::Struct(_) | syn::Item::Impl(_) | syn::Item::Fn(_) | syn::Item::Enum(_)
            )
        });
    }
    Ok(file)
}

fn parsed(model: &Model, source: &Source, checked: &Checked<'_>) -> Result<syn::File, Failure> {
    let file = Path::new(source.name()).file_name();
    let origin = Origin {
        file: file.map_or(String::new(), |name| name.to_string_lossy().into_owned()),
        has_file: true,
        line_of: &|span| checked.line(span),
        part_of: &|span| {
            let place = checked.part(span)?;
            Some((place.path.to_owned(), place.line as u32))
        },
        parts: checked.compiled.parts.iter().map(|part| part.path.clone()).collect(),
    };
    syn::parse2(assur_emit::mechanism(model, &origin)).map_err(|error| {
        Failure::request("the emitted Rust cannot be laid out")
            .place(source.name())
            .reason(error.to_string())
            .remedy("this is a mistake of Assur; `assur check` tells whether the file is right")
    })
}
