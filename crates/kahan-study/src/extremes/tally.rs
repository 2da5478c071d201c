//! Counts of trials, a cell for each regime, tier and scalar; sums of cells do not depend on their
//! order.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

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
    /// The systems whose stable tier broke its promise, with the first failure of each.
    pub broken: BTreeMap<String, Broken>,
}

/// How often a system broke the promise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broken {
    /// How often it was silently wrong.
    pub silently_wrong: u64,
    /// How often it was flagged without right.
    pub unjustified: u64,
    /// The first failure.
    pub first: Failure,
}

/// As many failures of each kind are shown.
const SHOWN: usize = 3;

impl Tally {
    pub(crate) fn cell(&mut self, place: Place) -> &mut Cell {
        self.cells.entry(place).or_default()
    }

    pub(crate) fn fail(&mut self, name: &str, failure: Failure) {
        let (silently_wrong, unjustified) = (u64::from(!failure.is_flag), u64::from(failure.is_flag));
        let broken = Broken { silently_wrong, unjustified, first: failure.clone() };
        self.note_broken(name.to_owned(), broken);
        self.show(failure);
    }

    fn note_broken(&mut self, name: String, more: Broken) {
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

    /// Keeps the failure if it is one of the first.
    fn show(&mut self, failure: Failure) {
        let at = self.failures.partition_point(|known| *known <= failure);
        let is_flag = failure.is_flag;
        self.failures.insert(at, failure);
        let of_its_kind = || self.failures.iter().filter(|known| known.is_flag == is_flag);
        if of_its_kind().count() > SHOWN {
            let last = self.failures.iter().rposition(|known| known.is_flag == is_flag);
            last.map(|last| self.failures.remove(last));
        }
    }

    /// Adds the counts and failures of another.
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
