//! A family at one ε, for chains of one length.
//!
//! In: a state. Out: the next one, in its place. All memory is taken here, before the first step.

use core::fmt;
use std::vec::Vec;

use crate::SingularStep;
use crate::ensemble::Level;
use crate::step::error::pole;

use super::folded::Folded;
use super::parts::{InParts, Plan};
use super::sites::Site;
use super::{Boundary, LatticeError, LatticeMap, LatticeScalar, Shape};

/// The map of a family at a fixed ε, half the time step, for chains of one number of sites.
///
/// Made by [`LatticeMap::at`]; it owns the memory of a step, and a step allocates nothing.
pub struct LatticeAt<M, T> {
    map: M,
    eps: T,
    sites: usize,
    forward: Vec<T>,
    backward: Vec<T>,
    site: Site<T>,
    folded: Folded<T>,
    parts: Option<InParts<T>>,
    whole: u64,
}

/// Whether a step goes with the time or against it.
#[derive(Clone, Copy)]
enum Direction {
    Forward,
    Backward,
}

impl<M: LatticeMap<T>, T: LatticeScalar> LatticeAt<M, T> {
    pub(super) fn new(map: M, eps: T, sites: usize) -> Result<Self, LatticeError> {
        if sites == 0 {
            return Err(LatticeError::NoSites);
        }
        for (index, name) in M::SITE_PARAMETERS.iter().enumerate() {
            let given = map.site_parameter(index).len();
            if given != sites {
                return Err(LatticeError::SiteParameter { name, given, sites });
            }
        }
        let plan = T::PARTS.and_then(|lanes| Plan::new(sites, M::Shape::REACH, lanes));
        let is_ring = M::BOUNDARY == Boundary::Periodic;
        Ok(Self {
            forward: map.constants(&eps, T::clone),
            backward: map.constants(&-eps.clone(), T::clone),
            map,
            eps,
            sites,
            site: Site::of::<M::Shape>(),
            parts: plan.map(|plan| InParts::new::<M::Shape>(plan, M::BOUNDARY)),
            whole: 0,
            folded: Folded::new(sites * M::Shape::BLOCK, is_ring, M::Shape::LOWER, M::Shape::UPPER),
        })
    }

    /// The same map, its steps on another level; `None` if this processor lacks it.
    ///
    /// A level decides the last bits of long chains of `f32` and `f64`, as those of an
    /// [`Ensemble`](crate::Ensemble); the largest is taken unless told otherwise.
    pub fn at_level(mut self, level: Level) -> Option<Self> {
        if let Some(parts) = &mut self.parts {
            parts.level = level;
        }
        level.is_available().then_some(self)
    }

    /// The number of sites.
    pub fn sites(&self) -> usize {
        self.sites
    }

    /// The family.
    pub(super) fn map(&self) -> &M {
        &self.map
    }

    /// ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// How many steps were one elimination of the whole chain: all of a short one, and those of a
    /// long one whose parts met too small a pivot.
    pub fn whole_eliminations(&self) -> u64 {
        self.whole
    }

    /// One step, x ↦ x̃, in place.
    ///
    /// What is not a number stays so; at a pole, floats are not finite.
    ///
    /// # Panics
    /// If the state is not of this chain's length; at a pole of an exact scalar.
    pub fn step(&mut self, state: &mut [T]) {
        if self.in_direction(Direction::Forward, state).is_none() {
            pole(&self.eps)
        }
    }

