//! Blocks in a user's macro, with macro fragments (`ident`, `expr`, `literal`, `tt`) in formulas.

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

macro_rules! system {
    ($name:ident, $parameter:ident, $factor:expr, $number:literal, $rest:tt) => {
        kahan! {
            /// A system written by a macro.
            pub(crate) struct $name { $parameter }
            xdot = $factor*y - $number*$parameter*x;
            ydot = $rest^2 - $factor^2;
        }
    };
}

system!(FromPieces, mu, x + 1, 0.1, (x - y));

/// A system equal to the one that the macro writes, written by hand.
mod in_one_piece {
    use super::kahan;

    kahan! {
        /// The system that the macro writes, written by hand.
        pub(super) struct FromPieces { mu }
        xdot = (x + 1)*y - 0.1*mu*x;
        ydot = (x - y)^2 - (x + 1)^2;
    }
}

/// Defines a map with the rate `$rate`, and makes a step from `$x`.
macro_rules! decay {
    ($rate:ident, $x:expr) => {{
        let x = $x;
        kahan! { xdot = -$rate*x; }.step(&x, 0.25)
    }};
}

macro_rules! pass_on {
    ($($tokens:tt)*) => { kahan! { $($tokens)* } };
}

pass_on! {
    /// A system in a block that a macro passes on.
    pub(super) struct PassedOn;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2;
}

#[test]
fn fragments_bind_as_one_operand() {
    let (pieces, piece) = (FromPieces { mu: ratio(3, 2) }, in_one_piece::FromPieces { mu: ratio(3, 2) });
    assert_eq!(assert_kahan(&pieces), assert_kahan(&piece));
}

#[test]
fn a_macro_may_pass_a_block_on() {
    assert_kahan(&PassedOn);
    assert_eq!(PassedOn::INTEGRALS, ["H"]);
}

#[test]
fn names_from_the_caller_of_a_macro_are_captured() {
    let mu = 2.0_f64;
    assert!((decay!(mu, vector![3.0])[0] - 1.0).abs() < 1e-15);
}
