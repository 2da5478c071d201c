//! Solves relations between parameters and ε for names that occur linearly.
//!
//! The result gives some names as rational functions of the other names. To solve a relation a·v +
//! b = 0 for v, a is assumed not to be 0. Later relations are then divided by the factors of a. If
//! a and b are coprime, a·v + b is irreducible, and the solutions do not depend on the choice of v.

use crate::poly::{Budget, OverBudget, Polynomial, Variable, WithinBudget, gcd_within};
use crate::rational_function::RationalFunction;

/// The most terms of a value or a relation.
const MOST_TERMS: usize = 10_000;
const MOST_WORK: u64 = 300_000;

/// A set of solved relations.
#[derive(Clone, Debug)]
pub struct Relations {
    values: Vec<(Variable, RationalFunction)>,
    nonzero: Vec<Polynomial>,
    budget: Budget,
}

/// An obstacle to adding a relation to earlier relations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// The earlier relations already imply this relation.
    Identity,
    /// The relation never holds.
    Contradiction,
    /// No name occurs linearly in the relation.
    NotLinear,
    /// The relation is a product of these polynomials, and either factor may vanish.
    Product(Polynomial, Polynomial),
    /// The relation is too large.
    TooLarge,
}

/// Classes of names v in relations a·v + b = 0. Earlier classes are preferred.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Solvability {
    /// The coefficient a is a number.
    Number,
    /// The coefficients a and b are coprime.
    Irreducible,
    /// The coefficients a and b have a common factor, which is assumed to be nonzero.
    Factor,
    /// The coefficient b is 0, so either v or a may vanish.
    Product,
}

impl From<OverBudget> for Obstacle {
    fn from(_: OverBudget) -> Self {
        Obstacle::TooLarge
    }
}

impl Default for Relations {
    fn default() -> Self {
        Relations { values: Vec::new(), nonzero: Vec::new(), budget: Budget::new(MOST_TERMS, MOST_WORK) }
    }
}

impl Relations {
    /// Adds the relation `polynomial` = 0 and returns the name for which it was solved. In a
    /// relation a·v + b = 0, names v with a number a are preferred, then names with coprime a and
    /// b, then the order of `names`.
    ///
    /// # Errors
    /// Returns the [`Obstacle`], and does not add the relation.
    pub fn add(&mut self, polynomial: &Polynomial, names: &[Variable]) -> Result<Variable, Obstacle> {
        let mut relation = self.put_into(polynomial)?.ok_or(Obstacle::Contradiction)?.numerator().clone();
        if relation.is_zero() {
            return Err(Obstacle::Identity);
        }
        self.refuse_product(polynomial)?;
        for index in 0..self.nonzero.len() {
            let nonzero = self.nonzero[index].clone();
            let Some(nonzero) = self.put_into(&nonzero)? else { continue };
            relation = without(relation, nonzero.numerator(), &mut self.budget)?;
        }
        if relation.as_constant().is_some() {
            return Err(Obstacle::Contradiction);
        }
        let mut candidates = [names, &relation.variables().into_iter().collect::<Vec<_>>()].concat();
        candidates.retain(|name| relation.degree_in(*name) == 1);
        let mut best: Option<(Solvability, Variable)> = None;
        for name in candidates {
            let rank = self.rank(&relation, name)?;
            if best.is_none_or(|(known, _)| rank < known) {
                best = Some((rank, name));
            }
        }
        let (rank, name) = best.ok_or(Obstacle::NotLinear)?;
        let (coefficient, rest) = linear_in(&relation, name);
        if rank == Solvability::Product {
            return Err(Obstacle::Product(Polynomial::variable(name), coefficient));
        }
        let value = RationalFunction::new_within(-&rest, coefficient.clone(), &mut self.budget)?;
        let value = value.ok_or(Obstacle::Contradiction)?;
        let mut values = Vec::with_capacity(self.values.len() + 1);
        for (known, function) in &self.values {
            let function = function.compose_within(name, &value, &mut self.budget)?;
            values.push((*known, function.ok_or(Obstacle::Contradiction)?));
        }
        values.push((name, value));
        self.values = values;
        if coefficient.as_constant().is_none() {
            self.nonzero.push(coefficient.primitive_part());
        }
        Ok(name)
    }

