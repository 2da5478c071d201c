//! The plans of a field in which many products of two variables occur: sums in one order, so that
//! loops over packed coefficients have the plans' bits.

use kahan_syntax::rational::Rational;

use crate::kept::Kept;
use crate::poly::{Polynomial, Variable};
use crate::symbols::Symbols;

use super::{Node, Plan, PlanBuilder};

/// The fewest variables of a field that is dense.
const FEWEST_VARIABLES: usize = 10;
/// The fewest products of two variables in such a field: straight lines are faster for fewer.
const FEWEST_PRODUCTS: usize = 300;
/// In a dense field at least one product in this many has a coefficient other than 0.
const SPARSEST: usize = 10;

/// The coefficients of a dense field.
#[derive(Clone, Debug)]
pub(crate) struct DenseField {
    states: Vec<Variable>,
    /// For each component its coefficients: the constant, those of the variables, and those of
    /// their products xⱼxₖ with j ≤ k, row after row of that triangle.
    components: Vec<Vec<Polynomial>>,
}

impl DenseField {
    /// The field, if it is dense and its text has no sums as factors and no divisors.
    pub(crate) fn of(kept: &Kept, symbols: &Symbols) -> Option<Self> {
        let n = symbols.dimension();
        let fewest = FEWEST_PRODUCTS.max(n * n * (n + 1) / 2 / SPARSEST);
        let terms: usize = kept.components.iter().map(Polynomial::len).sum();
        if n < FEWEST_VARIABLES || !kept.values.values.is_empty() || terms < fewest {
            return None;
        }
        let mut field =
            DenseField { states: (0..n).map(|i| symbols.state(i)).collect(), components: Vec::new() };
        let mut found = 0;
        for component in &kept.components {
            let mut coefficients = vec![Polynomial::zero(); 1 + n + n * (n + 1) / 2];
            for (monomial, coefficient) in component.group(|variable| symbols.is_state(variable)) {
                let factors = monomial.powers().iter().flat_map(|&(variable, power)| {
                    std::iter::repeat_n(usize::from(variable.0), power as usize)
                });
                let place = match factors.collect::<Vec<_>>()[..] {
                    [] => 0,
                    [j] => 1 + j,
                    [j, k] => {
                        found += 1;
                        field.place(j.min(k), j.max(k))
                    }
                    _ => return None,
                };
                coefficients[place] = coefficient;
            }
            field.components.push(coefficients);
        }
        (found >= fewest).then_some(field)
    }

    /// How many variables it has.
    pub(crate) fn dimension(&self) -> usize {
        self.states.len()
    }

    /// The places of the entries of f′, row by row.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let n = self.dimension();
        (0..n * n).map(move |place| (place / n, place % n))
    }

    /// Whether ∂fᵢ/∂xⱼ is not identically zero.
    pub(crate) fn depends(&self, (i, j): (usize, usize)) -> bool {
        let coefficients = &self.components[i];
        let product = |k: usize| &coefficients[self.place(j.min(k), j.max(k))];
        !coefficients[1 + j].is_zero() || (0..self.dimension()).any(|k| !product(k).is_zero())
    }

    /// The place of the coefficient of xⱼxₖ, j ≤ k.
    fn place(&self, j: usize, k: usize) -> usize {
        let n = self.states.len();
        1 + n + j * n - j * (j + 1) / 2 + k
    }

    /// All coefficients, one component after the other.
    pub(crate) fn coefficients(&self) -> Plan {
        Plan::of(self.components.iter().flatten())
    }

    /// f(x): cᵢ + Σⱼ xⱼ·(bᵢⱼ + Σₖ qᵢⱼₖxₖ), k ≥ j, in this order.
    pub(crate) fn field(&self) -> Plan {
        let mut builder = PlanBuilder::default();
        let component = |coefficients: &Vec<Polynomial>| {
            let constant = builder.polynomial(&coefficients[0]);
            (0..self.states.len()).fold(constant, |sum, j| {
                let linear = builder.polynomial(&coefficients[1 + j]);
                let cofactor = (j..self.states.len()).fold(linear, |sum, k| {
                    let term = self.term(&mut builder, coefficients, [j, k], k);
                    builder.add(sum, term)
                });
                let state = builder.input(self.states[j]);
                let product = builder.multiply(state, cofactor);
                builder.add(sum, product)
            })
        };
        let components: Vec<Node> = self.components.iter().map(component).collect();
        builder.finish(&components)
    }

    /// Entries ∂fᵢ/∂xⱼ of f′(x): bᵢⱼ + Σₖ qᵢⱼₖxₖ, in this order; k = j counts twice.
    pub(crate) fn slopes(&self, entries: impl IntoIterator<Item = (usize, usize)>) -> Plan {
        let mut builder = PlanBuilder::default();
        let slope = |(i, j): (usize, usize)| {
            let coefficients = &self.components[i];
            let linear = builder.polynomial(&coefficients[1 + j]);
            (0..self.states.len()).fold(linear, |sum, k| {
                let term = self.term(&mut builder, coefficients, [j.min(k), j.max(k)], k);
                let term = if j == k { builder.add(term, term) } else { term };
                builder.add(sum, term)
            })
        };
        let entries: Vec<Node> = entries.into_iter().map(slope).collect();
        builder.finish(&entries)
    }

    /// The coefficient of a product, times the variable with index `k`.
    fn term(&self, builder: &mut PlanBuilder, of: &[Polynomial], [i, j]: [usize; 2], k: usize) -> Node {
        let coefficient = &of[self.place(i, j)];
        if coefficient.is_zero() {
            return builder.constant(&Rational::zero());
        }
        let coefficient = builder.polynomial(coefficient);
        let state = builder.input(self.states[k]);
        builder.multiply(coefficient, state)
    }
}
