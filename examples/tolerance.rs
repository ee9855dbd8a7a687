//! The heald linkage of a weaving dobby carries the motion of the knives to the jack. Its links are made with errors: by
//! how much does the jack miss its angle? To first order each error counts with its influence coefficient; linkages made
//! at random show that this is enough here. And which tolerances narrow the band by a third at the least cost, if half a
//! tolerance costs twice as much?
//!
//!     cargo run --release --example tolerance

use assur::closure::Variable;
use assur::shape::Distribution;
use assur::tolerance::{
    Candidate, Cost, Rule, Sampling, Source, Study, allocate, influences, linear, monte_carlo,
};
use assur_equations::heald_linkage::Printed;

/// The angle of the jack among the outputs.
const JACK: usize = 2;
/// Thousandths of a radian.
const MRAD: f64 = 1e-3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let linkage = Printed::default();
    let study = Study {
        output: JACK,
        places: vec![vec![90f64.to_radians()]],
        sources: Printed::shape().loops().variables.iter().enumerate().map(source).collect(),
    };

    let found = influences(&linkage, JACK, &study.places)?;
    let errors = &linear(&found, &study.sources)?[0];
    println!("   error by   mrad   share");
    for (source, one) in study.sources.iter().zip(&errors.contributions) {
        let name = name(source.variable);
        println!("{name:>10} {:7.4} {:5.1} %", one.worst / MRAD, 100.0 * one.share);
    }
    let made = monte_carlo(&linkage, &study, &Sampling::default(), &|_| ())?;
    let sampled = &made.places[0];
    let [low, high] = [sampled.deviation.low, sampled.deviation.high].map(|one| one / MRAD);
    println!("\nworst case          {:.4} mrad", errors.worst / MRAD);
    println!("standard deviation  {:.5} mrad", errors.deviation / MRAD);
    println!("  of {} linkages {low:.5} to {high:.5} mrad", sampled.assembled);
    assert!((errors.worst / MRAD - 2.0570).abs() < 5e-5);
    assert!((errors.deviation / MRAD - 0.55949).abs() < 5e-6);
    assert_eq!(sampled.assembled, sampled.drawn);

    let way = Study {
        places: (60..=120).map(|at| vec![f64::from(at).to_radians()]).collect(),
        ..study.clone()
    };
    let candidates: Vec<_> = study.sources.iter().map(candidate).collect();
    let band = 2.0 / 3.0 * errors.worst;
    let chosen = allocate(&linkage, &way, &candidates, Rule::Worst, band)?;
    println!("\nfor {:.3} mrad from 60° to 120°   now   cheapest", band / MRAD);
    for (source, tolerance) in study.sources.iter().zip(&chosen.tolerances) {
        let (unit, factor) = match Printed::shape().loops().variables[source.variable] {
            Variable::Constant(_) => ("mm", 1e-3),
            Variable::Driver(_) => ("deg", 1f64.to_radians()),
        };
        let [now, then] = [source.half_width, *tolerance].map(|one| one / factor);
        println!("{:>27} {unit:3} {now:7.3} {then:10.4}", name(source.variable));
    }
    let before = study.sources.len();
    println!("at a cost of {:.2} in place of {before}", chosen.cost);
    assert!(chosen.greatest <= band * (1.0 + 1e-9));
    Ok(())
}

/// The error of a variable by the tolerance of the equation file; that of the knives is a tenth of a degree.
fn source((variable, of): (usize, &Variable)) -> Source {
    let half_width = match of {
        Variable::Constant(index) => Printed::shape().constants[*index].tolerance,
        Variable::Driver(_) => 0.1f64.to_radians(),
    };
    Source { variable, half_width, distribution: Distribution::Uniform }
}

/// Any tolerance may be chosen, at a cost that is 1 for the present one and grows as it shrinks.
fn candidate(source: &Source) -> Candidate {
    Candidate {
        variable: source.variable,
        distribution: source.distribution,
        cost: Cost { fixed: 0.0, factor: source.half_width, exponent: 1.0 },
        least: 0.0,
        most: f64::INFINITY,
    }
}

/// What a variable is called.
fn name(variable: usize) -> &'static str {
    match Printed::shape().loops().variables[variable] {
        Variable::Constant(index) => Printed::shape().constants[index].quantity.name,
        Variable::Driver(_) => "phi4",
    }
}
