//! Orbits of chains with any number of sites, in doubles. Each row holds the linear integrals, and
//! if there is a Hamiltonian, its value and the modified energy. It also holds all variables or,
//! for a long chain, the range of each variable over the sites.

use std::ops::{ControlFlow, Range};

use kahan_algebra::arithmetic::Float64;
use kahan_discover::Watch;
use kahan_runtime::{ChainAt, End, Follow, Lattice};
use serde::Serialize;

use crate::count::WorkCount;
use crate::named::{Names, by_name};
use crate::numbers::ScalarKind;
use crate::rows::{Column, Ending, Rows};

use super::points::{EarlyEnd, EndReason, OrbitPoints, OrbitRows, rows_in_milliseconds};
use super::row_schedule::RowSchedule;
use super::{columns, is_none, names};

/// A chain with its map and state.
#[derive(Debug)]
pub struct Chain {
    /// The name of the family of equations.
    pub name: String,
    /// The family.
    pub lattice: Lattice,
    /// The names of the variables of a short chain; empty for a long one.
    pub variables: Vec<String>,
    /// The map of the chain.
    pub map: ChainAt,
    /// The number of sites.
    pub sites: usize,
    /// ε, half the time step.
    pub eps: f64,
    /// The parameters that all sites have in common.
    pub parameters: Names<f64>,
    /// The current state, site by site, with the arrays interleaved.
    pub state: Vec<f64>,
}

/// Metadata of a chain's orbit, known before its first step.
#[derive(Clone, Debug, Serialize)]
pub struct ChainHead {
    /// The name of the family.
    pub system: String,
    /// The names of the family's arrays, each of which holds one variable of all sites.
    pub arrays: Vec<String>,
    /// The number of sites.
    pub sites: usize,
    /// The parameters that all sites have in common.
    #[serde(serialize_with = "by_name")]
    pub parameters: Names<f64>,
    /// ε, half the time step.
    pub eps: f64,
    /// The scalar of the computation.
    pub scalar: ScalarKind,
    /// The order of the method.
    pub order: u32,
    /// The number of steps before the first row.
    #[serde(skip_serializing_if = "is_none")]
    pub transient: u64,
    /// The number of steps after the transient.
    pub steps: u64,
    /// The number of steps between rows.
    pub every: u64,
    /// The columns of the rows.
    #[serde(serialize_with = "names")]
    pub columns: Vec<Column>,
}

impl Chain {
    /// Returns the metadata of an orbit.
    #[must_use]
    pub fn head(&self, RowSchedule { transient, steps, every }: RowSchedule) -> ChainHead {
        let Chain { name, lattice, sites, eps, parameters, .. } = self;
        let range = |array: &String| [format!("{array}_min"), format!("{array}_max")];
        let states = match &self.variables[..] {
            [] => lattice.arrays().iter().flat_map(range).collect(),
            variables => variables.to_vec(),
        };
        let energy = lattice.hamiltonian().map(|name| [name.to_owned(), format!("{name}_modified")]);
        let integrals = lattice.integrals().into_iter().map(str::to_owned);
        let sums: Vec<String> = integrals.chain(energy.into_iter().flatten()).collect();
        ChainHead {
            system: name.clone(),
            arrays: lattice.arrays().to_vec(),
            sites: *sites,
            parameters: parameters.clone(),
            eps: *eps,
            scalar: ScalarKind::F64,
            order: 2,
            transient,
            steps,
            every: every.get(),
            columns: columns(&states, &sums),
        }
    }

    /// Advances the state along the schedule, and passes rows to `rows`. Calls `see` with the state
    /// of each row; if `see` breaks, the orbit ends.
    pub fn rows(
        &mut self,
        paces: RowSchedule,
        range: Range<u64>,
        rows: &mut dyn Rows,
        see: &mut dyn FnMut(&[f64]) -> ControlFlow<()>,
        watch: &dyn Watch,
    ) -> Ending {
        let columns = &self.head(paces).columns;
        let course = OrbitRows { arithmetic: &Float64, columns, eps: self.eps, paces };
        let mut points = ShownChain { chain: self, see, flow: ControlFlow::Continue(()) };
        match course.pass_rows(&mut points, range, rows, watch) {
            Ok(()) => Ending::plain(End::Complete, paces.in_all()),
            Err(EarlyEnd::Stopped(step)) => Ending::plain(End::Stopped(step), step),
            Err(EarlyEnd::Ended(step, _)) => Ending {
                end: End::Range(step),
                step,
                why: Some(format!(
                    "the orbit of {} leaves the range of f64 at step {}: at n = {step} det A = 0 nearly or the numbers are too \
                     large; the rows up to it are kept",
                    self.name,
                    step + 1
                )),
                instead: None,
                note: None,
            },
        }
    }
}

struct ShownChain<'a> {
    chain: &'a mut Chain,
    see: &'a mut dyn FnMut(&[f64]) -> ControlFlow<()>,
    flow: ControlFlow<()>,
}

impl OrbitPoints<Float64> for ShownChain<'_> {
    fn row(&mut self, cells: &mut Vec<f64>) {
        let Chain { map, state, variables, lattice, .. } = &mut *self.chain;
        self.flow = (self.see)(state);
        if variables.is_empty() {
            let arrays = lattice.arrays().len();
            for array in 0..arrays {
                let of_array = || state.iter().skip(array).step_by(arrays).copied();
                cells.extend(of_array().reduce(f64::min));
                cells.extend(of_array().reduce(f64::max));
            }
        } else {
            cells.extend_from_slice(state);
        }
        // The state has the length of the chain, so the call succeeds.
        cells.extend(map.integrals(state).into_iter().flatten());
        cells.extend(map.hamiltonian(state).ok().flatten());
        cells.extend(map.modified_energy(state).ok().flatten());
    }

    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd> {
        if steps > 0 && self.flow.is_break() {
            return Err(EarlyEnd::Stopped(0));
        }
        let Chain { map, state, .. } = &mut *self.chain;
        let followed = map.follow(state, steps, |steps| progress.tell(steps));
        EarlyEnd::of(&followed.expect("the state is of the chain"), || EndReason::Range)
    }

    fn at_once(&self, every: u64) -> usize {
        rows_in_milliseconds(self.chain.state.len(), every)
    }
}
