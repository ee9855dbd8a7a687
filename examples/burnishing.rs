//! Diamond burnishing: a formula sheet that answers questions. Which feed and speed keep roughness and temperature within
//! limits? Which radius of the diamond is the most productive, and how hard may it be pressed? Is a power law good enough?
//! Where does the heat go?
//!
//!     cargo run --release --example burnishing

use assur::closure::{AtDeadPoint, Axis, Linkage, sweep};
use assur_equations::burnishing::{Fits, Influence, Radius, Recommended, Region, Temperature};

const MM: f64 = 1e-3;
const UM: f64 = 1e-6;

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Outcome<()> {
    feed_and_speed()?;
    radius_and_force()?;
    power_laws()?;
    heat()
}

/// Outputs of a sheet at a place.
fn values<L: Linkage, const N: usize>(
    sheet: &L,
    place: &[f64],
    names: [&str; N],
) -> Outcome<[f64; N]> {
    let axes: Vec<_> = place.iter().map(|at| Axis { from: *at, to: *at, count: 1 }).collect();
    let found = sweep(sheet, &axes, AtDeadPoint::Stop)?;
    let mut values = [0.0; N];
    for (value, name) in values.iter_mut().zip(names) {
        let index = sheet.shape().outputs.iter().position(|output| output.name == name);
        *value = found.outputs(0)[index.ok_or("no such output")?];
    }
    Ok(values)
}

/// The largest feed and speed for an admissible roughness and temperature, beside the paper's eq (14).
fn feed_and_speed() -> Outcome<()> {
    println!("1. Largest feed and speed\n");
    println!("Ra, um  Theta, K   S, mm  by (14)   V, m/s  by (14)   S*V, mm2/s");
    for (roughness, temperature) in [(0.6, 300.0), (1.0, 300.0), (1.6, 300.0), (1.0, 800.0)] {
        let [feed, law, speed, other, rate] = values(
            &Recommended::default(),
            &[roughness * UM, temperature],
            ["S_adm", "S_14", "V_adm", "V_14", "productivity"],
        )?;
        println!(
            "{roughness:6}  {temperature:8}  {:6.4}  {:7.4}  {speed:7.3}  {other:7.3}  {:11.1}",
            feed / MM,
            law / MM,
            rate / MM.powi(2)
        );
        if (roughness, temperature) == (1.0, 300.0) {
            assert!((feed / MM - 0.1311).abs() < 5e-5 && (speed - 1.6900).abs() < 5e-3);
        }
    }
    Ok(())
}

/// The largest force for each radius at the default feed and speed, and what can be produced with it.
fn radius_and_force() -> Outcome<()> {
    println!("\n2. Radius and force for Ra <= 1 um, Theta <= 800 K\n");
    println!("r, mm  P from, N  P to, N   S*V at 100 N, mm2/s");
    let sheet = Region::default();
    // The scene has no value where a limit is passed.
    let holds = |force: f64, radius: f64| -> Outcome<bool> {
        Ok(values(&sheet, &[force, radius], ["Ra"])?[0].is_finite())
    };
    let mut most = (0.0, 0.0);
    for radius in [0.5, 0.6, 0.8, 1.0, 1.2, 1.5].map(|radius| radius * MM) {
        let forces =
            (20..=300).map(|force| Ok((f64::from(force), holds(f64::from(force), radius)?)));
        let forces = forces.collect::<Outcome<Vec<_>>>()?;
        let good: Vec<f64> = forces.into_iter().filter(|one| one.1).map(|one| one.0).collect();
        let inverse = Radius { Theta_adm: 800.0, ..Radius::default() };
        let [rate] = values(&inverse, &[radius], ["productivity"])?;
        let (from, to) = (good.first(), good.last());
        let text = |force: Option<&f64>| force.map_or("none".into(), |force| format!("{force:.0}"));
        println!(
            "{:5.1}  {:>9}  {:>7}  {:20.1}",
            radius / MM,
            text(from),
            text(to),
            rate / MM.powi(2)
        );
        if rate > most.1 {
            most = (radius, rate);
        }
    }
    println!(
        "the largest diamond is the most productive: it leaves lower marks and spreads the heat"
    );
    assert!((most.0 - 1.5 * MM).abs() < 1e-12);
    Ok(())
}

/// Exponents by least squares, of logarithms and of the values themselves, over ranges of the fit.
fn power_laws() -> Outcome<()> {
    println!("\n3. Power laws: Ra/um = C*(S/mm)^q, published 6.418 and 0.88\n");
    println!("S, mm           q       C   error     q of values  C of values");
    for (from, to) in [(0.05, 0.15), (0.05, 0.2), (0.1, 0.2)] {
        let sheet = Fits { S_1: from * MM, S_2: to * MM, ..Fits::default() };
        let [q, c, error, other, factor] =
            values(&sheet, &[100.0], ["q", "C_R", "Ra_error", "q_lin", "C_R_lin"])?;
        println!(
            "{from:4} to {to:4}  {q:7.4}  {c:6.3}  {:4.1} %  {other:12.4}  {factor:11.3}",
            100.0 * error
        );
        // Ra is a square and a constant: no power law fits better than this.
        assert!(error > 0.04);
    }
    println!("\nTheta/K = C*(V/(m/s))^p, published 211 and 0.49\n");
    println!("V, m/s          p        C   error     p of values  C of values");
    for (from, to) in [(0.25, 4.0), (0.5, 2.0), (0.5, 3.0)] {
        let sheet = Fits { V_1: from, V_2: to, ..Fits::default() };
        let [p, c, error, other, factor] =
            values(&sheet, &[100.0], ["p", "C_T", "Theta_error", "p_lin", "C_T_lin"])?;
        println!(
            "{from:4} to {to:4}  {p:7.4}  {c:7.2}  {:4.1} %  {other:12.4}  {factor:11.2}",
            100.0 * error
        );
        assert!((p - 0.667).abs() < 0.005 && error < 0.03);
    }
    Ok(())
}

/// The share of the heat that the diamond takes, and whether its parts follow the paper's trends.
fn heat() -> Outcome<()> {
    println!("\n4. Heat into the diamond\n");
    println!("V, m/s  share    q1, W/mm2  q2, W/mm2");
    for speed in [0.5, 1.0, 3.0, 5.0] {
        row(speed, values(&Temperature::default(), &[speed], ["share", "q_1", "q_2"])?);
    }
    println!("\n  P, N  share    q1, W/mm2  q2, W/mm2");
    for force in [50.0, 100.0, 300.0] {
        row(force, values(&Influence::default(), &[force, MM], ["share", "q_1", "q_2"])?);
    }
    println!("\n r, mm  share    q1, W/mm2  q2, W/mm2");
    for radius in [0.5, 1.0, 1.5] {
        row(radius, values(&Influence::default(), &[100.0, radius * MM], ["share", "q_1", "q_2"])?);
    }
    println!(
        "printed: q1 falls with r, rises with P and V - met; q2 rises with r, falls with P - not met"
    );
    Ok(())
}

fn row(at: f64, [share, first, second]: [f64; 3]) {
    println!("{at:6}  {:4.1} %  {:9.2}  {:9.2}", 100.0 * share, first * 1e-6, second * 1e-6);
}
