//! The table of a machine tool is run up by a motor through an elastic link. How far does the table lag behind, which
//! torque does the link bear, and how long does it take? What the paper says of it, and what comes out:
//!
//! | the paper | here |
//! |---|---|
//! | twist, torque and time grow with the inertia of the table | they do |
//! | a softer link bears less | it does: half the torque for a sixteenth of the stiffness |
//! | a softer link twists less | it twists more; the time hardly changes |
//! | more resistance takes longer and goes further | to one and the same speed; to its own last speed, which falls, the table takes 2 % longer at most, and goes half as far |
//! | the largest torque is that of the first stage, 4 to 6 times the starting torque | of a table that cannot move, if nothing is lost: `4/(1 - r^2)`, twice with the damping; a table that can move starts at the resistance, and the largest torque comes after |
//!
//! And the motor decides: a characteristic with a largest torque, as real motors have it, twists the link less than a fifth
//! as far as the straight one drawn through to standstill.
//!
//! Published by H. D. Mustafayev, Bulletin of NTU "KhPI", 2013, No. 40, pp. 79-87.
//!
//!     cargo run --example table_drive

use assur::prelude::*;
use assur_equations::table_drive::*;

/// What a run-up comes to.
struct RunUp {
    /// Largest twist in rad, and when, in s.
    twist: f64,
    time: f64,
    /// Twist at the end.
    rest: f64,
    /// Largest torque of the stiffness and of the whole link, in N m.
    elastic: f64,
    link: f64,
    /// Largest torque of the stiffness before the table moves.
    before: f64,
    /// Time in s and path of the table in rad to 95, 98 and 99 % of the last speed.
    reached: [(f64, f64); 3],
    /// Time in s and path of the table in rad to 80 rad/s.
    to_80: (f64, f64),
    /// Speed of the motor where the clearance is taken up, in rad/s.
    impact: f64,
}

fn main() {
    heading();
    let table_1 = Table1::default();
    let base = line("table 1", &table_1);
    line("table 2", &Table2::default());
    line("table 2 as it is headed", &Printed::default());
    inertia(&table_1);
    stiffness(&table_1);
    resistance(&table_1);
    clearance(&base);
    motor(&base);
    first_stage();
}

fn inertia(table_1: &Table1) {
    println!("inertia of the table");
    let runs = [0.25, 0.5, 1.0, 2.0, 4.0].map(|ratio| {
        let drive = Table1 { J2: ratio * table_1.J1, ..*table_1 };
        line(&format!("  J2/J1 = {ratio}"), &drive)
    });
    for pair in runs.windows(2) {
        assert!(pair[1].twist > pair[0].twist && pair[1].elastic > pair[0].elastic);
        assert!(pair[1].reached[1].0 > pair[0].reached[1].0);
    }
}

fn stiffness(table_1: &Table1) {
    println!("stiffness of the link");
    let runs = [177.5, 355.0, 710.0, 1420.0, 2840.0]
        .map(|c| line(&format!("  c = {c} N m/rad"), &Table1 { c, ..*table_1 }));
    for pair in runs.windows(2) {
        assert!(pair[1].elastic > pair[0].elastic, "a stiffer link bears more");
        assert!(pair[1].twist < pair[0].twist, "and twists less");
        assert!((pair[1].reached[1].0 / pair[0].reached[1].0 - 1.0).abs() < 0.02);
    }
}

fn resistance(table_1: &Table1) {
    println!("resistance");
    let torques = [0.0, 0.2, 1.0, 2.0, 4.0, 8.0];
    let runs = torques
        .map(|torque| line(&format!("  Mc = {torque} N m"), &Table1 { Mc: torque, ..*table_1 }));
    for (run, torque) in runs.iter().zip(torques) {
        assert!((run.rest - torque / table_1.c).abs() < 1e-8, "what winds the link at rest");
    }
    for pair in runs.windows(2) {
        assert!(pair[1].twist > pair[0].twist && pair[1].elastic > pair[0].elastic);
        assert!(pair[1].to_80.0 > pair[0].to_80.0 && pair[1].to_80.1 > pair[0].to_80.1);
        let [one, other] = [&pair[0], &pair[1]].map(|run| run.reached[1]);
        assert!(other.0 > one.0 && other.1 < one.1);
    }
    let [first, .., last] = runs.each_ref().map(|run| run.reached[1]);
    assert!(last.0 / first.0 < 1.02 && last.1 / first.1 < 0.55);
}

