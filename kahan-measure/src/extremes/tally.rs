//! Counts of trials, a cell for each regime, tier and scalar; sums of cells do not depend on their
//! order.

use std::collections::BTreeMap;

use super::regime::Regime;

/// What became of the trials of one regime, tier and scalar.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// How many there were.
    pub trials: u64,
    /// The largest ‖error‖∞/‖exact‖∞ of a finite result where the exact step has a value, in units
    /// of the scalar; `None` without such a result, infinite beside an exact 0.
    pub max_error_u: Option<f64>,
    /// How many have no result: refused by `try_step`, or not finite.
    pub flagged: u64,
    /// How many flags of the stable tier are against its promise: a condition number below the
    /// bound, and an exact result that the format holds.
    pub unjustified: u64,
    /// How many results are outside their promise, without a flag.
    pub silently_wrong: u64,
}

/// The regime, the tier and the scalar of a cell.
pub type Place = (Regime, &'static str, &'static str);

/// A trial that broke a promise of the stable tier.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Failure {
    /// Whether it is a flag without right; else it is silently wrong, which comes first.
    pub is_flag: bool,
    /// The trial.
    pub index: u64,
    /// What was promised and what came, with the arguments.
    pub text: String,
}

/// Cells by their place, and the first failures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// The cells.
    pub cells: BTreeMap<Place, Cell>,
    /// The first failures of the stable tier: silently wrong, then flagged without right, each by
    /// its index.
    pub failures: Vec<Failure>,
}

/// As many failures of each kind are shown.
const SHOWN: usize = 3;

impl Tally {
    pub(crate) fn cell(&mut self, place: Place) -> &mut Cell {
        self.cells.entry(place).or_default()
    }

    pub(crate) fn fail(&mut self, failure: Failure) {
        let at = self.failures.partition_point(|known| *known <= failure);
        let is_flag = failure.is_flag;
        self.failures.insert(at, failure);
        let of_its_kind = || self.failures.iter().filter(|known| known.is_flag == is_flag);
        if of_its_kind().count() > SHOWN {
            let last = self.failures.iter().rposition(|known| known.is_flag == is_flag);
            last.map(|last| self.failures.remove(last));
        }
    }

    pub(crate) fn add(&mut self, other: Self) {
        for (place, theirs) in other.cells {
            let cell = self.cell(place);
            cell.trials += theirs.trials;
            cell.flagged += theirs.flagged;
            cell.unjustified += theirs.unjustified;
            cell.silently_wrong += theirs.silently_wrong;
            cell.note_error(theirs.max_error_u);
        }
        for failure in other.failures {
            self.fail(failure);
        }
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
