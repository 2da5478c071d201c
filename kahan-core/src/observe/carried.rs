//! Tangent vectors that follow an orbit.
//!
//! In: the points of the orbit, one after another. Out: K vectors, each at the point given last and
//! scaled by a power of two.

use crate::{Constant, FloatScalar};

use super::Tangent;
use super::growth::{Size, scale};

/// K tangent vectors that a map carries along.
#[derive(Clone, Debug)]
pub(super) struct Carried<M: Tangent<T>, T, const K: usize> {
    map: M,
    /// Where the vectors are.
    place: M::Point,
    vectors: [M::Point; K],
    /// Vector k stands for itself times 2 to this power.
    exponents: [i64; K],
}

impl<M: Tangent<T>, T: FloatScalar, const K: usize> Carried<M, T, K> {
    /// Vectors in directions that nothing prefers.
    pub(super) fn new(map: M) -> Self {
        let vectors = core::array::from_fn(|k| map.point(|i| any_direction(k, i)));
        Self { place: map.point(|_| T::zero()), vectors, exponents: [0; K], map }
    }

    /// To the next point, and the squares of the vectors' lengths there.
    #[inline(always)]
    pub(super) fn follow(&mut self, step: u64, x: &[T]) -> [Size; K] {
        if step > 0 {
            for vector in &mut self.vectors {
                self.map.carry(self.place.as_ref(), vector);
            }
        }
        self.place.as_mut().copy_from_slice(x);
        core::array::from_fn(|k| scale(self.vectors[k].as_mut(), &mut self.exponents[k]))
    }

    /// The vectors, each up to a power of two.
    pub(super) fn vectors(&self) -> [&[T]; K] {
        self.vectors.each_ref().map(M::Point::as_ref)
    }

    /// The time of one step.
    pub(super) fn time_step(&self) -> f64 {
        2.0 * self.map.half_step()
    }
}

/// Entry i of vector k: 64ths from 1/64 to 1, in no order that a field would have.
fn any_direction<T: FloatScalar>(k: usize, i: usize) -> T {
    T::constant(&Constant::ratio(((37 * i + 23 * k * (i + 1) + 11) % 64 + 1) as i64, 64))
}
