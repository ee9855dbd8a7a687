//! Numbers of the specification.

use super::super::{
    Sampling, Source, Status, influences, linear, monte_carlo, ranking, worst_place,
};
use super::{Heald, at, study};
use crate::shape::Distribution;

fn bands(degrees: &[f64], sources: Option<&[Source]>) -> Vec<super::super::Linear> {
    let study = study(degrees, 1.0, Distribution::Uniform);
    let influences = influences(&Heald::default(), 0, &study.places).expect("it moves there");
    linear(&influences, sources.unwrap_or(&study.sources)).expect("the sources are sound")
}

#[test]
fn bands_of_the_heald_linkage() {
    let band = &bands(&[90.0], None)[0];
    assert!((band.worst - 2.0570e-3).abs() < 5e-8, "{}", band.worst);
    assert!((band.deviation - 0.559_49e-3).abs() < 5e-9, "{}", band.deviation);
    let shares: f64 = band.contributions.iter().map(|one| one.share).sum();
    let variances: f64 = band.contributions.iter().map(|one| one.variance_share).sum();
    assert!((shares - 1.0).abs() < 1e-14 && (variances - 1.0).abs() < 1e-14);
}

#[test]
fn what_the_paper_leaves_out_is_a_fifth() {
    let mut sources = at(90.0).1.sources;
    sources.retain(|source| source.variable != 2 && source.variable != 6);
    let band = &bands(&[90.0], Some(&sources))[0];
    assert!((band.worst - 1.604e-3).abs() < 5e-7, "{}", band.worst);
}

#[test]
fn the_ranking_goes_over_the_range() {
    let degrees: Vec<f64> = (0..=60).map(|k| 60.0 + f64::from(k)).collect();
    let bands = bands(&degrees, None);
    let ranks = ranking(&bands);
    let means: f64 = ranks.iter().map(|rank| rank.mean).sum();
    assert!((means - 1.0).abs() < 1e-13);
    for pair in ranks.windows(2) {
        assert!(pair[0].mean >= pair[1].mean);
    }
    for rank in &ranks {
        let there = bands[rank.place].contributions[rank.source].share;
        assert_eq!(there, rank.largest);
    }
    let worst = worst_place(&bands);
    assert!(bands.iter().all(|band| band.worst <= bands[worst].worst));
}

#[test]
fn play_adds_its_length_error() {
    let (_, mut study) = at(90.0);
    let without = bands(&[90.0], None)[0].clone();
    study.sources.push(Source::play(1, 2e-5));
    let with = &bands(&[90.0], Some(&study.sources))[0];
    // c/(|C| l7)
    let play = 2e-5 / (1.832_496 * 0.12);
    assert!((with.worst - without.worst - play).abs() < 1e-10);
}

#[test]
fn samples_agree_with_the_first_order_where_tolerances_are_small() {
    let (heald, study) = at(90.0);
    let sampling = Sampling { samples: 200_000, ..Sampling::default() };
    let found = &monte_carlo(&heald, &study, &sampling, &|_| ()).expect("it assembles").places[0];
    assert_eq!(found.status, Status::Complete);
    let deviation = found.deviation;
    assert!(deviation.low < 0.559_49e-3 && 0.559_49e-3 < deviation.high, "{deviation:?}");
    assert!(found.greatest < 2.0570e-3 && found.least > -2.0570e-3);
    assert!(found.mean.low < 1e-6 && found.mean.high > -1e-6);
    assert!((found.value.to_degrees() + 70.06145).abs() < 5e-6);
}

#[test]
fn distributions_have_their_deviations() {
    for (distribution, factor) in [
        (Distribution::Normal, 1.0 / 3f64.sqrt()),
        (Distribution::Truncated, 0.986_578_1 / 3f64.sqrt()),
    ] {
        let study = study(&[90.0], 1.0, distribution);
        let found = monte_carlo(&Heald::default(), &study, &Sampling::default(), &|_| ());
        let deviation = found.expect("it assembles").places[0].deviation;
        let expected = 0.559_49e-3 * factor;
        let room = 1.5 * (deviation.high - deviation.low);
        assert!((deviation.value - expected).abs() < room, "{deviation:?} {expected}");
    }
}