fn clearance(base: &RunUp) {
    println!("clearance");
    let gaps = [0.0, 0.002, 0.005, 0.01, 0.02];
    let runs = gaps.map(|g| {
        let drive = Loose { g, ..Loose::default() };
        let run = run(&drive);
        print_line(&format!("  g = {} mrad, {:.1} rad/s", g * 1e3, run.impact), &run);
        run
    });
    assert!((runs[0].elastic / base.elastic - 1.0).abs() < 1e-6);
    for pair in runs.windows(2) {
        assert!(pair[1].impact > pair[0].impact);
        assert!(pair[1].link > pair[0].link && pair[1].elastic > pair[0].elastic);
    }
    assert!(
        runs[4].link > 3.5 * base.link && runs[4].elastic < 1.2 * base.elastic,
        "damping bears the impact"
    );
}

fn motor(base: &RunUp) {
    println!("motor");
    let kloss = line("  with a largest torque", &Kloss::default());
    let switched = line("  transient, then straight", &Switched::default());
    let full = line("  straight, full torque starts", &Full::default());
    assert!(kloss.twist < 0.2 * base.twist && kloss.reached[1].0 > 3.0 * base.reached[1].0);
    for other in [switched, full] {
        assert!((other.twist / base.twist - 1.0).abs() < 0.01);
    }
}

fn first_stage() {
    println!("\nlargest elastic torque in starting torques");
    let still = Blocked::default();
    let kept = Blocked { beta: 0.0, lambda1: 0.0, lambda2: 0.0, ..still };
    // r = omega/k = 1/sqrt(3).
    let soft = Blocked { c: 3.0 * still.omega.powi(2) * still.J1, ..kept };
    let ratio = |drive: &Blocked| run(drive).elastic / drive.Mst;
    let free = Transient::default();
    let moving = run(&free);
    for (name, found, expected) in [
        ("the table cannot move", ratio(&still), 2.149),
        (
            "and nothing is lost",
            ratio(&kept),
            4.0 / (1.0 - still.omega.powi(2) * still.J1 / still.c),
        ),
        ("and the link is soft", ratio(&soft), 6.0),
        ("the table can move: before it does", moving.before / free.Mst, free.Mc / free.Mst),
        ("afterwards", moving.elastic / free.Mst, 1.080),
    ] {
        println!("  {name:36} {found:7.3}");
        assert!((found / expected - 1.0).abs() < 2e-3, "{name}: {found}, expected {expected}");
    }
}

fn heading() {
    let units = ["mrad", "ms", "mrad", "N m", "N m", "ms", "ms", "ms", "rad", "ms", "rad"];
    let names = [
        "twist", "at", "at rest", "elastic", "link", "95 %", "98 %", "99 %", "path", "80 rad/s",
        "path",
    ];
    for titles in [names, units] {
        let titles = titles.map(|title| format!("{title:>9}"));
        println!("{:32}{}", "", titles.concat());
    }
}

fn print_line(name: &str, run: &RunUp) {
    let [first, second, third] = run.reached;
    let milli = 1e3;
    let numbers = [
        milli * run.twist,
        milli * run.time,
        milli * run.rest,
        run.elastic,
        run.link,
        milli * first.0,
        milli * second.0,
        milli * third.0,
        second.1,
        milli * run.to_80.0,
        run.to_80.1,
    ];
    println!("{name:32}{}", numbers.map(|number| format!("{number:9.3}")).concat());
}

/// Runs a scene and prints what it comes to.
fn line<C: Scene>(name: &str, drive: &C) -> RunUp {
    let run = run(drive);
    print_line(name, &run);
    run
}

fn run<C: Scene>(drive: &C) -> RunUp {
    let motion = drive.ask().until(0.4).run().unwrap();
    let peak = |name: &str, until: f64| {
        let subject = motion.subject(name).unwrap();
        let extremes = motion.extremes(&[subject], (0.0, until));
        extremes.first().map_or((0.0, 0.0), |found| (found.highest.time, found.highest.value))
    };
    let value = |name: &str, time: f64| motion.value(name, time).unwrap();
    let speed = motion.subject("dot(phi2)").unwrap();
    let last = value("dot(phi2)", 0.4);
    let reach = |speed_of: f64| {
        let time = motion.first_time(speed, speed_of).unwrap_or(f64::NAN);
        (time, value("phi2", time))
    };
    let modes = drive.shape().modes;
    let mut events = motion.events().iter();
    let started = events.find(|event| modes[event.to].name == "run");
    let mut events = motion.events().iter();
    let contact = events.find(|event| modes[event.from].name == "gap");
    let (time, twist) = peak("twist", 0.4);
    RunUp {
        twist,
        time,
        rest: value("twist", 0.4),
        elastic: peak("elastic_torque", 0.4).1,
        link: peak("link_torque", 0.4).1,
        before: peak("elastic_torque", started.map_or(0.4, |event| event.time)).1,
        reached: [0.95, 0.98, 0.99].map(|part| reach(part * last)),
        to_80: reach(80.0),
        impact: contact.map_or(0.0, |event| event.before[2]),
    }
}
