//! `assur structure`: the loops of a linkage, and the order in which they are solved.

use assur::closure::{ClosureError, Group};
use assur::registry::{Mechanism, Sample};
use assur::shape::EquationText;
use serde_json::{Value, json};

use crate::arguments::{StructureArguments, StructureFormat};
use crate::asked::For;
use crate::error::Failure;
use crate::linkage::case::Case;
use crate::linkage::group;
use crate::linkage::wording::{Names, tell};
use crate::lookup::Registry;
use crate::number;
use crate::output;
use crate::style::{self, Style};
use crate::table::{Page, about};
use crate::text::{Align, Columns};
use crate::unit;

/// Name and version of the format.
const FORMAT: &str = "assur-structure/1";

/// Prints the structure of a linkage.
///
/// # Errors
/// A wrong request; or a linkage that cannot be put together, after its structure is printed.
pub fn execute(options: &StructureArguments, registry: Registry) -> Result<(), Failure> {
    let (mechanism, constants) = options.asked.find(registry, "structure", For::Linkages)?;
    let case = Case::new(constants)?;
    let start = start(&case);
    let text = match options.format {
        StructureFormat::Table => table(mechanism, &case, &start, style::stdout()),
        StructureFormat::Json => json(mechanism, &case, &start),
    };
    output::print(&text)?;
    start.map(|_| ()).map_err(|error| {
        let names = Names { entry: case.entry, drivers: &case.drivers };
        tell(names, &error).failure("the linkage cannot be put together")
    })
}

/// The linkage where it starts, and the groups whose assembly mode had to be assumed.
type Start = Result<(Sample, Vec<usize>), ClosureError>;

fn start(case: &Case) -> Start {
    let standing = case.standing();
    let known = standing.iter().all(|position| position.is_finite());
    let place = match case.axes().first() {
        Some(axis) if !known => case.place(&[axis.from]),
        _ => standing,
    };
    let path = case.run().follow(&[place])?;
    match (path.samples.into_iter().next(), path.stopped) {
        (Some(sample), _) => Ok((sample, path.start.assumed)),
        (None, Some(error)) => Err(error),
        (None, None) => {
            Err(ClosureError::BadRange { reason: "there is no position to start at".to_owned() })
        }
    }
}

/// The equation of the file that each loop belongs to: a vector equation is several loops.
fn texts(case: &Case) -> Vec<Option<&'static EquationText>> {
    let base = |name: &'static str| {
        let component = [".x", ".y", ".z"].into_iter().find_map(|end| name.strip_suffix(end));
        component.unwrap_or(name)
    };
    let mut next = 0;
    let mut last = None;
    let loops = case.entry.loops.iter().map(|one| {
        if last != Some((base(one.name), one.line)) {
            last = Some((base(one.name), one.line));
            next += 1;
        }
        case.scene.equations.get(next - 1)
    });
    loops.collect()
}

fn table(mechanism: &Mechanism, case: &Case, start: &Start, style: Style) -> String {
    let mut page = Page::new(style);
    let title = format!("{}, scene {}: structure", mechanism.title, case.scene.name);
    about(&mut page, &title, &case.constants);
    page.line(&mobility(case));
    page.line("");
    loops(&mut page, case);
    coordinates(&mut page, case, start);
    order(&mut page, case, start);
    page.text
}

/// The degrees of freedom in words.
fn mobility(case: &Case) -> String {
    let (equations, unknowns, drivers) = counts(case);
    let many = |count: usize, what: &str| match count {
        1 => format!("1 {what}"),
        _ => format!("{count} {what}s"),
    };
    let freedom = match drivers {
        1 => "1 degree of freedom".to_owned(),
        _ => format!("{drivers} degrees of freedom"),
    };
    if equations == 0 {
        return format!(
            "{freedom}: {} and no loop; the outputs are formulas",
            many(drivers, "driver")
        );
    }
    let names: Vec<_> = case.drivers.iter().map(|driver| driver.name).collect();
    let (moves, rest) = match drivers {
        0 => ("nothing moves it".to_owned(), "everything"),
        1 => (format!("{} moves it", names[0]), "the rest"),
        _ => (format!("{} move it", names.join(", ")), "the rest"),
    };
    format!(
        "{freedom} = {} + {} - {}: {moves}, the loops determine {rest}.",
        many(unknowns, "unknown"),
        many(drivers, "driver"),
        many(equations, "loop equation"),
    )
}

