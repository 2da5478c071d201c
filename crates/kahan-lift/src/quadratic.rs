//! The equations of a lift: derivatives as quadratic polynomials in the lifted variables.
//!
//! A monomial such as x² can often be written in several ways, as x·x or as the variable that
//! stands for it. Every way is right on the relations between the variables, but beside them the
//! fields differ, so all ways are listed, up to a limit.

use std::collections::BTreeMap;

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational_function::RationalFunction;

use crate::laurent::{Laurent, Monomial};
use crate::ring::Ring;

/// The factors of a product of at most two variables, the first not greater; `None` is 1.
pub(crate) type Pair = (Option<usize>, Option<usize>);

/// A quadratic polynomial in the lifted variables.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Quadratic(pub BTreeMap<Pair, RationalFunction>);

impl Quadratic {
    /// A multiple of a variable.
    pub(crate) fn multiple(variable: usize, factor: &RationalFunction) -> Self {
        let mut sum = Self::default();
        sum.add((None, Some(variable)), factor);
        sum
    }

    /// A polynomial of degree at most two in the states.
    pub(crate) fn in_states(polynomial: &Laurent) -> Self {
        let mut sum = Self::default();
        for (monomial, coefficient) in polynomial.terms() {
            let repeated = |(state, power): (usize, i16)| {
                std::iter::repeat_n(state, usize::try_from(power).expect("a power of a polynomial"))
            };
            let mut factors = monomial.powers().flat_map(repeated);
            sum.add((factors.next(), factors.next()), coefficient);
        }
        sum
    }

    /// The product of two variables.
    pub(crate) fn product(left: usize, right: usize) -> Self {
        let mut product = Self::default();
        product.add((Some(left), Some(right)), &RationalFunction::one());
        product
    }

    fn add(&mut self, (left, right): Pair, factor: &RationalFunction) {
        let pair = (left.min(right), left.max(right));
        let sum = self.0.get(&pair).map_or_else(|| factor.clone(), |known| known + factor);
        if sum.is_zero() {
            self.0.remove(&pair);
        } else {
            self.0.insert(pair, sum);
        }
    }

    /// Adds a multiple of another polynomial.
    pub(crate) fn add_scaled(&mut self, other: &Self, factor: &RationalFunction) {
        other.0.iter().for_each(|(&pair, value)| self.add(pair, &(value * factor)));
    }

    /// The product of an affine polynomial with a variable.
    pub(crate) fn times(&self, variable: usize) -> Option<Self> {
        let mut product = Self::default();
        for (&(left, right), value) in &self.0 {
            if left.is_some() {
                return None;
            }
            product.add((right, Some(variable)), value);
        }
        Some(product)
    }

    /// The polynomial over its common denominator, variable i of the lift being `Variable(i)` and
    /// parameter k `Variable(variables + k)`.
    pub(crate) fn component(&self, variables: usize) -> RationalFunction {
        let number = |index: usize| Variable(u16::try_from(index).expect("a lift has few variables"));
        let shift = |polynomial: &Polynomial| {
            polynomial.map_variables(|parameter| number(usize::from(parameter.0) + variables))
        };
        let factor = |variable: Option<usize>| {
            variable.map_or_else(RationalFunction::one, |index| RationalFunction::variable(number(index)))
        };
        let mut sum = RationalFunction::zero();
        for (&(left, right), value) in &self.0 {
            let value = RationalFunction::new(shift(value.numerator()), shift(value.denominator()));
            let product = &factor(left) * &factor(right);
            sum = &sum + &(&value.expect("denominators are not 0") * &product);
        }
        sum
    }
}

/// The products of variables, by the monomial that they are.
#[derive(Debug)]
pub(crate) struct Products<'a> {
    ring: &'a Ring,
    variables: &'a [Laurent],
    /// In order, as relations are numbered in answers.
    direct: BTreeMap<Monomial, Vec<Pair>>,
    derived: BTreeMap<Monomial, Quadratic>,
    /// Polynomials between the variables that are 0.
    pub relations: Vec<Quadratic>,
}

impl<'a> Products<'a> {
    /// All products of at most two variables.
    pub(crate) fn new(ring: &'a Ring, variables: &'a [Laurent]) -> Self {
        let mut products = Products {
            ring,
            variables,
            direct: BTreeMap::new(),
            derived: BTreeMap::new(),
            relations: Vec::new(),
        };
        let one = Laurent::from(Monomial::one());
        let value = |index: Option<usize>| index.map_or(&one, |index| &variables[index]);
        let mut composite = Vec::new();
        let indices: Vec<Option<usize>> =
            std::iter::once(None).chain((0..variables.len()).map(Some)).collect();
        for (at, &left) in indices.iter().enumerate() {
            for &right in &indices[at..] {
                let product = ring.product(value(left), value(right));
                match product.as_monomial() {
                    Some(monomial) => {
                        products.direct.entry(monomial.clone()).or_default().push((left, right));
                    }
                    None => composite.push(((left, right), product)),
                }
            }
        }
        products.derive(composite);
        products
    }

