//! Proves rational relations modulo primes, and over ℚ if the expansion is short. Relations that
//! are too large for either proof are checked at exact points.

use std::collections::BTreeMap;

use kahan_algebra::arithmetic::{Arithmetic, Exact, FractionSize, Functions, Modular, SizeArithmetic};
use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::prime_field::{PrimeField, Random, Shake256};
use kahan_algebra::prove::points_needed;
use kahan_algebra::rational::Rational;

use super::super::evaluate::EvaluationError;
use super::super::formula::{Formula, Relation, rationalise};
use super::names::uses_map;
use super::{Evidence, Identity, MOST_DRAWS, words};

/// The greatest number of terms of a formula that is expanded over ℚ.
const MOST_TERMS: usize = 20_000;
/// The greatest number of multiplications of terms in an expansion over ℚ, about a second's work.
const MOST_WORK: u64 = 2_000_000;

/// The number of exact points at which a relation is checked if it is too large for a proof.
const EXACT_POINTS: u32 = 12;

type Point = BTreeMap<String, Rational>;

impl Identity<'_> {
    pub(super) fn rational(&self, left: &Formula, right: &Formula) -> Result<Evidence, String> {
        let names = self.names([left, right]);
        // The points depend on a hash of the formulas, so nobody can fit a formula to the points.
        let mut random = Shake256::new(format!("{left:?} {:?} {right:?}", self.relation).as_bytes());
        let sizes = names.iter().map(|name| (name.clone(), FractionSize::variable())).collect();
        let points = match self.sides(&SizeArithmetic, left, right, sizes).map_err(|trouble| words(&trouble))
        {
            Ok([left, right]) => {
                let difference = SizeArithmetic.subtract(&left, &right);
                points_needed(difference.above.degree, difference.above.bits)
            }
            Err(trouble) => return Err(trouble),
        };
        for _ in 0..points.unwrap_or(3) {
            let (left, right) = self.modular_point(left, right, &names, &mut random)?;
            match self.relation {
                Relation::Equal if left != right => {
                    return Err(self.refutation(left, right, &names, &mut random));
                }
                // One point at which the sides differ is as good a proof as different normal forms.
                Relation::Different if left != right => return Ok(Evidence::NormalForm),
                _ => {}
            }
        }
        if self.relation == Relation::Different {
            return Err("the two sides are equal".to_owned());
        }
        match (self.normal_form(left, right, &names), points) {
            (Some(true), _) => Ok(Evidence::NormalForm),
            (Some(false), _) => Err("the normal forms of the two sides differ".to_owned()),
            (None, Some(points)) => Ok(Evidence::Modular(points)),
            (None, None) => self.exact(left, right, &names, &mut random),
        }
    }

    fn modular_point(
        &self,
        left: &Formula,
        right: &Formula,
        names: &[String],
        random: &mut dyn Random,
    ) -> Result<(u64, u64), String> {
        let mut trouble = EvaluationError::Undefined;
        for _ in 0..MOST_DRAWS {
            let field = PrimeField::random(random);
            let values = names.iter().map(|name| (name.clone(), field.sample(random))).collect();
            match self.sides(&Modular(field), left, right, values) {
                Ok([left, right]) => return Ok((left, right)),
                Err(why) => trouble = why,
            }
        }
        Err(words(&trouble))
    }

    fn normal_form(&self, left: &Formula, right: &Formula, names: &[String]) -> Option<bool> {
        if !self.model.is_expanded() && (uses_map(left) || uses_map(right)) {
            return None;
        }
        let functions = Functions::new(Budget::new(MOST_TERMS, MOST_WORK));
        let variable = |index: usize| {
            Polynomial::variable(Variable(u16::try_from(index).expect("a formula has few names")))
        };
        let values = names.iter().enumerate().map(|(k, name)| (name.clone(), Some(variable(k).into())));
        let [left, right] = self.sides(&functions, left, right, values.collect()).ok()?;
        functions.subtract(&left, &right).map(|difference| difference.numerator.is_zero())
    }

    fn exact(
        &self,
        left: &Formula,
        right: &Formula,
        names: &[String],
        random: &mut dyn Random,
    ) -> Result<Evidence, String> {
        for _ in 0..EXACT_POINTS {
            let [left, right] = self.exact_point(left, right, names, random)?.1;
            if left != right {
                return Err(format!("{left} is not {right} at an exact point"));
            }
        }
        Ok(Evidence::Exact(EXACT_POINTS))
    }

    fn exact_point(
        &self,
        left: &Formula,
        right: &Formula,
        names: &[String],
        random: &mut dyn Random,
    ) -> Result<(Point, [Rational; 2]), String> {
        for _ in 0..MOST_DRAWS {
            let mut small = || Rational::new(1 + random.below(5) as i64, 1 + random.below(5) as i64);
            let point: Point = names.iter().map(|name| (name.clone(), small())).collect();
            if let Ok(sides) = self.sides(&Exact, left, right, point.clone()) {
                return Ok((point, sides));
            }
        }
        Err("it divides by zero".to_owned())
    }

    /// Describes an exact point where the sides differ, or else `left` and `right` modulo a prime.
    fn refutation(&self, left: u64, right: u64, names: &[String], random: &mut dyn Random) -> String {
        if let (Some(a), Some(b)) = (rationalise(self.left), rationalise(self.right)) {
            for _ in 0..MOST_DRAWS {
                if let Ok((point, [left, right])) = self.exact_point(&a, &b, names, random)
                    && left != right
                {
                    let shown: Vec<String> =
                        point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
                    return format!("at {}: {left} on the left, {right} on the right", shown.join(", "));
                }
            }
        }
        format!("{left} is not {right} modulo a random prime")
    }
}
