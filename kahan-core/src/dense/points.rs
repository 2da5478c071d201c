//! Elimination for several points at once, with one point per lane.
//!
//! The result for each point has the bits of the elimination of a single point.

use core::marker::PhantomData;

use crate::Level;
use crate::ensemble::lanes::{InLanes, Lanes, OverLanes};

use super::{COLUMNS_TOGETHER, Loops, Workspace, minus_product};

/// Returns the number of points that [`velocities`] takes, one per lane of a 512-bit register.
#[must_use]
pub const fn points<T: InLanes>() -> usize {
    T::MOST
}

/// Replaces x by A(x,ε)⁻¹f(x) for [`points`] vectors x. Entry i of point p has the index
/// i·[`points`] + p. The result of point p is unreliable if |`growth[p]`| exceeds
/// [`LARGEST_FACTOR`](crate::__private::LARGEST_FACTOR). Zero pivots give infinities or NaNs.
pub fn velocities<T: InLanes>(
    packed: &[T],
    x: &mut [T],
    eps: T,
    growth: &mut [T],
    workspace: &mut Workspace<T>,
) {
    let n = x.len() / points::<T>();
    workspace.columns.resize(n * (n + 1) * points::<T>(), T::zero());
    workspace.factors.resize(2 * n * points::<T>(), T::zero());
    T::run(PointsWork { packed, x, eps, growth, workspace }, Level::best());
}

struct PointsWork<'a, T> {
    packed: &'a [T],
    x: &'a mut [T],
    eps: T,
    growth: &'a mut [T],
    workspace: &'a mut Workspace<T>,
}

impl<T: InLanes> OverLanes<T> for PointsWork<'_, T> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let PointsWork { packed, x, eps, growth, workspace: Workspace { columns, factors, .. } } = self;
        let variables = x.len() / points::<T>();
        let loops = Loops::<T, L, true> { variables, height: variables, lanes: PhantomData };
        for part in 0..points::<T>() / L::WIDTH {
            let part = part * L::WIDTH;
            for i in 0..variables {
                L::load(x, i * points::<T>() + part).store(factors, i * L::WIDTH);
            }
            loops.assemble(packed, factors, eps, columns);
            loops.eliminate_points(columns, factors).store(growth, part);
            for i in 0..variables {
                L::load(columns, loops.at(i, variables)).store(x, i * points::<T>() + part);
            }
        }
    }
}

impl<T: InLanes, L: Lanes<T>> Loops<T, L, true> {
    /// Solves the linear system whose right-hand side is the last column, replaces this column by
    /// the solution, and returns the growth. For a pivot p, let r be the largest |entry| to the
    /// right of p in its row, and c the largest |entry| below p. The growth is the maximum of
    /// min(r, c)/|p| over all pivots. `sizes` is memory for two numbers per variable.
    #[inline(always)]
    fn eliminate_points(self, columns: &mut [T], sizes: &mut [T]) -> L {
        let (n, zero) = (self.variables, L::spread(&T::zero()));
        let larger = |a: L, b: L| L::choose(b.exceeds(a), b, a);
        let (of_rows, of_factors) = sizes.split_at_mut(n * L::WIDTH);
        for i in 0..n {
            zero.store(of_rows, i * L::WIDTH);
        }
        for j in 0..=n {
            for block in 0..n / COLUMNS_TOGETHER {
                self.reduce_rows::<COLUMNS_TOGETHER>(columns, block * COLUMNS_TOGETHER, j);
            }
            for row in n - n % COLUMNS_TOGETHER..n {
                self.reduce_rows::<1>(columns, row, j);
            }
            if j == n {
                break;
            }
            for k in 0..j {
                let largest = larger(L::load(of_rows, k * L::WIDTH), L::load(columns, self.at(k, j)));
                largest.store(of_rows, k * L::WIDTH);
            }
            let Some(reciprocal) = L::load(columns, self.at(j, j)).reciprocal() else { continue };
            reciprocal.store(columns, self.at(j, j));
            let mut largest = zero;
            for i in j + 1..n {
                let factor = L::load(columns, self.at(i, j)) * reciprocal;
                largest = larger(largest, factor);
                factor.store(columns, self.at(i, j));
            }
            largest.store(of_factors, j * L::WIDTH);
        }
        let mut growth = zero;
        for k in 0..n {
            let quotient = L::load(of_rows, k * L::WIDTH) * L::load(columns, self.at(k, k));
            let factor = L::load(of_factors, k * L::WIDTH);
            growth = larger(growth, L::choose(factor.exceeds(quotient), quotient, factor));
        }
        for k in (0..n).rev() {
            let value = L::load(columns, self.at(k, n)) * L::load(columns, self.at(k, k));
            value.store(columns, self.at(k, n));
            for i in 0..k {
                let reduced =
                    minus_product(L::load(columns, self.at(i, n)), L::load(columns, self.at(i, k)), value);
                reduced.store(columns, self.at(i, n));
            }
        }
        growth
    }

    /// Subtracts multiples of earlier pivot rows from W entries of column j, from row `first` on.
    #[inline(always)]
    #[expect(clippy::needless_range_loop, reason = "what is no plain range is not always inlined")]
    fn reduce_rows<const W: usize>(self, columns: &mut [T], first: usize, j: usize) {
        let mut own = [L::spread(&T::zero()); W];
        for w in 0..W {
            own[w] = L::load(columns, self.at(first + w, j));
        }
        for k in 0..first.min(j) {
            let upper = L::load(columns, self.at(k, j));
            for w in 0..W {
                own[w] = minus_product(own[w], L::load(columns, self.at(first + w, k)), upper);
            }
        }
        for w in 0..W.min(j.saturating_sub(first)) {
            let upper = own[w];
            for v in w + 1..W {
                own[v] = minus_product(own[v], L::load(columns, self.at(first + v, first + w)), upper);
            }
        }
        for w in 0..W {
            own[w].store(columns, self.at(first + w, j));
        }
    }
}
