//! Several Lyapunov exponents at once.

use std::vec::Vec;

use num_traits::One;

use crate::{Constant, FloatScalar, Scalar, StateVector};

use super::carried::{carry_all, state_from_entries};
use super::growth::{Size, dot, scale, square};
use super::lyapunov::Doublings;
use super::{Exponent, Observer, TangentMap};

/// An observer of the k largest Lyapunov exponents, per unit of time, in descending order.
///
/// Every m steps the observer makes each of k tangent vectors orthogonal to the vectors before it
/// (QR decomposition; G. Benettin, L. Galgani, A. Giorgilli, J.-M. Strelcyn, Meccanica 15 (1980)
/// 9). The growth rate of the orthogonal component of vector j tends to the j-th largest exponent.
/// The report sorts the rates, because short runs may give another order. With as many vectors as
/// variables, the exponents sum to [`MeanLogDet`](super::MeanLogDet), up to rounding.
///
/// A step costs k tangent vectors, and every m-th step about k² inner products.
#[derive(Clone, Debug)]
pub struct Spectrum<M: TangentMap> {
    map: M,
    place: M::State,
    directions: Vec<GrowingVector<M::State>>,
    every: u64,
    until: u64,
    turns: u64,
    steps: u64,
}

#[derive(Clone, Debug)]
struct GrowingVector<P> {
    vector: P,
    /// The squared length of the vector after the last orthogonalisation.
    squared: f64,
    /// The growth factor of the squared length from the start to the last orthogonalisation.
    growth: Size,
    doublings: Doublings,
}

impl<M: TangentMap> Spectrum<M> {
    /// Creates an observer of the `k` largest exponents of a prepared map.
    ///
    /// Vectors are orthogonalised every `every` steps. Between two orthogonalisations, no vector
    /// may grow relative to another by a factor above 1/u, where u is the rounding unit.
    ///
    /// # Panics
    /// If there are fewer variables than `k`, or `every` is 0.
    pub fn new(map: M, k: usize, every: u64) -> Self {
        let variables = map.dimension();
        assert!(k <= variables && every > 0, "{k} exponents in {variables} variables, every {every} steps");
        // With fewer vectors than variables, the initial vectors must not lie in coordinate planes,
        // which are often invariant.
        let off_axis = if k < variables { 1 } else { 0 };
        let entry = |j: usize, i: usize| {
            let skew = Constant::ratio(off_axis * ((29 * i + 17 * j + 5) % 32) as i64, 64);
            if i == j { M::Scalar::one() } else { M::Scalar::constant(&skew) }
        };
        let direction = |j: usize| {
            let vector = state_from_entries(&map, |i| entry(j, i));
            GrowingVector { vector, squared: 1.0, growth: Size::ONE, doublings: Doublings::default() }
        };
        let mut directions: Vec<_> = (0..k).map(direction).collect();
        make_orthogonal(&mut directions);
        for direction in &mut directions {
            direction.growth = Size::ONE;
        }
        let place = M::State::zeros(variables);
        Self { map, place, directions, every, until: every, turns: 0, steps: 0 }
    }
}

impl<M: TangentMap<Scalar = T>, T: FloatScalar> Observer<T> for Spectrum<M> {
    type Report = Vec<Exponent>;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        if step > 0 {
            let vectors = self.directions.iter_mut().map(|direction| &mut direction.vector);
            carry_all(&self.map, self.place.as_slice(), x, vectors);
            self.steps = step;
            self.until -= 1;
            if self.until == 0 {
                (self.until, self.turns) = (self.every, self.turns + 1);
                make_orthogonal(&mut self.directions);
                if self.turns.is_power_of_two() {
                    for GrowingVector { growth, doublings, .. } in &mut self.directions {
                        doublings.pass(step, *growth);
                    }
                }
            }
        }
        self.place.as_mut_slice().copy_from_slice(x);
    }

    fn report(mut self) -> Vec<Exponent> {
        make_orthogonal(&mut self.directions);
        let time = 2.0 * self.map.eps().approximate();
        let exponent = |direction: &GrowingVector<_>| {
            direction.doublings.exponent(Size::ONE, (self.steps, direction.growth), time)
        };
        let mut exponents: Vec<_> = self.directions.iter().map(exponent).collect();
        exponents.sort_by(|one, other| other.value.total_cmp(&one.value));
        exponents
    }
}

fn make_orthogonal<P, T>(directions: &mut [GrowingVector<P>])
where
    P: StateVector<T>,
    T: FloatScalar,
{
    for j in 0..directions.len() {
        let (before, rest) = directions.split_at_mut(j);
        let Some(GrowingVector { vector, squared, growth, .. }) = rest.first_mut() else { return };
        for axis in before.iter().map(|direction| direction.vector.as_slice()) {
            let along = dot(axis, vector.as_slice()) / dot(axis, axis);
            for (entry, axis) in vector.as_mut_slice().iter_mut().zip(axis) {
                *entry -= along * *axis;
            }
        }
        let now = scale(vector, &mut 0);
        growth.multiply(now);
        growth.multiply(Size::of(1.0 / *squared));
        *squared = square(vector.as_slice());
    }
}
