//! Writes derivatives as quadratic polynomials in the lifted variables.
//!
//! A monomial may have several representations. For example, x² is x·x, or the variable for x².
//! Fields from different representations are equal only where the relations hold. Representations
//! are listed up to a limit.

use std::collections::BTreeMap;

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational_function::RationalFunction;

use crate::laurent::{Laurent, Monomial};
use crate::ring::Ring;

/// A polynomial of degree at most 2 in the lifted variables. The states come before the new
/// variables.
pub(crate) type Quadratic = Laurent;

/// Multiplies an affine polynomial by a variable. Returns `None` for other polynomials.
pub(crate) fn times(affine: &Quadratic, variable: usize) -> Option<Quadratic> {
    let is_affine = affine.terms().all(|(monomial, _)| monomial.size() <= 1);
    is_affine.then(|| affine.shifted(&Monomial::power(variable, 1)))
}

/// Returns a polynomial as a rational function in which parameters follow the variables of the
/// lift.
pub(crate) fn component(polynomial: &Quadratic, variables: usize) -> RationalFunction {
    let number = |index: usize| Variable(u16::try_from(index).expect("a lift has few variables"));
    let shift = |polynomial: &Polynomial| {
        polynomial.map_variables(|parameter| number(usize::from(parameter.0) + variables))
    };
    let mut sum = RationalFunction::zero();
    for (monomial, value) in polynomial.terms() {
        let powers =
            monomial.powers().map(|(variable, power)| (number(variable), u32::from(power.unsigned_abs())));
        let above = shift(value.numerator()).mul_monomial(&powers.collect());
        let value = RationalFunction::new(above, shift(value.denominator()));
        sum = &sum + &value.expect("denominators are not 0");
    }
    sum
}

/// All products of at most two variables, as polynomials in coordinates.
#[derive(Debug)]
pub(crate) struct Products<'a> {
    ring: &'a Ring,
    /// The states, then the functions of the new variables.
    variables: Vec<Laurent>,
    /// For each monomial: the products that equal it. Their order determines the order of relations
    /// in results.
    direct: BTreeMap<Monomial, Vec<Monomial>>,
    derived: BTreeMap<Monomial, Quadratic>,
    /// Polynomials in the variables that vanish as functions of the states.
    pub relations: Vec<Quadratic>,
}

impl<'a> Products<'a> {
    pub(crate) fn new(ring: &'a Ring, new: &[Laurent]) -> Self {
        let states = (0..ring.field.len()).map(Laurent::coordinate);
        let variables: Vec<Laurent> = states.chain(new.iter().cloned()).collect();
        let mut direct: BTreeMap<Monomial, Vec<Monomial>> = BTreeMap::new();
        let one = Laurent::from(Monomial::one());
        let numbered = variables.iter().enumerate().map(|(i, value)| (Monomial::power(i, 1), value));
        let factors: Vec<(Monomial, &Laurent)> =
            std::iter::once((Monomial::one(), &one)).chain(numbered).collect();
        let mut composite = Vec::new();
        for (at, (left, left_value)) in factors.iter().enumerate() {
            for (right, right_value) in &factors[at..] {
                let (pair, product) = (left.times(right), ring.product(left_value, right_value));
                match product.as_monomial() {
                    Some(monomial) => direct.entry(monomial.clone()).or_default().push(pair),
                    None => composite.push((pair, product)),
                }
            }
        }
        let (derived, relations) = (BTreeMap::new(), Vec::new());
        let mut products = Products { ring, variables, direct, derived, relations };
        products.derive(composite);
        products
    }

