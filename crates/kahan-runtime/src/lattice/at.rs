//! Kahan's map of a lattice, for one ε and one number of sites.
//!
//! In: a state, which holds the variables of the first site, then those of the second, and so on.
//! Out: the next state in the same memory, linear integrals, the Hamiltonian, and the modified
//! energy.

use std::sync::Arc;

use kahan_algebra::rational::Rational;
use kahan_core::__private::LatticeMap;
use kahan_core::{LatticeAt, Level, Step, Stopped, Workspace};

use crate::at::expect_fit;
use crate::dimension::Argument;
use crate::parameters::in_order;
use crate::{DimensionError, ParameterError};

use super::runtime_family::RuntimeFamily;
use super::{LatticeCode, LatticeError};

/// The map of a chain at a fixed ε, half the time step.
///
/// A state holds the variables of the first site, then those of the second site, and so on.
/// [`step`](Self::step) does not allocate.
#[derive(Debug)]
pub struct ChainAt {
    code: Arc<LatticeCode>,
    at: LatticeAt<RuntimeFamily, f64>,
}

impl ChainAt {
    pub(super) fn new<N: AsRef<str>, V: AsRef<[f64]>>(
        code: Arc<LatticeCode>,
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
        let site_parameters = numbers.split_off(plain).into();
        let parameters: Arc<[f64]> = numbers.into_iter().flatten().collect();
        let read =
            RuntimeFamily { code: Arc::clone(&code), parameters: Arc::clone(&parameters), site_parameters };
        let undefined = || {
            let value = |number: &f64| Rational::from_f64(*number).expect("it was seen to be finite");
            let names = family.parameters.iter().cloned();
            ParameterError::Undefined(names.zip(parameters.iter().map(value)).collect())
        };
        let constants = LatticeMap::constants(&read, eps, f64::clone);
        if !constants.is_some_and(|constants| constants.iter().all(|constant| constant.is_finite())) {
            return Err(undefined().into());
        }
        let at = LatticeAt::new(read, eps, sites).map_err(|_| undefined())?;
        Ok(ChainAt { code: Arc::clone(&code), at })
    }

    /// Returns the chain with steps in another SIMD instruction set; `None` if the processor lacks
    /// it. Long chains use SIMD lanes, so their last bits depend on the instruction set.
    #[must_use]
    pub fn at_level(self, level: Level) -> Option<Self> {
        Some(ChainAt { at: self.at.at_level(level)?, ..self })
    }

    /// Returns the number of entries of a state: sites times arrays.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.at.sites() * self.code.sizes.block
    }

    /// Replaces x by x̃, the state one step later. At a pole, the numbers are not finite.
    ///
    /// # Errors
    /// [`DimensionError`] for a state of another length.
    pub fn step(&mut self, state: &mut [f64]) -> Result<(), DimensionError> {
        self.check(state)?;
        self.at.step(state);
        Ok(())
    }

    /// Returns the linear integrals, in order.
    ///
    /// # Errors
    /// [`DimensionError`] for a state of another length.
    pub fn integrals(&self, state: &[f64]) -> Result<Vec<f64>, DimensionError> {
        self.check(state)?;
        Ok(self.at.integrals(state))
    }

    /// Returns the Hamiltonian H(x), which the flow preserves and the map does not; `None` if the
    /// family has no Hamiltonian.
    ///
    /// # Errors
    /// [`DimensionError`] for a state of another length.
    pub fn hamiltonian(&self, state: &[f64]) -> Result<Option<f64>, DimensionError> {
        self.check(state)?;
        Ok(self.code.family.hamiltonian.is_some().then(|| self.at.hamiltonian(state)))
    }

    /// Returns H(x) + (2ε/3) ∇H(x)ᵀ A(x,ε)⁻¹ f(x) for the Hamiltonian H; `None` without H. The map
    /// preserves this energy if H has a degree of at most three.
    ///
    /// # Errors
    /// [`DimensionError`] for a state of another length.
    pub fn modified_energy(&mut self, state: &[f64]) -> Result<Option<f64>, DimensionError> {
        self.check(state)?;
        Ok(self.code.family.hamiltonian.is_some().then(|| self.at.modified_energy(state)))
    }

    fn check(&self, state: &[f64]) -> Result<(), DimensionError> {
        DimensionError::check(Argument::State, state.len(), self.unknowns())
    }
}

/// Steps panic if the length of a state is not [`unknowns`](ChainAt::unknowns).
impl Step for ChainAt {
    type Scalar = f64;
    type State = Vec<f64>;

    fn dimension(&self) -> usize {
        self.unknowns()
    }

    fn eps(&self) -> &f64 {
        self.at.eps()
    }

    #[track_caller]
    fn advance(&self, x: &mut [f64], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        expect_fit(self.check(x));
        Step::advance(&self.at, x, steps, workspace)
    }

    #[track_caller]
    fn part(&self, eps: &f64, x: &mut [f64], workspace: &mut Workspace) -> Result<(), Stopped> {
        expect_fit(self.check(x));
        self.at.part(eps, x, workspace)
    }
}
