//! Counts trials for each regime, scalar type, and kind of step such as `fast` or `try_step`.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use serde::{Serialize, Serializer};

use super::regime::Regime;

/// Counts of the trials of one regime, kind of step and scalar type.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Cell {
    /// The number of trials.
    pub trials: u64,
    /// The largest relative error ‖error‖∞/‖exact‖∞ in multiples of u = 2^−precision; `None`
    /// without results.
    #[serde(serialize_with = "finite")]
    pub max_error_u: Option<f64>,
    /// The number of trials without a result: `try_step` refused, or the result was not finite.
    pub flagged: u64,
    /// The number of steps that `try_step` refused, although they are well-conditioned and the
    /// scalar type holds their results.
    #[serde(rename = "unjustified_flags")]
    pub unjustified: u64,
    /// The number of wrong results without a reported failure. A result of `try_step` is wrong if
    /// its error exceeds the bound, and other results if their relative error exceeds 1e-3.
    pub silently_wrong: u64,
}

/// The regime, the kind of step and the scalar type whose trials one [`Cell`] counts.
pub type CellKey = (Regime, &'static str, &'static str);

/// A trial in which `try_step` violated its error bound, or refused without a reason.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(transparent)]
pub struct Failure {
    /// Whether `try_step` refused without a reason; otherwise the result was wrong.
    #[serde(skip)]
    pub is_flag: bool,
    /// The index of the trial, which determines the inputs.
    #[serde(skip)]
    pub index: u64,
    /// The violated guarantee, the result, and the arguments of the step.
    pub text: String,
}

/// The counts for each regime, kind of step and scalar type, and the first failures of `try_step`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Tally {
    /// The counts for each regime, kind of step and scalar type.
    #[serde(serialize_with = "by_place")]
    pub cells: BTreeMap<CellKey, Cell>,
    /// The failures of `try_step` in each system, by the system's name.
    #[serde(serialize_with = "by_system")]
    pub broken: BTreeMap<String, BrokenPromises>,
    /// The first failures of `try_step`: wrong results by index, then refusals by index.
    pub failures: Vec<Failure>,
}

/// The failures of `try_step` in one system.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BrokenPromises {
    /// The equations of a random field; empty for systems of the catalog.
    pub text: String,
    /// The number of wrong results without a warning.
    pub silently_wrong: u64,
    /// The number of well-conditioned steps that `try_step` refused.
    #[serde(rename = "unjustified_flags")]
    pub unjustified: u64,
    /// The first failure in the order of [`Tally::failures`].
    pub first: Failure,
}

/// Writes infinity as `f64::MAX`, as JSON has no infinity.
fn finite<S: Serializer>(error: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    error.map(|error| error.min(f64::MAX)).serialize(serializer)
}

fn by_place<S: Serializer>(cells: &BTreeMap<CellKey, Cell>, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Object<'a> {
        regime: &'static str,
        tier: &'static str,
        scalar: &'static str,
        #[serde(flatten)]
        cell: &'a Cell,
    }
    let cells = cells.iter();
    serializer.collect_seq(cells.map(|(&(regime, tier, scalar), cell)| Object {
        regime: regime.name(),
        tier,
        scalar,
        cell,
    }))
}

fn by_system<S: Serializer>(
    systems: &BTreeMap<String, BrokenPromises>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Object<'a> {
        name: &'a str,
        #[serde(flatten)]
        broken: &'a BrokenPromises,
    }
    serializer.collect_seq(systems.iter().map(|(name, broken)| Object { name, broken }))
}

const MAX_SHOWN_FAILURES: usize = 3;

impl Tally {
    pub(crate) fn cell(&mut self, place: CellKey) -> &mut Cell {
        self.cells.entry(place).or_default()
    }

    pub(crate) fn fail(&mut self, name: &str, failure: Failure) {
        let (silently_wrong, unjustified) = (u64::from(!failure.is_flag), u64::from(failure.is_flag));
        let broken =
            BrokenPromises { text: String::new(), silently_wrong, unjustified, first: failure.clone() };
        self.note_broken(name.to_owned(), broken);
        self.show(failure);
    }

    fn note_broken(&mut self, name: String, more: BrokenPromises) {
        match self.broken.entry(name) {
            Entry::Vacant(place) => drop(place.insert(more)),
            Entry::Occupied(mut place) => {
                let known = place.get_mut();
                known.silently_wrong += more.silently_wrong;
                known.unjustified += more.unjustified;
                if more.first < known.first {
                    known.first = more.first;
                }
            }
        }
    }

    fn show(&mut self, failure: Failure) {
        let at = self.failures.partition_point(|known| *known <= failure);
        let is_flag = failure.is_flag;
        self.failures.insert(at, failure);
        let of_its_kind = || self.failures.iter().filter(|known| known.is_flag == is_flag);
        if of_its_kind().count() > MAX_SHOWN_FAILURES {
            let last = self.failures.iter().rposition(|known| known.is_flag == is_flag);
            last.map(|last| self.failures.remove(last));
        }
    }

    /// Adds the counts and failures of another tally.
    pub fn add(&mut self, other: Self) {
        for (place, theirs) in other.cells {
            let cell = self.cell(place);
            cell.trials += theirs.trials;
            cell.flagged += theirs.flagged;
            cell.unjustified += theirs.unjustified;
            cell.silently_wrong += theirs.silently_wrong;
            cell.note_error(theirs.max_error_u);
        }
        other.failures.into_iter().for_each(|failure| self.show(failure));
        other.broken.into_iter().for_each(|(name, more)| self.note_broken(name, more));
    }
}

impl Cell {
    pub(crate) fn note_error(&mut self, error: Option<f64>) {
        self.max_error_u = match (self.max_error_u, error) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No known system fails, so only this test writes a failure.
    #[test]
    fn a_broken_promise_is_written_with_its_first_failure() {
        let mut tally = Tally::default();
        tally.cell((Regime::Ordinary, "stable", "f64")).max_error_u = Some(f64::INFINITY);
        for (is_flag, index) in [(true, 3), (false, 7), (false, 5)] {
            tally.fail("Odd", Failure { is_flag, index, text: format!("trial {index}") });
        }
        let written = serde_json::json!(tally);
        assert_eq!(written["cells"][0]["regime"], "ordinary");
        assert_eq!(written["cells"][0]["max_error_u"], f64::MAX);
        let first = serde_json::json!({
            "name": "Odd", "text": "", "silently_wrong": 2, "unjustified_flags": 1, "first": "trial 5",
        });
        assert_eq!(written["broken"], serde_json::json!([first]));
        assert_eq!(written["failures"], serde_json::json!(["trial 5", "trial 7", "trial 3"]));
    }
}
