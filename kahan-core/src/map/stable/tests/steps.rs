//! Tests whole steps with worst-case rounding.

use num_traits::{Signed, ToPrimitive, Zero};

use nalgebra::SVector;

use super::super::bounded_step::BoundedStep;
use super::super::precisions::{ERROR_BOUND, in_own_precision};
use super::super::scalars::PromiseScalar;
use super::worst::{Q, Worst, off_by, two_to};
use crate::scalar::Wide;
use crate::scalar::bounded::Bounded;
use crate::scalar::bounded::UnpackedPair;
use crate::scalar::bounded::{Number, power_of_two};
use crate::{Dd, ExtendScalars, KahanMap, Pivot, PreparedStep, vector};

const BITS: i32 = 24;
type Number24 = Worst<BITS>;

crate::kahan! {
    /// A field whose map has a pole at 1 − 2εx = 0.
    struct Riccati { k }
    xdot = x^2 - k;
}

crate::kahan! {
    /// A field in three variables. The factors of det A are 1 − εx, 1 − 2εy and 1 + ε − εy.
    struct Chain { a }
    xdot = x*y - x;
    ydot = y^2 + a;
    zdot = x*z - 1;
}

crate::kahan! {
    /// A field in which y² has the coefficient a, which may be larger than any state.
    struct Driven { a }
    xdot = a*y^2;
    ydot = -y;
}

crate::kahan! {
    struct Decay;
    xdot = -x;
}

crate::kahan! {
    /// A field whose step has many roundings in its numerator and few in its denominator.
    struct LongNumber { a }
    xdot = -x + a^12*y;
    ydot = 0;
}

impl<const BITS: i32> PromiseScalar for Worst<BITS> {
    type Packed = UnpackedPair<Self>;
    type Wider = Self;
    const IS_WIDEST: bool = true;

    fn embed(&self) -> Self {
        *self
    }

    fn round(value: Self) -> Self {
        value
    }

    fn widen(&self) -> Wide {
        Wide::from(crate::Scalar::approximate(self))
    }

    fn narrow(value: Wide) -> Self {
        Self::of_float(value.to_f64())
    }
}

fn compared<const N: usize>(x: &[Number24; N], y: &SVector<Q, N>) -> (f64, f64) {
    let largest = |values: &mut dyn Iterator<Item = Q>| {
        values.map(|value| value.abs().to_f64().expect("a number")).fold(0.0, f64::max)
    };
    let error = largest(&mut x.iter().zip(y).map(|(x, y)| x.exact() - y));
    (error, largest(&mut y.iter().cloned()))
}

/// Calls `see` with pseudorandom states and ε. Some cases are ordinary, and some are near poles.
fn cases<const N: usize>(count: u64, mut see: impl FnMut(SVector<f64, N>, f64)) {
    let mut state = 20_261_122_u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1_u64 << 24) as f64
    };
    for _ in 0..count {
        let x = SVector::from_fn(|_, _| 3.0 * unit() - 1.0);
        see(x, unit());
        // This ε makes 1 − 2εx₀ small.
        see(x, (1.0 + (unit() - 0.5) * power_of_two(-(16.0 * unit()) as i32)) / (2.0 * x[0]));
    }
}

fn by_step<M, const N: usize>(
    map: &M,
    x: &SVector<Bounded<Number24>, N>,
    eps: Bounded<Number24>,
) -> Option<BoundedStep<Number24, N>>
where
    M: KahanMap<Bounded<Number24>, N>,
{
    Some(BoundedStep::by_increments(x, map.prepare(&eps).quotients(x)?))
}

/// Returns the largest ratio of an attempt's actual error to its bound.
fn largest_part<M, const N: usize>(
    map: &M,
    attempt: impl Fn(&SVector<f64, N>, f64) -> Option<BoundedStep<Number24, N>>,
) -> f64
where
    M: ExtendScalars<Number24, N>,
{
    let exact_map = map.extend_scalars(Worst::exact);
    let mut largest = 0.0_f64;
    cases(40, |x: SVector<f64, N>, eps| {
        let exact = exact_map
            .try_step(&x.map(|x| Q::from_float(x).expect("finite")), Q::from_float(eps).expect("finite"));
        for direction in [(1, 0), (-1, 0)] {
            let Some(attempt) = off_by(direction, || attempt(&x, eps)) else { continue };
            let Ok(exact) = &exact else { panic!("a value at a pole: {x:?}, {eps}") };
            let (error, size) = compared(&attempt.next, exact);
            let computed = attempt.next.iter().map(|next| f64::from(next.size())).fold(0.0, f64::max);
            // `attempt.bound()` excludes the roundings of the last product and of its sum with x.
            let own = 2.0 * Number24::UNIT * (computed + size);
            let bound = attempt.bound() * computed;
            assert!(error <= bound + own, "{error:e} beyond {bound:e} at {x:?}, {eps}");
            largest = largest.max((error - own) / bound);
        }
    });
    largest
}

