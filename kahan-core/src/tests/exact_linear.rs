//! Compares elimination over the rationals with the algorithm without divisions.

use nalgebra::{SMatrix, SVector};
use num_traits::{One, Zero};

use super::rationals::{Q, Rationals, product, q, scaled};
use crate::field::linear::{determinant, determinant_and_adjugate_product, solve};

const TRIALS: usize = 20;

fn singular<const N: usize>(rationals: &mut Rationals) -> SMatrix<Q, N, N> {
    let mut a = rationals.matrix::<N>();
    for j in 0..N {
        a[(N - 1, j)] = (0..N - 1).fold(Q::zero(), |sum, i| sum + &a[(i, j)]);
    }
    a
}

fn adjugate<const N: usize>(a: &SMatrix<Q, N, N>) -> SMatrix<Q, N, N> {
    let columns: [SVector<Q, N>; N] = core::array::from_fn(|j| {
        let unit = SVector::from_fn(|i, _| if i == j { Q::one() } else { Q::zero() });
        determinant_and_adjugate_product(a, &unit).0
    });
    SMatrix::from_fn(|i, j| columns[j][i].clone())
}

fn solutions_satisfy_their_equations<const N: usize>() {
    let mut rationals = Rationals::seeded(N as u64);
    for _ in 0..TRIALS {
        let (a, b) = (rationals.matrix::<N>(), rationals.matrix::<N>());
        match solve(a.clone(), b.clone()) {
            Some(x) => assert_eq!(product(&a, &x), b),
            None => assert!(determinant(a).is_zero()),
        }
    }
}

fn both_algorithms_agree<const N: usize>() {
    let mut rationals = Rationals::seeded(100 + N as u64);
    let mut solved = 0;
    for _ in 0..TRIALS {
        let (a, b) = (rationals.matrix::<N>(), rationals.vector::<N>());
        let (numerators, denominator) = determinant_and_adjugate_product(&a, &b);
        assert_eq!(denominator, determinant(a.clone()));
        if let Some(x) = solve(a, b) {
            assert_eq!(numerators, scaled(&denominator, &x));
            solved += 1;
        }
    }
    assert!(solved > TRIALS / 2, "{solved} of {TRIALS} matrices have an inverse");
}

fn the_adjugate_inverts_up_to_the_determinant<const N: usize>() {
    let mut rationals = Rationals::seeded(200 + N as u64);
    for trial in 0..TRIALS {
        let a = if trial % 2 == 0 { rationals.matrix::<N>() } else { singular(&mut rationals) };
        let d = determinant(a.clone());
        let expected = SMatrix::<Q, N, N>::from_fn(|i, j| if i == j { d.clone() } else { Q::zero() });
        let adjugate = adjugate(&a);
        assert_eq!(product(&a, &adjugate), expected);
        assert_eq!(product(&adjugate, &a), expected);
    }
}

#[test]
fn elimination_solves() {
    solutions_satisfy_their_equations::<1>();
    solutions_satisfy_their_equations::<2>();
    solutions_satisfy_their_equations::<3>();
    solutions_satisfy_their_equations::<6>();
}

#[test]
fn the_division_free_algorithm_agrees_with_elimination() {
    both_algorithms_agree::<1>();
    both_algorithms_agree::<2>();
    both_algorithms_agree::<3>();
    both_algorithms_agree::<4>();
    both_algorithms_agree::<6>();
}

#[test]
fn the_adjugate_is_right_for_singular_matrices_too() {
    the_adjugate_inverts_up_to_the_determinant::<2>();
    the_adjugate_inverts_up_to_the_determinant::<3>();
    the_adjugate_inverts_up_to_the_determinant::<5>();
}

#[test]
fn the_determinant_changes_sign_with_two_rows() {
    let mut rationals = Rationals::seeded(7);
    for _ in 0..TRIALS {
        let a = rationals.matrix::<4>();
        let mut swapped = a.clone();
        swapped.swap_rows(1, 3);
        assert_eq!(determinant(swapped), -determinant(a));
    }
}

#[test]
fn a_singular_matrix_has_no_solution_and_determinant_zero() {
    let mut rationals = Rationals::seeded(8);
    for _ in 0..TRIALS {
        let a = singular::<4>(&mut rationals);
        assert_eq!(determinant(a.clone()), Q::zero());
        assert_eq!(solve(a, rationals.vector::<4>()), None);
    }
}

#[test]
fn a_zero_in_the_corner_is_no_obstacle() {
    let a = SMatrix::<Q, 2, 2>::new(q(0, 1), q(2, 1), q(3, 1), q(5, 7));
    let b = SVector::<Q, 2>::new(q(4, 1), q(10, 7));
    assert_eq!(determinant(a.clone()), q(-6, 1));
    assert_eq!(solve(a, b), Some(SVector::<Q, 2>::new(q(0, 1), q(2, 1))));
}
