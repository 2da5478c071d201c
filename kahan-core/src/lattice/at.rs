//! A family at one ε, for chains of one length.
//!
//! In: a state. Out: the next one, in its place. All memory is taken here, before the first step.

use core::fmt;
use std::vec::Vec;

use crate::SingularStep;
use crate::ensemble::Level;
use crate::scalar::Room;
use crate::step::error::{Reason, pole};

use super::folded::Folded;
use super::parts::{InParts, Plan};
use super::promise::{Promise, REFINEMENTS};
use super::scalar::Eliminated;
use super::sites::Site;
use super::{Boundary, LatticeError, LatticeMap, LatticeScalar, Shape};

/// The map of a family at a fixed ε, half the time step, for chains of one number of sites.
///
/// Made by [`LatticeMap::at`]; it owns the memory of a step, and a step allocates nothing.
pub struct LatticeAt<M, T: LatticeScalar> {
    map: M,
    eps: T,
    sites: usize,
    forward: Vec<T>,
    backward: Vec<T>,
    site: Site<T>,
    folded: Folded<T>,
    parts: Option<InParts<T>>,
    whole_eliminations: u64,
    promise: Promise<T>,
}

/// Whether a step goes with the time or against it.
#[derive(Clone, Copy)]
enum Direction {
    Forward,
    Backward,
}

impl<M: LatticeMap<T>, T: LatticeScalar> LatticeAt<M, T> {
    pub(super) fn new(map: M, eps: T, sites: usize) -> Result<Self, LatticeError> {
        let plan = T::PARTS.and_then(|lanes| Plan::new(sites, M::Shape::REACH, lanes));
        Self::planned(map, eps, sites, plan)
    }

