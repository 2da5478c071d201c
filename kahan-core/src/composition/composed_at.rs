//! A composition at a fixed ε.
//!
//! In: a map at its ε, and a composition. Out: steps that take a state only.

use nalgebra::SVector;

use crate::step::error::pole;
use crate::{FloatScalar, KahanAt, KahanMap, Room, Step};

use super::{Composed, Composition};

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// The composition of this map at its ε: a step of it takes the same time 2ε.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    /// use kahan_core::{Composition, Ensemble};
    ///
    /// kahan! {
    ///     /// Predator and prey.
    ///     pub struct LotkaVolterra;
    ///     xdot = x*(1 - y);
    ///     ydot = y*(x - 1);
    /// }
    ///
    /// let map = LotkaVolterra.at(0.05).composed(Composition::KAHAN_LI_8);
    /// let mut ponds = Ensemble::new(vec![vector![1.5, 1.0], vector![0.7, 0.7]]);
    /// ponds.advance(&map, 100);
    ///
    /// let alone = map.orbit(vector![1.5, 1.0]).nth(100).unwrap();
    /// assert!((ponds.point(0).unwrap() - alone).norm() < 1e-12);
    /// ```
    pub fn composed(&self, composition: Composition) -> KahanAt<M, T, N, Composed> {
        let (map, eps) = (self.map.clone(), self.eps);
        let stages = composition.stages_of(&eps, |eps| map.prepare(&eps));
        KahanAt { map, eps, stages }
    }
}

impl<M, T, const N: usize> KahanAt<M, T, N, Composed>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// The state one time step of 2ε later, by all stages in order; not finite where a stage meets
    /// a pole.
    #[inline]
    pub fn step(&self, x: &SVector<T, N>) -> SVector<T, N> {
        match Step::next(self, x, &mut Room::new()) {
            Some(next) => next,
            None => pole(&self.eps),
        }
    }
}
