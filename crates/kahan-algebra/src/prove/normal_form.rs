//! Proves claims slowly by expanding both sides of every identity over ℚ, without random points.

use kahan_syntax::rational::Rational;

use crate::arithmetic::{Arithmetic, Function, Functions};
use crate::kahan::RationalMap;
use crate::plan::plan_of;
use crate::poly::{Budget, Polynomial, Variable};
use crate::relations::put_into;
use crate::system::{Claim, System};

use super::residual::SampledClaim;
use super::sample::{FieldPlans, Sample, evaluate_conditions, rows, run};

/// The most terms of an intermediate result. A proof takes about a second at worst.
const MOST_TERMS: usize = 20_000;
const MOST_WORK: u64 = 1_000_000;

/// Returns whether the claim holds. Returns `None` if the work exceeds the budget.
#[must_use]
pub fn prove_by_normal_form(system: &System, claim: &Claim) -> Option<bool> {
    let map = RationalMap::of(&system.field)?;
    let scheme = FieldPlans::of(&system.field);
    let functions = Functions::new(Budget::new(MOST_TERMS, MOST_WORK));
    let sample = sample(&scheme, &map, claim, &functions)?;
    let mut holds = true;
    for pair in (SampledClaim { claim, arithmetic: &functions, sample: &sample }).pairs()? {
        holds &= functions.subtract(&pair.left, &pair.right)?.numerator.is_zero();
    }
    Some(holds)
}

fn sample(
    scheme: &FieldPlans,
    map: &RationalMap,
    claim: &Claim,
    functions: &Functions,
) -> Option<Sample<Option<Function>>> {
    let n = scheme.dimension();
    let variable = |index: usize| Variable(u16::try_from(index).expect("symbols are numbered by 16 bits"));
    let mut here: Vec<Option<Function>> =
        (0..scheme.variables).map(|index| Some(Polynomial::variable(variable(index)).into())).collect();
    evaluate_conditions(&claim.conditions, functions, &mut here)?;
    let eps = usize::from(scheme.symbols.epsilon().0);
    let specialised = |polynomial: &Polynomial| {
        let values = claim.conditions.iter().map(|condition| (condition.variable, &condition.value));
        let quotient = put_into(polynomial, values, &mut Budget::new(MOST_TERMS, MOST_WORK)).ok()??;
        let [above, below] = [quotient.numerator(), quotient.denominator()].map(|of| Some(of.clone().into()));
        functions.divide(&above, &below)
    };
    let denominator = specialised(&map.reduced.denominator)?;
    let two_eps = functions.multiply(&functions.constant(&Rational::from(2))?, &here[eps]);
    let mut there = here.clone();
    for (value, increment) in there.iter_mut().zip(&map.reduced.increments) {
        let quotient = functions.divide(&specialised(increment)?, &denominator)?;
        *value = functions.add(value, &functions.multiply(&two_eps, &quotient));
    }
    let mut back = there.clone();
    back[eps] = functions.negate(&here[eps]);
    let determinant = plan_of([&map.denominator]);
    let matrix = rows(&run(functions, &scheme.matrix, &here)?, n);
    let back_matrix = rows(&run(functions, &scheme.matrix, &back)?, n);
    let above = run(functions, &determinant, &back)?.pop()?;
    let below = run(functions, &determinant, &here)?.pop()?;
    let jacobian_determinant = functions.divide(&above, &below)?;
    Some(Sample { here, there, matrix, back_matrix, jacobian_determinant })
}