    /// Finds the monomials that follow from a product with no other unknown monomial, and the
    /// relations that products without an unknown monomial are.
    fn derive(&mut self, mut composite: Vec<(Pair, Laurent)>) {
        loop {
            let before = composite.len();
            let mut rest = Vec::new();
            for (pair, product) in composite {
                let unknown: Vec<Monomial> = product
                    .terms()
                    .filter(|(monomial, _)| self.known(monomial).is_none())
                    .map(|(monomial, _)| monomial.clone())
                    .collect();
                if unknown.len() > 1 {
                    rest.push((pair, product));
                    continue;
                }
                let mut sum = Quadratic::default();
                sum.add(pair, &RationalFunction::one());
                for (monomial, coefficient) in product.terms() {
                    if let Some(known) = self.known(monomial) {
                        sum.add_scaled(&known, &-coefficient);
                    }
                }
                match unknown.first() {
                    None => self.relations.push(sum),
                    Some(only) => {
                        let inverse = RationalFunction::one().checked_div(&product.coefficient(only));
                        let mut value = Quadratic::default();
                        value.add_scaled(&sum, &inverse.expect("a coefficient is not 0"));
                        self.derived.insert(only.clone(), value);
                    }
                }
            }
            if rest.len() == before {
                break;
            }
            composite = rest;
        }
        let direct: Vec<Vec<Pair>> = self.direct.values().filter(|pairs| pairs.len() > 1).cloned().collect();
        for pairs in direct {
            for &other in &pairs[1..] {
                let mut relation = Quadratic::default();
                relation.add(pairs[0], &RationalFunction::one());
                relation.add(other, &-&RationalFunction::one());
                self.relations.push(relation);
            }
        }
    }

    fn known(&self, monomial: &Monomial) -> Option<Quadratic> {
        if let Some(pairs) = self.direct.get(monomial) {
            let mut first = Quadratic::default();
            first.add(pairs[0], &RationalFunction::one());
            return Some(first);
        }
        self.derived.get(monomial).cloned()
    }

    /// The polynomial as an affine polynomial in the variables.
    pub(crate) fn affine(&self, polynomial: &Laurent) -> Option<Quadratic> {
        let mut sum = Quadratic::default();
        for (monomial, coefficient) in polynomial.terms() {
            let pairs = self.direct.get(monomial)?;
            let pair = pairs.iter().find(|(left, _)| left.is_none())?;
            sum.add(*pair, coefficient);
        }
        Some(sum)
    }

    /// The ways to write the derivative of a variable, the preferred one first. `of` is the
    /// variable, `states` the number of original ones.
    fn ways(&self, derivative: &Laurent, of: usize, states: usize) -> Option<Vec<Quadratic>> {
        let mut ways = vec![Quadratic::default()];
        for (monomial, coefficient) in derivative.terms() {
            let mut options: Vec<Quadratic> = Vec::new();
            let mut pairs = self.direct.get(monomial).cloned().unwrap_or_default();
            // A decay of the variable itself keeps its relation; otherwise original states do.
            let is_negative = coefficient.numerator().leading_term().is_some_and(|(_, c)| c.is_negative());
            let new = |index: Option<usize>| usize::from(index.is_some_and(|index| index >= states));
            pairs.sort_by_key(|&(left, right)| {
                let is_own = left.is_none() && right == Some(of);
                (!(is_own && is_negative), new(left) + new(right), left, right)
            });
            // The equation of a state stays as it is written where it is quadratic already.
            if of < states && pairs.first().is_some_and(|&(left, right)| new(left) + new(right) == 0) {
                pairs.truncate(1);
            }
            for pair in pairs {
                let mut option = Quadratic::default();
                option.add(pair, &RationalFunction::one());
                options.push(option);
            }
            if options.is_empty() {
                options.push(self.known(monomial)?);
            }
            let keep = if ways.len() * options.len() > MOST_WAYS { 1 } else { options.len() };
            ways = options[..keep]
                .iter()
                .flat_map(|option| {
                    ways.iter().map(|way| {
                        let mut way = way.clone();
                        way.add_scaled(option, coefficient);
                        way
                    })
                })
                .collect();
        }
        Some(ways)
    }

    /// The forms of the field: lists of equations, one a variable, the preferred form first.
    /// `fixed` holds equations that have one form.
    pub(crate) fn forms(
        &self,
        states: usize,
        fixed: &BTreeMap<usize, Quadratic>,
    ) -> Option<Vec<Vec<Quadratic>>> {
        let mut ways = Vec::new();
        for (index, variable) in self.variables.iter().enumerate() {
            ways.push(match fixed.get(&index) {
                Some(equation) => vec![equation.clone()],
                None => self.ways(&self.ring.derivative(variable), index, states)?,
            });
        }
        self.add_product_rules(&mut ways, states);
        let mut forms: Vec<Vec<Quadratic>> = vec![Vec::new()];
        let mut left: usize = MOST_FORMS;
        for ways in ways {
            let keep = ways.len().min(left);
            left /= keep;
            forms = ways[..keep]
                .iter()
                .flat_map(|way| forms.iter().map(|form| [form.clone(), vec![way.clone()]].concat()))
                .collect();
        }
        Some(forms)
    }

    /// Puts the product rule (uv)′ = u′v + uv′ first among the ways of a variable that is a product
    /// of variables whose equations are affine: the lifted field then keeps its relation. States
    /// keep their equations.
    fn add_product_rules(&self, ways: &mut [Vec<Quadratic>], states: usize) {
        for (index, variable) in self.variables.iter().enumerate().skip(states) {
            let Some(monomial) = variable.as_monomial() else { continue };
            for &(left, right) in &self.direct[monomial] {
                let (Some(left), Some(right)) = (left, right) else { continue };
                let rule = ways[left][0].times(right).zip(ways[right][0].times(left));
                if let Some((mut rule, other)) = rule.filter(|_| left != index && right != index) {
                    rule.add_scaled(&other, &RationalFunction::one());
                    ways[index].retain(|way| *way != rule);
                    ways[index].insert(0, rule);
                }
            }
        }
    }
}

/// The most ways to write one equation that are looked at.
const MOST_WAYS: usize = 16;
/// The most forms of a field that are looked at.
const MOST_FORMS: usize = 128;
