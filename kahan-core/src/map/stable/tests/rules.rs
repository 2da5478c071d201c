//! Tests that each rule of the running error bound is nearly sharp. A test would fail if its rule
//! counted one rounding less, or if the reserve in the factor `SLACK` were halved.

use num_traits::One;

use super::worst::{Beside, Q, Worst, off_by, two_to, with_low_magnitudes};
use crate::scalar::bounded::Number;
use crate::scalar::bounded::{Bounded, SLACK};

/// A precision so coarse that (1+u)ᵏ − 1 differs from k·u, where u is the rounding unit.
const COARSE: i32 = 10;
/// A precision so fine that (1+u)ᵏ − 1 is nearly k·u, where u is the rounding unit.
const FINE: i32 = 24;

const UP: (i64, i64) = (1, 0);
const DOWN: (i64, i64) = (-1, 0);
const EXACTLY: (i64, i64) = (0, 0);

/// Returns the number 1 after k upward roundings, which is (1+u)ᵏ.
fn rounded_up<const BITS: i32>(k: usize) -> Beside<BITS> {
    let one = Beside::from_input(1.0);
    off_by(UP, || (0..k).fold(one.clone(), |product, _| product.times(&one)))
}

fn rounded_down<const BITS: i32>(k: usize) -> Beside<BITS> {
    let one = Beside::from_input(1.0);
    off_by(DOWN, || (0..k).fold(one.clone(), |product, _| product.times(&one)))
}

#[track_caller]
fn assert_near<const BITS: i32>(value: &Beside<BITS>, least: f64) {
    let part = value.part();
    assert!(part <= 1.0, "{part} of the bound");
    assert!(part >= least, "a bound that nothing comes near says little: {part}");
}

const ALL: f64 = 1.0 / SLACK - 1e-4;

#[test]
fn inputs_and_whole_literals_are_exact_and_others_are_rounded_once() {
    for exact in [Beside::<FINE>::from_input(0.3), Beside::literal(7, 1)] {
        assert_eq!((exact.bounded.roundings(), exact.error()), (0, Q::from_integer(0.into())));
    }
    let third = off_by(UP, || Beside::<FINE>::literal(1, 3));
    assert_near(&third, ALL);
}

#[test]
fn a_sum_rounds_once() {
    let (one, two) = (Beside::<FINE>::from_input(1.0), Beside::from_input(2.0));
    for direction in [UP, DOWN] {
        assert_near(&off_by(direction, || one.plus(&two)), ALL);
        assert_near(&off_by(direction, || one.minus(&two.negated())), ALL);
        let nothing = Beside::from_input(0.0);
        assert_near(&off_by(direction, || nothing.times_plus(&one, &two)), 0.4);
    }
}

#[test]
fn a_sum_has_the_errors_of_its_terms() {
    for (a, b) in [(5, 5), (0, 5), (5, 0)] {
        let sum = off_by(UP, || rounded_up::<FINE>(a).plus(&rounded_up(b)));
        let all = f64::from(u8::from(a > 0) + u8::from(b > 0)) * 5.0 / 2.0 + 1.0;
        assert_near(&sum, ALL * all / 6.0);
        let difference = rounded_up::<FINE>(a).minus(&rounded_down(b));
        assert_near(&difference, ALL * (all - 1.0) / 6.0);
    }
}

#[test]
fn a_product_rounds_once_and_has_the_errors_of_both_factors() {
    for (a, b) in [(0, 0), (4, 0), (0, 4), (4, 4)] {
        assert_near(&off_by(UP, || rounded_up::<FINE>(a).times(&rounded_up(b))), ALL);
        assert_near(&off_by(DOWN, || rounded_down::<FINE>(a).times(&rounded_down(b))), ALL);
        let nothing = Beside::from_input(0.0);
        let sum = off_by(UP, || rounded_up::<FINE>(a).times_plus(&rounded_up(b), &nothing));
        assert_near(&sum, ALL);
    }
}

/// The factor `SLACK` covers 40 roundings, and the downward rounding of magnitudes.
#[test]
fn the_slack_pays_for_products_of_roundings_and_for_those_of_magnitudes() {
    with_low_magnitudes(|| assert_near(&rounded_up::<COARSE>(40), 0.99));
}

