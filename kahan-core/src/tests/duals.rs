//! Dual numbers: the rules of differentiation, on numbers that floats hold exactly.

use num_traits::{One, Zero};

use crate::scalar::Dual;
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
    assert_eq!(Dual::<f64, 2>::zero(), Dual::lift(0.0));
    assert_eq!(Dual::<f64, 2>::one(), Dual::lift(1.0));
    assert_eq!(Dual::<f64, 2>::constant(&Constant::ratio(1, 4)), Dual::lift(0.25));
    assert!(!Dual::<f64, 2>::coordinate(0.0, 1).is_zero());
}