/// Numbers of scalar loop equations, unknowns and drivers.
fn counts(case: &Case) -> (usize, usize, usize) {
    (case.entry.loops.len(), case.entry.dependents.len(), case.drivers.len())
}

fn loops(page: &mut Page, case: &Case) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("line", Align::Right),
        ("unit", Align::Left),
        ("", Align::Left),
    ]);
    let mut above = "";
    for (one, text) in case.entry.loops.iter().zip(texts(case)) {
        let text = text.map_or("", |text| plain(text.text));
        // The components of a vector equation share it.
        let shown = if text == above { "" } else { text };
        above = text;
        table.row([
            one.name.to_owned(),
            one.line.to_string(),
            one.unit.to_owned(),
            shown.to_owned(),
        ]);
    }
    if !case.entry.loops.is_empty() {
        page.section("Loops", &table);
        page.line("");
    }
}

/// A closure without its keyword and its name.
fn plain(text: &str) -> &str {
    let named = text.strip_prefix("closure ").and_then(|rest| rest.split_once(": "));
    named.map_or(text, |(_, equation)| equation).trim_end_matches(';')
}

fn coordinates(page: &mut Page, case: &Case, start: &Start) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("at the start", Align::Point),
        ("", Align::Left),
        ("", Align::Left),
        ("", Align::Left),
    ]);
    let first_line = |text: &str| text.lines().next().unwrap_or("").to_owned();
    let sample = start.as_ref().ok().map(|(sample, _)| sample);
    for (index, driver) in case.drivers.iter().enumerate() {
        let position = sample.and_then(|sample| sample.independents.get(index));
        let position =
            position.map(|position| number::short(unit::stated(*position, driver.factor)));
        table.row([
            driver.name.to_owned(),
            position.unwrap_or_default(),
            driver.unit.to_owned(),
            "driver".to_owned(),
            first_line(driver.summary),
        ]);
    }
    for (index, dependent) in case.entry.dependents.iter().enumerate() {
        let value = sample.and_then(|sample| sample.dependents.get(index));
        let value = value.map(|value| settled(unit::stated(*value, dependent.factor)));
        table.row([
            dependent.name.to_owned(),
            value.unwrap_or_default(),
            dependent.unit.to_owned(),
            "unknown".to_owned(),
            first_line(dependent.summary),
        ]);
    }
    page.section("Coordinates", &table);
    page.line("");
}

/// A value to seven digits; what is left of zero is zero.
fn settled(value: f64) -> String {
    match value.abs() < 1e-12 {
        true => "0".to_owned(),
        false => number::significant(value, 7),
    }
}

fn order(page: &mut Page, case: &Case, start: &Start) {
    if case.entry.groups.is_empty() {
        return;
    }
    let at = match start {
        Ok((sample, _)) => format!(", at {}", case.label(&sample.independents)),
        Err(_) => String::new(),
    };
    let heading = page.style.heading(&format!("Order of solution{at}"));
    page.line(&heading);
    for (index, of_group) in case.entry.groups.iter().enumerate() {
        let found = found(start, index, of_group);
        page.line(&format!(
            "  {}  {} for {}",
            index + 1,
            group::equations(case.entry, of_group),
            group::unknowns(case.entry, of_group)
        ));
        page.line(&format!(
            "     {}: {}; {}",
            group::kind(of_group.kind),
            group::links(of_group.kind),
            group::solved(of_group.kind)
        ));
        let picked =
            if found.assumed { "no start value, assumed" } else { "the start values pick" };
        let mode = found.mode.map(|mode| format!("{picked} assembly mode {mode:+}"));
        let angle = found.angle.map(|angle| {
            let angle = number::short(number::rounded(angle, 4));
            format!("transmission angle {angle} deg")
        });
        let both: Vec<_> = mode.into_iter().chain(angle).collect();
        if !both.is_empty() {
            let line = page.style.faint(&format!("     {}", both.join(", ")));
            page.line(&line);
        }
    }
}

