use kahan_syntax::rational::Rational;

use super::{Budget, Monomial, OverBudget, Polynomial, Variable, gcd, gcd_all, gcd_within};
use crate::prime_field::SplitMix64;

fn v(index: u16) -> Polynomial {
    Polynomial::variable(Variable(index))
}

fn c(value: i64) -> Polynomial {
    Polynomial::constant(Rational::from(value))
}

fn random(rng: &mut SplitMix64, variables: u16, terms: usize) -> Polynomial {
    Polynomial::from_terms((0..terms).map(|_| {
        let powers = (0..variables).map(|index| (Variable(index), u32::try_from(rng.below(3)).unwrap()));
        let monomial: Monomial = powers.collect();
        let numerator = i64::try_from(rng.below(19)).unwrap() - 9;
        (monomial, Rational::new(numerator, 1 + i64::try_from(rng.below(4)).unwrap()))
    }))
}

fn assert_normal(polynomial: &Polynomial) {
    assert!(polynomial.terms.is_sorted_by(|left, right| left.0 > right.0), "{polynomial:?}");
    assert!(polynomial.terms().all(|(_, coefficient)| !coefficient.is_zero()), "{polynomial:?}");
}

#[test]
fn polynomials_form_a_commutative_ring() {
    let mut rng = SplitMix64::new(1);
    for _ in 0..60 {
        let [p, q, r] = [5, 6, 7].map(|terms| random(&mut rng, 3, terms));
        assert_normal(&p);
        assert_eq!(&p + &q, &q + &p);
        assert_eq!(&p * &q, &q * &p);
        assert_eq!(&(&p + &q) + &r, &p + &(&q + &r));
        assert_eq!(&(&p * &q) * &r, &p * &(&q * &r));
        assert_eq!(&p * &(&q + &r), &(&p * &q) + &(&p * &r));
        assert_eq!(&(&p - &q) + &q, p);
        assert!((&p - &p).is_zero());
        assert_eq!(&p * &Polynomial::one(), p);
        assert_eq!(p.clone() - q.clone(), &p - &q);
        assert_normal(&(&p * &q));
        assert_normal(&(&p + &q));
    }
}

#[test]
fn the_order_of_monomials_is_graded_and_admissible() {
    let mut rng = SplitMix64::new(2);
    let monomials: Vec<Monomial> = random(&mut rng, 4, 30).terms().map(|(m, _)| m.clone()).collect();
    for m in &monomials {
        assert!(*m >= Monomial::one());
        for n in &monomials {
            assert_eq!(m == n, m.cmp(n).is_eq());
            assert_eq!(m.mul(n).div(n).as_ref(), Some(m));
            assert_eq!(m.gcd(n).degree() == 0, m.powers().iter().all(|(v, _)| n.exponent(*v) == 0));
            assert!(m.div(&m.gcd(n)).is_some() && n.div(&m.gcd(n)).is_some());
            for k in &monomials {
                assert_eq!(m.cmp(n), m.mul(k).cmp(&n.mul(k)));
            }
        }
    }
    let first = Monomial::variable(Variable(0));
    assert!(first > Monomial::variable(Variable(1)));
    assert!(first < Monomial::power(Variable(1), 2));
    assert_eq!(first.pow(3), Monomial::power(Variable(0), 3));
    assert_eq!(first.div(&Monomial::variable(Variable(1))), None);
}

#[test]
fn the_derivative_obeys_the_product_rule() {
    let mut rng = SplitMix64::new(3);
    for _ in 0..30 {
        let (p, q) = (random(&mut rng, 3, 6), random(&mut rng, 3, 6));
        let x = Variable(1);
        assert_eq!((&p * &q).derivative(x), &(&p.derivative(x) * &q) + &(&p * &q.derivative(x)));
    }
}

#[test]
fn substitution_is_a_ring_homomorphism() {
    let mut rng = SplitMix64::new(4);
    let (x, value) = (Variable(0), Rational::new(-2, 3));
    for _ in 0..30 {
        let (p, q) = (random(&mut rng, 3, 6), random(&mut rng, 3, 6));
        let at = |polynomial: &Polynomial| polynomial.substitute(x, &value);
        assert_eq!(at(&(&p * &q)), &at(&p) * &at(&q));
        assert_eq!(at(&(&p + &q)), &at(&p) + &at(&q));
        assert!(!at(&p).contains(x));
    }
}

