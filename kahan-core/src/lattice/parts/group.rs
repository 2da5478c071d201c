//! The parts of a group, gathered from the state into SIMD lanes and scattered back.
//!
//! The sites of each part are stored in order, one register per array. With the reach R, they are
//! stored together with the R sites before the part and the 2R sites after it.

use crate::ensemble::Level;
use crate::ensemble::lanes::{InLanes, Lanes, OverLanes};
use crate::lattice::sites::neighbour;
use crate::lattice::{LatticeMap, LatticeScalar};

/// Consecutive parts of equal length, one in each lane.
#[derive(Clone, Copy)]
pub(super) struct PartGroup {
    /// The first site of the separator of the first part.
    pub(super) start: usize,
    /// The number of sites of each part, including its separator.
    pub(super) length: usize,
    pub(super) width: usize,
}

impl PartGroup {
    /// Gathers states and parameters, from R sites before the left separator to R sites after the
    /// right separator. R is the family's reach.
    pub(super) fn gather<M: LatticeMap<T>, T: LatticeScalar + InLanes>(
        self,
        map: &M,
        state: &[T],
        x: &mut [T],
        c: &mut [T],
        level: Level,
    ) {
        let (block, reach) = (map.sizes().block, map.sizes().reach);
        let sites = state.len() / block;
        let number = |site: usize, b: usize| state[site * block + b];
        self.gather_edges(map, sites, block, block, x, number);
        let inner = &mut x[reach * block * self.width..];
        self.gather_inner(state, block, 1, self.length, inner, level);
        self.gather_parameters(map, sites, c, level);
    }

    pub(super) fn gather_parameters<M: LatticeMap<T>, T: LatticeScalar + InLanes>(
        self,
        map: &M,
        sites: usize,
        c: &mut [T],
        level: Level,
    ) {
        let (reach, parameters) = (map.sizes().reach, map.sizes().parameters);
        for p in 0..parameters {
            let (values, c) = (map.site_parameter(p), &mut c[p * self.width..]);
            self.gather_edges(map, sites, 1, parameters, c, |site, _| values[site]);
            let inner = &mut c[reach * parameters * self.width..];
            self.gather_inner(values, 1, parameters, self.length, inner, level);
        }
    }

    /// Gathers states or parameters of the R sites before and the 2R sites after each part, where R
    /// is the reach. A site has `block` numbers, and sites are `stride` registers apart.
    fn gather_edges<M, T>(
        self,
        map: &M,
        sites: usize,
        block: usize,
        stride: usize,
        lanes: &mut [T],
        number: impl Fn(usize, usize) -> T,
    ) where
        T: LatticeScalar + Copy,
        M: LatticeMap<T>,
    {
        let (reach, length) = (map.sizes().reach as isize, self.length as isize);
        // Only these sites may lie beyond the end of a ring and wrap around.
        for site in (-reach..0).chain(length..length + 2 * reach) {
            for b in 0..block {
                let place = ((site + reach) as usize * stride + b) * self.width;
                for (k, lane) in lanes[place..][..self.width].iter_mut().enumerate() {
                    let chain = (self.start + k * self.length) as isize + site;
                    let seen = neighbour(map.boundary(), sites, 0, chain);
                    *lane = seen.map_or_else(T::zero, |site| number(site, b));
                }
            }
        }
    }

    /// Gathers the first `sites` sites of each part. Adjacent sites are `stride` registers apart.
    /// The slice `chain` starts at the first site of the first part.
    pub(super) fn gather_inner<T: InLanes>(
        self,
        chain: &[T],
        block: usize,
        stride: usize,
        sites: usize,
        lanes: &mut [T],
        level: Level,
    ) {
        let from = StridedRows { numbers: &chain[self.start * block..], stride: self.length * block };
        let to = StridedRows { numbers: lanes, stride: stride * self.width };
        T::run(Transposed { rows: self.width, columns: sites * block, from, to }, level);
    }

    pub(super) fn scatter_inner<T: InLanes>(
        self,
        chain: &mut [T],
        block: usize,
        from: usize,
        lanes: &[T],
        level: Level,
    ) {
        let rows = (self.length - from) * block;
        let from = (self.start + from) * block;
        let to = StridedRows { numbers: &mut chain[from..], stride: self.length * block };
        let from = StridedRows { numbers: lanes, stride: self.width };
        T::run(Transposed { rows, columns: self.width, from, to }, level);
    }
}

struct StridedRows<N> {
    numbers: N,
    stride: usize,
}

struct Transposed<'a, T> {
    rows: usize,
    columns: usize,
    from: StridedRows<&'a [T]>,
    to: StridedRows<&'a mut [T]>,
}

const SIDE: usize = 4;

#[expect(
    clippy::needless_range_loop,
    clippy::manual_memcpy,
    reason = "loops of a length that is known are unrolled, and slices are copied by calls"
)]
impl<T: InLanes> OverLanes<T> for Transposed<'_, T> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let Transposed { rows, columns, from, to } = self;
        let [rows_in_squares, columns_in_squares] = [rows - rows % SIDE, columns - columns % SIDE];
        for row in 0..rows_in_squares / SIDE {
            for column in 0..columns_in_squares / SIDE {
                let (row, column) = (row * SIDE, column * SIDE);
                let mut square = [[from.numbers[0]; SIDE]; SIDE];
                for r in 0..SIDE {
                    let numbers = &from.numbers[(row + r) * from.stride + column..][..SIDE];
                    for c in 0..SIDE {
                        square[r][c] = numbers[c];
                    }
                }
                let square = L::transposed(square);
                for c in 0..SIDE {
                    let numbers = &mut to.numbers[(column + c) * to.stride + row..][..SIDE];
                    for r in 0..SIDE {
                        numbers[r] = square[c][r];
                    }
                }
            }
        }
        for row in 0..rows {
            let first = if row < rows_in_squares { columns_in_squares } else { 0 };
            for column in first..columns {
                to.numbers[column * to.stride + row] = from.numbers[row * from.stride + column];
            }
        }
    }
}
