//! Families read at run time, as maps of chains with any number of sites.
//!
//! In: a checked family ([`FieldText::family`](crate::FieldText::family)), ε, a number of sites,
//! and parameters. Out: steps in `f64` with the bits of compiled families. For a stencil that
//! [`StencilMenu`] lacks, a long chain is eliminated as a whole, so last bits differ.

mod at;
mod error;
mod program;
mod runtime_family;

use std::sync::Arc;

use kahan_algebra::family::Family;
use kahan_algebra::syntax::Boundary;
use kahan_core::__private as core;
use kahan_core::__private::Sizes;
use kahan_core::__private::chain::StencilMenu;
use kahan_core::eps_from_dt;

use crate::line::Line;
use crate::literal::Literal;

use program::{OperandNumbering, Program};

pub use at::ChainAt;
pub use error::LatticeError;

/// A family of equations, ready for chains of any number of sites. Clones share their programs.
#[derive(Clone, Debug)]
pub struct Lattice {
    code: Arc<LatticeCode>,
}

#[derive(Debug)]
struct LatticeCode {
    family: Family,
    boundary: core::Boundary,
    /// The program that computes the prepared constants from the parameters of the chain and ε.
    constants: Line,
    /// The numbers in the equations, which follow the prepared constants in memory.
    literals: Vec<Literal>,
    /// The program that computes, at one site, the field for each array, and the rows of A(x,ε).
    rows: Program,
    /// The program that computes a site's contribution to each integral, then to the Hamiltonian.
    sums: Program,
    /// In the rows of A at a site, the indices of the entries that are not always 0.
    entries: Vec<usize>,
    sizes: Sizes,
}

impl LatticeCode {
    fn of(family: &Family) -> Self {
        let lines = family.lines();
        let (block, stencil, parameters) = (family.block(), family.stencil(), family.site_parameters.len());
        let numbering = OperandNumbering {
            symbols: &lines.symbols,
            block,
            stencil,
            site_parameters: parameters,
            prepared: lines.constants.outputs.len(),
        };
        let columns = stencil * block;
        let entries: Vec<usize> =
            lines.entries.iter().map(|entry| entry.row * columns + entry.column).collect();
        let mut literals = Vec::new();
        let places = (0..block).chain(entries.iter().map(|entry| block + entry));
        let rows = Program::of(&lines.rows, places, block + block * columns, &numbering, &mut literals);
        let sums = family.sums().count();
        let sums = Program::of(&lines.sums, 0..sums, sums, &numbering, &mut literals);
        let sizes = StencilMenu::widened(Sizes {
            block,
            reach: family.reach,
            parameters,
            lower: lines.lower,
            upper: lines.upper,
            registers: rows.registers().max(sums.registers()),
            registers_abreast: rows.registers_abreast(numbering.prepared + literals.len()),
        });
        let boundary = match family.boundary {
            Boundary::Periodic => core::Boundary::Periodic,
            Boundary::Open => core::Boundary::Open,
        };
        LatticeCode {
            constants: Line::with_checked_divisions(&lines.constants, &lines.given),
            family: family.clone(),
            boundary,
            literals,
            rows,
            sums,
            entries,
            sizes,
        }
    }
}

impl Lattice {
    /// Prepares the lattice of a family; does not prove the claims of the family again.
    #[must_use]
    pub fn of(family: &Family) -> Self {
        Lattice { code: Arc::new(LatticeCode::of(family)) }
    }

    /// Returns the names of the arrays, in their order within a site.
    #[must_use]
    pub fn arrays(&self) -> &[String] {
        &self.code.family.arrays
    }

    /// Returns the names of the parameters of the whole chain.
    #[must_use]
    pub fn parameters(&self) -> &[String] {
        &self.code.family.parameters
    }

    /// Returns the names of the parameters of each site.
    #[must_use]
    pub fn site_parameters(&self) -> &[String] {
        &self.code.family.site_parameters
    }

    /// Returns the names of the linear integrals, in order.
    #[must_use]
    pub fn integrals(&self) -> Vec<&str> {
        self.code.family.integrals.iter().map(|sum| sum.name.text.as_str()).collect()
    }

    /// Returns the name of the Hamiltonian, if there is one.
    #[must_use]
    pub fn hamiltonian(&self) -> Option<&str> {
        self.code.family.hamiltonian.as_ref().map(|sum| sum.name.text.as_str())
    }

    /// Prepares the map at ε, half the time step, for chains of `sites` sites.
    ///
    /// `values` holds the name and the numbers of each parameter, in any order. A parameter of the
    /// whole chain has one number. A parameter of sites has one number for all sites, or one number
    /// for each site.
    ///
    /// # Errors
    /// [`LatticeError`] for 0 sites, an ε that is not finite, or wrong parameters.
    ///
    /// ```
    /// use kahan_runtime::{FieldText, Lattice};
    ///
    /// let text = "for i in periodic { x[i]dot = x[i]*(x[i+1] - mu*x[i-1]); }";
    /// let family = FieldText::new(text.to_owned(), "chain".to_owned()).family().unwrap().unwrap();
    /// let mut chain = Lattice::of(&family).at(0.05, 1000, [("mu", [1.0])]).unwrap();
    /// let mut state = vec![1.0; 1000];
    /// state[0] = 2.0;
    /// chain.step(&mut state).unwrap();
    /// assert!(state[1] < 1.0 && state[999] > 1.0);
    /// ```
    pub fn at<N: AsRef<str>, V: AsRef<[f64]>>(
        &self,
        eps: f64,
        sites: usize,
        values: impl IntoIterator<Item = (N, V)>,
    ) -> Result<ChainAt, LatticeError> {
        ChainAt::new(Arc::clone(&self.code), eps, sites, values)
    }

    /// Prepares the map at the time step Δt = 2ε; see [`at`](Self::at).
    ///
    /// # Errors
    /// See [`at`](Self::at).
    pub fn at_dt<N: AsRef<str>, V: AsRef<[f64]>>(
        &self,
        dt: f64,
        sites: usize,
        values: impl IntoIterator<Item = (N, V)>,
    ) -> Result<ChainAt, LatticeError> {
        self.at(eps_from_dt(dt), sites, values)
    }
}
