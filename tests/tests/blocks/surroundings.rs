//! Tests that blocks in hostile surroundings compile without warnings and keep their meaning.
//! `user_crate.rs` covers other editions, `no_std` and renamed dependencies.

#![deny(warnings, missing_docs, unused, clippy::pedantic)]

mod blocks_in_bodies;
mod conditional;
mod drifts;
mod headers;
mod included;
mod items_in_scope;
mod names_in_blocks;
mod within_macros;
mod without_prelude;

use kahan_core::prelude::*;

fn ratio(p: i64, q: i64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

/// Asserts the defining equation of Kahan's map for a step. Returns the start and the end.
fn assert_kahan<M, const N: usize>(map: &M) -> (SVector<BigRational, N>, SVector<BigRational, N>)
where
    M: KahanMap<BigRational, N>,
{
    let eps = ratio(2, 7);
    let x = SVector::<BigRational, N>::from_fn(|i, _| ratio(i64::try_from(3 * i).unwrap() + 2, 5));
    let next = map.step(&x, eps.clone());
    let increment = map.polarized(&x, &next).map(|entry| entry * ratio(4, 7));
    assert_eq!(next.clone() - x.clone(), increment);
    assert_ne!(next, x);
    assert_eq!(map.step_back(&next, eps.clone()), x);
    let unit = map.jacobian(&x, eps.clone()).determinant_by_rows();
    assert_eq!(unit, map.det_jacobian(&x, eps));
    (x, next)
}

trait DeterminantByRows {
    fn determinant_by_rows(&self) -> BigRational;
}

impl<const N: usize> DeterminantByRows for SMatrix<BigRational, N, N> {
    fn determinant_by_rows(&self) -> BigRational {
        fn minor<const N: usize>(
            matrix: &SMatrix<BigRational, N, N>,
            row: usize,
            columns: &[usize],
        ) -> BigRational {
            let term = |(k, &column): (usize, &usize)| {
                let rest: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
                let product = matrix[(row, column)].clone() * minor(matrix, row + 1, &rest);
                if k % 2 == 0 { product } else { -product }
            };
            if columns.is_empty() { ratio(1, 1) } else { columns.iter().enumerate().map(term).sum() }
        }
        minor(self, 0, &(0..N).collect::<Vec<usize>>())
    }
}
