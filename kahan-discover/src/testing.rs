//! What tests share: the claims of a block as reduced rational functions.

use kahan_algebra::arithmetic::{Function, Functions};
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::{Claim, System};

/// A claim by its name.
pub(crate) fn claim<'a>(system: &'a System, name: &str) -> &'a Claim {
    system.claims.iter().find(|claim| claim.name.text == name).expect("the claim exists")
}

/// What a claim states: one function, or the entries of a bracket above the diagonal.
pub(crate) fn functions(claim: &Claim) -> Vec<RationalFunction> {
    let arithmetic = Functions::new(Budget::unlimited());
    let values =
        claim.plan.evaluate(&arithmetic, |variable| Function::polynomial(Polynomial::variable(variable)));
    let reduced = |value: Option<Function>| {
        let Some(Function::Known { numerator, denominator }) = value else { panic!("a value") };
        let below =
            denominator.iter().flat_map(|(factor, power)| std::iter::repeat_n(factor, *power as usize));
        let below = below.fold(Polynomial::one(), |product, factor| &product * factor);
        RationalFunction::new(numerator, below).expect("no division by zero")
    };
    values.into_iter().map(reduced).collect()
}

/// What an integral or a density states.
pub(crate) fn function(claim: &Claim) -> RationalFunction {
    functions(claim).remove(0)
}
