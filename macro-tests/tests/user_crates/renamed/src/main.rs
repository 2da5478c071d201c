//! kahan-core under another name, in a crate where nothing of the prelude is in scope.

#![no_implicit_prelude]
#![deny(missing_docs, unused, warnings)]
#![deny(clippy::pedantic)]

use ::k::prelude::*;

kahan! {
    /// E6.
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
}

kahan! {
    /// E7.
    pub struct E7 {
        /// The exponent.
        xi
    }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
    density rho = 1/(x*y*(1 - eps^2*x^2));
}

fn ratio(p: i64, q: i64) -> BigRational {
    BigRational::new(::core::convert::From::from(p), ::core::convert::From::from(q))
}

fn main() {
    let x = vector![ratio(1, 2), ratio(1, 3), ratio(1, 5)];
    let next = E6.step(&x, ratio(1, 7));
    ::std::assert_eq!(E6.integrals(&next, ratio(1, 7)), E6.integrals(&x, ratio(1, 7)));
    let e7 = E7 { xi: ratio(3, 2) };
    let next = e7.step(&x, ratio(1, 7));
    ::std::assert_eq!(
        e7.density(&next, ratio(1, 7)) * e7.det_jacobian(&x, ratio(1, 7)),
        e7.density(&x, ratio(1, 7))
    );
}
