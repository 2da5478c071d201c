//! Linear algebra on small matrices over any scalar.
//!
//! [`solve`] and [`determinant`] use partial pivoting. [`determinant_and_adjugate_product`] only
//! adds and multiplies, and therefore has no poles. Only operations of the scalar may allocate.

use core::array::from_fn;

use nalgebra::{ArrayStorage, SMatrix, SVector};

use crate::Scalar;

/// Solves A·X = B. If A is singular, floats become infinite or NaN, and exact scalars give `None`.
pub fn solve<T: Scalar, const N: usize, const M: usize>(
    mut a: SMatrix<T, N, N>,
    mut b: SMatrix<T, N, M>,
) -> Option<SMatrix<T, N, M>> {
    solve_in_place(&mut a, &mut b)?;
    Some(b)
}

/// Solves A·X = B in place of B, and overwrites A.
#[inline(always)]
pub(crate) fn solve_in_place<T: Scalar, const N: usize, const M: usize>(
    a: &mut SMatrix<T, N, N>,
    b: &mut SMatrix<T, N, M>,
) -> Option<()> {
    for k in 0..N {
        let row = pivot_row(a, k);
        a.swap_rows(k, row);
        b.swap_rows(k, row);
        let reciprocal = a[(k, k)].reciprocal()?;
        for i in k + 1..N {
            let factor = a[(i, k)].clone() * reciprocal.clone();
            subtract_row(a, i, k, k + 1, &factor);
            subtract_row(b, i, k, 0, &factor);
        }
        a[(k, k)] = reciprocal;
    }
    for k in (0..N).rev() {
        for j in 0..M {
            let mut entry = b[(k, j)].clone();
            for i in k + 1..N {
                entry -= a[(k, i)].clone() * b[(i, j)].clone();
            }
            b[(k, j)] = entry * a[(k, k)].clone();
        }
    }
    Some(())
}

/// Returns det A, which is 0 for a singular matrix over every scalar.
pub fn determinant<T: Scalar, const N: usize>(mut a: SMatrix<T, N, N>) -> T {
    eliminated_determinant(&mut a)
}

#[inline(always)]
pub(crate) fn eliminated_determinant<T: Scalar, const N: usize>(a: &mut SMatrix<T, N, N>) -> T {
    let mut determinant = T::one();
    for k in 0..N {
        // If A contains a NaN, a zero pivot does not prove that A is singular. Therefore all
        // entries of the column are tested.
        if (k..N).all(|i| a[(i, k)].is_zero()) {
            return T::zero();
        }
        let row = pivot_row(a, k);
        if row != k {
            a.swap_rows(k, row);
            determinant = -determinant;
        }
        determinant *= a[(k, k)].clone();
        if k + 1 < N {
            let Some(reciprocal) = a[(k, k)].reciprocal() else { return T::zero() };
            for i in k + 1..N {
                let factor = a[(i, k)].clone() * reciprocal.clone();
                subtract_row(a, i, k, k + 1, &factor);
            }
        }
    }
    determinant
}

/// Returns (adj(A)·b, det A) without a division.
///
/// With C = I − A and its characteristic polynomial χ(λ) = λᴺ + c₁λᴺ⁻¹ + … + c_N,
///
///   det A = χ(1),  adj(A)·b = Σ_{k<N} v_k with v₀ = b and v_k = C·v_{k−1} + c_k·b.
///
/// For Kahan's matrix A = I − εf′, C = εf′ is of order ε. Therefore the sum has no cancellation for
/// small ε. The cost is O(N⁴) operations.
pub fn determinant_and_adjugate_product<T: Scalar, const N: usize>(
    a: &SMatrix<T, N, N>,
    b: &SVector<T, N>,
) -> (SVector<T, N>, T) {
    let c = SMatrix::<T, N, N>::from_fn(|i, j| {
        let entry = -a[(i, j)].clone();
        if i == j { T::one() + entry } else { entry }
    });
    let coefficients = characteristic_coefficients(&c);

    let mut power = b.clone();
    let mut product = b.clone();
    for coefficient in coefficients.iter().take(N.saturating_sub(1)) {
        power = SVector::from_fn(|i, _| {
            let mut entry = coefficient.clone() * b[i].clone();
            for j in 0..N {
                entry += c[(i, j)].clone() * power[j].clone();
            }
            entry
        });
        for i in 0..N {
            product[i] += power[i].clone();
        }
    }
    let determinant = coefficients.into_iter().fold(T::one(), |sum, coefficient| sum + coefficient);
    (product, determinant)
}