fn from_input<const N: usize>(x: &SVector<f64, N>) -> SVector<Bounded<Number24>, N> {
    x.map(|x| Bounded::from_input(Worst::of_float(x)))
}

#[test]
fn an_attempt_is_within_what_it_says() {
    let convert = |value: &Number24| Bounded::<Number24>::from_input(*value);
    let eps = |eps: f64| Bounded::<Number24>::from_input(Worst::of_float(eps));
    let riccati = Riccati { k: Number24::of_float(0.75) };
    let chain = Chain { a: Number24::of_float(-0.625) };
    let part =
        largest_part(&riccati, |x, e| by_step(&riccati.extend_scalars(convert), &from_input(x), eps(e)));
    assert!(part > 0.05, "a bound that nothing comes near says little: {part}");
    let part = largest_part(&chain, |x, e| by_step(&chain.extend_scalars(convert), &from_input(x), eps(e)));
    assert!(part > 0.01, "a bound that nothing comes near says little: {part}");
    let part = largest_part(&riccati, |x, e| {
        BoundedStep::by_reduced_map(&riccati.extend_scalars(convert), &from_input(x), eps(e))
    });
    assert!(part > 0.03, "a bound that nothing comes near says little: {part}");
    let part = largest_part(&chain, |x, e| {
        BoundedStep::by_reduced_map(&chain.extend_scalars(convert), &from_input(x), eps(e))
    });
    assert!(part > 0.002, "a bound that nothing comes near says little: {part}");
}

#[test]
fn an_attempt_has_the_roundings_of_its_numerators() {
    let (x, a, eps) = (vector![0.0, 0.7], 1.25, 0.0123);
    let rational = |x: f64| Q::from_float(x).expect("finite");
    let exact = LongNumber { a: rational(a) }.step(&x.map(rational), rational(eps));
    let attempt = off_by((1, 0), || {
        let [a, eps] = [a, eps].map(|number| Bounded::<Number24>::from_input(Worst::of_float(number)));
        by_step(&LongNumber { a }, &from_input(&x), eps).expect("no pole is near")
    });
    let error = compared(&[attempt.next[0]], &vector![exact[0].clone()]).0;
    let size = f64::from(attempt.next[1].size());
    let own = 2.0 * Number24::UNIT * f64::from(attempt.next[0].size());
    let part = (error - own) / (attempt.bound() * size);
    assert!(part <= 1.0 && part > 0.6, "{part} of the bound");
}

#[test]
fn the_first_rung_keeps_the_promise() {
    let riccati = Riccati { k: Number24::of_float(0.75) };
    let exact_map = riccati.extend_scalars(Worst::exact);
    let (mut passed, mut refused, mut largest) = (0, 0, 0.0_f64);
    cases(300, |x: SVector<f64, 1>, eps| {
        let exact = exact_map
            .try_step(&x.map(|x| Q::from_float(x).expect("finite")), Q::from_float(eps).expect("finite"));
        for direction in [(1, 0), (-1, 0)] {
            let next = off_by(direction, || {
                in_own_precision(&riccati, &x.map(Worst::of_float), &Worst::of_float(eps))
            });
            let Some(next) = next else {
                refused += 1;
                continue;
            };
            passed += 1;
            let (error, size) = compared(&[next[0]], exact.as_ref().expect("no pole"));
            largest = largest.max(error / (Number24::UNIT * size));
        }
    });
    assert!(largest <= 64.0 && largest > 5.0, "{largest} u");
    assert!(passed > 100 && refused > 100 && ERROR_BOUND < 64.0, "{passed} passed, {refused} were refused");
}