    /// The same, cut as planned or not at all.
    pub(super) fn planned(map: M, eps: T, sites: usize, plan: Option<Plan>) -> Result<Self, LatticeError> {
        if sites == 0 {
            return Err(LatticeError::NoSites);
        }
        for (index, name) in M::SITE_PARAMETERS.iter().enumerate() {
            let given = map.site_parameter(index).len();
            if given != sites {
                return Err(LatticeError::SiteParameter { name, given, sites });
            }
        }
        let constants = |eps| map.constants(eps, T::clone).ok_or(LatticeError::Undefined);
        let (forward, backward) = (constants(eps.clone())?, constants(-eps.clone())?);
        let promise = Promise::new(&map, &eps, sites * M::Shape::BLOCK);
        // What is beyond the range of these numbers alone does not hinder a step with a promise.
        if !(forward.iter().all(T::is_finite_number) || promise.has_equations()) {
            return Err(LatticeError::Undefined);
        }
        let is_ring = M::BOUNDARY == Boundary::Periodic;
        // A chain in parts is eliminated as a whole where a part meets too small a pivot.
        let folded = if plan.is_some() { Folded::rarely } else { Folded::new };
        Ok(Self {
            forward,
            backward,
            promise,
            map,
            eps,
            sites,
            site: Site::of::<M::Shape>(),
            folded: folded(sites * M::Shape::BLOCK, is_ring, M::Shape::LOWER, M::Shape::UPPER),
            parts: plan.map(|plan| InParts::new::<M::Shape>(plan, M::BOUNDARY)),
            whole_eliminations: 0,
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
        self.whole_eliminations
    }

    /// One step, x ↦ x̃, in place.
    ///
    /// What is not a number stays so; at a pole, floats are not finite.
    ///
    /// # Panics
    /// If the state is not of this chain's length; at a pole of an exact scalar.
    #[track_caller]
    pub fn step(&mut self, state: &mut [T]) {
        if self.in_direction(Direction::Forward, state).is_none() {
            pole(&self.eps)
        }
    }

    /// One step of the inverse map, in place: the step with −ε.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    #[track_caller]
    pub fn step_back(&mut self, state: &mut [T]) {
        if self.in_direction(Direction::Backward, state).is_none() {
            pole(&self.eps)
        }
    }

    /// One step with a promise, in place; the state stays as it is where there is none.
    ///
    /// `Ok` says of x̃, for this very call, that |A·x̃ − b|ᵢ ≤ (k + 8)·u·(|A|·|x̃| + |b|)ᵢ for
    /// every unknown i: A(x,ε) and b(x,ε) = x + εBx + 2εc are exact at the floats as given, and k
    /// is the number of entries in the row of A. An exact scalar's step is exact.
    ///
    /// # Errors
    /// At a pole, where x̃ is not finite or leaves the range, and where neither two refinements
    /// nor, in chains of up to 4096 numbers, an elimination over many digits keeps the promise.
    /// That elimination allocates.
    ///
    /// # Panics
    /// If the state is not of this chain's length.
    #[track_caller]
    pub fn try_step(&mut self, state: &mut [T]) -> Result<(), SingularStep> {
        self.check(state);
        self.promise.before.clone_from_slice(state);
        let tried = self.promised(state);
        if tried.is_err() {
            state.clone_from_slice(&self.promise.before);
        }
        tried
    }

    fn promised(&mut self, state: &mut [T]) -> Result<(), SingularStep> {
        let eps = self.eps.approximate();
        let failed = |reason, bound| Err(SingularStep::because(reason, f64::NAN, bound, eps));
        if !state.iter().all(T::is_finite_number) {
            return failed(Reason::NotFinite, f64::INFINITY);
        }
        if self.in_direction(Direction::Forward, state).is_none() {
            return Err(SingularStep::pole(eps));
        }
        if T::UNIT == 0.0 {
            return Ok(());
        }
        let mut least = f64::INFINITY;
        for turn in 0..=REFINEMENTS {
            let is_finite = state.iter().all(T::is_finite_number);
            let bound = if is_finite { self.promise.bound(&self.map, state) } else { f64::INFINITY };
            if bound <= 1.0 {
                return Ok(());
            }
            least = bound.min(least);
            if turn < REFINEMENTS {
                // What is not finite is begun again, from x̃ = x.
                if !is_finite {
                    state.clone_from_slice(&self.promise.before);
                    self.promise.bound(&self.map, state);
                }
                let Promise { before, residual, .. } = &self.promise;
                let (map, constants) = (&self.map, &self.forward);
                let correction =
                    whole(map, constants, &mut self.site, &mut self.folded, before, Some(residual));
                let Some(correction) = correction else { return Err(SingularStep::pole(eps)) };
                for (x, d) in state.iter_mut().zip(correction) {
                    *x += d.clone();
                }
            }
        }
        for room in Room::ALL {
            let eliminated = T::eliminated(&self.map, &self.eps, &self.promise.before, room);
            let Some(Eliminated { next, is_promised, is_settled }) = eliminated else { continue };
            if next.iter().all(T::is_finite_number) {
                state.clone_from_slice(&next);
                if is_promised {
                    return Ok(());
                }
                let bound = self.promise.bound(&self.map, state);
                if bound <= 1.0 {
                    return Ok(());
                }
                least = bound.min(least);
            }
            if is_settled {
                break;
            }
        }
        failed(Reason::Refined, least * T::UNIT)
    }

    /// So many steps, in place.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    #[track_caller]
    pub fn advance(&mut self, state: &mut [T], steps: u64) {
        for _ in 0..steps {
            self.step(state);
        }
    }

    /// So many steps, in place; after each, `visit` gets its number, from 1 on, and the state.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    #[track_caller]
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
    #[track_caller]
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
    #[track_caller]
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
                for (j, entry) in site.row::<M::Shape>(M::BOUNDARY, self.sites, b) {
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

    #[track_caller]
    fn check(&self, state: &[T]) {
        let len = self.sites * M::Shape::BLOCK;
        assert!(
            state.len() == len,
            "a state of {} numbers: {} sites of {} arrays take {len}",
            state.len(),
            self.sites,
            M::Shape::BLOCK
        );
    }

    #[track_caller]
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
        self.whole_eliminations += 1;
        let gained = whole(&self.map, constants, &mut self.site, &mut self.folded, state, None)?;
        for (x, w) in state.iter_mut().zip(gained) {
            *x = w.clone().multiply_add(twice.clone(), x.clone());
        }
        Some(())
    }
}

/// The solution of A(x,ε)·w = f(x), or of another right-hand side, by one elimination of the whole
/// chain.
fn whole<'a, M: LatticeMap<T>, T: LatticeScalar>(
    map: &M,
    constants: &[T],
    site: &mut Site<T>,
    folded: &'a mut Folded<T>,
    x: &[T],
    right: Option<&[T]>,
) -> Option<&'a [T]> {
    let (block, sites) = (M::Shape::BLOCK, x.len() / M::Shape::BLOCK);
    folded.solve(|unknown, row| {
        let (i, b) = (unknown / block, unknown % block);
        site.rows(map, constants, x, i, T::clone);
        row.add_right(right.map_or_else(|| site.f(b).clone(), |right| right[unknown].clone()));
        for (column, entry) in site.entries::<M::Shape>(M::BOUNDARY, sites, b) {
            row.add(column, entry.clone());
        }
    })
}

impl<M: fmt::Debug, T: LatticeScalar> fmt::Debug for LatticeAt<M, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { map, eps, sites, .. } = self;
        f.debug_struct("LatticeAt").field("map", map).field("eps", eps).field("sites", sites).finish()
    }
}