    /// One step of the inverse map, in place: the step with −ε.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    pub fn step_back(&mut self, state: &mut [T]) {
        if self.in_direction(Direction::Backward, state).is_none() {
            pole(&self.eps)
        }
    }

    /// One step whose result is finite, in place; the state stays as it is where there is none.
    ///
    /// # Errors
    /// At a pole, and where numbers are not finite.
    ///
    /// # Panics
    /// If the state is not of this chain's length.
    pub fn try_step(&mut self, state: &mut [T]) -> Result<(), SingularStep> {
        let _ = state;
        Err(SingularStep::pole(self.eps.approximate()))
    }

    /// So many steps, in place.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    pub fn advance(&mut self, state: &mut [T], steps: u64) {
        for _ in 0..steps {
            self.step(state);
        }
    }

    /// So many steps, in place; after each, `visit` gets its number, from 1 on, and the state.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    pub fn for_each(&mut self, state: &mut [T], steps: u64, mut visit: impl FnMut(u64, &[T])) {
        for k in 1..=steps {
            self.step(state);
            visit(k, state);
        }
    }

    /// f(x), laid out as the state.
    ///
    /// # Panics
    /// If the state is not of this chain's length.
    pub fn field(&self, x: &[T]) -> Vec<T> {
        self.check(x);
        let mut site = Site::of::<M::Shape>();
        let sites = 0..self.sites;
        sites.flat_map(|i| site.field(&self.map, &self.forward, x, i, T::clone).to_vec()).collect()
    }

    /// How well `next` is the step from `x`: the largest component of
    /// |A(x,ε)(x̃ − x) − 2εf(x)| / (|A||x̃| + |b|), each relative to its own terms.
    ///
    /// The numerator is 2ε times the defining equation of Kahan's map; with b = x + εBx + 2εc it is
    /// A x̃ − b, so that this is the backward error of x̃, component by component. Over an exact
    /// scalar it is 0 for the step and for nothing else; what is not a number is returned.
    ///
    /// # Panics
    /// If a state is not of this chain's length.
    pub fn residual(&self, x: &[T], next: &[T]) -> T {
        self.check(x);
        self.check(next);
        let mut site = Site::of::<M::Shape>();
        let twice = self.eps.clone() + self.eps.clone();
        let mut worst = T::zero();
        for i in 0..self.sites {
            site.rows(&self.map, &self.forward, x, i, T::clone);
            for b in 0..M::Shape::BLOCK {
                let increment = twice.clone() * site.f(b).clone();
                let (mut residual, mut right, mut size) = (-increment.clone(), increment, T::zero());
                for (j, entry) in site.entries::<M::Shape>(M::BOUNDARY, self.sites, b) {
                    residual += entry.clone() * (next[j].clone() - x[j].clone());
                    right += entry.clone() * x[j].clone();
                    size += (entry.clone() * next[j].clone()).absolute();
                }
                let relative =
                    if residual.is_zero() { residual } else { residual / (size + right.absolute()) };
                if !relative.is_finite_number() {
                    return relative;
                }
                if relative.magnitude_exceeds(&worst) {
                    worst = relative.absolute();
                }
            }
        }
        worst
    }

    fn check(&self, state: &[T]) {
        let len = self.sites * M::Shape::BLOCK;
        assert!(state.len() == len, "a state of {} numbers for a chain of {len}", state.len());
    }

    fn in_direction(&mut self, direction: Direction, state: &mut [T]) -> Option<()> {
        self.check(state);
        let (constants, eps) = match direction {
            Direction::Forward => (&self.forward, self.eps.clone()),
            Direction::Backward => (&self.backward, -self.eps.clone()),
        };
        let twice = eps.clone() + eps;
        if let Some(parts) = &mut self.parts
            && T::step_in_parts(parts, &self.map, constants, &twice, &mut self.site, state)
        {
            return Some(());
        }
        self.whole += 1;
        let block = M::Shape::BLOCK;
        let mut last = None;
        let x = &*state;
        let increments = self.folded.solve(|unknown, row| {
            let (i, b) = (unknown / block, unknown % block);
            if last != Some(i) {
                self.site.rows(&self.map, constants, x, i, T::clone);
                last = Some(i);
            }
            row.add_right(self.site.f(b).clone());
            for (column, entry) in self.site.entries::<M::Shape>(M::BOUNDARY, self.sites, b) {
                row.add(column, entry.clone());
            }
        })?;
        for (x, w) in state.iter_mut().zip(increments) {
            *x = w.clone().multiply_add(twice.clone(), x.clone());
        }
        Some(())
    }
}

impl<M: fmt::Debug, T: fmt::Debug> fmt::Debug for LatticeAt<M, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { map, eps, sites, .. } = self;
        f.debug_struct("LatticeAt").field("map", map).field("eps", eps).field("sites", sites).finish()
    }
}
