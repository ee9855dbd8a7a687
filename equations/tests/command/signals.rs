//! Interrupts and closed pipes.

use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::{command, entries, folder};

/// A run of ten minutes of motion, which takes the command seconds.
const LONG: [&str; 9] =
    ["run", "batten", "--scene", "start", "--set", "n=1rpm", "--rtol", "1e-13", "--plot"];

#[test]
fn an_interrupt_leaves_no_file() {
    let directory = folder("interrupt");
    let arguments = [&LONG[..], &["figure.svg"]].concat();
    let mut child = command(&arguments, &directory)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    std::thread::sleep(Duration::from_millis(300));
    let number = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &number]).status();
    assert!(sent.expect("kill is there").success());
    let clock = Instant::now();
    let status = child.wait().expect("it ends");
    assert!(clock.elapsed() < Duration::from_secs(5), "it ends at once");
    let mut complaint = String::new();
    let mut stderr = child.stderr.take().expect("a pipe");
    stderr.read_to_string(&mut complaint).expect("text");
    assert_eq!(status.code(), Some(130), "{complaint}");
    assert!(complaint.contains("interrupted"), "{complaint}");
    assert!(entries(&directory).is_empty(), "{:?}", entries(&directory));
}

/// What has been measured so far is printed, and that it is not all.
#[test]
fn an_interrupted_cost_says_what_there_is() {
    let directory = folder("interrupted_cost");
    let arguments = ["cost", "batten", "--seconds", "3000", "--rtol", "1e-6..1e-4"];
    let child = command(&arguments, &directory)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    std::thread::sleep(Duration::from_secs(3));
    let number = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &number]).status();
    assert!(sent.expect("kill is there").success());
    let output = child.wait_with_output().expect("it ends");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{complaint}");
    assert!(complaint.contains("not all that was asked for"), "{complaint}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("dop853"));
}

#[test]
fn a_closed_pipe_is_no_mistake() {
    let directory = folder("pipe");
    for arguments in [&["list"][..], &["expand", "batten"], &["scenes", "batten"], &["--help"]] {
        let mut child = command(arguments, &directory)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {complaint}");
        assert_eq!(complaint, "", "{arguments:?}");
    }
}
