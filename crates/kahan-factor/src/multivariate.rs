//! Factors a polynomial that is primitive in its main variable.
//!
//! All variables except the main one are set to small integers. An irreducible image of full degree
//! proves that the polynomial is irreducible. Otherwise the factors of the image are lifted modulo
//! large primes until their product is the polynomial (Wang, "An improved multivariate polynomial
//! factoring algorithm", Math. Comp. 32, 1978). Lifted factors are irreducible because their images
//! are. After eight failed attempts the result is unknown.

use kahan_algebra::poly::{Budget, OverBudget, Polynomial, Variable};
use kahan_algebra::prime_field::{PrimeField, SplitMix64};
use kahan_algebra::rational::Rational;

use super::crt_factors::CrtFactors;
use super::sparse::{self, SparseLiftingProblem};
use super::{Powers, irreducible, univariate, without_monomial};

/// Limits the attempts with new points. Each attempt draws its points from a larger range.
const MAX_ATTEMPTS: u32 = 8;
/// Each attempt factors images at this many points, and lifts the one with the fewest factors.
const IMAGES_PER_ATTEMPT: usize = 2;

/// Returns the irreducible factors with their exponents. Returns `None` if no image can be lifted.
pub(super) fn factors(
    whole: &Polynomial,
    main: Variable,
    budget: &mut Budget,
) -> Result<Option<Powers>, OverBudget> {
    let mut order: Vec<Variable> = whole.variables().into_iter().filter(|&v| v != main).collect();
    if order.is_empty() {
        return univariate::factors(whole, main, budget).map(Some);
    }
    order.insert(0, main);
    let mut rng = SplitMix64::new(whole.len() as u64);
    let mut lead = None;
    for round in 0..MAX_ATTEMPTS {
        let mut best: Option<Image> = None;
        for _ in 0..IMAGES_PER_ATTEMPT {
            let Some(image) = Image::at(whole, &order, 8 << (2 * round), &mut rng, budget)? else { continue };
            if image.is_irreducible() {
                return Ok(Some(vec![(whole.clone(), 1)]));
            }
            if best.as_ref().is_none_or(|best| image.key() < best.key()) {
                best = Some(image);
            }
        }
        let Some(image) = best else { continue };
        if lead.is_none() {
            lead = LeadingCoefficient::of(whole, main, budget)?;
        }
        let Some(lead) = &lead else { return Ok(None) };
        if let Some(factors) = image.lifted(whole, &order, lead, &mut rng, budget)? {
            return Ok(Some(factors));
        }
    }
    Ok(None)
}

/// The factors of the polynomial with all variables except the main one set to `points`.
struct Image {
    points: Vec<i64>,
    factors: Powers,
}

impl Image {
    /// Sets all variables but the first to random integers r with 2 ≤ |r| ≤ `size` + 1, and factors
    /// the image. Returns `None` if this lowers the degree in the first variable.
    fn at(
        whole: &Polynomial,
        order: &[Variable],
        size: u64,
        rng: &mut SplitMix64,
        budget: &mut Budget,
    ) -> Result<Option<Self>, OverBudget> {
        let points: Vec<i64> = order[1..]
            .iter()
            .map(|_| {
                let point = 2 + rng.below(size) as i64;
                if rng.below(2) == 0 { point } else { -point }
            })
            .collect();
        let mut image = whole.clone();
        for (&variable, &point) in order[1..].iter().zip(&points) {
            let power =
                u64::from(image.degree_in(variable)) * u64::from(point.unsigned_abs().ilog2() + 1) / 64 + 1;
            budget.charge(power * power + image.len() as u64 * image.coefficient_words() * power)?;
            image = image.substitute(variable, &Rational::from(point));
        }
        if image.degree() != whole.degree_in(order[0]) {
            return Ok(None);
        }
        let factors = univariate::factors(&image.primitive_part(), order[0], budget)?;
        Ok(Some(Self { points, factors }))
    }

    fn is_irreducible(&self) -> bool {
        matches!(self.factors.as_slice(), [(_, 1)])
    }

    /// Returns a sort key that prefers images with few repeated factors, then few factors.
    fn key(&self) -> (i64, usize) {
        (-self.factors.iter().map(|(factor, _)| i64::from(factor.degree())).sum::<i64>(), self.factors.len())
    }