/// The underflow error of y² is multiplied by a = 2⁶⁰, and then exceeds the bound for underflow.
#[test]
fn the_first_rung_takes_no_input_that_underflow_is_not_allowed_for() {
    let driven = Driven { a: Worst::<BITS>::new(two_to(60)) };
    let (x, eps) = (vector![0.0625, 0.0], 0.03125);
    let step = || in_own_precision(&driven, &x.map(Worst::of_float), &Worst::of_float(eps));
    assert!(off_by((0, 1), step).is_none());
    let driven = Driven { a: Worst::<BITS>::of_float(0.5) };
    let step = || in_own_precision(&driven, &x.map(Worst::of_float), &Worst::of_float(eps));
    assert!(off_by((0, 1), step).is_some());
}

/// Rounding to a narrower scalar adds an error, which exceeds the bound near underflow.
#[test]
fn a_result_that_is_rounded_below_the_normal_range_is_refused() {
    let least = f32::from_bits(1);
    // The exact result, 2·7/9 times the smallest positive float, is not a float.
    assert!(Decay.try_step(&vector![2.0 * least], 0.125).is_err());
    assert_eq!(Decay.try_step(&vector![9.0 * least], 0.125), Ok(vector![7.0 * least]));
    let least = f64::from_bits(1);
    assert!(Decay.try_step(&vector![2.0 * least], 0.125).is_err());
    assert_eq!(Decay.try_step(&vector![9.0 * least], 0.125), Ok(vector![7.0 * least]));
}

#[test]
fn what_is_not_finite_is_no_result() {
    assert!(Decay.try_step(&vector![f64::INFINITY], 0.125).is_err());
    assert!(Decay.try_step(&vector![Dd::from(f64::NAN)], Dd::from(0.125)).is_err());
    assert!(!f64::INFINITY.is_finite_number());
    let zero = Decay.try_step(&vector![0.0], 0.125).expect("a state of rest");
    assert!(zero[0].is_zero());
}

/// At h = ±1 the linear terms of f have determinant 0. Therefore the leading terms of det A cancel.
#[test]
fn what_cancels_at_a_parameter_is_answered_at_every_size() {
    crate::kahan! {
        struct Coupled { h }
        xdot = h*y - x + y*z;
        ydot = h*x - y - x*z;
        zdot = -z + x*y;
    }
    crate::kahan! {
        struct Thirds { h }
        xdot = 1/3*h*y - 1/3*x + y*z;
        ydot = 1/3*h*x - 1/3*y - 2/7*x*z;
        zdot = -z/5 + x*y;
    }
    let eps = [1e3, -9.261772546366742e147, 1e200, -3e285, 1.7e307];
    for h in [-1.0, 1.0] {
        for (eps, size) in eps.iter().flat_map(|eps| [1e-160, 1e-148, 1e-300].map(|size| (*eps, size))) {
            let x = vector![-1.1 * size, -1.5 * size, 1.8 * size];
            let coupled = Coupled { h }.try_step(&x, eps);
            let exact = Coupled { h: Q::from_float(h).unwrap() }
                .step(&x.map(|x| Q::from_float(x).unwrap()), Q::from_float(eps).unwrap());
            assert_answered(coupled, &exact, h, eps);
            let thirds = Thirds { h }.try_step(&x, eps);
            let exact = Thirds { h: Q::from_float(h).unwrap() }
                .step(&x.map(|x| Q::from_float(x).unwrap()), Q::from_float(eps).unwrap());
            assert_answered(thirds, &exact, h, eps);
        }
    }
}

/// Expanded forms would need more than 17 × 64 bits for their terms, but elimination succeeds.
#[cfg(feature = "std")]
#[test]
fn what_is_well_determined_is_answered_however_far_apart_its_terms_are() {
    crate::kahan! {
        struct Apart;
        xdot = 6.56e-1*y*z;
        ydot = 5670664788756226/2^475*z*w - 7666568224479733*2^142*x*w - 2^691*x*z;
        zdot = -11*2^633*w*x + 1.2033372214795e-127*w*y;
        wdot = 6199542747639997/2^360*x*x - 3*2^360*w*z - 4.30783*z;
    }
    let eps = -3.0061345059505065e110;
    let x = [8.705797018655056e18, 1.3604808388164863e126, -6.717876107567089e-139, 1.60544903119305e106];
    let exact = Apart.step(&SVector::from(x).map(|x| Q::from_float(x).unwrap()), Q::from_float(eps).unwrap());
    assert_answered(Apart.try_step(&SVector::from(x), eps), &exact, 0.0, eps);
}

crate::kahan! {
    /// A ring of nine variables, whose step uses sparse elimination.
    struct Ring { h }
    adot = a*(b - i); bdot = b*(c - a); cdot = c*(d - b); ddot = d*(e - c); edot = h*e*(f - d);
    fdot = f*(g - e); gdot = g*(k - f); kdot = k*(i - g); idot = i*(a - k);
}