#[test]
fn the_slack_of_quotients_pays_for_rounded_magnitudes() {
    const MIDDLE: i32 = 13;
    with_low_magnitudes(|| {
        for (a, b) in [(300, 0), (300, 100), (112, 112)] {
            let quotient =
                off_by(DOWN, || rounded_down::<MIDDLE>(a).over(&rounded_up(b))).expect("a quotient");
            assert!(quotient.part() <= 1.0, "{}", quotient.part());
        }
        let chain = off_by(DOWN, || {
            let first = Beside::<MIDDLE>::literal(2, 1).over(&rounded_up(112))?;
            (0..5).try_fold(first, |quotient, _| quotient.over(&rounded_up(112)))
        });
        assert!(chain.expect("a quotient").part() <= 1.0);
    });
}

#[test]
fn a_quotient_rounds_once_and_has_the_errors_of_both_operands() {
    for (a, b) in [(0, 0), (4, 0), (0, 4), (4, 4)] {
        let quotient = off_by(UP, || rounded_up::<FINE>(a).over(&rounded_down(b))).expect("a quotient");
        let k = a.max(b) as f64 + 1.0;
        let part = (a + b + 1) as f64 / (2.0 * k);
        assert_near(&quotient, part / SLACK.powi(2) - 1e-4);
    }
    for b in [0, 4] {
        let quotient =
            off_by(UP, || Beside::<FINE>::literal(1, 1).over(&rounded_down(b))).expect("a quotient");
        assert_near(&quotient, 0.5 / SLACK.powi(2) - 1e-4);
    }
}

#[test]
fn the_slack_of_a_quotient_pays_for_what_stands_for_it() {
    const MIDDLE: i32 = 13;
    let quotient = off_by(DOWN, || rounded_down::<MIDDLE>(112).over(&rounded_up(112))).expect("a quotient");
    assert!(quotient.part() <= 1.0 && quotient.part() * SLACK * SLACK > 1.005, "{}", quotient.part());
}

/// A quotient requires a divisor with a relative error below 1/64.
#[test]
fn a_divisor_that_may_be_zero_has_no_quotient() {
    let one = Beside::<COARSE>::from_input(1.0);
    let divisor = |d: f64| off_by(EXACTLY, || rounded_up::<COARSE>(3).minus(&Beside::from_input(d)));
    let mut seen = [0, 0];
    for step in 0..1000 {
        let divisor = divisor(f64::from(step) / 1000.0);
        let doubt = Q::one() * divisor.error() * Q::from_integer(64.into());
        match one.over(&divisor) {
            Some(_) => {
                seen[0] += 1;
                assert!(doubt <= divisor.bounded.value().exact() * two_to(0), "{divisor:?}");
                let bound: f64 = divisor.bounded.error().into();
                assert!(64.0 * bound <= 1.01 * f64::from(divisor.bounded.value().size()), "{divisor:?}");
            }
            None => seen[1] += 1,
        }
    }
    assert!(seen.iter().all(|&count| count > 50), "{seen:?}");
}

#[test]
fn a_quotient_of_a_quotient_has_the_errors_of_all_divisors() {
    for k in [0, 1, 4] {
        let chain = off_by(UP, || {
            let first = Beside::<FINE>::literal(2, 1).over(&rounded_down(k))?;
            first.over(&rounded_down(k))?.over(&rounded_down(k))
        });
        let chain = chain.expect("a quotient");
        let part = (3 * k + 3) as f64 / (4 * (k + 3)) as f64;
        assert_near(&chain, part / SLACK.powi(2) - 1e-4);
    }
}

#[test]
fn negation_rounds_nothing_and_keeps_the_error() {
    let value = rounded_up::<FINE>(5);
    assert_near(&value.negated(), ALL);
    assert_near(&value.minus(&value.negated().negated()), 0.0);
}

#[test]
fn what_is_divided_by_eps_is_rounded_once_more() {
    let eps = Beside::<FINE>::from_input(0.5);
    assert_near(&off_by(UP, || Beside::literal(3, 1).over_input(&eps)), ALL);
    assert_near(&off_by(UP, || off_by(UP, || Beside::literal(1, 3)).over_input(&eps)), ALL);
}

