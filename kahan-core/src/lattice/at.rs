//! The Kahan map of a chain with a fixed number of sites, at a fixed ε.

use core::fmt;
use std::sync::{Mutex, PoisonError};
use std::vec::Vec;

use crate::ensemble::Level;
use crate::map::eliminated_at_any_capacity;
use crate::step::error::{Reason, pole};
use crate::{SingularStep, Step, Stopped, Workspace};

use super::folded::FoldedBand;
use super::parts::{Kernels, PartSolver, Partition};
use super::promise::{PromiseCheck, REFINEMENTS};
use super::scalar::ChainArithmetic;
use super::sites::Site;
use super::{Boundary, LatticeError, LatticeMap, LatticeScalar, Sizes};

/// The Kahan map of a chain of fixed length, at a fixed ε (half the time step).
///
/// [`LatticeMap::at`](super::LatticeMap::at) creates this map. Steps over floats do
/// not allocate, except concurrent calls of [`advance`](Self::advance).
pub struct LatticeAt<M, T: LatticeScalar> {
    map: M,
    eps: T,
    forward: Vec<T>,
    backward: Vec<T>,
    form: WorkspaceLayout,
    /// The workspace of steps. Each concurrent call allocates another workspace.
    memory: Mutex<StepWorkspace<T>>,
    promise: PromiseCheck<T>,
}

struct StepWorkspace<T: LatticeScalar> {
    form: WorkspaceLayout,
    site: Site<T>,
    folded: FoldedBand<T>,
    parts: Option<<T as ChainArithmetic>::Parts>,
    whole_eliminations: u64,
}

#[derive(Clone, Copy, PartialEq, Eq)]
struct WorkspaceLayout {
    sizes: Sizes,
    sites: usize,
    boundary: Boundary,
    partition: Option<Partition>,
    level: Level,
}

impl<T: LatticeScalar> StepWorkspace<T> {
    fn new(form: WorkspaceLayout) -> Self {
        let WorkspaceLayout { sizes, sites, boundary, partition, level } = form;
        let is_ring = boundary == Boundary::Periodic;
        let folded = if partition.is_some() { FoldedBand::with_little_memory } else { FoldedBand::new };
        Self {
            form,
            site: Site::of(sizes),
            folded: folded(sites * sizes.block, is_ring, sizes.lower, sizes.upper),
            parts: partition.and_then(|partition| PartSolver::new(sizes, partition, boundary, level)),
            whole_eliminations: 0,
        }
    }

    /// Takes `steps` steps with the `constants` for ε. Over exact scalars, stops before a pole.
    fn advance<M: LatticeMap<T>>(
        &mut self,
        map: &M,
        constants: &[T],
        eps: &T,
        state: &mut [T],
        steps: u64,
    ) -> Result<(), Stopped> {
        let twice = eps.clone() + eps.clone();
        for steps in 0..steps {
            if let Some(parts) = &mut self.parts
                && parts.step(map, constants, &twice, &mut self.site, state)
            {
                continue;
            }
            self.whole_eliminations += 1;
            let Some(gained) = self.solve(map, constants, state, None) else {
                return Err(Stopped { steps, why: SingularStep::pole(eps.approximate()) });
            };
            for (x, w) in state.iter_mut().zip(gained) {
                *x = w.clone().multiply_add(twice.clone(), x.clone());
            }
        }
        Ok(())
    }

    /// Solves A(x,ε)·w = r by eliminating the whole chain; r is `right`, or f(x) for `None`.
    fn solve<M: LatticeMap<T>>(
        &mut self,
        map: &M,
        constants: &[T],
        x: &[T],
        right: Option<&[T]>,
    ) -> Option<&[T]> {
        let Self { site, folded, .. } = self;
        let block = map.sizes().block;
        let sites = x.len() / block;
        folded.solve(|unknown, row| {
            let (i, b) = (unknown / block, unknown % block);
            site.rows(map, constants, x, i, T::clone);
            row.add_right(right.map_or_else(|| site.f(b).clone(), |right| right[unknown].clone()));
            for (column, entry) in site.entries(map, sites, b) {
                row.add(column, entry.clone());
            }
        })
    }
}

impl<M: LatticeMap<T>, T: LatticeScalar> LatticeAt<M, T> {
    /// Prepares a chain of `sites` sites. Each site parameter must have `sites` values.
    #[doc(hidden)]
    pub fn new(map: M, eps: T, sites: usize) -> Result<Self, LatticeError> {
        let sizes = map.sizes();
        let lanes = <T as ChainArithmetic>::Parts::LANES.filter(|_| M::Kernels::supports(sizes));
        let partition = lanes.and_then(|lanes| Partition::new(sites, sizes.reach, lanes));
        Self::with_partition(map, eps, sites, partition)
    }

