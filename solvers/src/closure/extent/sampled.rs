//! Quantities at evenly spaced places of a way for which only some loops have to close.

use super::track::Along;
use crate::closure::linkage::any::AnyLinkage;

/// All quantities that measures look at, at the middles of so many parts of a way, the loops of these groups closed as they are put
/// together where the linkage starts: what needs others means nothing. None where one of them does not close.
pub fn sampled_of(
    linkage: &dyn AnyLinkage,
    along: Along,
    groups: &[usize],
    places: usize,
) -> Option<Vec<Vec<f64>>> {
    let mut assembly = linkage.assemble();
    let mut guide = assembly.guide();
    let (standing, near) = (guide.declared(), linkage.start());
    let instant = guide.loops.instant_row(&standing, &[]);
    guide.place_some(groups.iter().copied(), &standing, &instant, &near).ok()?;
    let (from, to) = along.bounds();
    let place = |part: usize| {
        let at = from + (to - from) * ((part as f64 + 0.5) / places as f64);
        let (mut drivers, mut motion) = (standing.clone(), Vec::new());
        match along {
            Along::Driver(index, _) => drivers[index] = at,
            Along::Time(..) => {
                drivers = linkage.drive(at)?;
                motion = drivers.split_off(standing.len());
            }
        }
        let instant = guide.loops.instant_row(&drivers, linkage.motion(&motion));
        for &group in groups {
            let mode = guide.mode(group);
            if !guide.closed(group, &instant, mode).is_finite() {
                return None;
            }
        }
        let mut values = vec![f64::NAN; linkage.shape().measured];
        guide.loops.measured(&instant, guide.trial, &mut values);
        Some(values)
    };
    (0..places).map(place).collect()
}