    fn refuse_product(&mut self, polynomial: &Polynomial) -> Result<(), Obstacle> {
        let mut own = polynomial.clone();
        for index in 0..self.nonzero.len() {
            let nonzero = self.nonzero[index].clone();
            own = without(own, &nonzero, &mut self.budget)?;
        }
        // Let `own` = a·v + b with v = `name`. If a and b have a common factor, `own` is a product.
        let Some(name) = own.variables().into_iter().find(|name| own.degree_in(*name) == 1) else {
            return Ok(());
        };
        let (coefficient, rest) = linear_in(&own, name);
        let factor = gcd_within(&coefficient, &rest, &mut self.budget)?;
        if factor.as_constant().is_some() {
            return Ok(());
        }
        let other =
            own.div_within(&factor, &mut self.budget)?.expect("a factor of both coefficients divides");
        Err(Obstacle::Product(other.primitive_part(), factor))
    }

    fn rank(&mut self, relation: &Polynomial, name: Variable) -> WithinBudget<Solvability> {
        let (coefficient, rest) = linear_in(relation, name);
        Ok(if coefficient.as_constant().is_some() {
            Solvability::Number
        } else if rest.is_zero() {
            Solvability::Product
        } else if gcd_within(&coefficient, &rest, &mut self.budget)?.as_constant().is_some() {
            Solvability::Irreducible
        } else {
            Solvability::Factor
        })
    }

    /// Records that `polynomial` is nonzero. Returns `false` if it vanishes where the relations
    /// hold.
    pub fn require(&mut self, polynomial: &Polynomial) -> WithinBudget<bool> {
        let vanishes = self.makes_vanish(polynomial)?;
        if !vanishes && polynomial.as_constant().is_none() {
            self.nonzero.push(polynomial.primitive_part());
        }
        Ok(!vanishes)
    }

    /// Returns whether `polynomial` vanishes or is undefined where the relations hold.
    pub fn makes_vanish(&mut self, polynomial: &Polynomial) -> WithinBudget<bool> {
        Ok(self.put_into(polynomial)?.is_none_or(|value| value.is_zero()))
    }

    /// Returns the value of a name. Returns `None` for names without a relation.
    #[must_use]
    pub fn value(&self, name: Variable) -> Option<&RationalFunction> {
        self.values.iter().find(|(known, _)| *known == name).map(|(_, value)| value)
    }

    /// Returns the names for which relations were solved, with their values, in order.
    pub fn values(&self) -> impl Iterator<Item = (Variable, &RationalFunction)> {
        self.values.iter().map(|(name, value)| (*name, value))
    }

    /// Returns the polynomials that must be nonzero.
    pub fn nonzero(&self) -> &[Polynomial] {
        &self.nonzero
    }

    /// Replaces every name by its value. Returns `None` if a divisor becomes identically 0.
    pub fn put_into(&mut self, polynomial: &Polynomial) -> WithinBudget<Option<RationalFunction>> {
        put_into(polynomial, self.values.iter().map(|(name, value)| (*name, value)), &mut self.budget)
    }
}

/// Replaces names by their values within a budget. Returns `None` if a divisor becomes identically
/// 0.
pub(crate) fn put_into<'a>(
    polynomial: &Polynomial,
    values: impl Iterator<Item = (Variable, &'a RationalFunction)>,
    budget: &mut Budget,
) -> WithinBudget<Option<RationalFunction>> {
    let mut function = RationalFunction::from(polynomial.clone());
    for (name, value) in values {
        match function.compose_within(name, value, budget)? {
            Some(composed) => function = composed,
            None => return Ok(None),
        }
    }
    Ok(Some(function))
}

/// Returns the coefficients a and b of a polynomial a·`name` + b.
fn linear_in(polynomial: &Polynomial, name: Variable) -> (Polynomial, Polynomial) {
    let mut parts = polynomial.coefficients_in(name);
    (parts.remove(&1).unwrap_or_default(), parts.remove(&0).unwrap_or_default())
}

fn without(mut polynomial: Polynomial, other: &Polynomial, budget: &mut Budget) -> WithinBudget<Polynomial> {
    loop {
        let common = gcd_within(&polynomial, other, budget)?;
        if common.as_constant().is_some() {
            return Ok(polynomial);
        }
        polynomial = polynomial.div_within(&common, budget)?.expect("a common divisor divides");
    }
}