    pub(super) fn with_partition(
        map: M,
        eps: T,
        sites: usize,
        partition: Option<Partition>,
    ) -> Result<Self, LatticeError> {
        if sites == 0 {
            return Err(LatticeError::NoSites);
        }
        let constants = |eps| map.constants(eps, T::clone).ok_or(LatticeError::Undefined);
        let (forward, backward) = (constants(eps.clone())?, constants(-eps.clone())?);
        let (sizes, boundary, level) = (map.sizes(), map.boundary(), Level::best());
        let promise = PromiseCheck::new(&map, &eps, sites * sizes.block);
        // Constants that overflow T are an error, unless `try_step` can represent them.
        if !(forward.iter().all(T::is_finite_number) || promise.has_equations()) {
            return Err(LatticeError::Undefined);
        }
        let form = WorkspaceLayout { sizes, sites, boundary, partition, level };
        let memory = Mutex::new(StepWorkspace::new(form));
        Ok(Self { map, eps, forward, backward, form, memory, promise })
    }

    /// Sets the instruction set of the steps, which affects the last bits of long chains. The
    /// default is the processor's highest instruction set. Returns `None` if the processor lacks
    /// the instruction set.
    pub fn at_level(mut self, level: Level) -> Option<Self> {
        self.form.level = level;
        self.memory = Mutex::new(StepWorkspace::new(self.form));
        level.is_available().then_some(self)
    }

    /// Returns the number of sites.
    pub fn sites(&self) -> usize {
        self.form.sites
    }

    pub(super) fn map(&self) -> &M {
        &self.map
    }

    /// Returns ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// Returns how many steps eliminated the whole chain in one piece. Long chains are eliminated
    /// in parts; a step of a long chain counts only if this failed.
    pub fn whole_eliminations(&self) -> u64 {
        self.memory.lock().unwrap_or_else(PoisonError::into_inner).whole_eliminations
    }

    /// Takes one step x ↦ x̃ in place. NaNs stay NaN. At a pole, floats become infinite or NaN.
    ///
    /// # Panics
    /// If the state has the wrong length, or if it is a pole of an exact scalar.
    #[track_caller]
    pub fn step(&mut self, state: &mut [T]) {
        self.check(state);
        let Self { map, eps, forward, memory, .. } = self;
        if own(memory).advance(map, forward, eps, state, 1).is_err() {
            pole(eps)
        }
    }

    /// Takes one step of the inverse map, which is the map with −ε, in place.
    ///
    /// # Panics
    /// Panics as [`step`](Self::step) does.
    #[track_caller]
    pub fn step_back(&mut self, state: &mut [T]) {
        self.check(state);
        let Self { map, eps, backward, memory, .. } = self;
        if own(memory).advance(map, backward, &-eps.clone(), state, 1).is_err() {
            pole(eps)
        }
    }

