//! Takes one step of the map at a point over any field.

use kahan_syntax::rational::Rational;

use crate::arithmetic::{Exact, Modular, OverRationals, determinant, solve};
use crate::field::Field;
use crate::kahan::scaled_matrix;
use crate::plan::{Input, Plan, PlanBuilder, plan_of};
use crate::poly::Variable;
use crate::prime_field::{PrimeField, Random, Shake256};
use crate::symbols::Symbols;
use crate::system::Condition;

/// Plans that evaluate the field's numerators and the matrix A = I − ε f′. Each row of A is
/// multiplied by the denominator of its equation.
pub(super) struct FieldPlans {
    pub(super) symbols: Symbols,
    pub(super) numerators: Plan,
    pub(super) matrix: Plan,
    pub(super) variables: usize,
}

impl FieldPlans {
    pub(super) fn of(field: &Field) -> Self {
        let numerators = plan_of(field.numerators());
        let matrix = plan_of(scaled_matrix(field).iter().flatten());
        let variables = usize::from(field.symbols.epsilon().0) + 1;
        FieldPlans { symbols: field.symbols.clone(), numerators, matrix, variables }
    }

    pub(super) fn dimension(&self) -> usize {
        self.symbols.dimension()
    }
}

/// A point `here` and its image `there`. The step from `here` with ε has the matrix `matrix`, the
/// step from `there` with −ε has `back_matrix`.
pub(super) struct Sample<V> {
    pub(super) here: Vec<V>,
    pub(super) there: Vec<V>,
    pub(super) matrix: Vec<Vec<V>>,
    pub(super) back_matrix: Vec<Vec<V>>,
    /// The determinant of the Jacobian ∂x̃/∂x.
    pub(super) jacobian_determinant: V,
}

pub(super) fn run<A: OverRationals>(
    arithmetic: &A,
    plan: &Plan,
    values: &[A::Value],
) -> Option<Vec<A::Value>> {
    let value = |input: &Input| input.variable().map(|Variable(k)| values[usize::from(k)].clone());
    plan.evaluate(arithmetic, value).into_iter().collect()
}

pub(super) fn rows<V: Clone>(entries: &[V], n: usize) -> Vec<Vec<V>> {
    entries.chunks(n).map(<[V]>::to_vec).collect()
}

/// Takes one step from the point `here`. Returns `None` if the step is undefined.
pub(super) fn take_step<A: OverRationals>(
    scheme: &FieldPlans,
    arithmetic: &A,
    here: Vec<A::Value>,
) -> Option<Sample<A::Value>> {
    let n = scheme.dimension();
    let eps = usize::from(scheme.symbols.epsilon().0);
    let two_eps = arithmetic.add(&here[eps], &here[eps]);
    let matrix = rows(&run(arithmetic, &scheme.matrix, &here)?, n);
    let right: Vec<Vec<A::Value>> =
        run(arithmetic, &scheme.numerators, &here)?.into_iter().map(|value| vec![value]).collect();
    let solved = solve(arithmetic, &matrix, &right)?;
    let mut there = here.clone();
    for (value, increment) in there.iter_mut().zip(&solved.solution) {
        *value = arithmetic.add(value, &arithmetic.multiply(&two_eps, &increment[0]));
    }
    let mut back = there.clone();
    back[eps] = arithmetic.negate(&here[eps]);
    let back_matrix = rows(&run(arithmetic, &scheme.matrix, &back)?, n);
    let jacobian_determinant =
        arithmetic.divide(&determinant(arithmetic, &back_matrix)?, &solved.determinant)?;
    Some(Sample { here, there, matrix, back_matrix, jacobian_determinant })
}

/// The most points drawn for one step. The bound on the error probability ([`super::sizes`]) grows
/// with the square of this number.
pub(super) const MOST_DRAWS: usize = 16;

/// Random points that satisfy given conditions, drawn when needed.
pub(super) struct Samples<'a> {
    pub(super) conditions: &'a [Condition],
    random: Shake256,
    modular: Vec<(Modular, Sample<u64>)>,
    exact: Vec<Sample<Rational>>,
}

impl<'a> Samples<'a> {
    pub(super) fn new(conditions: &'a [Condition], seed: [u8; 32]) -> Self {
        Samples { conditions, random: Shake256::new(&seed), modular: Vec::new(), exact: Vec::new() }
    }

    /// Returns a point modulo its own prime. Returns `None` if [`MOST_DRAWS`] draws fail.
    pub(super) fn modular(&mut self, scheme: &FieldPlans, index: usize) -> Option<&(Modular, Sample<u64>)> {
        let conditions = self.conditions;
        while self.modular.len() <= index {
            let sample = (0..MOST_DRAWS).find_map(|_| {
                let arithmetic = Modular(PrimeField::random(&mut self.random));
                let mut here: Vec<u64> =
                    (0..scheme.variables).map(|_| arithmetic.0.sample(&mut self.random)).collect();
                evaluate_conditions(conditions, &arithmetic, &mut here)?;
                Some((arithmetic, take_step(scheme, &arithmetic, here)?))
            })?;
            self.modular.push(sample);
        }
        self.modular.get(index)
    }

    /// Returns an exact point of small rationals. Returns `None` if [`MOST_DRAWS`] draws fail.
    pub(super) fn exact(&mut self, scheme: &FieldPlans, index: usize) -> Option<&Sample<Rational>> {
        let conditions = self.conditions;
        while self.exact.len() <= index {
            let sample = (0..MOST_DRAWS).find_map(|_| {
                take_step(scheme, &Exact, small_point(scheme, conditions, 3, &mut self.random)?)
            })?;
            self.exact.push(sample);
        }
        self.exact.get(index)
    }
}

/// Stores in `here` the values given by conditions. Returns `None` if a value is undefined.
pub(super) fn evaluate_conditions<A: OverRationals>(
    conditions: &[Condition],
    arithmetic: &A,
    here: &mut [A::Value],
) -> Option<()> {
    for condition in conditions {
        let mut builder = PlanBuilder::default();
        let value = builder.quotient(condition.value.numerator(), condition.value.denominator());
        here[usize::from(condition.variable.0)] = run(arithmetic, &builder.finish(&[value]), here)?.pop()?;
    }
    Some(())
}

/// Draws a random point whose coordinates are fractions with numerators and denominators up to
/// `height`, and imposes the conditions. ε is positive and parameters are nonzero, unless the
/// conditions fix them. Returns `None` if a condition divides by zero, or if ε = 0.
pub(super) fn small_point(
    scheme: &FieldPlans,
    conditions: &[Condition],
    height: u64,
    random: &mut dyn Random,
) -> Option<Vec<Rational>> {
    let states = scheme.dimension();
    let mut here: Vec<Rational> = (0..scheme.variables)
        .map(|index| {
            let denominator = 1 + random.below(height);
            let numerator = if index < states { random.below(height + 1) } else { 1 + random.below(height) };
            let sign = if index + 1 < scheme.variables && random.below(2) == 1 { -1 } else { 1 };
            Rational::new(sign * numerator as i64, denominator as i64)
        })
        .collect();
    evaluate_conditions(conditions, &Exact, &mut here)?;
    let eps = &here[usize::from(scheme.symbols.epsilon().0)];
    (!eps.is_zero()).then_some(here)
}
