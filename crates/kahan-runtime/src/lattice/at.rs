//! A family at one ε, for chains of one length.
//!
//! In: a state, site by site, arrays interleaved. Out: the next one in its place, and what is kept.
//! All memory of a step is taken here, before the first one, or is the caller's.

use std::sync::Arc;

use kahan_algebra::family::Family;
use kahan_algebra::rational::Rational;
use kahan_core::__private::{Boundary, Folded, Total};
use kahan_core::{Dual, Scalar, Step, Stopped, Workspace};

use crate::at::fitting;
use crate::dimension::Argument;
use crate::parameters::in_order;
use crate::{DimensionError, ParameterError};

use super::site::{Chain, Site};
use super::{Code, LatticeError};

/// The map of a family at a fixed ε, half the time step, for chains of one number of sites.
///
/// A state is site by site, arrays interleaved. A step allocates nothing.
pub struct ChainAt {
    fixed: Arc<Fixed>,
    memory: Memory,
}

/// What no step changes.
struct Fixed {
    code: Arc<Code>,
    chain: Arc<Chain>,
    /// The parameters of the chain, and ε behind them.
    given: Vec<f64>,
    /// What the lines take as constants, ε last.
    constants: Vec<f64>,
}

/// What a step computes in.
struct Memory {
    site: Site<f64>,
    folded: Folded<f64>,
}

impl Fixed {
    /// The chain at these parameters and, behind them, ε.
    fn new(code: Arc<Code>, chain: Arc<Chain>, given: Vec<f64>) -> Self {
        let mut registers = vec![0.0; code.constants.registers()];
        let constants = code.constants.results(given.iter().copied(), &mut registers, &[]);
        let constants = constants.expect("floats have a value where they divide by zero");
        let constants = constants.iter().chain(given.last().copied()).collect();
        Fixed { code, chain, given, constants }
    }

    fn eps(&self) -> &f64 {
        self.given.last().unwrap_or_else(|| unreachable!("eps is one of them"))
    }

    fn memory(&self) -> Memory {
        let Self { code, chain, constants, .. } = self;
        let is_ring = chain.boundary == Boundary::Periodic;
        Memory {
            site: Site::new(chain, &code.rows, constants.iter().copied()),
            folded: Folded::new(chain.unknowns(), is_ring, code.lower, code.upper),
        }
    }

    fn step(&self, Memory { site, folded }: &mut Memory, state: &mut [f64]) {
        let Self { code, chain, .. } = self;
        let gained = folded.solve(|unknown, row| {
            let (i, b) = (unknown / chain.block, unknown % chain.block);
            let results = site.run(chain, &code.rows, i, |k| state[k], |number| number);
            row.add_right(results.get(b));
            for &(result, place) in &code.entries[b] {
                if let Some(column) = chain.unknown(i, place) {
                    row.add(column, results.get(result));
                }
            }
        });
        let twice = self.eps() + self.eps();
        for (x, w) in state.iter_mut().zip(gained.into_iter().flatten()) {
            *x = w.multiply_add(twice, *x);
        }
    }
}

impl ChainAt {
    pub(super) fn new<N: AsRef<str>, V: AsRef<[f64]>>(
        code: Arc<Code>,
        eps: f64,
        sites: usize,
        values: impl IntoIterator<Item = (N, V)>,
    ) -> Result<Self, LatticeError> {
        if sites == 0 {
            return Err(LatticeError::NoSites);
        }
        if !eps.is_finite() {
            return Err(LatticeError::Eps);
        }
        let family = &code.family;
        let names = [&family.parameters[..], &family.site_parameters].concat();
        let plain = family.parameters.len();
        let finite = |name: &str, value: V| {
            let is_finite = value.as_ref().iter().all(|number| number.is_finite());
            if is_finite { Ok(value) } else { Err(ParameterError::NotFinite(name.to_owned())) }
        };
        let mut numbers: Vec<Vec<f64>> = Vec::with_capacity(names.len());
        for (k, value) in in_order(&names, values, finite)?.iter().enumerate() {
            let sites = (k >= plain).then_some(sites);
            numbers.push(match (value.as_ref(), sites) {
                ([number], Some(sites)) => vec![*number; sites],
                (value, sites) if value.len() == sites.unwrap_or(1) => value.to_vec(),
                (value, sites) => {
                    return Err(LatticeError::Values { name: names[k].clone(), found: value.len(), sites });
                }
            });
        }
        let of_sites = numbers.split_off(plain);
        let chain = Chain {
            boundary: code.boundary(),
            sites,
            block: family.block(),
            reach: family.reach,
            parameters: of_sites,
        };
        let given = numbers.into_iter().flatten().chain([eps]).collect();
        let fixed = Fixed::new(code, Arc::new(chain), given);
        if !fixed.constants.iter().all(|constant| constant.is_finite()) {
            let value = |number: &f64| Rational::from_f64(*number).expect("it was seen to be finite");
            let names = fixed.code.family.parameters.iter().cloned();
            let values = names.zip(fixed.given.iter().map(value)).collect();
            return Err(ParameterError::Undefined(values).into());
        }
        Ok(ChainAt { memory: fixed.memory(), fixed: Arc::new(fixed) })
    }