    /// Takes one step with a bound on the step's backward error. After an error the state is
    /// unchanged.
    ///
    /// `Ok` means |A·x̃ − b|ᵢ ≤ (k + 8)·u·(|A|·|x̃| + |b|)ᵢ for every unknown i, proved for this
    /// call. Here the step's matrix A and right-hand side b are exact for the given floats, row i
    /// of A has k entries, and u is the rounding unit. Steps over exact scalars are exact.
    ///
    /// # Errors
    /// If the state is a pole, if the state or x̃ is not finite, or if no computed x̃ is within the
    /// bound. After two refinements of x̃, chains of at most 4096 unknowns try an elimination with
    /// many digits, which allocates.
    ///
    /// # Panics
    /// If the state has the wrong length.
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
        let Self { map, eps: exact_eps, forward, memory, promise, .. } = self;
        let memory = own(memory);
        memory.advance(map, forward, exact_eps, state, 1).map_err(|stopped| stopped.why)?;
        if T::UNIT == 0.0 {
            return Ok(());
        }
        let mut least = f64::INFINITY;
        for turn in 0..=REFINEMENTS {
            let is_finite = state.iter().all(T::is_finite_number);
            let bound = if is_finite { promise.bound(map, state) } else { f64::INFINITY };
            if bound <= 1.0 {
                return Ok(());
            }
            least = bound.min(least);
            if turn < REFINEMENTS {
                if !is_finite {
                    state.clone_from_slice(&promise.before);
                    promise.bound(map, state);
                }
                let PromiseCheck { before, residual, .. } = promise;
                let correction = memory.solve(map, forward, before, Some(residual));
                let Some(correction) = correction else { return Err(SingularStep::pole(eps)) };
                for (x, d) in state.iter_mut().zip(correction) {
                    *x += d.clone();
                }
            }
        }
        let before = promise.before.clone();
        let next = eliminated_at_any_capacity(
            |capacity| T::eliminated(map, exact_eps, &before, capacity),
            |next| {
                let bound = promise.bound(map, next);
                least = bound.min(least);
                bound <= 1.0
            },
        );
        if let Some(next) = next {
            state.clone_from_slice(&next);
            return Ok(());
        }
        failed(Reason::Refined, least * T::UNIT)
    }

    /// Takes `steps` steps in place. A concurrent call from another thread allocates a workspace.
    ///
    /// # Panics
    /// Panics as [`step`](Self::step) does.
    #[track_caller]
    pub fn advance(&self, state: &mut [T], steps: u64) {
        self.check(state);
        let Self { map, eps, forward, memory, form, .. } = self;
        let advanced = match memory.try_lock() {
            Ok(mut memory) => memory.advance(map, forward, eps, state, steps),
            Err(_) => StepWorkspace::new(*form).advance(map, forward, eps, state, steps),
        };
        if advanced.is_err() {
            pole(eps)
        }
    }

    /// Takes `steps` steps. After step k = 1, 2, …, calls `visit` with k and the state.
    ///
    /// # Panics
    /// Panics as [`step`](Self::step) does.
    #[track_caller]
    pub fn for_each(&mut self, state: &mut [T], steps: u64, mut visit: impl FnMut(u64, &[T])) {
        for k in 1..=steps {
            self.step(state);
            visit(k, state);
        }
    }

    /// Returns the componentwise backward error of the step from x = `x` to x̃ = `next`. With f(x)
    /// = Q(x,x) + Bx + c, A(x,ε) = I − εf′(x) and b(x,ε) = x + εBx + 2εc, the result is the maximum
    /// over all components of
    ///
    ///   |A(x,ε)(x̃ − x) − 2εf(x)| / (|A||x̃| + |b|).
    ///
    /// The numerator is |A x̃ − b|. Over an exact scalar the result is 0 only for the exact step.
    /// If a component is NaN, the result is NaN.
    ///
    /// # Panics
    /// If a state has the wrong length.
    #[track_caller]
    pub fn residual(&self, x: &[T], next: &[T]) -> T {
        self.check(x);
        self.check(next);
        let mut site = Site::of(self.map.sizes());
        let twice = self.eps.clone() + self.eps.clone();
        let mut worst = T::zero();
        for i in 0..self.sites() {
            site.rows(&self.map, &self.forward, x, i, T::clone);
            for b in 0..self.map.sizes().block {
                let increment = twice.clone() * site.f(b).clone();
                let (mut residual, mut right, mut size) = (-increment.clone(), increment, T::zero());
                for (j, entry) in site.row(&self.map, self.sites(), b) {
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

    /// Returns f(x), in the order of the state.
    ///
    /// # Panics
    /// If the state has the wrong length.
    #[track_caller]
    pub fn field(&self, x: &[T]) -> Vec<T> {
        self.check(x);
        let mut site = Site::of(self.map.sizes());
        let mut field = Vec::with_capacity(x.len());
        for i in 0..self.sites() {
            site.rows(&self.map, &self.forward, x, i, T::clone);
            field.extend((0..self.map.sizes().block).map(|b| site.f(b).clone()));
        }
        field
    }

    #[track_caller]
    fn check(&self, state: &[T]) {
        let len = self.sites() * self.map.sizes().block;
        assert!(
            state.len() == len,
            "a state of {} numbers: {} sites of {} arrays take {len}",
            state.len(),
            self.sites(),
            self.map.sizes().block
        );
    }
}

fn own<T>(memory: &mut Mutex<T>) -> &mut T {
    memory.get_mut().unwrap_or_else(PoisonError::into_inner)
}

impl<M: LatticeMap<T>, T: LatticeScalar> Step for LatticeAt<M, T> {
    type Scalar = T;
    type State = Vec<T>;

    fn dimension(&self) -> usize {
        self.sites() * self.map.sizes().block
    }

    fn eps(&self) -> &T {
        &self.eps
    }

    #[track_caller]
    fn advance(&self, x: &mut [T], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        self.check(x);
        self.memory_in(workspace).advance(&self.map, &self.forward, &self.eps, x, steps)
    }

    #[track_caller]
    fn part(&self, eps: &T, x: &mut [T], workspace: &mut Workspace) -> Result<(), Stopped> {
        self.check(x);
        match self.map.constants(eps.clone(), T::clone) {
            Some(constants) => self.memory_in(workspace).advance(&self.map, &constants, eps, x, 1),
            None => Err(Stopped { steps: 0, why: SingularStep::pole(eps.approximate()) }),
        }
    }
}

impl<M: LatticeMap<T>, T: LatticeScalar> LatticeAt<M, T> {
    fn memory_in<'a>(&self, workspace: &'a mut Workspace) -> &'a mut StepWorkspace<T> {
        let form = self.form;
        workspace.of(|memory: &StepWorkspace<T>| memory.form == form, || StepWorkspace::new(form))
    }
}

impl<M: fmt::Debug, T: LatticeScalar> fmt::Debug for LatticeAt<M, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { map, eps, form, .. } = self;
        let sites = form.sites;
        f.debug_struct("LatticeAt").field("map", map).field("eps", eps).field("sites", &sites).finish()
    }
}