#[test]
fn many_variables_are_promised_at_every_size() {
    let rational = |x: f64| Q::from_float(x).unwrap();
    let exact = Ring { h: rational(0.75) };
    for power in [-1000, -280, 0, 280, 700, 1000] {
        let unit = power_of_two(power);
        let x: SVector<f64, 9> = SVector::from_fn(|i, _| unit * (1.0 + 0.375 * (i * i % 5) as f64));
        let eps = power_of_two(-4) / unit;
        let next = Ring { h: 0.75 }.try_step(&x, eps).unwrap_or_else(|why| panic!("{why} at 2^{power}"));
        let (x, next, eps) = (x.map(rational), next.map(rational), rational(eps));
        let (matrix, right) = (exact.matrix(&x, eps.clone()), exact.rhs(&x, eps));
        for i in 0..9 {
            let products = (0..9).map(|j| &matrix[(i, j)] * &next[j]);
            let (mut rest, mut size) = (-right[i].clone(), right[i].abs());
            for product in products {
                size += product.abs();
                rest += product;
            }
            assert!(rest.abs() <= Q::from_integer(11.into()) * two_to(-53) * size, "row {i} at 2^{power}");
        }
    }
}

#[track_caller]
fn assert_answered<const N: usize>(
    next: Result<SVector<f64, N>, crate::SingularStep>,
    exact: &SVector<Q, N>,
    h: f64,
    eps: f64,
) {
    let next = next.unwrap_or_else(|why| panic!("{why} at h = {h}"));
    let errors = next.iter().zip(exact).map(|(x, y)| (Q::from_float(*x).unwrap() - y).abs());
    let (error, size) = (errors.max().unwrap(), exact.iter().map(Signed::abs).max().unwrap());
    assert!(error <= two_to(6 - 53) * size, "at h = {h}, eps = {eps:e}");
}

crate::kahan! {
    /// The field is undefined where a = b.
    struct Divided { a, b }
    xdot = x^2/(a - b) - x;
}

/// Tests every reason for failure except too few digits, which occurs too rarely.
#[test]
fn reports_say_what_is_the_case() {
    use crate::SingularStep;
    use crate::step::error::Reason;
    use std::string::ToString;
    let said = |step: Result<SVector<f64, 1>, SingularStep>| step.expect_err("no step").to_string();
    let riccati = |k: f64, x: f64, eps: f64| said(Riccati { k }.try_step(&vector![x], eps));
    let pole = "det A = 0: the Kahan map has a pole at this point";
    assert_eq!(riccati(0.0, 1.0, 0.5), std::format!("{pole} (eps = 0.5, half the time step)"));
    for text in [riccati(f64::NAN, 1.0, 0.5), riccati(0.0, f64::INFINITY, 0.5)] {
        assert!(text.starts_with("the point, eps or a parameter is not a finite number"), "{text}");
    }
    let beyond = [riccati(-1e300, 0.0, 1e100), said(Decay.try_step(&vector![f64::from_bits(2)], 0.125))];
    for text in beyond {
        assert!(text.contains("beyond the range of the scalar") && !text.contains("pole"), "{text}");
    }
    let text = said(Divided { a: 1.0, b: 1.0 }.try_step(&vector![0.5], 0.125));
    assert!(text.contains("divides by zero at these parameters") && !text.contains("pole"), "{text}");

    let digits = |bound: f64| SingularStep::because(Reason::Digits(17), 0.25, bound, 0.5).to_string();
    let text = digits(0.5);
    assert!(text.contains("17 digits of 64 bits settle the step") && text.contains("5e-1"), "{text}");
    assert!(!text.contains("pole"), "{text}");
    assert!(digits(f64::INFINITY).contains("17 digits of 64 bits do not tell whether this point is a pole"));
}

#[test]
fn no_float_is_too_near_to_a_pole() {
    for k in 0..60 {
        let x = 0.3 + f64::from(k) / 64.0;
        let near = 0.5 / x;
        for eps in [near, f64::from_bits(near.to_bits() - 1), f64::from_bits(near.to_bits() + 1)] {
            match (Riccati { k: 0.0 }).try_step(&vector![x], eps) {
                Ok(next) => assert!(next[0].abs() > 1e14),
                Err(why) => assert_eq!(why.determinant(), 0.0),
            }
        }
    }
}
