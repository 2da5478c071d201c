//! Orbits of chains of any number of sites, in doubles: what goes into the table, and the states
//! into a file of NumPy's.

use std::ops::ControlFlow;
use std::path::Path;

use kahan_study::MOST_VARIABLES;
use serde_json::json;

use super::{Method, Orbit, ScalarKind};
use crate::printing::{Answer, Npy, Refusal, Sink};

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
        if self.method != Method::Kahan {
            return Err(Refusal::new(
                "--start is for chains, which are stepped by Kahan's map: leave --method out",
            ));
        }
        let array = self.out.as_deref().filter(|path| is_array(path));
        let has_table_file = self.out.is_some() && array.is_none();
        let most_names = if has_table_file { usize::MAX } else { MOST_VARIABLES };
        let mut chain = self.start.chain(start, most_names)?;
        let arrays = chain.lattice.arrays().len();
        let sizes = if arrays == 1 { vec![chain.sites] } else { vec![chain.sites, arrays] };
        let array = array.map(|path| Npy::new(Sink::file(path, "--out")?, sizes).map_err(Refusal::from));
        let mut array = array.transpose()?;
        let head = chain.head(self.steps, self.every);
        self.write(json!(head), vec![&mut chain], |chain, table, watch| {
            // The file is wanted even where nobody reads the table.
            table.outlive_reader(array.is_some());
            let mut written = Ok(());
            let see = &mut |state: &[f64]| {
                written = array.as_mut().map_or(Ok(()), |array| array.row(state));
                if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            };
            let end = chain.rows([self.steps, self.every], 0..u64::MAX, table, see, watch);
            written?;
            array.take().map_or(Ok(()), Npy::finish)?;
            Ok(end)
        })
    }
}
