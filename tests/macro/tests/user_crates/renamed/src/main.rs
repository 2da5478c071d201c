//! A crate without a prelude that uses kahan-core under another name.

#![no_implicit_prelude]
#![deny(missing_docs, unused, warnings)]
#![deny(clippy::pedantic)]

use ::k::prelude::*;

kahan! {
    /// A rotation.
    pub struct Rotation;
    xdot = -y;
    ydot = x;
    integral H = x^2 + y^2;
}

kahan! {
    /// A Riccati equation.
    pub struct Riccati {
        /// The square of its fixed points.
        a
    }
    xdot = a - x^2;
    density rho = 1/(a - x^2);
}

fn ratio(p: i64, q: i64) -> BigRational {
    BigRational::new(::core::convert::From::from(p), ::core::convert::From::from(q))
}

fn main() {
    let x = vector![ratio(1, 2), ratio(1, 3)];
    let next = Rotation.step(&x, ratio(1, 7));
    ::std::assert_eq!(Rotation.integrals(&next, ratio(1, 7)), Rotation.integrals(&x, ratio(1, 7)));
    let riccati = Riccati { a: ratio(3, 2) };
    let x = vector![ratio(1, 2)];
    let next = riccati.step(&x, ratio(1, 7));
    ::std::assert_eq!(
        riccati.density(&next, ratio(1, 7)) * riccati.det_jacobian(&x, ratio(1, 7)),
        riccati.density(&x, ratio(1, 7))
    );
}