    /// Lifts the factors of this image to factors of the polynomial. Returns `None` if the lift
    /// fails.
    fn lifted(
        &self,
        whole: &Polynomial,
        order: &[Variable],
        lead: &LeadingCoefficient,
        rng: &mut SplitMix64,
        budget: &mut Budget,
    ) -> Result<Option<Powers>, OverBudget> {
        let mut multipliers = Vec::new();
        for (_, exponent) in &self.factors {
            multipliers.push(lead.multiplier(*exponent, budget)?);
        }
        let problem = SparseLiftingProblem {
            whole,
            order,
            points: &self.points,
            images: &self.factors,
            multipliers: &multipliers,
        };
        let words: u64 = multipliers.iter().map(Polynomial::coefficient_words).max().unwrap_or(1);
        let mut known = CrtFactors::default();
        for _ in 0..whole.coefficient_words() + words + 2 {
            let field = PrimeField::random(rng);
            let Some(residues) = sparse::lift(field, &problem, rng, budget)? else { continue };
            let is_news = known.combine(field, residues);
            let candidates = known.factors(order);
            if self.agrees_at_point(whole, lead, &multipliers, &candidates) {
                let mut factors = Vec::new();
                for (candidate, (_, exponent)) in candidates.into_iter().zip(&self.factors) {
                    factors.push((lead.without_multiplier(candidate, budget)?, *exponent));
                }
                // If the factors have the degrees of their images and the right product, the lift
                // has succeeded.
                let degrees = factors.iter().zip(&self.factors);
                let has_degrees = |((factor, _), (image, _)): (&(Polynomial, _), &(Polynomial, _))| {
                    factor.degree_in(order[0]) == image.degree()
                };
                if degrees.into_iter().all(has_degrees) && is_product(whole, &factors, budget)? {
                    return Ok(Some(factors));
                }
            }
            if !is_news {
                break;
            }
        }
        Ok(None)
    }

    /// Tests at one point modulo a prime whether the product of the candidates' powers is `whole`,
    /// up to leading coefficients. The leading coefficient of a candidate is its multiplier.
    fn agrees_at_point(
        &self,
        whole: &Polynomial,
        lead: &LeadingCoefficient,
        multipliers: &[Polynomial],
        candidates: &[Polynomial],
    ) -> bool {
        let field = PrimeField::MERSENNE_61;
        let product = |start: &Polynomial, others: &[Polynomial]| {
            others.iter().zip(&self.factors).fold(value(start), |product, (other, (_, exponent))| {
                field.mul(product, field.pow(value(other), u64::from(*exponent)))
            })
        };
        product(&lead.whole, candidates) == product(whole, multipliers)
    }
}

fn value(polynomial: &Polynomial) -> u64 {
    let field = PrimeField::MERSENNE_61;
    polynomial.terms().fold(0, |sum, (monomial, coefficient)| {
        let start = field.reduce(coefficient).expect("the coefficients are integers");
        let term = monomial.powers().iter().fold(start, |product, &(variable, exponent)| {
            let point = SplitMix64::new(u64::from(variable.0)).below(field.prime());
            field.mul(product, field.pow(point, u64::from(exponent)))
        });
        field.add(sum, term)
    })
}

fn is_product(
    whole: &Polynomial,
    factors: &[(Polynomial, u32)],
    budget: &mut Budget,
) -> Result<bool, OverBudget> {
    let mut rest = whole.clone();
    for (factor, exponent) in factors {
        for _ in 0..*exponent {
            match rest.div_within(factor, budget)? {
                Some(quotient) => rest = quotient,
                None => return Ok(false),
            }
        }
    }
    Ok(rest.is_one())
}

struct LeadingCoefficient {
    whole: Polynomial,
    content: Rational,
    factors: Powers,
}

impl LeadingCoefficient {
    fn of(whole: &Polynomial, main: Variable, budget: &mut Budget) -> Result<Option<Self>, OverBudget> {
        let whole = whole.leading_coefficient_in(main);
        let (mut factors, core) = without_monomial(&whole);
        let Some(others) = irreducible(&core, budget)? else { return Ok(None) };
        factors.extend(others);
        Ok(Some(Self { content: whole.content().abs(), whole, factors }))
    }

    /// Returns a common multiple of the leading coefficients of all factors that occur to the power
    /// `exponent`.
    fn multiplier(&self, exponent: u32, budget: &mut Budget) -> Result<Polynomial, OverBudget> {
        let mut product = Polynomial::constant(self.content.clone());
        for (factor, own) in &self.factors {
            product = product.mul_within(&factor.pow_within(own / exponent, budget)?, budget)?;
        }
        Ok(product)
    }

    /// Removes factors of the leading coefficient `self`, and returns the primitive part.
    fn without_multiplier(
        &self,
        polynomial: Polynomial,
        budget: &mut Budget,
    ) -> Result<Polynomial, OverBudget> {
        let (_, mut rest) = without_monomial(&polynomial);
        for (factor, exponent) in self.factors.iter().filter(|(factor, _)| factor.len() > 1) {
            for _ in 0..*exponent {
                let Some(quotient) = rest.div_within(factor, budget)? else { break };
                rest = quotient.primitive_part();
            }
        }
        Ok(rest)
    }
}
