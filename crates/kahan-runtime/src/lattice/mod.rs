//! Families that are read at run time, as maps of chains of any number of sites.
//!
//! In: a checked family ([`FieldText::family`](crate::FieldText::family)), ε, a number of sites,
//! values of the parameters. Out: steps that cost what the couplings cost, in `f64`. The line of a
//! site is interpreted, and A(x,ε) is solved by the pivoted elimination that compiled families fall
//! back to; chains that the macro steps by it alone have the same bits here.

mod at;
mod error;
mod site;

use std::sync::Arc;

use kahan_algebra::family::Family;
use kahan_algebra::syntax::Boundary;
use kahan_core::__private as core;

use crate::line::Line;

pub use at::ChainAt;
pub use error::LatticeError;

/// A family of equations, ready for chains of any number of sites.
///
/// Copies share all that is made of it.
#[derive(Clone, Debug)]
pub struct Lattice {
    code: Arc<Code>,
}

/// The straight lines of a site.
#[derive(Debug)]
struct Code {
    family: Family,
    /// From the parameters of the chain and ε to what the other lines take as constants.
    constants: Line,
    /// The field, an array a result, then the entries of A.
    rows: Line,
    /// The densities of the integrals, then that of the Hamiltonian.
    sums: Line,
    /// Of each array's row of A: which result of `rows`, and the place of its column among the
    /// values that a site sees.
    entries: Vec<Vec<(usize, usize)>>,
    /// The largest distance of an entry to the left of the diagonal.
    lower: usize,
    /// The same to the right.
    upper: usize,
}

impl Code {
    fn of(family: &Family) -> Self {
        let lines = family.lines();
        let mut entries = vec![Vec::new(); family.block()];
        for (place, entry) in (family.block()..).zip(&lines.entries) {
            entries[entry.row].push((place, entry.column));
        }
        Code {
            constants: Line::of(&lines.constants, &lines.given),
            rows: Line::of(&lines.rows, &lines.symbols),
            sums: Line::of(&lines.sums, &lines.symbols),
            entries,
            lower: lines.lower,
            upper: lines.upper,
            family: family.clone(),
        }
    }

    fn boundary(&self) -> core::Boundary {
        match self.family.boundary {
            Boundary::Periodic => core::Boundary::Periodic,
            Boundary::Open => core::Boundary::Open,
        }
    }
}

impl Lattice {
    /// The lattice of a family, whose claims are taken as they are.
    #[must_use]
    pub fn of(family: &Family) -> Self {
        Lattice { code: Arc::new(Code::of(family)) }
    }

    /// The arrays, in their order within a site.
    #[must_use]
    pub fn arrays(&self) -> &[String] {
        &self.code.family.arrays
    }

    /// The parameters that a chain has.
    #[must_use]
    pub fn parameters(&self) -> &[String] {
        &self.code.family.parameters
    }

    /// The parameters that each site has.
    #[must_use]
    pub fn site_parameters(&self) -> &[String] {
        &self.code.family.site_parameters
    }

    /// The names of the linear integrals, in order.
    #[must_use]
    pub fn integrals(&self) -> Vec<&str> {
        self.code.family.integrals.iter().map(|sum| sum.name.text.as_str()).collect()
    }

    /// The name of the Hamiltonian, if there is one.
    #[must_use]
    pub fn hamiltonian(&self) -> Option<&str> {
        self.code.family.hamiltonian.as_ref().map(|sum| sum.name.text.as_str())
    }

    /// The map at this ε, half the time step, for chains of so many sites, with all memory that its
    /// steps need.
    ///
    /// `values` are pairs of a parameter's name and its numbers, in any order: one number, or for a
    /// parameter of each site as many as there are sites.
    ///
    /// # Errors
    /// [`LatticeError`] for no sites, and for values that are not those of the parameters.
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
}