#[test]
fn a_weight_bounds_the_product_with_a_reciprocal() {
    for (n, d) in [(0, 0), (6, 0), (0, 6), (6, 6)] {
        for is_whole in [false, true] {
            let one = if is_whole { Beside::<FINE>::literal(1, 1) } else { Beside::from_input(1.0) };
            let (numerator, reciprocal, product) = off_by(UP, || {
                let numerator = rounded_up::<FINE>(n);
                let reciprocal = one.over(&rounded_down(d)).expect("a quotient");
                (numerator.clone(), reciprocal.clone(), numerator.times(&reciprocal))
            });
            let weight = reciprocal.bounded.weight(numerator.bounded.roundings());
            assert!(weight >= reciprocal.bounded.value().size());
            let bound = f64::from(weight * numerator.bounded.magnitude()) * Worst::<FINE>::UNIT;
            let part = num_traits::ToPrimitive::to_f64(&product.error()).expect("a number") / bound;
            let reached = (n + d + 2) as f64 / (n + 1 + 2 * (d + 1)) as f64;
            assert!(part <= 1.0 && part >= reached / SLACK.powi(2) - 1e-4, "{part} of the bound at {n}, {d}");
        }
    }
}

#[test]
fn a_weight_of_an_exact_number_counts_the_product() {
    for n in [0, 5] {
        let (numerator, factor) = (rounded_up::<FINE>(n), Beside::from_input(0.75));
        let product = off_by(UP, || numerator.times(&factor));
        let weight = factor.bounded.weight(numerator.bounded.roundings());
        let bound = f64::from(weight * numerator.bounded.magnitude()) * Worst::<FINE>::UNIT;
        let part = num_traits::ToPrimitive::to_f64(&product.error()).expect("a number") / bound;
        assert!((ALL..=1.0).contains(&part), "{part} of the bound");
    }
}

/// A number with a known error radius has a bound close to this radius, even if terms cancelled.
#[test]
fn a_known_radius_is_the_error() {
    use crate::scalar::{Size, Wide};
    let third = crate::Constant::ratio(1, 3);
    let exact = Bounded::<Wide>::from_input(Wide::from(1.0)) + crate::Scalar::constant(&third);
    assert!(f64::from(exact.error()) == 0.0 && exact.roundings() == 0);
    let sum = Bounded::<Wide>::from_input(Wide::from(1e300)) + Bounded::from_input(Wide::from(3e-300));
    let quotient = exact.quotient(sum).expect("a quotient");
    assert!(exact.quotient(Bounded::from_input(Wide::from(1e-300))).is_some());
    let radius = quotient.value().radius();
    assert!(radius > Size::from(0.0) && quotient.error() >= radius);
    assert!(quotient.magnitude() * Size::from(Wide::UNIT) >= radius);
    let difference = quotient - quotient;
    assert!(difference.value() == Wide::from(0.0) && difference.error() >= radius + radius);
    assert!(difference.error() <= (radius + radius) * Size::from(1.07));
}

#[cfg(target_arch = "x86_64")]
#[test]
fn packed_pairs_are_pairs() {
    use crate::scalar::bounded::{BoundedPair, UnpackedPair};
    use crate::scalar::bounded::{PackedDouble, PackedSingle};
    fn same<V: Number, P: BoundedPair<V>>(packed: P, both: UnpackedPair<V>) {
        assert!(packed.value() == both.value() && packed.magnitude() == both.magnitude());
    }
    fn check<V: Number, P: BoundedPair<V>>(a: (V, V::Magnitude), b: (V, V::Magnitude)) {
        let (p, q) = (P::new(a.0, a.1), P::new(b.0, b.1));
        let (x, y) = (UnpackedPair::new(a.0, a.1), UnpackedPair::new(b.0, b.1));
        same(p.plus(q), x.plus(y));
        same(p.minus(q), x.minus(y));
        same(p.times(q), x.times(y));
        same(p.negated(), x.negated());
        same(p.multiply_add(q, p), x.multiply_add(y, x));
    }
    for (a, b) in [(1.5, -0.25), (-3.0, 7.0), (0.0, 2.0)] {
        check::<f64, PackedDouble>((a, 2.0 * a.abs() + 1.0), (b, b.abs()));
        let (a, b) = (a as f32, b as f32);
        check::<f32, PackedSingle>((a, 2.0 * a.abs() + 1.0), (b, b.abs()));
    }
}

/// The rounding unit of each number type covers the stated error bounds of its operations.
#[test]
fn units_are_those_of_the_operations() {
    use crate::Dd;
    let u = f64::EPSILON / 2.0;
    assert_eq!((f64::UNIT, f32::UNIT), (u, f64::from(f32::EPSILON) / 2.0));
    // A `Dd` quotient errs by at most 14u², and a `Dd` product by at most 16u². A multiply-add
    // counts as two roundings, and errs by at most 16u² of the product plus 5u² of the result.
    assert!(Dd::UNIT >= 14.0 * u * u && 2.0 * Dd::UNIT >= 21.0 * u * u && Dd::UNIT >= 16.0 * u * u);
}
