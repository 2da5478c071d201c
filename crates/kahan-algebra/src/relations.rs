//! Relations between parameters and ε, each solved for a name that enters it linearly.
//!
//! In come polynomials that are to vanish, one after the other; out go values of some names as
//! rational functions of the others. What holds: a value mentions no name that has a value. What a
//! relation is divided by to be solved, the coefficient of its name, is not 0 where the relations
//! hold: that is part of their meaning, and what later relations share with it is divided out of
//! them. Where coefficient and rest have no common factor the relation is irreducible, so that
//! "generic on the relations" means the same whichever name is solved for.

use crate::poly::{Budget, OverBudget, Polynomial, Variable, Within, gcd_within};
use crate::rational_function::RationalFunction;

/// The most terms of a value or of a relation after the values before it are put in, and products
/// of terms in all.
const MOST_TERMS: usize = 10_000;
const MOST_WORK: u64 = 300_000;

/// Relations, solved.
#[derive(Clone, Debug)]
pub struct Relations {
    values: Vec<(Variable, RationalFunction)>,
    nonzero: Vec<Polynomial>,
    budget: Budget,
}

/// Why a relation cannot stand behind those before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// It holds already.
    Identity,
    /// It never holds.
    Contradiction,
    /// No name enters it linearly.
    NotLinear,
    /// It is a product, and holds where either factor vanishes.
    Product(Polynomial, Polynomial),
    /// It is too large to be solved.
    TooLarge,
}

/// How good a name is to solve a relation for, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    /// Its coefficient is a number.
    Number,
    /// Its coefficient has no factor in common with the rest, so that the relation is irreducible.
    Irreducible,
    /// It has one, which is then not 0 either.
    Factor,
    /// There is no rest: the relation is this name times its coefficient, and either may be meant
    /// to vanish.
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
    /// Adds the relation that `polynomial` vanishes and gives the name it was solved for: the best
    /// by its coefficient (a number, else one without a factor in common with the rest), and the
    /// first of those in the order of `names` and then of what earlier values brought in.
    ///
    /// # Errors
    /// The [`Obstacle`]; nothing is added then.
    pub fn add(&mut self, polynomial: &Polynomial, names: &[Variable]) -> Result<Variable, Obstacle> {
        // It vanishes where its numerator does.
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
        let mut best: Option<(Rank, Variable)> = None;
        for name in candidates {
            let rank = self.rank(&relation, name)?;
            if best.is_none_or(|(known, _)| rank < known) {
                best = Some((rank, name));
            }
        }
        let (rank, name) = best.ok_or(Obstacle::NotLinear)?;
        let (coefficient, rest) = linear_in(&relation, name);
        if rank == Rank::Product {
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

    /// A relation that is a product as it is written does not say which factor is to vanish.
    fn refuse_product(&mut self, polynomial: &Polynomial) -> Result<(), Obstacle> {
        let mut own = polynomial.clone();
        for index in 0..self.nonzero.len() {
            let nonzero = self.nonzero[index].clone();
            own = without(own, &nonzero, &mut self.budget)?;
        }
        // A polynomial that is linear in a name is a product where its two coefficients share a
        // factor.
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

    fn rank(&mut self, relation: &Polynomial, name: Variable) -> Within<Rank> {
        let (coefficient, rest) = linear_in(relation, name);
        Ok(if coefficient.as_constant().is_some() {
            Rank::Number
        } else if rest.is_zero() {
            Rank::Product
        } else if gcd_within(&coefficient, &rest, &mut self.budget)?.as_constant().is_some() {
            Rank::Irreducible
        } else {
            Rank::Factor
        })
    }

    /// Notes that `polynomial` is not 0 where the relations hold; `false` if they make it vanish.
    pub fn require(&mut self, polynomial: &Polynomial) -> Within<bool> {
        let vanishes = self.makes_vanish(polynomial)?;
        if !vanishes && polynomial.as_constant().is_none() {
            self.nonzero.push(polynomial.primitive_part());
        }
        Ok(!vanishes)
    }

    /// Whether `polynomial` is 0 where the relations hold, or has no value there.
    pub fn makes_vanish(&mut self, polynomial: &Polynomial) -> Within<bool> {
        Ok(self.put_into(polynomial)?.is_none_or(|value| value.is_zero()))
    }

    /// The value of a name that has one.
    #[must_use]
    pub fn value(&self, name: Variable) -> Option<&RationalFunction> {
        self.values.iter().find(|(known, _)| *known == name).map(|(_, value)| value)
    }

    /// The names that have a value, with their values, in the order of their relations.
    pub fn values(&self) -> impl Iterator<Item = (Variable, &RationalFunction)> {
        self.values.iter().map(|(name, value)| (*name, value))
    }

    /// What may not vanish, so that the relations have these values.
    pub fn nonzero(&self) -> &[Polynomial] {
        &self.nonzero
    }

    /// The polynomial with every name replaced by its value; `None` where that divides by zero
    /// identically.
    pub fn put_into(&mut self, polynomial: &Polynomial) -> Within<Option<RationalFunction>> {
        put_into(polynomial, self.values.iter().map(|(name, value)| (*name, value)), &mut self.budget)
    }
}

/// The polynomial with names replaced by their values, within a budget; `None` where that divides
/// by zero identically.
pub(crate) fn put_into<'a>(
    polynomial: &Polynomial,
    values: impl Iterator<Item = (Variable, &'a RationalFunction)>,
    budget: &mut Budget,
) -> Within<Option<RationalFunction>> {
    let mut function = RationalFunction::from(polynomial.clone());
    for (name, value) in values {
        match function.compose_within(name, value, budget)? {
            Some(composed) => function = composed,
            None => return Ok(None),
        }
    }
    Ok(Some(function))
}

/// The coefficient of a name in a polynomial that is linear in it, and the rest.
fn linear_in(polynomial: &Polynomial, name: Variable) -> (Polynomial, Polynomial) {
    let mut parts = polynomial.coefficients_in(name);
    (parts.remove(&1).unwrap_or_default(), parts.remove(&0).unwrap_or_default())
}

/// The polynomial without the factors that it shares with `other`.
fn without(mut polynomial: Polynomial, other: &Polynomial, budget: &mut Budget) -> Within<Polynomial> {
    loop {
        let common = gcd_within(&polynomial, other, budget)?;
        if common.as_constant().is_some() {
            return Ok(polynomial);
        }
        polynomial = polynomial.div_within(&common, budget)?.expect("a common divisor divides");
    }
}
