//! Several ways to write one thing: each is tried, the one that makes the fewest steps is kept.

use crate::poly::Polynomial;

use super::super::Node;
use super::super::draft::Signed;
use super::super::nesting::Goal;
use super::{Entry, Writer};

impl Writer {
    /// A polynomial in plain symbols and ε, its powers of ε distributed in the way that adds the
    /// fewest steps.
    pub(in crate::plan) fn write_cheapest(&mut self, polynomial: &Polynomial) -> Signed {
        let ways = self.scaling.ways(polynomial);
        let written = self.cheapest(&ways, |writer, way| writer.write(way, Goal::Few), |_| 0);
        written.unwrap_or_else(|| Signed::plus(self.draft.zero()))
    }

    /// The same as an entry of a matrix.
    pub(in crate::plan) fn cheapest_entry(&mut self, polynomial: &Polynomial) -> Entry {
        let ways = self.scaling.ways(polynomial);
        let write = |writer: &mut Self, way: &Polynomial| Entry {
            polynomial: way.clone(),
            written: writer.write(way, Goal::Few),
        };
        let entry = self.cheapest(&ways, write, |_| 0);
        entry.unwrap_or_else(|| Entry {
            polynomial: Polynomial::zero(),
            written: Signed::plus(self.draft.zero()),
        })
    }

    /// The factors of a term, in the way that adds the fewest steps, and its sign.
    pub(in crate::plan) fn cheapest_term(&mut self, term: &Polynomial) -> (Vec<Node>, bool) {
        let ways = self.scaling.ways(term);
        let factors = |writer: &mut Self, way: &Polynomial| {
            way.leading_term()
                .map(|(monomial, coefficient)| writer.factors_of_term(monomial, coefficient))
                .unwrap_or_default()
        };
        self.cheapest(&ways, factors, |(nodes, _)| nodes.len()).unwrap_or_default()
    }

    /// The attempt that makes the fewest steps, its result's own price added; the others leave no
    /// trace.
    pub(in crate::plan) fn cheapest<A, R>(
        &mut self,
        attempts: &[A],
        mut write: impl FnMut(&mut Self, &A) -> R,
        price: impl Fn(&R) -> usize,
    ) -> Option<R> {
        let (first, rest) = attempts.split_first()?;
        if rest.is_empty() {
            return Some(write(self, first));
        }
        let mark = self.mark();
        let mut best: Option<(usize, &A)> = None;
        for attempt in attempts {
            let result = write(self, attempt);
            let size = self.draft.kernel_size() + price(&result);
            if best.is_none_or(|(least, _)| size < least) {
                best = Some((size, attempt));
            }
            self.back_to(&mark);
        }
        best.map(|(_, attempt)| write(self, attempt))
    }

    fn mark(&self) -> Mark {
        Mark {
            draft: self.draft.length(),
            made: self.made.len(),
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
        for polynomial in self.made.drain(mark.made..) {
            self.known.remove(&polynomial);
        }
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
