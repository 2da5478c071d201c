//! Checks relations at random points in 256-bit arithmetic.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use kahan_systems::special::{Float256, Real};

use super::super::evaluate::EvaluationError;
use super::super::formula::Relation;
use super::super::numeric::Arithmetic256;
use super::{DECIMALS, Evidence, Identity, MOST_DRAWS, words};

const NUMERICAL_POINTS: usize = 3;

impl Identity<'_> {
    pub(super) fn numerical(&self) -> Result<Evidence, String> {
        let names = self.names([self.left, self.right]);
        let mut random = SplitMix64::new(self.seed);
        let mut worst = u32::MAX;
        let mut differs = false;
        for _ in 0..NUMERICAL_POINTS {
            let [left, right] = self.numerical_point(&names, &mut random)?;
            if self.relation == Relation::Approximate {
                let unit = self.digit.ok_or("an approximate value is one number")?;
                let difference = (left - right).abs();
                return if difference < decimal(unit) {
                    Ok(Evidence::Numerical(decimals_of(unit)))
                } else {
                    Err(format!("the value is {}", left.to_digits(12)))
                };
            }
            let decimals = agreement(&left, &right);
            if self.relation == Relation::Equal && decimals < DECIMALS {
                return Err(format!(
                    "{} on the left, {} on the right",
                    left.to_digits(12),
                    right.to_digits(12)
                ));
            }
            differs |= decimals < DECIMALS;
            worst = worst.min(decimals);
        }
        match self.relation {
            Relation::Different if differs => Ok(Evidence::Numerical(DECIMALS)),
            Relation::Different => Err("the two sides are equal".to_owned()),
            _ => Ok(Evidence::Numerical(worst)),
        }
    }

    fn numerical_point(&self, names: &[String], random: &mut SplitMix64) -> Result<[Float256; 2], String> {
        const GRID: u64 = 10_007;
        let mut trouble = EvaluationError::Undefined;
        for _ in 0..MOST_DRAWS {
            let mut draw = |name: &String| {
                let listed = self.domain.iter().find(|(listed, ..)| listed == name);
                let (low, high) = listed.map_or_else(
                    || (Rational::new(1, 5), Rational::new(4, 5)),
                    |(_, low, high)| (low.clone(), high.clone()),
                );
                let share = Rational::new(1 + random.below(GRID - 1) as i64, GRID as i64);
                decimal(&(&low + &(&share * &(&high - &low))))
            };
            let values = names.iter().map(|name| (name.clone(), draw(name))).collect();
            match self.sides(&Arithmetic256, self.left, self.right, values) {
                Ok(sides) => return Ok(sides),
                Err(why) => trouble = why,
            }
        }
        Err(words(&trouble))
    }
}

pub(super) fn decimal(value: &Rational) -> Float256 {
    Real::from_rational(&value.to_big())
}

/// Returns how many decimals, at most 70, agree after division by max(|left|, |right|, 1).
pub(super) fn agreement(left: &Float256, right: &Float256) -> u32 {
    let one = Float256::from(1);
    let scale = [left.abs(), right.abs()].into_iter().fold(one, |a, b| if b > a { b } else { a });
    let error = (*left - *right).abs() / scale;
    let mut unit = Float256::from(1);
    let tenth = Float256::from_ratio(1, 10);
    let mut decimals = 0;
    while decimals < 70 && error < unit {
        unit *= tenth;
        decimals += u32::from(error < unit);
    }
    decimals
}

/// Returns k for the unit 10⁻ᵏ.
fn decimals_of(unit: &Rational) -> u32 {
    let digits = unit.denominator().to_string().len();
    u32::try_from(digits).expect("a unit has few digits") - 1
}