#[test]
fn coefficients_in_a_variable_add_up_to_the_polynomial() {
    let p = random(&mut SplitMix64::new(5), 3, 20);
    let x = Variable(2);
    let mut sum = Polynomial::zero();
    for (exponent, coefficient) in p.coefficients_in(x) {
        assert_normal(&coefficient);
        assert!(!coefficient.contains(x));
        sum = &sum + &coefficient.mul_monomial(&Monomial::power(x, exponent));
    }
    assert_eq!(sum, p);
}

#[test]
fn renaming_there_and_back_is_the_identity() {
    let p = random(&mut SplitMix64::new(6), 3, 20);
    assert_eq!(p.map_variables(|x| Variable(9 - x.0)).map_variables(|x| Variable(9 - x.0)), p);
    assert_eq!((&v(0) - &v(1)).map_variables(|_| Variable(0)), Polynomial::zero());
}

#[test]
fn degrees_and_constants_are_read_off() {
    let p = &(&v(0) * &v(1)) + &c(3);
    assert_eq!((p.degree(), p.degree_in(Variable(1)), p.degree_in(Variable(7))), (2, 1, 0));
    assert_eq!(p.degree_where(|x| x == Variable(0)), 1);
    assert_eq!((p.as_constant(), c(3).as_constant()), (None, Some(Rational::from(3))));
    assert_eq!(Polynomial::zero().as_constant(), Some(Rational::ZERO));
    assert_eq!(p.coefficient(&Monomial::one()), Rational::from(3));
    assert_eq!(p.coefficient(&Monomial::variable(Variable(0))), Rational::ZERO);
    assert_eq!(p.variables().into_iter().collect::<Vec<_>>(), [Variable(0), Variable(1)]);
}

#[test]
fn content_times_primitive_part_is_the_polynomial() {
    let mut rng = SplitMix64::new(7);
    for _ in 0..30 {
        let p = random(&mut rng, 2, 5);
        let primitive = p.primitive_part();
        assert_eq!(primitive.scale(&p.content()), p);
        assert!(primitive.terms().all(|(_, coefficient)| coefficient.is_integer()));
        assert!(primitive.leading_term().is_none_or(|(_, coefficient)| !coefficient.is_negative()));
        assert!(p.is_zero() || primitive.content().is_one());
    }
    let p = &(&v(0) * &v(0)).scale(&Rational::new(-4, 3)) + &v(0).scale(&Rational::new(2, 9));
    assert_eq!(p.content(), Rational::new(-2, 9));
    assert_eq!(p.monomial_content(), Monomial::variable(Variable(0)));
}

#[test]
fn a_product_divides_exactly_and_a_remainder_is_refused() {
    let mut rng = SplitMix64::new(8);
    for _ in 0..40 {
        let (p, q) = (random(&mut rng, 3, 6), random(&mut rng, 3, 5));
        if q.is_zero() {
            assert_eq!(p.checked_div(&q), None);
            continue;
        }
        assert_eq!((&p * &q).checked_div(&q), Some(p.clone()));
        if q.degree() > 0 {
            assert_eq!((&(&p * &q) + &c(1)).checked_div(&q), None);
        }
    }
}

#[test]
fn products_and_powers_keep_to_their_budget() {
    let sum = &(&v(0) + &v(1)) + &c(1);
    let power = sum.pow_within(4, &mut Budget::unlimited()).unwrap();
    assert_eq!(power, &(&(&sum * &sum) * &sum) * &sum);
    assert_eq!(power.len(), 15);
    assert_eq!(sum.pow_within(0, &mut Budget::new(1, 0)), Ok(Polynomial::one()));
    assert_eq!(sum.pow_within(4, &mut Budget::new(14, 10_000)), Err(OverBudget));
    assert_eq!(sum.pow_within(4, &mut Budget::new(15, 10)), Err(OverBudget));
    assert_eq!(sum.mul_within(&sum, &mut Budget::new(5, 100)), Err(OverBudget));
    assert_eq!(sum.mul_within(&sum, &mut Budget::new(6, 9)), Ok(&sum * &sum));
    // The 64th power of `many` has more than 10^12 terms. The budget refuses it before any work.
    let many = (0..12).fold(c(1), |sum, index| &sum + &v(index));
    assert_eq!(many.pow_within(64, &mut Budget::new(100_000, u64::MAX)), Err(OverBudget));
    let dense = &(&(&v(0) * &v(0)) + &v(0)) + &c(1);
    assert_eq!(dense.pow_within(64, &mut Budget::new(129, 100_000)).unwrap().len(), 129);
    let mut nested = v(0).scale(&Rational::from(3));
    let mut budget = Budget::new(10, 1_000_000);
    let refused = (0..100).any(|_| match nested.pow_within(64, &mut budget) {
        Ok(power) => {
            nested = power;
            false
        }
        Err(OverBudget) => true,
    });
    assert!(refused);
}

