use super::*;

fn incidence(rows: &[&[usize]], columns: usize) -> Incidence {
    Incidence { rows: rows.iter().map(|row| row.to_vec()).collect(), columns }
}

#[track_caller]
fn check_blocks(rows: &[&[usize]], expected: &[&[usize]]) {
    let incidence = incidence(rows, rows.len());
    let matching = Matching::of(&incidence);
    assert_eq!(matching.imbalance(&incidence), Imbalance::default());
    let found: Vec<_> =
        blocks(&incidence, &matching).into_iter().map(|block| block.equations).collect();
    assert_eq!(found, expected);
}

#[test]
fn a_triangle_is_solved_from_its_tip() {
    check_blocks(&[&[0, 1, 2], &[1, 2], &[2]], &[&[2], &[1], &[0]]);
}

#[test]
fn equations_in_a_circle_stay_together() {
    check_blocks(&[&[0, 1], &[1, 2], &[2, 0], &[3, 0]], &[&[0, 1, 2], &[3]]);
}

#[test]
fn a_greedy_choice_is_corrected() {
    // Equation 0 would take unknown 0, which is the only one of equation 1.
    check_blocks(&[&[0, 1], &[0]], &[&[1], &[0]]);
}

#[test]
fn too_many_equations_are_named_with_their_unknowns() {
    let incidence = incidence(&[&[0], &[0], &[1]], 2);
    let imbalance = Matching::of(&incidence).imbalance(&incidence);
    assert_eq!(imbalance.overdetermined, Some((vec![0, 1], vec![0])));
    assert_eq!(imbalance.underdetermined, None);
}

#[test]
fn unknowns_without_an_equation_are_named_with_what_could_determine_them() {
    let incidence = incidence(&[&[0, 1], &[2]], 3);
    let imbalance = Matching::of(&incidence).imbalance(&incidence);
    assert_eq!(imbalance.underdetermined, Some((vec![0, 1], vec![0])));
    assert_eq!(imbalance.overdetermined, None);
}

#[test]
fn a_square_system_can_be_both() {
    let incidence = incidence(&[&[0], &[0], &[1, 2]], 3);
    let imbalance = Matching::of(&incidence).imbalance(&incidence);
    assert_eq!(imbalance.overdetermined, Some((vec![0, 1], vec![0])));
    assert_eq!(imbalance.underdetermined, Some((vec![1, 2], vec![2])));
}

#[test]
fn a_chain_of_a_hundred_thousand_equations_needs_no_deep_stack() {
    let size = 100_000;
    let rows =
        (0..size).map(|row| if row + 1 < size { vec![row, row + 1] } else { vec![row] }).collect();
    let incidence = Incidence { rows, columns: size };
    let matching = Matching::of(&incidence);
    assert_eq!(blocks(&incidence, &matching).len(), size);
}
