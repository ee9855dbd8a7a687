//! What runs without being compiled is what is compiled: every scene of every mechanism, bit for bit. And the tests that the
//! models generate: of what has been derived as it is interpreted, of published facts as they are compiled.

mod absent;
mod linkages;
mod motions;
mod octuple;
mod roundings;

use assur::registry::{Bind, Mechanism, SceneEntry};
use assur_equations::REGISTRY;
use assur_model::asked::Asked;

/// The scenes of a mechanism, as emitted and as interpreted.
#[track_caller]
fn pairs(emitted: &'static Mechanism) -> Vec<(&'static SceneEntry, &'static SceneEntry)> {
    let again = assur_interpreter::again(emitted, Asked::All).expect("tokens");
    let interpreted = Box::leak(Box::new(again.expect("a file without errors")));
    assert_eq!(emitted.scenes.len(), interpreted.scenes.len(), "{}", emitted.name);
    emitted.scenes.iter().zip(interpreted.scenes).collect()
}

fn compare(name: &str) {
    let mechanism = REGISTRY.iter().find(|one| one.name == name).expect("a mechanism");
    for (emitted, interpreted) in pairs(mechanism) {
        let place = format!("{name} {}", emitted.name);
        compare_scene(&place, emitted, interpreted);
        if let (Some(emitted), Some(interpreted)) = (emitted.unreduced, interpreted.unreduced) {
            compare_scene(&format!("{place}, unreduced"), emitted, interpreted);
        }
    }
}

fn compare_scene(place: &str, emitted: &SceneEntry, interpreted: &SceneEntry) {
    let shapes = [emitted, interpreted].map(|one| format!("{:#?}", one.shape));
    let [expected, found] = &shapes;
    let differing = expected.lines().zip(found.lines()).find(|(expected, found)| expected != found);
    assert_eq!(differing, None, "{place}");
    assert_eq!(expected.len(), found.len(), "{place}");
    let values: Vec<f64> = emitted.constants.iter().map(|constant| constant.default).collect();
    match (emitted.bind, interpreted.bind) {
        (Bind::Motion(emitted), Bind::Motion(interpreted)) => {
            let [emitted, interpreted] = [emitted, interpreted].map(|bind| bind(&values));
            match (emitted, interpreted) {
                (Ok(emitted), Ok(interpreted)) => motions::compare(place, &*emitted, &*interpreted),
                (emitted, interpreted) => assert_eq!(emitted.err(), interpreted.err(), "{place}"),
            }
        }
        (Bind::Linkage(emitted), Bind::Linkage(interpreted)) => {
            let [emitted, interpreted] = [emitted, interpreted].map(|bind| bind(&values));
            match (emitted, interpreted) {
                (Ok(emitted), Ok(interpreted)) => {
                    linkages::compare(place, &*emitted, &*interpreted)
                }
                (emitted, interpreted) => assert_eq!(emitted.err(), interpreted.err(), "{place}"),
            }
        }
        _ => panic!("{place}: kinds differ"),
    }
}

/// What goes on at a dead point goes on uncompiled too.
#[test]
fn dead_points_are_passed_as_interpreted() {
    let emitted = REGISTRY.iter().find(|one| one.name == "simple_pendulum").expect("a mechanism");
    let again = assur_interpreter::again(emitted, Asked::All).expect("tokens");
    test_all(Box::leak(Box::new(again.expect("a file without errors"))));
}

fn test(name: &str) {
    test_all(REGISTRY.iter().find(|one| one.name == name).expect("a mechanism"));
}

/// Runs the tests of a mechanism, and says of all that fail why.
#[track_caller]
fn test_all(mechanism: &'static Mechanism) {
    let tests = assur_interpreter::tests(mechanism, Asked::All).expect("tokens");
    let tests = tests.expect("a file without errors");
    assert!(!tests.is_empty());
    let failed = tests.iter().filter_map(|test| {
        let why = test.run().err()?;
        Some(format!("{}: {}: {why}\n", test.scene, test.name))
    });
    assert_eq!(failed.collect::<String>(), "");
}

/// Tests of each mechanism, and that there are some.
macro_rules! mechanisms {
    ($($name:ident)*) => {
        $(mod $name {
            #[test]
            fn runs_as_it_is_compiled() {
                super::compare(stringify!($name));
            }

            #[test]
            fn does_what_it_states() {
                super::test(stringify!($name));
            }
        })*

        #[test]
        fn all_are_compared() {
            let names: Vec<_> = REGISTRY.iter().map(|one| one.name).collect();
            assert_eq!(names, [$(stringify!($name)),*]);
        }
    };
}

mechanisms! {
    batten batten_table heald_linkage selvedge_linkage feed_rack feed_lift feed_stitch sewing_feed feed_inverse dwell_six_bar
    dwell_feed table_drive presser_foot needle_impact engine balanced_four_bar shaper andrews feed_dynamics car_axis governor
    elastic_crank simple_pendulum four_bar_chain four_bar_row bricard lamp_arm burnishing gear_flank packet_reducer
    cam pumping_jack
}
