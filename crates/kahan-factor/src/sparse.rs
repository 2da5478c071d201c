//! Lifts factors modulo a large prime, one variable at a time.
//!
//! Each step adds one variable and sets the variables added earlier to several values. The factors
//! are lifted at each value ([`series`](super::series)), and interpolated with the monomials that
//! the previous step found (Zippel, "Probabilistic algorithms for sparse polynomials", EUROSAM
//! 1979). The values are powers of one point, so the linear systems have Vandermonde matrices
//! (Monagan and Tuncer, CASC 2016; Chen and Monagan, CASC 2020). A final division detects errors.

use std::collections::BTreeMap;

use kahan_algebra::poly::{Budget, OverBudget, Polynomial, RESIDUES_PER_TERM, Variable};
use kahan_algebra::prime_field::{PrimeField, SplitMix64};
use kahan_algebra::table::Table;

use super::dense::{self, Dense};
use super::series::{self, BivariateCoefficients, LiftingProblem};
use super::vandermonde;

/// A polynomial over a prime field. Maps exponents (main variable first) to coefficients.
pub(super) type Residues = BTreeMap<Vec<u32>, u64>;

/// A polynomial to factor, and the factors of an image in the main variable.
pub(super) struct SparseLiftingProblem<'a> {
    pub(super) whole: &'a Polynomial,
    /// The variables, of which the main variable comes first.
    pub(super) order: &'a [Variable],
    /// The values of all variables except the main one.
    pub(super) points: &'a [i64],
    pub(super) images: &'a [(Polynomial, u32)],
    /// For each factor: a multiple of its leading coefficient in the main variable.
    pub(super) multipliers: &'a [Polynomial],
}

/// Lifts each factor to a polynomial whose leading coefficient is the factor's multiplier. Returns
/// `None` if the lift fails at the points.
pub(super) fn lift(
    field: PrimeField,
    problem: &SparseLiftingProblem<'_>,
    rng: &mut SplitMix64,
    budget: &mut Budget,
) -> Result<Option<Vec<Residues>>, OverBudget> {
    budget.charge((problem.whole.len() * problem.order.len()) as u64)?;
    let points: Vec<u64> = problem.points.iter().map(|&point| field.reduce_i64(point)).collect();
    let wholes = stages(field, problem.whole, problem.order, &points);
    let multipliers: Vec<Vec<Residues>> =
        problem.multipliers.iter().map(|each| stages(field, each, problem.order, &points)).collect();
    let mut factors: Vec<(Residues, u32)> = problem
        .images
        .iter()
        .map(|(image, exponent)| (residues(field, image, &problem.order[..1]), *exponent))
        .collect();
    for (stage, &point) in points.iter().enumerate() {
        let step = Step {
            field,
            whole: &wholes[stage + 1],
            multipliers: multipliers.iter().map(|each| &each[stage + 1]).collect(),
            factors: &factors,
            point,
        };
        let Some(lifted) = step.lift(rng, budget)? else { return Ok(None) };
        for ((factor, _), lifted) in factors.iter_mut().zip(lifted) {
            *factor = lifted;
        }
    }
    Ok(Some(factors.into_iter().map(|(factor, _)| factor).collect()))
}

/// Returns a list of polynomials. Entry k keeps the first k + 1 variables and sets the others to
/// the points.
fn stages(field: PrimeField, polynomial: &Polynomial, order: &[Variable], points: &[u64]) -> Vec<Residues> {
    let mut stages = vec![residues(field, polynomial, order)];
    for &point in points.iter().rev() {
        let mut fixed = Residues::new();
        for (exponents, &coefficient) in &stages[stages.len() - 1] {
            let (last, first) = exponents.split_last().expect("the main variable stays");
            let value = field.mul(coefficient, field.pow(point, u64::from(*last)));
            let sum = fixed.entry(first.to_vec()).or_insert(0);
            *sum = field.add(*sum, value);
        }
        stages.push(fixed);
    }
    stages.reverse();
    stages
}

fn residues(field: PrimeField, polynomial: &Polynomial, order: &[Variable]) -> Residues {
    polynomial
        .terms()
        .map(|(monomial, coefficient)| {
            let exponents = order.iter().map(|&variable| monomial.exponent(variable)).collect();
            (exponents, field.reduce(coefficient).expect("the coefficients are integers"))
        })
        .collect()
}

struct Step<'a> {
    field: PrimeField,
    whole: &'a Residues,
    multipliers: Vec<&'a Residues>,
    factors: &'a [(Residues, u32)],
    point: u64,
}

