//! What comes with Assur works as it is.

use assur::study::each;
use assur_equations::REGISTRY;
use serde_json::Value;

use super::{answer, folder, gallery};

/// Every scene of every mechanism runs with its own values, and what was published of it is met, with the numbers that the
/// gallery shows.
#[test]
fn every_scene_that_comes_with_assur_runs() {
    let (folder, page) = (folder("shipped"), gallery::page());
    let scenes: Vec<_> =
        REGISTRY.iter().flat_map(|of| of.scenes.iter().map(move |scene| (of, scene))).collect();
    each(scenes.len(), 0, &|_| (), &|index| {
        let (mechanism, scene) = scenes[index];
        let asked = ["run", mechanism.name, "--scene", scene.name, "--format", "json"];
        let object: Value = serde_json::from_str(&answer(&asked, &folder)).expect("JSON");
        // A measure may have no value, and says why; everything else has one.
        let lacks = |one: &Value| one["value"].is_null() && one["missing"].is_null();
        let measures = object["measures"].as_array().into_iter().flatten();
        // Where modes of a linkage meet outputs may have no value.
        let meets = object["events"].to_string().contains("change point of");
        let positions = object["positions"].as_array().into_iter().flatten();
        let results = positions.flat_map(|one| one["results"].as_array().into_iter().flatten());
        let has_gaps = meets && { results }.any(|one| one["value"].is_null());
        let has_all = measures.clone().all(|one| one["missing"].is_null());
        let status = match has_all && !has_gaps {
            true => "complete",
            false => "incomplete",
        };
        assert_eq!(object["status"], status, "{asked:?}");
        assert!(!measures.chain(&motions(&object)).any(lacks), "{asked:?}");
        let published = object["published"].as_array().expect("a list");
        for published in published {
            assert_ne!(published["within"], false, "{asked:?}: {published}");
        }
        gallery::check_numbers(&page, mechanism.title, scene.name, published);
    });
}

/// The results of a motion; none of a linkage, whose positions decide its status.
fn motions(object: &Value) -> Vec<Value> {
    match object["settings"].is_object() {
        true => object["results"].as_array().expect("a list").clone(),
        false => Vec::new(),
    }
}
