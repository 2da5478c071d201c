//! Tests the rules of differentiation of dual numbers, without rounding.

use num_traits::{One, Zero};

use crate::scalar::{DirectionalDual, Dual};
use crate::{Constant, Scalar};

fn coordinates() -> [Dual<f64, 2>; 2] {
    [Dual::coordinate(3.0, 0), Dual::coordinate(4.0, 1)]
}

#[test]
fn the_operators_differentiate() {
    let [u, v] = coordinates();
    assert_eq!(u + v, Dual { value: 7.0, gradient: [1.0, 1.0] });
    assert_eq!(u - v, Dual { value: -1.0, gradient: [1.0, -1.0] });
    assert_eq!(-u, Dual { value: -3.0, gradient: [-1.0, 0.0] });
    assert_eq!(u * v, Dual { value: 12.0, gradient: [4.0, 3.0] });
    assert_eq!(u / v, Dual { value: 0.75, gradient: [0.25, -0.1875] });
    assert_eq!(v.reciprocal(), Some(Dual { value: 0.25, gradient: [0.0, -0.0625] }));
    assert_eq!(u.quotient(v), Some(u / v));
}

#[test]
fn assigning_operators_agree_with_the_others() {
    let [u, v] = coordinates();
    let mut w = u;
    w += v;
    assert_eq!(w, u + v);
    w -= u;
    assert_eq!(w, v);
    w *= u;
    assert_eq!(w, v * u);
    w /= v;
    assert_eq!(w, v * u / v);
}

#[test]
fn constants_have_no_gradient() {
    assert_eq!(Dual::<f64, 2>::zero(), Dual::from_value(0.0));
    assert_eq!(Dual::<f64, 2>::one(), Dual::from_value(1.0));
    assert_eq!(Dual::<f64, 2>::constant(&Constant::ratio(1, 4)), Dual::from_value(0.25));
    assert!(!Dual::<f64, 2>::coordinate(0.0, 1).is_zero());
}

fn along() -> [DirectionalDual<f64>; 3] {
    [(3.0, Some(1.0)), (4.0, Some(2.0)), (4.0, None)].map(|(value, slope)| DirectionalDual { value, slope })
}

#[test]
fn the_operators_differentiate_along_a_line() {
    let [u, v, _] = along();
    assert_eq!(u + v, DirectionalDual { value: 7.0, slope: Some(3.0) });
    assert_eq!(u - v, DirectionalDual { value: -1.0, slope: Some(-1.0) });
    assert_eq!(-u, DirectionalDual { value: -3.0, slope: Some(-1.0) });
    assert_eq!(u * v, DirectionalDual { value: 12.0, slope: Some(10.0) });
    assert_eq!(u / v, DirectionalDual { value: 0.75, slope: Some(-0.125) });
    assert_eq!(v.reciprocal(), Some(DirectionalDual { value: 0.25, slope: Some(-0.125) }));
    assert_eq!(u.quotient(v), Some(u / v));
}

#[test]
fn a_constant_counts_as_a_number_of_slope_0() {
    let [u, v, constant] = along();
    let flat = DirectionalDual { value: constant.value, slope: Some(0.0) };
    for (left, right, expected) in [
        (u, constant, (u + flat, u - flat, u * flat, u / flat)),
        (constant, v, (flat + v, flat - v, flat * v, flat / v)),
    ] {
        assert_eq!((left + right, left - right, left * right, left / right), expected);
        assert_eq!(left.quotient(right), Some(left / right));
    }
    assert_eq!(constant * constant, DirectionalDual::from_value(16.0));
    assert_eq!((constant.into_slope(), v.into_slope()), (0.0, 2.0));
}

#[test]
fn prepared_constants_have_no_slope() {
    let [u, ..] = along();
    assert_eq!(u.prepared(), DirectionalDual::from_value(3.0));
}
