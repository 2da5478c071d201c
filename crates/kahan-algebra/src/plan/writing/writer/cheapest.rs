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
        let mark = self.mark();
        let mut best: Option<(usize, &A)> = None;
        for attempt in others {
            let result = write(self, attempt);
            let size = self.draft.kernel_size() + price(&result);
            if best.is_none_or(|(least, _)| size < least) {
                best = Some((size, attempt));
            }
            self.back_to(&mark);
        }
        // The first comes last: where it is the best, as it often is, it is written already.
        let result = write(self, first);
        match best {
            Some((size, attempt)) if size < self.draft.kernel_size() + price(&result) => {
                self.back_to(&mark);
                write(self, attempt)
            }
            _ => result,
        }
    }

    fn mark(&self) -> Mark {
        Mark {
            draft: self.draft.length(),
            made: self.steps.len(),
            sums: self.sums.len(),
            put: self.put.len(),
            coefficients: self.coefficients.len(),
        }
    }

    /// Forgets what was written since.
    fn back_to(&mut self, mark: &Mark) {
        self.draft.truncate(mark.draft);
        self.sums.truncate(mark.sums);
        self.put.truncate(mark.put);
        self.coefficients.truncate(mark.coefficients);
        self.made.truncate(mark.made);
        self.steps.truncate(mark.made);
    }
}

/// How much was written.
struct Mark {
    draft: usize,
    made: usize,
    sums: usize,
    put: usize,
    coefficients: usize,
}
