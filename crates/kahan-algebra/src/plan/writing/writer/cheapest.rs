//! Tries several ways to write a value, and keeps the one with the fewest operations.

use crate::poly::Polynomial;

use super::MatrixEntry;
use super::Writer;
use crate::plan::Node;
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::plan_draft::Signed;

impl Writer {
    /// Writes a polynomial in the cheapest of several ways to multiply ε into its terms.
    pub(in crate::plan) fn write_cheapest(&mut self, polynomial: &Polynomial) -> Signed {
        let ways = self.scaling.eps_distributions(polynomial);
        self.cheapest(&ways, |writer, way| writer.write(way, FormGoal::Few), |_| 0)
    }

    pub(in crate::plan) fn cheapest_entry(&mut self, polynomial: &Polynomial) -> MatrixEntry {
        let ways = self.scaling.eps_distributions(polynomial);
        let write = |writer: &mut Self, way: &Polynomial| MatrixEntry {
            polynomial: Some(way.clone()),
            written: writer.write(way, FormGoal::Few),
        };
        self.cheapest(&ways, write, |_| 0)
    }

    pub(in crate::plan) fn cheapest_term(&mut self, term: &Polynomial) -> (Vec<Node>, bool) {
        let ways = self.scaling.eps_distributions(term);
        let factors = |writer: &mut Self, way: &Polynomial| {
            let (monomial, coefficient) = way.leading_term().expect("a term is not zero");
            writer.factors_of_term(monomial, coefficient)
        };
        self.cheapest(&ways, factors, |(nodes, _)| nodes.len())
    }

    /// Tries all ways to write a value and keeps the cheapest. There must be at least one way.
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
        // The first way is often the best. Because it is tried last, its operations then remain.
        let result = write(self, first);
        match best {
            Some((size, attempt)) if size < self.draft.kernel_size() + price(&result) => {
                self.truncate(before);
                write(self, attempt)
            }
            _ => result,
        }
    }

    fn lengths(&self) -> [usize; 5] {
        [self.draft.length(), self.steps.len(), self.sums.len(), self.put.len(), self.coefficients.len()]
    }

    fn truncate(&mut self, [draft, made, sums, put, coefficients]: [usize; 5]) {
        self.draft.truncate(draft);
        self.made.truncate(made);
        self.steps.truncate(made);
        self.sums.truncate(sums);
        self.put.truncate(put);
        self.coefficients.truncate(coefficients);
    }
}
