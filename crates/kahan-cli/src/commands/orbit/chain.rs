//! Orbits of chains of any number of sites, in doubles.

use std::path::Path;

use kahan_algebra::arithmetic::Float64;
use kahan_study::MOST_VARIABLES;
use serde_json::{Map, Value, json};

use super::Orbit;
use super::rows::{AT_ONCE, columns};
use crate::numbers::{Printable, ScalarKind};
use crate::printing::{Answer, Broken, Npy, Refusal, Sink, Table};
use crate::reading::Chain;

/// Whether a file is to be an array of NumPy's.
pub(super) fn is_array(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "npy")
}

impl Orbit {
    /// The orbit of a chain that begins with what `--start` says.
    pub(super) fn chain(&self, start: &str) -> Result<Answer, Refusal> {
        if self.scalar != ScalarKind::F64 || self.order != 2 {
            return Err(Refusal::new(
                "--start is for chains, which are stepped by Kahan's map in f64: leave --scalar and --order out",
            ));
        }
        let array = self.out.as_deref().filter(|path| is_array(path));
        let has_table_file = self.out.is_some() && array.is_none();
        let most_names = if has_table_file { usize::MAX } else { MOST_VARIABLES };
        let chain = self.start.chain(start, most_names)?;
        let arrays = chain.lattice.arrays().len();
        let sizes = if arrays == 1 { vec![chain.sites] } else { vec![chain.sites, arrays] };
        let array = array.map(|path| Npy::new(Sink::file(path, "--out")?, sizes).map_err(Refusal::from));
        let orbit = ChainOrbit { array: array.transpose()?, chain };
        let head = self.chain_head(&orbit);
        self.write(head, [orbit], |mut orbit, rows, table| {
            let at_once = (AT_ONCE
                / i64::try_from(orbit.chain.state.len()).expect("the states fit into memory"))
            .max(1);
            let stopped =
                rows.follow(&mut orbit, at_once, |orbit, n| orbit.write(table, n), ChainOrbit::advance)?;
            if let Some(array) = orbit.array {
                array.finish()?;
            }
            Ok(stopped)
        })
    }

    fn chain_head(&self, orbit: &ChainOrbit) -> Map<String, Value> {
        let Chain { name, sites, eps, parameters, lattice, .. } = &orbit.chain;
        let parameters: Map<String, Value> =
            parameters.iter().map(|(name, value)| (name.clone(), Float64::json(value))).collect();
        let head = json!({
            "system": name,
            "arrays": lattice.arrays(),
            "sites": sites,
            "parameters": parameters,
            "eps": eps,
            "scalar": Float64::KIND.name(),
            "order": self.order,
            "steps": self.steps,
            "every": self.every,
            "columns": columns(&orbit.state_names(), &orbit.sum_names(), 1),
        });
        match head {
            Value::Object(head) => head,
            _ => Map::new(),
        }
    }
}

/// An orbit of a chain, and where its states go.
struct ChainOrbit {
    chain: Chain,
    /// The file of all states.
    array: Option<Npy>,
}

impl ChainOrbit {
    /// The variables; of a chain of many, the range of each array.
    fn state_names(&self) -> Vec<String> {
        if !self.chain.variables.is_empty() {
            return self.chain.variables.clone();
        }
        let range = |array: &String| [format!("{array}_min"), format!("{array}_max")];
        self.chain.lattice.arrays().iter().flat_map(range).collect()
    }

    /// The integrals, the Hamiltonian, the energy that the map keeps in its place.
    fn sum_names(&self) -> Vec<String> {
        let lattice = &self.chain.lattice;
        let energy = lattice.hamiltonian().map(|name| [name.to_owned(), format!("{name}_modified")]);
        let integrals = lattice.integrals().into_iter().map(str::to_owned);
        integrals.chain(energy.into_iter().flatten()).collect()
    }

    /// Writes the point n as a row, and the state to its file.
    fn write(&mut self, table: &mut Table, n: i64) -> Result<(), Broken> {
        let Chain { map, state, eps, variables, lattice, .. } = &mut self.chain;
        if let Some(array) = &mut self.array {
            array.row(state)?;
        }
        let mut values = vec![n as f64 * (*eps + *eps)];
        if variables.is_empty() {
            let arrays = lattice.arrays().len();
            for array in 0..arrays {
                let of_array = || state.iter().skip(array).step_by(arrays).copied();
                values.extend(of_array().reduce(f64::min));
                values.extend(of_array().reduce(f64::max));
            }
        } else {
            values.extend(&*state);
        }
        // The state is as long as the chain.
        values.extend(map.integrals(state).into_iter().flatten());
        values.extend(map.hamiltonian(state).ok().flatten());
        values.extend(map.modified_energy(state).ok().flatten());
        match table.row::<Float64>(n, values.iter().map(Some)) {
            // The file is wanted all the same.
            Err(Broken::ReaderGone) if self.array.is_some() => Ok(()),
            written => written,
        }
    }

    /// Goes from the point n to the one so many steps later; what to tell the user where there is
    /// none.
    fn advance(&mut self, n: i64, steps: i64) -> Result<(), String> {
        let Chain { map, state, name, .. } = &mut self.chain;
        for n in n..n + steps {
            map.step(state).map_err(|error| error.to_string())?;
            if !state.iter().all(|x| x.is_finite()) {
                return Err(format!(
                    "the orbit of {name} leaves the range of f64 at step {}: at n = {n} det A = 0 nearly or the numbers are too \
                     large; the rows up to it are kept",
                    n + 1
                ));
            }
        }
        Ok(())
    }
}