/// What is known of a group where the linkage starts.
struct Found {
    mode: Option<f64>,
    angle: Option<f64>,
    assumed: bool,
}

fn found(start: &Start, index: usize, of_group: &Group) -> Found {
    let sample = start.as_ref().ok();
    let mode = sample.filter(|_| of_group.kind.has_modes());
    let sine = sample.filter(|_| group::transmits(of_group));
    Found {
        mode: mode.map(|(sample, _)| sample.modes[index]),
        angle: sine.map(|(sample, _)| group::transmission(sample.sines[index])),
        assumed: sample.is_some_and(|(_, assumed)| assumed.contains(&index)),
    }
}

fn json(mechanism: &Mechanism, case: &Case, start: &Start) -> String {
    let entry = case.entry;
    let (equations, unknowns, drivers) = counts(case);
    let loops = entry.loops.iter().zip(texts(case)).map(|(one, text)| {
        json!({
            "name": one.name,
            "unit": one.unit,
            "line": one.line,
            "equation": text.map(|text| text.text),
        })
    });
    let sample = start.as_ref().ok().map(|(sample, _)| sample);
    let unknown = entry.dependents.iter().enumerate().map(|(index, dependent)| {
        json!({
            "name": dependent.name,
            "unit": dependent.unit,
            "start": sample.map(|sample| unit::stated(sample.dependents[index], dependent.factor)),
        })
    });
    let driver = case.drivers.iter().zip(&case.ranges).enumerate();
    let driver = driver.map(|(index, (driver, range))| {
        json!({
            "name": driver.name,
            "unit": driver.unit,
            "from": unit::stated(range.from, driver.factor),
            "to": unit::stated(range.to, driver.factor),
            "start": sample.map(|sample| unit::stated(sample.independents[index], driver.factor)),
        })
    });
    let groups = entry.groups.iter().enumerate().map(|(index, of_group)| {
        let found = found(start, index, of_group);
        let names = |list: &[usize], name: &dyn Fn(usize) -> &'static str| {
            list.iter().map(|&one| name(one)).collect::<Vec<_>>()
        };
        json!({
            "loops": names(of_group.equations, &|one| entry.loops[one].name),
            "unknowns": names(of_group.unknowns, &|one| entry.dependents[one].name),
            "kind": group::kind(of_group.kind),
            "links": group::links(of_group.kind),
            "solved": group::solved(of_group.kind),
            "assembly_mode": found.mode,
            "assumed": found.assumed,
            "transmission_angle": found.angle,
            "transmission_unit": "deg",
        })
    });
    let object = json!({
        "format": FORMAT,
        "mechanism": crate::json::mechanism(mechanism),
        "scene": crate::json::scene(&case.constants),
        "parameters": crate::json::parameters(&case.constants),
        "degrees_of_freedom": drivers,
        "counts": { "equations": equations, "unknowns": unknowns, "drivers": drivers },
        "loops": loops.collect::<Vec<_>>(),
        "unknowns": unknown.collect::<Vec<_>>(),
        "drivers": driver.collect::<Vec<_>>(),
        "groups": groups.collect::<Vec<_>>(),
        "status": if start.is_ok() { "complete" } else { "not assembled" },
    });
    // A `Value` has only text keys and finite numbers, so printing it cannot fail.
    serde_json::to_string_pretty::<Value>(&object).unwrap_or_default() + "\n"
}
