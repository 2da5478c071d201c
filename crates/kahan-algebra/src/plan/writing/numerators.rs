//! Writes numerators, times powers of ε, as products of factors. Common products of two factors are
//! computed once.

use crate::poly::{Polynomial, Variable};

use crate::plan::Node;
use crate::plan::writing::factors::Factored;
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::scaling::over_eps;
use crate::plan::writing::writer::Writer;

/// The power of ε by which a numerator is multiplied.
#[derive(Clone, Copy, Debug)]
pub(in crate::plan) enum Power {
    Eps,
    OverEps(u32),
}

impl Power {
    fn times(self, polynomial: &Polynomial, epsilon: Variable) -> Polynomial {
        match self {
            Power::Eps => &Polynomial::variable(epsilon) * polynomial,
            Power::OverEps(power) => over_eps(polynomial, power, epsilon),
        }
    }

    /// Divides factors by ε where possible. Returns the new product and the remaining power of ε.
    fn cancelled(self, product: &Factored, epsilon: Variable) -> (Factored, Self) {
        let Power::OverEps(mut rest) = self else { return (product.clone(), self) };
        let mut product = product.clone();
        for (factor, exponent) in &mut product.factors {
            let cancels = factor.degree_in(epsilon).min(rest / *exponent);
            rest -= cancels * *exponent;
            *factor = over_eps(factor, cancels, epsilon);
        }
        (product, Power::OverEps(rest))
    }
}

pub(in crate::plan) struct Products {
    lists: Vec<Factors>,
}

#[derive(Clone, Debug, Default)]
struct Factors {
    nodes: Vec<Node>,
    negative: bool,
}

impl Products {
    pub(in crate::plan) fn new() -> Self {
        Products { lists: Vec::new() }
    }

    pub(in crate::plan) fn push(&mut self, writer: &mut Writer, product: &Factored, goal: FormGoal) {
        let (nodes, negative) = writer.factors_of_term(&product.monomial, &product.coefficient);
        let mut list = Factors { nodes, negative };
        for (factor, exponent) in &product.factors {
            let written = writer.write_scaled(factor, goal);
            list.add(written, *exponent);
        }
        self.lists.push(list);
    }

    /// Adds a product with a power of ε. The power is multiplied into the factor for which this
    /// takes the fewest operations.
    pub(in crate::plan) fn push_with(&mut self, writer: &mut Writer, product: &Factored, power: Power) {
        if product.coefficient.is_zero() {
            let zero = writer.draft.zero();
            self.lists.push(Factors { nodes: vec![zero], negative: false });
            return;
        }
        let epsilon = writer.scaling.epsilon();
        let (product, power) = power.cancelled(product, epsilon);
        let has_monomial = !product.monomial.is_one() || product.factors.is_empty();
        let places: Vec<usize> = (usize::from(!has_monomial)..=product.factors.len()).collect();
        let write = |writer: &mut Writer, place: &usize| with_power_at(writer, &product, power, *place);
        self.lists.push(writer.cheapest(&places, write, |list| list.nodes.len()));
    }

    /// Writes all products. Pairs of factors that occur in several products are multiplied first.
    pub(in crate::plan) fn finish(mut self, writer: &mut Writer) -> Vec<Signed> {
        while let Some((a, b)) = self.shared_pair() {
            let node = writer.draft.multiply(a, b);
            for list in &mut self.lists {
                list.replace_pair(a, b, node);
            }
        }
        let mut product =
            |Factors { nodes, negative }| Signed { node: writer.draft.product(&nodes), negative };
        self.lists.into_iter().map(&mut product).collect()
    }

    fn shared_pair(&self) -> Option<(Node, Node)> {
        let mut best: Option<(usize, (Node, Node))> = None;
        for list in &self.lists {
            for (index, &a) in list.nodes.iter().enumerate() {
                for &b in &list.nodes[index + 1..] {
                    let count = self.lists.iter().filter(|list| list.contains_pair(a, b)).count();
                    if count > 1 && best.is_none_or(|(most, _)| count > most) {
                        best = Some((count, (a, b)));
                    }
                }
            }
        }
        best.map(|(_, pair)| pair)
    }
}

impl Factors {
    fn add(&mut self, factor: Signed, exponent: u32) {
        self.nodes.extend(std::iter::repeat_n(factor.node, exponent as usize));
        self.negative ^= factor.negative && exponent % 2 == 1;
    }

    fn contains_pair(&self, a: Node, b: Node) -> bool {
        let count = |node: Node| self.nodes.iter().filter(|&&other| other == node).count();
        if a == b { count(a) > 1 } else { count(a) > 0 && count(b) > 0 }
    }

    fn replace_pair(&mut self, a: Node, b: Node, product: Node) {
        while self.contains_pair(a, b) {
            for node in [a, b] {
                if let Some(place) = self.nodes.iter().position(|&other| other == node) {
                    self.nodes.remove(place);
                }
            }
            self.nodes.push(product);
        }
    }
}

/// Multiplies the monomial (`place` 0) or the factor number `place` (from 1) by the power of ε.
fn with_power_at(writer: &mut Writer, product: &Factored, power: Power, place: usize) -> Factors {
    let epsilon = writer.scaling.epsilon();
    let mut list = Factors::default();
    for (index, (factor, exponent)) in product.factors.iter().enumerate() {
        let plain_exponent = if index + 1 == place { exponent - 1 } else { *exponent };
        if plain_exponent > 0 {
            let written = writer.write_cheapest(factor);
            list.add(written, plain_exponent);
        }
        if index + 1 == place {
            let written = writer.write_cheapest(&power.times(factor, epsilon));
            list.add(written, 1);
        }
    }
    let term = Polynomial::term(product.monomial.clone(), product.coefficient.clone());
    let term = if place == 0 { power.times(&term, epsilon) } else { term };
    let best = writer.cheapest_term(&term);
    list.nodes.extend(best.0);
    list.negative ^= best.1;
    list
}
