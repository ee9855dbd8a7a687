//! Surfaces of formula sheets: the picture, the files of their facets, their places.

use std::collections::HashSet;
use std::path::Path;

use super::{answer, check_refused, entries, folder};

const TOOTH: &str = "addendum,dedendum,addendum_left,dedendum_left";

/// Corners and facets of an OBJ file.
fn obj(path: &Path) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    fn three<T: std::str::FromStr>(line: &str) -> Option<[T; 3]> {
        let parts: Vec<T> = line.split(' ').filter_map(|part| part.parse().ok()).collect();
        parts.try_into().ok()
    }
    let text = std::fs::read_to_string(path).expect("a file");
    let lines = |kind: &'static str| text.lines().filter_map(move |line| line.strip_prefix(kind));
    (lines("v ").filter_map(three).collect(), lines("f ").filter_map(three).collect())
}

#[test]
fn a_tooth_is_drawn_of_its_four_flanks() {
    let directory = folder("tooth");
    let text = answer(&["draw", "gear_flank", "--scene", TOOTH], &directory);
    for word in ["GearFlank, surface r_gear", "dedendum_left", "1152", "n_gear", "Picture: "] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert_eq!(entries(&directory), [directory.join("gear_flank-surface.svg")]);
    let picture = std::fs::read_to_string(directory.join("gear_flank-surface.svg")).expect("there");
    for word in ["GearFlank: surface r_gear", "addendum_left: u = 7.5° to 51.5°", "x, mm", "z, mm"]
    {
        assert!(picture.contains(word), "{word}");
    }
    assert!(picture.matches("class=\"facet\"").count() > 4 * 100 && !picture.contains("NaN"));
}

#[test]
fn facets_of_a_flank_have_one_side_and_join_the_places_that_run_prints() {
    let directory = folder("flank_files");
    let options = ["--surface", "r_gear", "--places", "u=9,th=13", "--obj", "a.obj", "--stl"];
    let asked = [&["draw", "gear_flank", "--scene", "dedendum"], &options[..], &["a.stl"]].concat();
    let text = answer(&asked, &directory);
    assert!(text.contains("OBJ:     a.obj, lengths in mm"), "{text}");
    let (corners, facets) = obj(&directory.join("a.obj"));
    assert_eq!((corners.len(), facets.len()), (9 * 13, 2 * 8 * 12));
    let stl = std::fs::read(directory.join("a.stl")).expect("a file");
    assert_eq!(stl.len(), 84 + 50 * facets.len());
    let ways = facets.iter().flat_map(|[a, b, c]| [(*a, *b), (*b, *c), (*c, *a)]);
    let ways: Vec<_> = ways.collect();
    let all: HashSet<_> = ways.iter().copied().collect();
    assert_eq!(all.len(), ways.len());
    let rim = ways.iter().filter(|(from, to)| !all.contains(&(*to, *from)));
    assert_eq!(rim.count(), 2 * (8 + 12));
    // The corners are the places that `run` prints, in the order of its rows.
    let run = ["run", "gear_flank", "--scene", "dedendum", "--format", "csv", "--places"];
    let csv = answer(&[&run[..], &["u=9,th=13"]].concat(), &directory);
    let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let heading = rows.next().expect("a heading");
    let first = heading.iter().position(|name| name.starts_with("r_gear.x"));
    let first = first.expect("a column");
    let scale = if heading[first].contains("[mm]") { 1.0 } else { 1e3 };
    let mut count = 0;
    for (row, corner) in rows.zip(&corners) {
        for (cell, component) in row[first..first + 3].iter().zip(corner) {
            let value: f64 = cell.parse().expect("a number");
            assert!((scale * value - component).abs() < 1e-10, "{value} {component}");
        }
        count += 1;
    }
    assert_eq!(count, corners.len());
}

#[test]
fn a_scene_is_turned_over_where_that_is_asked_for() {
    let directory = folder("flipped");
    let asked =
        ["draw", "gear_flank", "--scene", "addendum,addendum_left", "--places", "3", "--obj"];
    answer(&[&asked[..], &["as_it_is.obj"]].concat(), &directory);
    let text = answer(&[&asked[..], &["turned.obj", "--flip", "addendum"]].concat(), &directory);
    assert!(text.contains("n_gear, turned over"), "{text}");
    let [(_, plain), (_, turned)] =
        ["as_it_is.obj", "turned.obj"].map(|file| obj(&directory.join(file)));
    let sides = |facets: &[[usize; 3]]| {
        let mut sides: Vec<_> = facets
            .iter()
            .map(|[a, b, c]| {
                let least = *a.min(b).min(c);
                match least {
                    least if least == *a => [*a, *b, *c],
                    least if least == *b => [*b, *c, *a],
                    _ => [*c, *a, *b],
                }
            })
            .collect();
        sides.sort_unstable();
        sides
    };
    let back: Vec<_> = turned[..8].iter().map(|[a, b, c]| [*a, *c, *b]).collect();
    assert_eq!(sides(&plain[..8]), sides(&back));
    assert_eq!(sides(&plain[8..]), sides(&turned[8..]));
}

#[test]
fn surfaces_that_cannot_be_drawn() {
    let directory = folder("no_surfaces");
    let cases: &[(&[&str], &[&str])] = &[
        (&["--scene", "addendum"], &["several surfaces", "--surface r_rack, --surface r_gear"]),
        (&["--scene", "addendum,sections"], &["no surface in common", "sections: r_section"]),
        (&["--scene", "tooth_line"], &["is no surface", "sweeps two values", "--scene addendum"]),
        (&["--scene", "addendum,straight"], &["scene `straight`", "is no surface"]),
        (&["--scene", "addendum,addendun"], &["did you mean `addendum`?"]),
        (&["--scene", "sections,sections"], &["`sections` is given twice"]),
        (&["--scene", "sections", "--surface", "r_gear"], &["`r_gear` is no surface", "r_section"]),
        (&["--scene", "sections", "--view", "30deg"], &["--view takes two angles"]),
        (&["--scene", "sections", "--view", "0,100deg"], &["-90 deg", "90 deg"]),
        (&["--scene", "sections", "--view", "1mm,0"], &["--view 1mm,0", "wrong unit"]),
        (&["--scene", "sections", "--places", "1"], &["--places 1", "from 2 to 200"]),
        (&["--scene", "sections", "--places", "u=3,z=4"], &["`z` is not swept", "u, y"]),
        (&["--scene", "sections", "--places", "u=3"], &["along `y`", "u=3,y=25"]),
        (&["--scene", "sections", "--flip", "addendum"], &["`addendum` is not drawn", "sections"]),
        (&["--scene", "sections", "--forces"], &["a surface takes no --forces"]),
        (&["--scene", "sections", "--at", "u=9deg"], &["a surface takes no --at"]),
        (&["--scene", "sections", "--obj", "."], &["--obj .", "does not name a file"]),
    ];
    for (options, words) in cases {
        check_refused(&[&["draw", "gear_flank"], *options].concat(), words, &directory);
    }
    let points = ["draw", "heald_linkage", "--stl", "a.stl"];
    check_refused(&points, &["--stl is for surfaces", "has points"], &directory);
    let motion = ["run", "batten", "--places", "5"];
    check_refused(&motion, &["a motion takes no --places"], &directory);
}