/// Returns the coefficients c₁ … c_N of det(λI − C) = λᴺ + c₁λᴺ⁻¹ + … + c_N, by the
/// Samuelson–Berkowitz algorithm (S. J. Berkowitz, Inf. Process. Lett. 18 (1984) 147–150).
fn characteristic_coefficients<T: Scalar, const N: usize>(c: &SMatrix<T, N, N>) -> [T; N] {
    let mut coefficients: [T; N] = from_fn(|_| T::zero());
    for m in 0..N {
        let toeplitz = toeplitz_column(c, m);
        let old = coefficients;
        coefficients = from_fn(|k| {
            if k > m {
                return T::zero();
            }
            let mut entry = toeplitz[k].clone();
            if k < m {
                entry += old[k].clone();
            }
            for j in 0..k {
                entry += toeplitz[k - 1 - j].clone() * old[j].clone();
            }
            entry
        });
    }
    coefficients
}

/// Let the leading block of size m + 1 of `c` be [[C_m, s], [r, d]]. Returns column 0 of the m-th
/// Toeplitz matrix without its leading 1: −d, −r·s, −r·C_m·s, …, −r·C_m^(m−1)·s, then zeros.
fn toeplitz_column<T: Scalar, const N: usize>(c: &SMatrix<T, N, N>, m: usize) -> [T; N] {
    let mut power: [T; N] = from_fn(|i| if i < m { c[(i, m)].clone() } else { T::zero() });
    from_fn(|k| {
        if k > m {
            return T::zero();
        }
        if k == 0 {
            return -c[(m, m)].clone();
        }
        if k > 1 {
            let next = from_fn(|i| if i < m { row_times(c, i, m, &power) } else { T::zero() });
            power = next;
        }
        -row_times(c, m, m, &power)
    })
}

fn row_times<T: Scalar, const N: usize>(c: &SMatrix<T, N, N>, i: usize, m: usize, v: &[T; N]) -> T {
    let mut sum = T::zero();
    for j in 0..m {
        sum += c[(i, j)].clone() * v[j].clone();
    }
    sum
}

/// Returns the first row with the best pivot in column k, from row k on; see `is_better_pivot`.
fn pivot_row<T: Scalar, const N: usize>(a: &SMatrix<T, N, N>, k: usize) -> usize {
    (k + 1..N).fold(k, |best, i| if a[(i, k)].is_better_pivot(&a[(best, k)]) { i } else { best })
}

fn subtract_row<T: Scalar, const N: usize, const M: usize>(
    a: &mut SMatrix<T, N, M>,
    i: usize,
    k: usize,
    from: usize,
    factor: &T,
) {
    for j in from..M {
        let product = factor.clone() * a[(k, j)].clone();
        a[(i, j)] -= product;
    }
}

#[inline]
pub(crate) fn increment_by_elimination<T: Scalar, const N: usize>(
    matrix: SMatrix<T, N, N>,
    field: SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    let velocity = solve(matrix, field)?;
    let dt = eps.clone() + eps.clone();
    Some(SVector::from_fn(|i, _| dt.clone() * velocity[i].clone()))
}

/// Returns a vector with these entries.
#[inline(always)]
pub fn vector<T, const N: usize>(entries: [T; N]) -> SVector<T, N> {
    SVector::from_array_storage(ArrayStorage([entries]))
}

/// Returns the entries of a vector as an array.
#[inline(always)]
pub fn components<T, const N: usize>(vector: &SVector<T, N>) -> &[T; N] {
    let [entries] = &vector.data.0;
    entries
}
