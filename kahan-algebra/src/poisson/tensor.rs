//! A Poisson tensor as data, and what can be asked of it.

use crate::poly::{Budget, OverBudget, Variable};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;
use crate::system::upper_index;

use super::PoissonError;

/// An antisymmetric tensor P_jk = {x_j, x_k} of reduced rational functions.
///
/// Equal tensors are equal as data. Whether Jacobi's identity holds is [asked](Self::is_poisson), not assumed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PoissonTensor {
    states: Vec<Variable>,
    /// Above the diagonal, row by row.
    entries: Vec<RationalFunction>,
}

impl PoissonTensor {
    /// The tensor with these entries above its diagonal, in the order of [`upper_index`].
    ///
    /// # Errors
    /// Fewer than two states, or not n(n−1)/2 entries.
    pub fn new(symbols: &Symbols, entries: Vec<RationalFunction>) -> Result<Self, PoissonError> {
        let dimension = symbols.dimension();
        if dimension < 2 {
            return Err(PoissonError::Dimension { dimension });
        }
        if entries.len() != dimension * (dimension - 1) / 2 {
            return Err(PoissonError::EntryCount { dimension, given: entries.len() });
        }
        Ok(PoissonTensor { states: (0..dimension).map(|i| symbols.state(i)).collect(), entries })
    }

    /// n, the number of states.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.states.len()
    }

    /// The entries above the diagonal, in the order of [`upper_index`].
    #[must_use]
    pub fn entries(&self) -> &[RationalFunction] {
        &self.entries
    }

    /// {x_i, x_j}, for any i and j below n.
    ///
    /// # Panics
    /// For an index that is not below n.
    #[must_use]
    pub fn entry(&self, i: usize, j: usize) -> RationalFunction {
        let n = self.dimension();
        assert!(i < n && j < n, "a tensor of {n} states has no entry ({i}, {j})");
        match i.cmp(&j) {
            std::cmp::Ordering::Less => self.entries[upper_index(n, i, j)].clone(),
            std::cmp::Ordering::Equal => RationalFunction::zero(),
            std::cmp::Ordering::Greater => -&self.entries[upper_index(n, j, i)],
        }
    }

    /// Whether every entry is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.entries.iter().all(RationalFunction::is_zero)
    }

    /// The tensor times a function; in dimension 3 (and 2) it satisfies Jacobi's identity if this one does.
    ///
    /// # Errors
    /// More work than the budget allows.
    pub fn scaled(&self, factor: &RationalFunction, budget: &mut Budget) -> Result<Self, OverBudget> {
        let entries = self.entries.iter().map(|entry| entry.mul_within(factor, budget));
        Ok(PoissonTensor { states: self.states.clone(), entries: entries.collect::<Result<_, _>>()? })
    }

    /// P dF, the vector Σ_k P_jk ∂F/∂x_k = {x_j, F}; the flow ẋ = P dF has the Hamiltonian F.
    ///
    /// # Errors
    /// More work than the budget allows.
    pub fn hamiltonian_field(
        &self,
        function: &RationalFunction,
        budget: &mut Budget,
    ) -> Result<Vec<RationalFunction>, OverBudget> {
        let slopes = self.gradient(function, budget)?;
        (0..self.dimension())
            .map(|j| {
                let terms = slopes.iter().enumerate().map(|(k, slope)| (self.entry(j, k), slope));
                sum_of_products(terms, budget)
            })
            .collect()
    }

    /// {F, G} = Σ P_jk ∂F/∂x_j ∂G/∂x_k.
    ///
    /// # Errors
    /// More work than the budget allows.
    pub fn bracket(
        &self,
        left: &RationalFunction,
        right: &RationalFunction,
        budget: &mut Budget,
    ) -> Result<RationalFunction, OverBudget> {
        let slopes = self.gradient(left, budget)?;
        let field = self.hamiltonian_field(right, budget)?;
        sum_of_products(field.into_iter().zip(&slopes), budget)
    }

    /// Whether P dF = 0: F commutes with every function.
    ///
    /// # Errors
    /// More work than the budget allows.
    pub fn is_casimir(&self, function: &RationalFunction, budget: &mut Budget) -> Result<bool, OverBudget> {
        Ok(self.hamiltonian_field(function, budget)?.iter().all(RationalFunction::is_zero))
    }

    /// The Schouten bracket of two tensors of the same states, for all i < j < k in lexicographic order: the sum over the
    /// cyclic permutations of (i,j,k) of Σ_l (P_il ∂Q_jk/∂x_l + Q_il ∂P_jk/∂x_l). For P = Q it is twice Jacobi's sum.
    ///
    /// # Errors
    /// More work than the budget allows.
    ///
    /// # Panics
    /// If the tensors have different numbers of states.
    pub fn schouten(&self, other: &Self, budget: &mut Budget) -> Result<Vec<RationalFunction>, OverBudget> {
        let n = self.dimension();
        assert_eq!(n, other.dimension(), "tensors of one space");
        let mut sums = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                for k in j + 1..n {
                    let mut sum = RationalFunction::zero();
                    for (a, b, c) in [(i, j, k), (j, k, i), (k, i, j)] {
                        for (left, right) in [(self, other), (other, self)] {
                            let slopes = right.gradient(&right.entry(b, c), budget)?;
                            let terms = slopes.iter().enumerate().map(|(l, slope)| (left.entry(a, l), slope));
                            sum = sum.add_within(&sum_of_products(terms, budget)?, budget)?;
                        }
                    }
                    sums.push(sum);
                }
            }
        }
        Ok(sums)
    }

    /// Whether Jacobi's identity holds.
    ///
    /// # Errors
    /// More work than the budget allows.
    pub fn is_poisson(&self, budget: &mut Budget) -> Result<bool, OverBudget> {
        Ok(self.schouten(self, budget)?.iter().all(RationalFunction::is_zero))
    }

    /// Whether the Schouten bracket vanishes; for two Poisson tensors this says that P + λQ is Poisson for every λ.
    ///
    /// # Errors
    /// More work than the budget allows.
    ///
    /// # Panics
    /// If the tensors have different numbers of states.
    pub fn is_compatible_with(&self, other: &Self, budget: &mut Budget) -> Result<bool, OverBudget> {
        Ok(self.schouten(other, budget)?.iter().all(RationalFunction::is_zero))
    }

    fn gradient(
        &self,
        function: &RationalFunction,
        budget: &mut Budget,
    ) -> Result<Vec<RationalFunction>, OverBudget> {
        self.states.iter().map(|&state| function.derivative_within(state, budget)).collect()
    }
}

fn sum_of_products<'a>(
    terms: impl Iterator<Item = (RationalFunction, &'a RationalFunction)>,
    budget: &mut Budget,
) -> Result<RationalFunction, OverBudget> {
    let mut sum = RationalFunction::zero();
    for (left, right) in terms.filter(|(left, right)| !left.is_zero() && !right.is_zero()) {
        sum = sum.add_within(&left.mul_within(right, budget)?, budget)?;
    }
    Ok(sum)
}
