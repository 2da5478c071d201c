//! Several ways to write one thing: each is tried, the one that makes the fewest operations is
//! kept.

use crate::poly::Polynomial;

use super::Entry;
use super::Writer;
use crate::plan::Node;
use crate::plan::writing::draft::Signed;
use crate::plan::writing::nesting::Goal;

impl Writer {
    /// A polynomial in plain symbols and ε, its powers of ε distributed in the way that adds the
    /// fewest operations.
    pub(in crate::plan) fn write_cheapest(&mut self, polynomial: &Polynomial) -> Signed {
        let ways = self.scaling.ways(polynomial);
        self.cheapest(&ways, |writer, way| writer.write(way, Goal::Few), |_| 0)
    }

    /// The same as an entry of a matrix.
    pub(in crate::plan) fn cheapest_entry(&mut self, polynomial: &Polynomial) -> Entry {
        let ways = self.scaling.ways(polynomial);
        let write = |writer: &mut Self, way: &Polynomial| Entry {
            polynomial: Some(way.clone()),
            written: writer.write(way, Goal::Few),
        };
        self.cheapest(&ways, write, |_| 0)
    }

    /// The factors of a term, in the way that adds the fewest operations, and its sign.
    pub(in crate::plan) fn cheapest_term(&mut self, term: &Polynomial) -> (Vec<Node>, bool) {
        let ways = self.scaling.ways(term);
        let factors = |writer: &mut Self, way: &Polynomial| {
            let (monomial, coefficient) = way.leading_term().expect("a term is not zero");
            writer.factors_of_term(monomial, coefficient)
        };
        self.cheapest(&ways, factors, |(nodes, _)| nodes.len())
    }

    /// Of one attempt or more that which makes the fewest operations, its result's own price added,
    /// the first of several; the others leave no trace.
    pub(in crate::plan) fn cheapest<A, R>(
        &mut self,
        attempts: &[A],
        mut write: impl FnMut(&mut Self, &A) -> R,
        price: impl Fn(&R) -> usize,
    ) -> R {
        let (first, others) = attempts.split_first().expect("there is an attempt");
        let before = self.lengths();
        let mut best: Option<(usize, &A)> = None;
        for attempt in others {
            let result = write(self, attempt);
            let size = self.draft.kernel_size() + price(&result);
            if best.is_none_or(|(least, _)| size < least) {
                best = Some((size, attempt));
            }
            self.truncate(before);
        }
        // The first comes last: where it is the best, as it often is, it is written already.
        let result = write(self, first);
        match best {
            Some((size, attempt)) if size < self.draft.kernel_size() + price(&result) => {
                self.truncate(before);
                write(self, attempt)
            }
            _ => result,
        }
    }

    /// Returns how long each of the writer's lists is, to go back to with [`Self::truncate`].
    fn lengths(&self) -> [usize; 5] {
        [self.draft.length(), self.steps.len(), self.sums.len(), self.put.len(), self.coefficients.len()]
    }

    /// Forgets what was written since the lists had these lengths.
    fn truncate(&mut self, [draft, made, sums, put, coefficients]: [usize; 5]) {
        self.draft.truncate(draft);
        self.made.truncate(made);
        self.steps.truncate(made);
        self.sums.truncate(sums);
        self.put.truncate(put);
        self.coefficients.truncate(coefficients);
    }
}