impl Step<'_> {
    fn lift(&self, rng: &mut SplitMix64, budget: &mut Budget) -> Result<Option<Vec<Residues>>, OverBudget> {
        let field = self.field;
        let highest =
            |at: usize| self.whole.keys().map(|exponents| exponents[at]).max().unwrap_or(0) as usize;
        let last = self.whole.keys().next().map_or(1, |exponents| exponents.len() - 1);
        let (degree, len) = (highest(0), highest(last) + 1);
        let base: Vec<u64> = (1..last).map(|_| 1 + rng.below(field.prime() - 1)).collect();
        budget.charge((self.whole.len() * last) as u64)?;
        let shapes: Vec<FactorSupport> =
            self.factors.iter().map(|(factor, _)| FactorSupport::new(field, factor, &base)).collect();
        let samples = shapes.iter().map(FactorSupport::samples).max().unwrap_or(1);
        let size = (degree as u64 + 1).saturating_mul(len as u64);
        let each = size.saturating_mul(size).saturating_add(self.whole.len() as u64);
        budget.charge(each.saturating_mul(samples as u64) / RESIDUES_PER_TERM)?;

        let mut whole = PowerEvaluation::new(field, self.whole, &base, Some(last));
        let mut multipliers: Vec<PowerEvaluation> = self
            .multipliers
            .iter()
            .map(|each| PowerEvaluation::new(field, each, &base, Some(last)))
            .collect();
        let mut factors: Vec<PowerEvaluation> =
            self.factors.iter().map(|(factor, _)| PowerEvaluation::new(field, factor, &base, None)).collect();
        let mut lifts: Vec<Vec<BivariateCoefficients>> = vec![Vec::new(); factors.len()];
        for _ in 0..samples {
            let known: Vec<(Dense, u32)> = factors
                .iter_mut()
                .zip(self.factors)
                .map(|(walk, (_, exponent))| (column(&walk.next(field, degree + 1, 1)), *exponent))
                .collect();
            let multipliers: Vec<Dense> =
                multipliers.iter_mut().map(|walk| walk.next(field, 1, len).remove(0)).collect();
            let question = LiftingProblem {
                whole: &whole.next(field, degree + 1, len),
                factors: &known,
                multipliers: &multipliers,
                point: self.point,
            };
            let Some(lifted) = series::lift(field, &question) else { return Ok(None) };
            for (all, one) in lifts.iter_mut().zip(lifted) {
                all.push(one);
            }
        }
        let work: usize = shapes.iter().map(|shape| shape.work(len)).sum();
        budget.charge(work as u64 / RESIDUES_PER_TERM)?;
        Ok(shapes.iter().zip(&lifts).map(|(shape, lifts)| shape.interpolated(field, lifts, len)).collect())
    }
}

fn column(rows: &BivariateCoefficients) -> Dense {
    dense::trimmed(rows.iter().map(|row| row[0]).collect())
}

/// Returns the value of a monomial at `base`. The power of the main variable is left out.
fn value(field: PrimeField, exponents: &[u32], base: &[u64]) -> u64 {
    let powers = exponents[1..].iter().zip(base);
    powers.fold(1, |product, (&exponent, &base)| field.mul(product, field.pow(base, u64::from(exponent))))
}

/// A polynomial with all but one or two variables set to powers of the coordinates of a point.
struct PowerEvaluation {
    /// For each term: the exponents of the main and the second variable, the value of the other
    /// factors of the term, and the number by which `next` multiplies this value.
    terms: Vec<(usize, usize, u64, u64)>,
}

impl PowerEvaluation {
    /// Starts at power 0 of the point `base`. The main variable and the variable with index
    /// `second` are not set.
    fn new(field: PrimeField, polynomial: &Residues, base: &[u64], second: Option<usize>) -> Self {
        let term = |(exponents, &coefficient): (&Vec<u32>, &u64)| {
            let other = second.map_or(0, |place| exponents[place] as usize);
            (exponents[0] as usize, other, coefficient, value(field, exponents, base))
        };
        Self { terms: polynomial.iter().map(term).collect() }
    }

    /// Goes to the next power of the point. The rows of the result are indexed by powers of the
    /// main variable, and the columns by powers of the second variable.
    fn next(&mut self, field: PrimeField, rows: usize, columns: usize) -> BivariateCoefficients {
        let mut values = vec![vec![0; columns]; rows];
        for (row, column, value, ratio) in &mut self.terms {
            *value = field.mul(*value, *ratio);
            let sum: &mut u64 = &mut values[*row][*column];
            *sum = field.add(*sum, *value);
        }
        values
    }
}

/// The monomials of a factor, with values at a point, grouped by their power of the main variable.
struct FactorSupport {
    groups: Table<usize, Vec<(Vec<u32>, u64)>>,
}

impl FactorSupport {
    fn new(field: PrimeField, factor: &Residues, base: &[u64]) -> Self {
        let mut groups: Table<usize, Vec<(Vec<u32>, u64)>> = Table::new();
        for (exponents, _) in factor.iter().filter(|(_, coefficient)| **coefficient != 0) {
            let node = (exponents.clone(), value(field, exponents, base));
            groups.or_default(exponents[0] as usize).push(node);
        }
        Self { groups }
    }

    fn samples(&self) -> usize {
        self.groups.values().map(Vec::len).max().unwrap_or(1)
    }

    fn work(&self, len: usize) -> usize {
        self.groups.values().map(|group| group.len() * group.len() * len).sum()
    }

    fn interpolated(
        &self,
        field: PrimeField,
        lifts: &[BivariateCoefficients],
        len: usize,
    ) -> Option<Residues> {
        let mut terms = Residues::new();
        for (&row, group) in self.groups.iter() {
            let nodes: Vec<u64> = group.iter().map(|(_, node)| *node).collect();
            let columns: Vec<Dense> = (0..len)
                .map(|power| {
                    lifts[..nodes.len()].iter().map(|lift| lift.get(row).map_or(0, |r| r[power])).collect()
                })
                .collect();
            for ((exponents, _), solution) in
                group.iter().zip(vandermonde::solutions(field, &nodes, &columns)?)
            {
                for (power, coefficient) in solution.into_iter().enumerate().filter(|(_, c)| *c != 0) {
                    let mut exponents = exponents.clone();
                    exponents.push(power as u32);
                    terms.insert(exponents, coefficient);
                }
            }
        }
        Some(terms)
    }
}
