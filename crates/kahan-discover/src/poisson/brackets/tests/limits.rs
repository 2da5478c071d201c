//! Tests cases without a bracket, and cases beyond the budget.

use super::*;

#[test]
fn integrals_that_follow_from_one_another_have_no_bracket() {
    let system = system(E1_IN_FOUR);
    let [h, rho] = ["H", "rho"].map(|name| stated(&system, name));
    let constant = RationalFunction::variable(system.field.symbols.epsilon());
    assert_eq!(bracket(&system, &rho, &[h.clone(), &h * &h]), None);
    assert_eq!(bracket(&system, &rho, &[constant, h.clone()]), None);
    assert_eq!(bracket(&system, &RationalFunction::zero(), &[h.clone(), h]), None);
}

#[test]
fn work_beyond_the_budget_is_refused_and_not_begun() {
    let four = system(E1_IN_FOUR);
    let [h, k, rho] = ["H", "K", "rho"].map(|name| stated(&four, name));
    let mut little = Budget::new(100, 20);
    assert_eq!(invariant_tensor(&four.field.symbols, &rho, &[h, k], &mut little), None);

    let names: Vec<String> = (0..24).map(|i| format!("x{i}")).collect();
    let field: String = names.iter().map(|name| format!("{name}dot = {name}; ")).collect();
    let large = system(&field);
    let symbols = &large.field.symbols;
    let power_sum = |exponent: u32| {
        (0..24).fold(RationalFunction::zero(), |sum, i| &sum + &power(symbols.state(i), exponent))
    };
    let integrals: Vec<RationalFunction> = (1..=22).map(power_sum).collect();
    assert_eq!(bracket(&large, &RationalFunction::one(), &integrals), None);
}

fn found(claims: &Claims<'_>, system: &System, integrals: &[&str]) -> (Vec<Formula>, Formula) {
    let symbols = &system.field.symbols;
    let integral = |(index, name): (usize, &&str)| {
        let value = stated(system, name);
        claims.integral(symbols, index + 1, value.numerator(), value.denominator(), &[]).expect("an integral")
    };
    let below = stated(system, "rho").denominator().clone();
    let density = claims.density(symbols, None, &[(below, -1)], &[]).expect("a density");
    (integrals.iter().enumerate().map(integral).collect(), density)
}

#[test]
fn every_choice_of_integrals_gives_a_bracket_until_the_time_is_up() {
    let system = system(E1_IN_FOUR);
    let symbols = &system.field.symbols;
    let claims = Claims::new(&system, &[], None);
    let (integrals, density) = found(&claims, &system, &["H", "K", "L"]);
    let of = |integrals: &[Formula], deadline: &Deadline<'_>| {
        brackets(&claims, symbols, &[], integrals, Some(&density), deadline).proved
    };
    assert_eq!(of(&integrals, &Deadline::never()).len(), 3);
    assert_eq!(of(&integrals[..2], &Deadline::never()).len(), 1);
    assert!(of(&integrals[..1], &Deadline::never()).is_empty(), "too few integrals");

    let clock = Ticking::default();
    let work = WatchedSearch::new(&clock);
    let past = Deadline::after(&work, 0.0);
    assert!(of(&integrals, &past).is_empty());
    assert!(past.has_stopped(), "what was left out is known");
}
