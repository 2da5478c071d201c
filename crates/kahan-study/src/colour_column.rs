//! The number by which a chart colours each orbit.

use kahan_runtime::Observable;

use crate::error::StudyError;
use crate::question::Observe;
use crate::rows::{StoredColumn, Table};
use crate::study::Study;

/// An observable with a single number, or one column of an observable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColourColumn {
    /// The observable.
    pub observable: Observable,
    /// The name of the column. `drift` is no column, and stands for the largest drift of all
    /// integrals.
    pub column: String,
}

impl ColourColumn {
    /// Finds an observable with a single number, or a column, by name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let observable = Observable::of_column(name)?;
        let column = match observable.label() {
            _ if name != observable.name() => name,
            label => label.map(|_| observable.key())?,
        };
        Some(ColourColumn { observable, column: column.to_owned() })
    }

    /// Reads the name of an observable with a single number, or of one column of an observable.
    ///
    /// # Errors
    /// [`StudyError::UnknownColumn`], and [`StudyError::NoIntegral`] for drifts of a field without
    /// integrals.
    pub fn read(name: &str, study: &Study) -> Result<Self, StudyError> {
        let names = |of: Observe| of.columns(study).into_iter().map(|column| column.name).collect::<Vec<_>>();
        if let Some(shade) = Self::named(name) {
            let alone = Observe::of(vec![shade.observable], 0);
            alone.has_integrals(study)?;
            if shade.is_of_all() || names(alone).contains(&shade.column) {
                return Ok(shade);
            }
        }
        let known = names(Observe::of(Observable::ALL.to_vec(), 0));
        Err(StudyError::UnknownColumn { name: name.to_owned(), known })
    }

    fn is_of_all(&self) -> bool {
        self.observable == Observable::Drift && self.column == self.observable.name()
    }

    /// Returns the observed number of each row; NaN for an orbit without such a number.
    ///
    /// # Panics
    /// If the table was not observed with this observable alone.
    #[must_use]
    pub fn values<'a>(&self, table: &'a Table) -> Vec<f64> {
        let floats = |kept: &'a StoredColumn| match kept {
            StoredColumn::F64(numbers) => numbers,
            other => unreachable!("what is observed is a number, and not {other:?}"),
        };
        // A parameter may also be called `ended`, but only the observed column contains text.
        let is_word = |place: &usize| matches!(table.values[*place], StoredColumn::Text(_));
        let is_end = |place: &usize| is_word(place) && table.columns[*place].name == "ended";
        let place_of_end = (0..table.values.len()).find(is_end).expect("a row an orbit");
        let [StoredColumn::Text(ended), StoredColumn::Integer(steps), seen @ ..] =
            &table.values[place_of_end..]
        else {
            unreachable!("how an orbit ended is a word and a count")
        };
        if self.is_of_all() {
            // Each integral has two columns: the largest drift, then the drift at the last point.
            let drifts: Vec<&Vec<f64>> = seen.iter().step_by(2).map(floats).collect();
            let largest = |row: usize| drifts.iter().map(|drifts| drifts[row]).fold(f64::NAN, f64::max);
            return (0..ended.len()).map(largest).collect();
        }
        let of_seen = table.columns[place_of_end + 2..].iter().position(|column| column.name == self.column);
        let mut values = floats(&seen[of_seen.expect("a column of the observable")]).clone();
        if self.observable == Observable::Escape {
            // An orbit that ended with `range` escaped in the step after its last finite point.
            for row in (0..ended.len()).filter(|row| ended[*row] == "range" && steps[*row] > 0) {
                values[row] = (steps[row] + 1) as f64;
            }
        }
        values
    }
}
