//! The modules of the crate use only those before them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The modules that each one names, by the first folder or file below `src`.
fn uses() -> BTreeMap<String, BTreeSet<String>> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut open = vec![source.clone()];
    while let Some(place) = open.pop() {
        if place.is_dir() {
            let entries = fs::read_dir(&place).unwrap();
            open.extend(entries.map(|entry| entry.unwrap().path()));
            continue;
        }
        let inner = place.strip_prefix(&source).unwrap().with_extension("");
        let module = inner.iter().next().unwrap().to_string_lossy().into_owned();
        let text = fs::read_to_string(&place).unwrap();
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        if inner.iter().any(|part| part == "tests") || module == "lib" {
            continue;
        }
        for named in code.split("crate::").skip(1) {
            let name: String =
                named.chars().take_while(|one| one.is_alphanumeric() || *one == '_').collect();
            if name != module {
                uses.entry(module.clone()).or_default().insert(name);
            }
        }
    }
    uses
}

#[test]
fn no_module_is_used_by_one_that_it_uses() {
    let mut uses = uses();
    assert!(uses.len() > 20, "{uses:?}");
    // Whatever uses nothing that is left is taken away, again and again.
    loop {
        let left: BTreeSet<String> = uses.keys().cloned().collect();
        let count = left.len();
        uses.retain(|_, used| used.iter().any(|one| left.contains(one)));
        if uses.len() == count {
            break;
        }
    }
    assert!(uses.is_empty(), "these use each other: {uses:?}");
}
