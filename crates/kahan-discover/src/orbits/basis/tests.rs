//! Tests bases of systems whose integrals are known.

use kahan_algebra::field::Field;
use kahan_algebra::{lexer, read};

use super::*;
use crate::modular::matrix::Echelon;

fn field(text: &str) -> Field {
    read(&lexer::lex(text).tokens).system().expect("a system").field.as_ref().clone()
}

/// Clebsch's case of a rigid body in a fluid, with four integrals in six variables.
const CLEBSCH: &str = "m1dot = (w3 - w2)*p2*p3; m2dot = (w1 - w3)*p3*p1; m3dot = (w2 - w1)*p1*p2;
    p1dot = p2*m3 - p3*m2; p2dot = p3*m1 - p1*m3; p3dot = p1*m2 - p2*m1;";

fn found(text: &str, degree: u32, wanted: usize) -> (SearchField, Field, Vec<Basis>) {
    let field = field(text);
    let searched = SearchField::new(&field, None);
    let mut random = SplitMix64::new(1);
    let sample = searched.sample(Modulus::mersenne_61(), &mut random).unwrap();
    let place = sample.step(&mut random).unwrap();
    let all = candidates(&searched, degree, &mut random, &Deadline::never());
    let bases = choose_bases(&all, wanted, &place, &mut Vec::new(), &Deadline::never());
    (searched, field, bases)
}

#[test]
fn bases_of_the_clebsch_case_give_its_four_integrals_and_are_proved() {
    let (searched, field, bases) = found(CLEBSCH, 2, 4);
    assert_eq!(bases.iter().map(|basis| basis.integrals.len()).sum::<usize>(), 4);
    assert_eq!(bases[0].monomial_texts(&field.symbols.states), ["1", "p3^2", "p2^2", "p1^2"]);
    for basis in &bases {
        assert!(prove(basis, &searched, &field, &Deadline::never()).is_some());
    }
}

#[test]
fn what_is_no_basis_is_not_proved() {
    let (searched, field, bases) = found(CLEBSCH, 2, 4);
    let mut less = bases[0].clone();
    less.monomials.truncate(3);
    less.terms.truncate(3);
    let mut joined = bases[0].clone();
    joined.monomials.extend(bases[1].monomials.clone());
    joined.monomials.sort();
    joined.monomials.dedup();
    joined.terms = (0..joined.monomials.len()).map(|place| vec![(place, 1)]).collect();
    for other in [less, joined] {
        assert_eq!(prove(&other, &searched, &field, &Deadline::never()), None);
    }
}

#[test]
fn exact_values_are_constant_along_an_orbit_and_floats_agree_with_them() {
    use kahan_algebra::arithmetic::Exact;
    use kahan_algebra::interpret::{Interpreter, Point};
    use kahan_algebra::rational::Rational;
    let text = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);";
    let (_, _, bases) = found(text, 2, 2);
    let system = read(&lexer::lex(text).tokens).system().expect("a system");
    let eps = Rational::new(1, 10);
    let mut orbit = vec![vec![Rational::new(1, 2), Rational::new(-1, 3), Rational::one()]];
    let interpreter = Interpreter::new(&system);
    while orbit.len() < 12 {
        let state = orbit[orbit.len() - 1].clone();
        let point = Point { state, parameters: Vec::new(), eps: eps.clone() };
        orbit.push(interpreter.evaluate(&Exact, &point).unwrap().next.unwrap());
    }
    for basis in &bases {
        let first = basis.evaluate_exact(&orbit).unwrap();
        assert_eq!(basis.evaluate_exact(&orbit[3..]).unwrap(), first);
        let floats: Vec<Vec<f64>> =
            orbit.iter().map(|point| point.iter().map(Rational::to_f64).collect()).collect();
        let found = basis.evaluate(&floats).unwrap();
        assert!(found.condition >= 1.0);
        let scale = |place: usize| {
            let value = |point: &Vec<f64>| -> f64 {
                basis.monomials[place].iter().zip(point).map(|(&e, x)| x.powi(e as i32)).product()
            };
            floats.iter().map(|point| value(point).abs()).fold(0.0, f64::max)
        };
        let terms = first.iter().enumerate().map(|(place, c)| c.to_f64().abs() * scale(place));
        let largest = terms.fold(0.0, f64::max);
        for (place, (value, exact)) in found.coefficients.iter().zip(&first).enumerate() {
            let bound = 64.0 * f64::EPSILON * found.condition * largest / scale(place);
            assert!((value - exact.to_f64()).abs() <= bound, "{value} {exact} {}", found.condition);
        }
        assert_eq!(
            basis.evaluate(&floats[..basis.points() - 1]).unwrap_err(),
            BasisError::TooFewPoints { wanted: basis.points(), given: basis.points() - 1 }
        );
        let resting = vec![floats[0].clone(); 12];
        assert_eq!(basis.evaluate(&resting).unwrap_err(), BasisError::Undetermined);
        let infinite = vec![vec![f64::INFINITY; 3]; 12];
        assert_eq!(basis.evaluate(&infinite).unwrap_err(), BasisError::NotFinite);
    }
}

#[test]
fn gradients_are_those_of_the_coefficients() {
    let (searched, _, bases) = found(CLEBSCH, 2, 4);
    let mut random = SplitMix64::new(5);
    let sample = searched.sample(Modulus::mersenne_61(), &mut random).unwrap();
    let modulus = *sample.map.modulus();
    let point = sample.map.point(&mut random);
    let next = sample.map.next(&point).unwrap();
    let jacobian = sample.map.jacobian(&point, &next).unwrap();
    for basis in &bases {
        let here = gradients::of_coefficients(basis, &sample.map, &point).unwrap();
        let there = gradients::of_coefficients(basis, &sample.map, &next).unwrap();
        // Since c(φ(x)) = c(x), the gradient at x̃ times ∂x̃/∂x must be the gradient at x.
        for (own, other) in here.iter().zip(&there) {
            let mut pulled = vec![0; 6];
            for (factor, row) in other.iter().zip(&jacobian) {
                for (entry, value) in pulled.iter_mut().zip(row) {
                    *entry = modulus.plus(*entry, modulus.times(*factor, *value));
                }
            }
            assert_eq!(own, &pulled);
        }
        assert!(Echelon::of(&modulus, here, 6).rank() >= basis.integrals.len());
    }
}

#[test]
fn monomials_with_equal_coefficients_are_joined() {
    let kirchhoff =
        "m1dot = (a3 - a1)*m2*m3 + (b3 - b1)*p2*p3; m2dot = (a1 - a3)*m1*m3 + (b1 - b3)*p1*p3; m3dot = 0;
        p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);";
    let (searched, field, bases) = found(kirchhoff, 2, 4);
    let states = &field.symbols.states;
    let mut texts = Vec::new();
    for mut basis in bases {
        let before = (basis.points(), basis.monomials.clone());
        basis.join_terms(&searched, &mut SplitMix64::new(2));
        assert!(basis.points() <= before.0 && basis.monomials == before.1);
        assert!(prove(&basis, &searched, &field, &Deadline::never()).is_some());
        if let Some(term) = basis.terms.iter().position(|term| term.len() > 1) {
            let mut wrong = basis.clone();
            wrong.terms[term][1].1 += 1;
            assert_eq!(prove(&wrong, &searched, &field, &Deadline::never()), None);
        }
        texts.extend(basis.term_texts(states, &Text));
    }
    assert!(texts.iter().any(|text| text == "m1^2 + m2^2"), "{texts:?}");
}
