mod costs;
mod random;

use kahan_algebra::poly::{Budget, Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;

use super::{Factors, factors};

/// Parses a sum of terms such as `-3/2*x^2*y`. Each letter is a variable.
fn p(text: &str) -> Polynomial {
    let text = text.replace(' ', "").replace('-', "+-");
    Polynomial::from_terms(text.split('+').filter(|term| !term.is_empty()).map(|term| {
        let (sign, term) = term.strip_prefix('-').map_or((1, term), |rest| (-1, rest));
        let mut coefficient = Rational::from(sign);
        let mut monomial = Monomial::one();
        for factor in term.split('*') {
            let (base, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
            match base.as_bytes()[0] {
                letter @ b'a'..=b'z' => {
                    let variable = Variable(u16::from(letter - b'a'));
                    monomial = monomial.mul(&Monomial::power(variable, exponent.parse().unwrap()));
                }
                _ => {
                    let (numerator, denominator) = base.split_once('/').unwrap_or((base, "1"));
                    let number = |text| Rational::parse(text).unwrap();
                    coefficient =
                        &coefficient * &number(numerator).checked_div(&number(denominator)).unwrap();
                }
            }
        }
        (monomial, coefficient)
    }))
}

fn product<'a>(factors: impl IntoIterator<Item = &'a (Polynomial, u32)>) -> Polynomial {
    factors.into_iter().fold(Polynomial::one(), |product, (factor, exponent)| {
        &product * &factor.pow_within(*exponent, &mut Budget::unlimited()).unwrap()
    })
}

fn assert_sound(polynomial: &Polynomial, factors: &Factors) {
    assert_eq!(product(&factors.factors).scale(&factors.content), *polynomial);
    for (factor, exponent) in &factors.factors {
        assert!(factor.content().is_one() && factor.degree() > 0 && *exponent > 0, "{factor:?}");
    }
    for pair in factors.factors.windows(2) {
        assert!(pair[0].0.degree() <= pair[1].0.degree());
    }
}

fn all_factors(polynomial: &Polynomial) -> Vec<(Polynomial, u32)> {
    let factors = factors(polynomial, &mut Budget::new(100_000, 50_000_000));
    assert_sound(polynomial, &factors);
    assert!(factors.is_complete, "{polynomial:?}");
    factors.factors
}

fn assert_found(given: &[(&str, u32)]) {
    let given: Vec<(Polynomial, u32)> =
        given.iter().map(|(text, e)| (p(text).primitive_part(), *e)).collect();
    let found = all_factors(&product(&given));
    assert_eq!(found.len(), given.len(), "{given:?} became {found:?}");
    for factor in &given {
        assert!(found.contains(factor), "{factor:?} is missing in {found:?}");
    }
}

fn assert_irreducible(text: &str) {
    assert_found(&[(text, 1)]);
}

#[test]
fn known_products_come_back() {
    assert_found(&[("y", 1), ("2*x + 3*y", 1), ("x - y", 2)]);
    assert_found(&[("x^2 + 2*x*y + 2*y^2", 1), ("x^2 - 2*x*y + 2*y^2", 1)]);
    assert_found(&[("x + y + z + 1", 1), ("x + y + z - 1", 1)]);
    assert_found(&[("a", 3), ("b", 1), ("a^2 + b", 2), ("a + b^2", 3), ("a*b - 1", 1)]);
    assert_eq!(all_factors(&p("x^4 + 4*y^4")).len(), 2);
    assert_eq!(all_factors(&p("x^2 + y^2 + z^2 + 2*x*y + 2*x*z + 2*y*z - 1")).len(), 2);
    // At z = 0, the three factors are equal.
    assert_found(&[("x^2 + y", 1), ("x^2 + y + z^2 - z*t", 2), ("x^2 + y + z", 1)]);
}

#[test]
fn irreducible_ones_stay() {
    for text in [
        "x",
        "x + 1",
        "x^4 + 1",
        "x^4 - 10*x^2 + 1",
        "x^4 - 10*x^2*y^2 + y^4",
        // The polynomials x² − y and x⁴ − y are reducible if y is set to a square.
        "x^2 - y",
        "x^4 - y",
        "x^2 + y^2",
        "x^2 - 2*y^2*z^2",
        "x^2 + y^2 + z^2 - 1",
        // The roots are the sums ±√2 ± √3 ± √5.
        "x^8 - 40*x^6 + 352*x^4 - 960*x^2 + 576",
        "x^2*y^2 + x^2*z^2 + y^2*z^2 - x*y*z*t",
        "x^3*y^2 - z^5",
        "x^6 + y^6 + z^6 - 3*x^2*y^2*z^2 + t",
    ] {
        assert_irreducible(text);
    }
}

#[test]
fn the_determinant_of_unknowns_is_irreducible() {
    let det = "a*e*i + b*f*g + c*d*h - c*e*g - b*d*i - a*f*h";
    assert_irreducible(det);
    assert_found(&[(det, 2), ("a + e + i", 1)]);
    // The determinant of a symmetric matrix is linear in no entry off the diagonal.
    assert_irreducible("a*b*c + 2*x*y*z - a*x^2 - b*y^2 - c*z^2");
    // The determinant of a skew-symmetric matrix is the square of the Pfaffian.
    let pfaffian = p("a*f - b*e + c*d");
    assert_eq!(all_factors(&(&pfaffian * &pfaffian)), [(pfaffian, 2)]);
}

#[test]
fn differences_of_powers_have_a_factor_for_each_divisor() {
    for n in 1..=20_u32 {
        let divisors = (1..=n).filter(|d| n % d == 0).count();
        assert_eq!(all_factors(&p(&format!("x^{n} - 1"))).len(), divisors, "{n}");
        assert_eq!(all_factors(&p(&format!("x^{n} - y^{n}"))).len(), divisors, "{n}");
    }
    assert_eq!(all_factors(&p("x^12 - y^6*z^18")).len(), 4);
}

#[test]
fn constants_signs_and_contents() {
    let of = |polynomial: &Polynomial| factors(polynomial, &mut Budget::unlimited());
    let zero = of(&Polynomial::zero());
    assert_eq!((zero.content, zero.factors.len(), zero.is_complete), (Rational::ZERO, 0, true));
    let constant = of(&p("-3/7"));
    assert_eq!((constant.content, constant.factors.len()), (Rational::new(-3, 7), 0));
    let mixed = of(&p("-2/3*x^2*y + 2/3*y^3"));
    assert_sound(&p("-2/3*x^2*y + 2/3*y^3"), &mixed);
    assert_eq!(mixed.content, Rational::new(-2, 3));
    assert_eq!(mixed.factors, [(p("y"), 1), (p("x + y"), 1), (p("x - y"), 1)]);
}

#[test]
fn leading_coefficients_may_have_several_variables() {
    assert_found(&[("a*x + b", 1), ("c*x + d", 1), ("a*x + b^2*c", 1)]);
    assert_found(&[("a*x^2 + b", 1), ("c*x^2 + d", 2), ("a*b*x^2 + b^2*c + 1", 1)]);
    assert_found(&[("a*x^2 + a*b + 1", 3), ("6*a^2*x^2 + 5*b^2 + 1", 1), ("10*b*x^2 + a^2", 2)]);
    assert_found(&[("x^2*y^2*z - 1", 1), ("x^2*z^2*y + x + t", 1), ("t^2*x^2 + y^2*z^2 + 7", 1)]);
    assert_found(&[
        ("x^2*y^2*z^2 + x^2*y^2 + y^2*z^2 + x^2*z^2 + x^2 + 3", 1),
        ("x^2*y^2*z^2 - 2*x^2*y^2 + y^2*z^2 - x^2*z^2 + z^2 + 5*x*y*z", 2),
    ]);
}

#[test]
fn bad_points_are_no_matter() {
    let zeros = (-9..10).fold(Polynomial::one(), |product, root| &product * &p(&format!("y + {root}")));
    let near = &(&zeros * &p("x^2")) + &p("x*z + 1");
    let far = &(&zeros * &p("z^2")) + &p("x^2 + 3");
    for (left, right) in
        [(near.clone(), p("x^2 + x*z + y")), (near, far.clone()), (far, p("x^2 + 3*z^2 + 3"))]
    {
        assert_eq!(all_factors(&(&left * &right)).len(), 2, "{left:?} {right:?}");
    }
    // Both factors are equal if y is set to a root of `zeros`.
    let (left, right) = (p("x^2 + z"), &p("x^2 + z") + &zeros);
    assert_eq!(all_factors(&(&left * &right)).len(), 2);
}

#[test]
fn coefficients_may_have_fifty_digits() {
    let (left, right) = (
        "12345678901234567890123456789012345678901234567891",
        "98765432109876543210987654321098765432109876543211",
    );
    assert_found(&[
        (&format!("x^2 + {left}*y^2 + 1"), 1),
        (&format!("{right}*x^2 - {left}*x*y + z^2"), 2),
        (&format!("x + {right}*z"), 1),
    ]);
    assert_irreducible(&format!("{right}*x^2 - {left}*y^2*z^2"));
    assert_found(&[(&format!("{left}*x^3 + 1"), 1), (&format!("x^3 - {right}"), 1)]);
}