#[test]
fn the_gcd_of_multiples_is_the_common_factor_times_the_rest() {
    let mut rng = SplitMix64::new(9);
    let mut compared = 0;
    for round in 0..60 {
        let variables = 1 + round % 3;
        let [a, b, g] = [3, 4, 3].map(|terms| random(&mut rng, variables, terms));
        if a.is_zero() || b.is_zero() || g.is_zero() {
            continue;
        }
        let (left, right) = (&a * &g, &b * &g);
        let common = gcd(&left, &right);
        assert_eq!(common, common.primitive_part());
        let (p, q) = (left.checked_div(&common).unwrap(), right.checked_div(&common).unwrap());
        assert!(common.checked_div(&g).is_some(), "gcd({left:?}, {right:?}) = {common:?}");
        assert!(gcd(&p, &q).is_one());
        assert_eq!(gcd(&right, &left), common);
        compared += 1;
    }
    assert!(compared > 50, "{compared}");
}

#[test]
fn the_gcd_at_the_borders() {
    let p = &v(0).scale(&Rational::new(-2, 3)) + &c(4);
    assert_eq!(gcd(&Polynomial::zero(), &p), p.primitive_part());
    assert!(gcd(&Polynomial::zero(), &Polynomial::zero()).is_zero());
    assert!(gcd(&c(6), &p).is_one());
    assert_eq!(gcd(&(&v(0) * &v(0)), &(&v(0) * &v(1))), v(0));
    assert_eq!(gcd_all(&[&v(0) * &p, &v(1) * &p, p.clone()]), p.primitive_part());
    assert!(gcd_all(&[]).is_zero());
    let power = (&v(0) + &v(1)).pow_within(6, &mut Budget::unlimited()).unwrap();
    assert_eq!(
        gcd(&power, &power.derivative(Variable(0))),
        (&v(0) + &v(1)).pow_within(5, &mut Budget::unlimited()).unwrap()
    );
}

fn e3() -> (Polynomial, Polynomial, Polynomial) {
    let (x, y, z, e) = (v(0), v(1), v(2), v(3));
    let pole = &c(1) + &(&e * &z);
    let radius = &(&x * &x) + &(&y * &y);
    let rest = &pole + &(&(&e * &e) * &radius).scale(&Rational::from(2));
    let cofactor = &(&(&x + &(&e * &(&x * &z))) - &(&e * &y)) + &(&(&e * &e) * &(&radius * &z));
    (&pole * &rest, &pole * &cofactor, pole)
}

#[test]
fn the_removable_pole_of_e3_is_found() {
    let (denominator, numerator, pole) = e3();
    assert_eq!(gcd(&denominator, &numerator), pole);
    assert!(gcd(&denominator, &(&numerator + &c(1))).is_one());
}

#[test]
fn a_gcd_over_budget_says_so() {
    let (denominator, numerator, _) = e3();
    assert_eq!(gcd_within(&denominator, &numerator, &mut Budget::new(1000, 3)), Err(OverBudget));
    assert!(gcd_within(&denominator, &numerator, &mut Budget::new(1000, 10_000)).is_ok());
    let tall = |degree| &Polynomial::term(Monomial::power(Variable(0), degree), Rational::ONE) - &c(1);
    assert_eq!(
        gcd_within(&tall(1 << 20), &tall((1 << 20) - 1), &mut Budget::new(1000, 1_000_000)),
        Err(OverBudget)
    );
    assert_eq!(tall(1 << 20).div_within(&tall(1), &mut Budget::new(1000, 1_000_000)), Err(OverBudget));
}

#[test]
fn the_root_of_a_square_is_found_and_nothing_else_has_one() {
    let (x, y, z) = (v(0), v(1), v(2));
    let half = Rational::new(1, 2);
    let sum = &(&(&x * &y).scale(&half) - &z) + &c(3);
    let (tall, cube) = (&sum * &(&x * &x), &(&sum * &sum) * &sum);
    for root in [sum.clone(), c(0), c(1), x.clone(), tall, cube] {
        let square = &root * &root;
        assert_eq!(square.square_root(), Some(root.clone()), "{root:?}");
        assert_eq!((&square + &y).square_root(), None, "{root:?}");
        assert_eq!((-&(&square + &(&z * &z))).square_root(), None, "{root:?}");
    }
    assert_eq!(c(2).square_root(), None);
    assert_eq!((&(&x + &y) * &(&x + &z)).square_root(), None);
}
