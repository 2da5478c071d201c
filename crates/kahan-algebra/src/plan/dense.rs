//! Plans for fields with very many products of two variables. Sums have a fixed order, so a loop
//! over packed coefficients and straight-line code give the same bits.

use kahan_syntax::rational::Rational;

use crate::poly::{Monomial, Polynomial, Variable};
use crate::subexpressions::FieldWithSubexpressions;
use crate::symbols::Symbols;

use super::{Node, Plan, PlanBuilder};

const FEWEST_VARIABLES: usize = 10;
/// A dense field has at least this many products of two variables. With fewer, straight-line code
/// is faster.
const FEWEST_PRODUCTS: usize = 300;
/// In n variables, a dense field has at least n²(n + 1)/2 terms, divided by this number.
const PRODUCTS_PER_NONZERO: usize = 10;

#[derive(Clone, Debug)]
enum Coefficient {
    Number(Rational),
    Sum(Polynomial),
}

impl Coefficient {
    fn is_zero(&self) -> bool {
        match self {
            Coefficient::Number(number) => number.is_zero(),
            Coefficient::Sum(sum) => sum.is_zero(),
        }
    }

    fn node(&self, builder: &mut PlanBuilder) -> Node {
        match self {
            Coefficient::Number(number) => builder.constant(number),
            Coefficient::Sum(sum) => builder.polynomial(sum),
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct DenseField {
    states: Vec<Variable>,
    /// The coefficients of each component: the constant, those of variables, and those of products
    /// xⱼxₖ with j ≤ k.
    components: Vec<Vec<Coefficient>>,
}

impl DenseField {
    /// Returns the field in dense form. Returns `None` if the field has divisors, sums as factors,
    /// or few products of two variables.
    pub(crate) fn of(kept: &FieldWithSubexpressions, symbols: &Symbols) -> Option<Self> {
        let n = symbols.dimension();
        let fewest = FEWEST_PRODUCTS.max(n * n * (n + 1) / 2 / PRODUCTS_PER_NONZERO);
        let terms: usize = kept.components.iter().map(Polynomial::len).sum();
        if n < FEWEST_VARIABLES || !kept.values.values.is_empty() || terms < fewest {
            return None;
        }
        let mut field =
            DenseField { states: (0..n).map(|i| symbols.state(i)).collect(), components: Vec::new() };
        let mut found = 0;
        for component in &kept.components {
            let mut coefficients = vec![Coefficient::Number(Rational::ZERO); 1 + n + n * (n + 1) / 2];
            let mut put = |monomial: &Monomial, coefficient| {
                let place = match *monomial.powers() {
                    [] => 0,
                    [(j, 1)] => 1 + usize::from(j.0),
                    [(j, 2)] => field.place(j.0.into(), j.0.into()),
                    [(j, 1), (k, 1)] => field.place(j.0.into(), k.0.into()),
                    _ => return None,
                };
                found += usize::from(monomial.degree() == 2);
                coefficients[place] = coefficient;
                Some(())
            };
            if symbols.parameters.is_empty() {
                for (monomial, value) in component.terms() {
                    put(monomial, Coefficient::Number(value.clone()))?;
                }
            } else {
                for (monomial, sum) in component.group(|variable| symbols.is_state(variable)) {
                    put(&monomial, sum.as_constant().map_or(Coefficient::Sum(sum), Coefficient::Number))?;
                }
            }
            field.components.push(coefficients);
        }
        (found >= fewest).then_some(field)
    }

    pub(crate) fn dimension(&self) -> usize {
        self.states.len()
    }

    pub(crate) fn entries(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let n = self.dimension();
        (0..n * n).map(move |place| (place / n, place % n))
    }

    pub(crate) fn depends(&self, (i, j): (usize, usize)) -> bool {
        let coefficients = &self.components[i];
        let product = |k: usize| &coefficients[self.place(j.min(k), j.max(k))];
        !coefficients[1 + j].is_zero() || (0..self.dimension()).any(|k| !product(k).is_zero())
    }

    /// Returns the index of the coefficient of xⱼxₖ, where j ≤ k.
    fn place(&self, j: usize, k: usize) -> usize {
        let n = self.states.len();
        1 + n + j * n - j * (j + 1) / 2 + k
    }

    pub(crate) fn coefficients(&self) -> Plan {
        let mut builder = PlanBuilder::default();
        let outputs: Vec<Node> =
            self.components.iter().flatten().map(|coefficient| coefficient.node(&mut builder)).collect();
        builder.finish(&outputs)
    }

    pub(crate) fn numbers(&self) -> Option<Vec<&Rational>> {
        let coefficients = self.components.iter().flatten().map(|coefficient| match coefficient {
            Coefficient::Number(number) => Some(number),
            Coefficient::Sum(_) => None,
        });
        coefficients.collect()
    }

    /// Returns the plan of the field with components cᵢ + Σⱼ xⱼ·(bᵢⱼ + Σₖ qᵢⱼₖxₖ), k ≥ j.
    pub(crate) fn field(&self) -> Plan {
        let mut builder = PlanBuilder::default();
        let component = |coefficients: &Vec<Coefficient>| {
            let constant = coefficients[0].node(&mut builder);
            (0..self.states.len()).fold(constant, |sum, j| {
                let linear = coefficients[1 + j].node(&mut builder);
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

    /// Returns the plan of entries ∂fᵢ/∂xⱼ = bᵢⱼ + Σₖ qᵢⱼₖxₖ. The term with k = j is doubled.
    pub(crate) fn slopes(&self, entries: impl IntoIterator<Item = (usize, usize)>) -> Plan {
        let mut builder = PlanBuilder::default();
        let slope = |(i, j): (usize, usize)| {
            let coefficients = &self.components[i];
            let linear = coefficients[1 + j].node(&mut builder);
            (0..self.states.len()).fold(linear, |sum, k| {
                let term = self.term(&mut builder, coefficients, [j.min(k), j.max(k)], k);
                let term = if j == k { builder.add(term, term) } else { term };
                builder.add(sum, term)
            })
        };
        let entries: Vec<Node> = entries.into_iter().map(slope).collect();
        builder.finish(&entries)
    }

    fn term(&self, builder: &mut PlanBuilder, of: &[Coefficient], [i, j]: [usize; 2], k: usize) -> Node {
        let coefficient = &of[self.place(i, j)];
        if coefficient.is_zero() {
            return builder.constant(&Rational::zero());
        }
        let coefficient = coefficient.node(builder);
        let state = builder.input(self.states[k]);
        builder.multiply(coefficient, state)
    }
}
