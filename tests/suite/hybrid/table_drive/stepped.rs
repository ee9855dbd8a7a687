//! Motions with many events, against another program in another language that steps from event to event.

use super::*;

/// Nine digits; that program's own error is below 1e-12.
#[track_caller]
fn check<C: Drive>(name: &str) {
    let case = case("stepped", name);
    let moved = Moved::<C>::of(drive(case), number(&case["end"]));
    check_events(&moved, case, 1e-10);
    check_samples(&moved, case, 1e-9);
}

#[test]
fn the_torque_jumps_where_the_table_starts() {
    check::<Switched>("switched");
}

#[test]
fn the_transient_torque_all_the_way() {
    check::<Transient>("transient");
}

#[test]
fn a_motor_with_a_largest_torque() {
    check::<Kloss>("kloss");
    check::<Kloss>("kloss_table_2");
}

#[test]
fn clearance() {
    check::<Loose>("loose");
    check::<LooseSwitched>("loose_switched");
}

/// The table rebounds, and is caught up with.
#[test]
fn clearance_that_opens_again() {
    check::<Loose>("loose_undamped");
    check::<Loose>("loose_wide");
    check::<Loose>("loose_rubbing");
}

/// The table stops and starts while the link swings about the resistance.
#[test]
fn the_table_sticks_and_slips() {
    check::<Table1>("rubbing");
    check::<Table1>("stalled");
}

#[test]
fn the_table_is_pulled_back() {
    check::<Transient>("pulled_back");
}

/// A link that is so damped that the impact alone starts the table, and one that is not.
#[test]
fn the_table_starts_at_the_impact() {
    check::<LooseFull>("loose_full");
    check::<LooseFull>("loose_full_rubbing");
}
