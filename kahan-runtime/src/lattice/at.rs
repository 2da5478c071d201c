//! A family at one ε, for chains of one length.
//!
//! In: a state, site by site, arrays interleaved. Out: the next one in its place, and what is kept.
//! All memory of a step is taken here, before the first one.

use std::sync::Arc;

use kahan_algebra::family::Family;
use kahan_algebra::rational::Rational;
use kahan_core::__private::{Boundary, Folded, Total};
use kahan_core::{Dual, Scalar};

use crate::dimension::Argument;
use crate::parameters::in_order;
use crate::{DimensionError, ParameterError};

use super::site::{Chain, Site};
use super::{Code, LatticeError};

/// The map of a family at a fixed ε, half the time step, for chains of one number of sites.
///
/// A state is site by site, arrays interleaved. A step allocates nothing.
pub struct LatticeAt {
    code: Arc<Code>,
    eps: f64,
    chain: Chain,
    /// What the lines take as constants, ε last.
    constants: Vec<f64>,
    site: Site<f64>,
    folded: Folded<f64>,
}

impl LatticeAt {
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
        let given: Vec<f64> = numbers.into_iter().flatten().collect();
        let mut registers = vec![0.0; code.constants.registers()];
        let constants = code.constants.results(given.iter().copied().chain([eps]), &mut registers, &[]);
        let constants = constants.expect("floats have a value where they divide by zero");
        let constants: Vec<f64> = constants.iter().collect();
        if !constants.iter().all(|constant| constant.is_finite()) {
            let value = |number: &f64| Rational::from_f64(*number).expect("it was seen to be finite");
            let values = family.parameters.iter().cloned().zip(given.iter().map(value)).collect();
            return Err(ParameterError::Undefined(values).into());
        }
        let constants = [constants, vec![eps]].concat();
        let chain = Chain {
            boundary: code.boundary(),
            sites,
            block: family.block(),
            reach: family.reach,
            parameters: of_sites,
        };
        let is_ring = chain.boundary == Boundary::Periodic;
        Ok(LatticeAt {
            site: Site::new(&chain, &code.rows, constants.iter().copied()),
            folded: Folded::new(chain.unknowns(), is_ring, code.lower, code.upper),
            code,
            eps,
            chain,
            constants,
        })
    }

    /// How many numbers a state has: as many a site as there are arrays.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.chain.unknowns()
    }

    /// One step, x ↦ x̃, in place; at a pole the numbers are not finite.
    ///
    /// # Errors
    /// A state of another length.
    pub fn step(&mut self, state: &mut [f64]) -> Result<(), DimensionError> {
        self.check(state)?;
        let Self { code, chain, site, folded, .. } = self;
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
        let twice = self.eps + self.eps;
        for (x, w) in state.iter_mut().zip(gained.into_iter().flatten()) {
            *x = w.multiply_add(twice, *x);
        }
        Ok(())
    }

    /// The linear integrals, in order.
    ///
    /// # Errors
    /// A state of another length.
    pub fn integrals(&self, state: &[f64]) -> Result<Vec<f64>, DimensionError> {
        let mut sums = self.sums(state)?;
        sums.truncate(self.code.family.integrals.len());
        Ok(sums)
    }

    /// H(x), which the flow keeps and the map does not; `None` without a Hamiltonian.
    ///
    /// # Errors
    /// A state of another length.
    pub fn hamiltonian(&self, state: &[f64]) -> Result<Option<f64>, DimensionError> {
        Ok(self.sums(state)?.get(self.code.family.integrals.len()).copied())
    }

    /// The linear integrals, and the Hamiltonian behind them.
    fn sums(&self, state: &[f64]) -> Result<Vec<f64>, DimensionError> {
        self.check(state)?;
        let Family { integrals, hamiltonian, .. } = &self.code.family;
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
            Dual::lift,
            |densities| {
                for Dual { value, gradient: [slope] } in densities.skip(self.code.family.integrals.len()) {
                    total.add(&value);
                    total.add(&(1.0 / 3.0 * slope));
                }
            },
        );
        Ok(self.code.family.hamiltonian.is_some().then(|| total.sum()))
    }

    /// Shows the densities of every site.
    fn for_each_site<V: Scalar>(
        &self,
        state: impl Fn(usize) -> V,
        lift: impl Fn(f64) -> V,
        mut visit: impl FnMut(&mut dyn Iterator<Item = V>),
    ) {
        let (chain, line) = (&self.chain, &self.code.sums);
        let mut site = Site::new(chain, line, self.constants.iter().map(|constant| lift(*constant)));
        for i in 0..chain.sites {
            visit(&mut site.run(chain, line, i, &state, &lift).iter());
        }
    }

    fn check(&self, state: &[f64]) -> Result<(), DimensionError> {
        DimensionError::check(Argument::State, state.len(), self.unknowns())
    }
}

impl core::fmt::Debug for LatticeAt {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { eps, chain, .. } = self;
        f.debug_struct("LatticeAt").field("eps", eps).field("sites", &chain.sites).finish_non_exhaustive()
    }
}