    /// Expresses monomials by products of two variables: solves each product with one monomial left
    /// to express, until nothing changes. Products with no such monomial give relations.
    fn derive(&mut self, mut composite: Vec<(Monomial, Laurent)>) {
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
                let mut sum = Quadratic::from(pair);
                for (monomial, coefficient) in product.terms() {
                    if let Some(known) = self.known(monomial) {
                        sum.add_scaled(&known, &-coefficient);
                    }
                }
                match unknown.first() {
                    None => self.relations.push(sum),
                    Some(only) => {
                        let inverse = product.coefficient(only).recip().expect("a coefficient is not 0");
                        self.derived.insert(only.clone(), sum.scale(&inverse));
                    }
                }
            }
            if rest.len() == before {
                break;
            }
            composite = rest;
        }
        for pairs in self.direct.values() {
            for other in &pairs[1..] {
                let mut relation = Quadratic::from(pairs[0].clone());
                relation.add_term(other.clone(), &-&RationalFunction::one());
                self.relations.push(relation);
            }
        }
    }

    fn known(&self, monomial: &Monomial) -> Option<Quadratic> {
        let direct = self.direct.get(monomial).map(|pairs| Quadratic::from(pairs[0].clone()));
        direct.or_else(|| self.derived.get(monomial).cloned())
    }

    /// Writes a polynomial as an affine polynomial in the variables if possible.
    pub(crate) fn affine(&self, polynomial: &Laurent) -> Option<Quadratic> {
        let mut sum = Quadratic::default();
        for (monomial, coefficient) in polynomial.terms() {
            let single = self.direct.get(monomial)?.iter().find(|pair| pair.size() <= 1)?;
            sum.add_term(single.clone(), coefficient);
        }
        Some(sum)
    }

    /// Returns alternatives for a derivative of a variable. The preferred alternative comes first.
    fn derivative_forms(&self, of: usize) -> Option<Vec<Quadratic>> {
        let states = self.ring.field.len();
        let mut ways = vec![Quadratic::default()];
        for (monomial, coefficient) in self.ring.derivative(&self.variables[of]).terms() {
            let mut pairs = self.direct.get(monomial).cloned().unwrap_or_default();
            // A term −c·v in the equation of v is preferred, because it damps errors. Otherwise,
            // products with fewer new variables are preferred.
            let is_negative = coefficient.numerator().leading_term().is_some_and(|(_, c)| c.is_negative());
            let new = |pair: &Monomial| {
                pair.powers().filter(|&(index, _)| index >= states).map(|(_, power)| power).sum::<i16>()
            };
            pairs.sort_by_key(|pair| (!(*pair == Monomial::power(of, 1) && is_negative), new(pair)));
            // A product of two states in the equation of a state stays as written.
            if of < states && pairs.first().is_some_and(|pair| new(pair) == 0) {
                pairs.truncate(1);
            }
            let mut options: Vec<Quadratic> = pairs.into_iter().map(Quadratic::from).collect();
            if options.is_empty() {
                options.push(self.known(monomial)?);
            }
            let keep = if ways.len() * options.len() > MOST_WAYS { 1 } else { options.len() };
            let sum = |way: &Quadratic, option: &Quadratic| {
                let mut sum = way.clone();
                sum.add_scaled(option, coefficient);
                sum
            };
            let sums = |option| ways.iter().map(move |way| sum(way, option));
            ways = options[..keep].iter().flat_map(sums).collect();
        }
        Some(ways)
    }

    /// Returns alternative quadratic fields, with the preferred field first. Some of the equations
    /// are prescribed by `fixed`.
    pub(crate) fn quadratic_fields(&self, fixed: &BTreeMap<usize, Quadratic>) -> Option<Vec<Vec<Quadratic>>> {
        let mut ways = Vec::new();
        for index in 0..self.variables.len() {
            ways.push(match fixed.get(&index) {
                Some(equation) => vec![equation.clone()],
                None => self.derivative_forms(index)?,
            });
        }
        self.add_product_rules(&mut ways);
        let mut choices: Vec<Vec<usize>> = vec![Vec::new()];
        let mut left: usize = MOST_FORMS;
        for ways in &ways {
            let keep = ways.len().min(left);
            left /= keep;
            choices = (0..keep)
                .flat_map(|way| choices.iter().map(move |choice| [&choice[..], &[way]].concat()))
                .collect();
        }
        let form =
            |choice: Vec<usize>| ways.iter().zip(choice).map(|(ways, way)| ways[way].clone()).collect();
        Some(choices.into_iter().map(form).collect())
    }

    /// For a new variable w = uv whose factors have affine equations, prefers w′ = u′v + uv′. The
    /// map then preserves the relation w = uv.
    fn add_product_rules(&self, ways: &mut [Vec<Quadratic>]) {
        for (index, variable) in self.variables.iter().enumerate().skip(self.ring.field.len()) {
            let Some(monomial) = variable.as_monomial() else { continue };
            for pair in self.direct[monomial].iter().filter(|pair| pair.size() == 2) {
                let mut factors = pair.powers().map(|(factor, _)| factor);
                let Some(left) = factors.next() else { continue };
                let right = factors.next().unwrap_or(left);
                let rule = times(&ways[left][0], right).zip(times(&ways[right][0], left));
                if let Some((mut rule, other)) = rule.filter(|_| left != index && right != index) {
                    rule.add_scaled(&other, &RationalFunction::one());
                    ways[index].retain(|way| *way != rule);
                    ways[index].insert(0, rule);
                }
            }
        }
    }
}

const MOST_WAYS: usize = 16;
const MOST_FORMS: usize = 128;