    /// How many numbers a state has: as many a site as there are arrays.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.fixed.chain.unknowns()
    }

    /// One step, x ↦ x̃, in place; at a pole the numbers are not finite.
    ///
    /// # Errors
    /// A state of another length.
    pub fn step(&mut self, state: &mut [f64]) -> Result<(), DimensionError> {
        self.check(state)?;
        self.fixed.step(&mut self.memory, state);
        Ok(())
    }

    /// The linear integrals, in order.
    ///
    /// # Errors
    /// A state of another length.
    pub fn integrals(&self, state: &[f64]) -> Result<Vec<f64>, DimensionError> {
        let mut sums = self.sums(state)?;
        sums.truncate(self.fixed.code.family.integrals.len());
        Ok(sums)
    }

    /// H(x), which the flow keeps and the map does not; `None` without a Hamiltonian.
    ///
    /// # Errors
    /// A state of another length.
    pub fn hamiltonian(&self, state: &[f64]) -> Result<Option<f64>, DimensionError> {
        Ok(self.sums(state)?.get(self.fixed.code.family.integrals.len()).copied())
    }

    /// The linear integrals, and the Hamiltonian behind them.
    fn sums(&self, state: &[f64]) -> Result<Vec<f64>, DimensionError> {
        self.check(state)?;
        let Family { integrals, hamiltonian, .. } = &self.fixed.code.family;
        let mut totals = vec![Total::zero(); integrals.len() + usize::from(hamiltonian.is_some())];
        let add = |densities: &mut dyn Iterator<Item = f64>| {
            totals.iter_mut().zip(densities).for_each(|(total, density)| total.add(&density));
        };
        self.for_each_site(|k| state[k], |number| number, add);
        Ok(totals.into_iter().map(Total::sum).collect())
    }

    /// H(x) + (2ε/3) ∇H(x)ᵀ A(x,ε)⁻¹ f(x), which the map keeps where H is of degree three at most;
    /// `None` without a Hamiltonian. Cost: one step, as x̃ − x = 2ε A⁻¹ f, and a copy of the state.
    ///
    /// # Errors
    /// A state of another length.
    pub fn modified_energy(&mut self, state: &[f64]) -> Result<Option<f64>, DimensionError> {
        let mut next = state.to_vec();
        self.step(&mut next)?;
        let mut total = Total::zero();
        self.for_each_site(
            |k| Dual { value: state[k], gradient: [next[k] - state[k]] },
            Dual::from_value,
            |densities| {
                for Dual { value, gradient: [slope] } in
                    densities.skip(self.fixed.code.family.integrals.len())
                {
                    total.add(&value);
                    total.add(&(1.0 / 3.0 * slope));
                }
            },
        );
        Ok(self.fixed.code.family.hamiltonian.is_some().then(|| total.sum()))
    }

    /// Shows the densities of every site.
    fn for_each_site<V: Scalar>(
        &self,
        state: impl Fn(usize) -> V,
        convert: impl Fn(f64) -> V,
        mut visit: impl FnMut(&mut dyn Iterator<Item = V>),
    ) {
        let Fixed { code, chain, constants, .. } = &*self.fixed;
        let line = &code.sums;
        let mut site = Site::new(chain, line, constants.iter().map(|constant| convert(*constant)));
        for i in 0..chain.sites {
            visit(&mut site.run(chain, line, i, &state, &convert).iter());
        }
    }

    fn check(&self, state: &[f64]) -> Result<(), DimensionError> {
        DimensionError::check(Argument::State, state.len(), self.unknowns())
    }
}

/// In memory of the workspace's, so that any number of threads can share a chain. A state of
/// another length panics here, as dimensions of nalgebra do.
impl Step for ChainAt {
    type Scalar = f64;
    type State = Vec<f64>;

    fn dimension(&self) -> usize {
        self.unknowns()
    }

    fn eps(&self) -> &f64 {
        self.fixed.eps()
    }

    #[track_caller]
    fn advance(&self, x: &mut [f64], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        fitting(self.check(x));
        let is_own = |(fixed, _): &(Arc<Fixed>, Memory)| Arc::ptr_eq(fixed, &self.fixed);
        let (fixed, memory) = workspace.of(is_own, || (Arc::clone(&self.fixed), self.fixed.memory()));
        (0..steps).for_each(|_| fixed.step(memory, x));
        Ok(())
    }

    #[track_caller]
    fn part(&self, eps: &f64, x: &mut [f64], _room: &mut Workspace) -> Result<(), Stopped> {
        fitting(self.check(x));
        let Fixed { code, chain, given, .. } = &*self.fixed;
        let (_, parameters) = given.split_last().unwrap_or_else(|| unreachable!("eps is one of them"));
        let part = Fixed::new(Arc::clone(code), Arc::clone(chain), [parameters, &[*eps]].concat());
        part.step(&mut part.memory(), x);
        Ok(())
    }
}

impl core::fmt::Debug for ChainAt {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let (eps, sites) = (self.fixed.eps(), self.fixed.chain.sites);
        f.debug_struct("ChainAt").field("eps", eps).field("sites", &sites).finish_non_exhaustive()
    }
}
