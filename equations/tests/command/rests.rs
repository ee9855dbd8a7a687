//! Positions of rest and motions as the command tells and draws them.

use super::{answer, check_refused, folder, json};

#[test]
fn a_position_of_rest_has_its_vibrations() {
    let directory = folder("rest");
    let text = answer(&["run", "lamp_arm", "--scene", "damped"], &directory);
    for word in ["position of rest", "0.6897623934", "0.05374", "falls to 1/e in 4.3 s", "stable"] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    let object = json(&["run", "lamp_arm", "--scene", "damped"], &directory);
    assert_eq!(object["task"]["kind"], "rest");
    assert_eq!(object["status"], "complete");
    let vibrations = object["vibrations"].as_array().expect("a list");
    assert_eq!(vibrations.len(), 1);
    assert_eq!(vibrations[0]["shape"][0]["name"], "phi");
    let csv = ["run", "lamp_arm", "--scene", "still", "--format", "csv"];
    assert_eq!(answer(&csv, &directory).lines().count(), 2);
    let any = json(&["run", "lamp_arm", "--scene", "any"], &directory);
    let conclusions = any["conclusions"].to_string();
    assert!(conclusions.contains("indifferent in 1 direction"), "{conclusions}");
}

#[test]
fn motions_are_drawn_in_time_with_forces_if_wished() {
    let directory = folder("draw_motion");
    let read = |name: &str| std::fs::read_to_string(directory.join(name)).expect(name);
    let text = answer(&["draw", "shaper", "--scene", "steady", "--forces"], &directory);
    assert!(text.contains("shaper-steady-moving.svg"), "{text}");
    let moving = read("shaper-steady-moving.svg");
    assert!(moving.contains("times slower than it is"), "its pace is told");
    assert_eq!(moving.matches("class=\"force\"").count(), 1, "the force in the slot");
    answer(&["draw", "shaper", "--scene", "steady"], &directory);
    assert!(!read("shaper-steady-moving.svg").contains("class=\"force\""));
    // What comes to a dead point is drawn on its way beyond.
    let text = answer(&["draw", "four_bar_chain", "--at", "time=2s"], &directory);
    assert!(text.contains("time = 2 s"), "{text}");
}

#[test]
fn a_vibration_is_drawn_about_the_position_of_rest() {
    let directory = folder("draw_vibration");
    let text = answer(&["draw", "lamp_arm", "--scene", "damped", "--vibration", "1"], &directory);
    assert!(text.contains("at rest, and in vibration 1 of 0.6898 Hz"), "{text}");
    let read = |name: &str| std::fs::read_to_string(directory.join(name)).expect(name);
    assert!(read("lamp_arm-damped-moving.svg").contains("Larger than it is"));
    // A balanced arm stays wherever it is.
    let text = answer(&["draw", "lamp_arm", "--scene", "any"], &directory);
    assert!(text.contains("at rest") && !text.contains("Moving"), "{text}");
    for (scene, words) in [
        ("damped", ["there is no vibration 2 to draw", "the position of rest: 1"]),
        ("swing", ["has no position of rest", "choose a scene that rests"]),
    ] {
        let asked = ["draw", "lamp_arm", "--scene", scene, "--vibration", "2"];
        check_refused(&asked, &words, &directory);
    }
}

#[test]
fn energies_are_curves_on_request() {
    let directory = folder("energies");
    let curves = ["--curves", "energy,energy(kinetic),energy(potential)"];
    let text =
        answer(&[&["run", "lamp_arm", "--scene", "swing"], &curves[..]].concat(), &directory);
    assert!(text.contains("constant but for what is gained and lost"), "{text}");
    let figure = std::fs::read_to_string(directory.join("lamp_arm-swing.svg")).expect("a figure");
    assert!(figure.contains("Energy, J") && figure.contains("energy(kinetic)"));
    let words = ["states no energies", "--curves energy"];
    check_refused(&["run", "batten_table", "--curves", "energy"], &words, &directory);
}
