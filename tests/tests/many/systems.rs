//! Fields of more than eight variables. They differ in which variables occur in which equations.

use kahan_core::prelude::*;

macro_rules! block {
    ($text:ident: $($block:tt)*) => {
        kahan! { $($block)* }
        pub(super) const $text: &str = stringify!($($block)*);
    };
}

block! { RING:
    /// Volterra's chain, which is closed to a ring.
    pub(super) struct Ring;
    x0dot = x0*(x1 - x11);
    x1dot = x1*(x2 - x0);
    x2dot = x2*(x3 - x1);
    x3dot = x3*(x4 - x2);
    x4dot = x4*(x5 - x3);
    x5dot = x5*(x6 - x4);
    x6dot = x6*(x7 - x5);
    x7dot = x7*(x8 - x6);
    x8dot = x8*(x9 - x7);
    x9dot = x9*(x10 - x8);
    x10dot = x10*(x11 - x9);
    x11dot = x11*(x0 - x10);
}

block! { ARROW:
    /// A field in which one variable is coupled to all others in both directions.
    pub(super) struct Arrow { a }
    hubdot = 1 - x0*hub - x1*hub - x2*hub - x3*hub - x4*hub - x5*hub - x6*hub - x7*hub - x8*hub - x9*hub;
    x0dot = a*hub*x0 - x0^2;
    x1dot = a*hub*x1 - x1^2;
    x2dot = a*hub*x2 - x2^2;
    x3dot = a*hub*x3 - x3^2;
    x4dot = a*hub*x4 - x4^2;
    x5dot = a*hub*x5 - x5^2;
    x6dot = a*hub*x6 - x6^2;
    x7dot = a*hub*x7 - x7^2;
    x8dot = a*hub*x8 - x8^2;
    x9dot = a*hub*x9 - x9^2;
}

block! { CASCADE:
    /// Three triples of coupled variables, and x6; none of these groups depends on later ones.
    pub(super) struct Cascade;
    x0dot = x1*x2;
    x1dot = -x0*x2;
    x2dot = x0*x1;
    x3dot = x0*x4 - x3;
    x4dot = x3*x5 + x1;
    x5dot = -x4*x5 + 2*x2;
    x6dot = x3*x6;
    x7dot = x8^2 - x6*x7;
    x8dot = x9*x7 - x0;
    x9dot = x7*x8 + x5*x9 + 1/3;
}

block! { WEB:
    /// A field of species that all act on each other.
    pub(super) struct Web;
    x0dot = x0*(1 - 1/7*x0 - 4/7*x1 - 7/7*x2 - 3/7*x3 - 6/7*x4 - 2/7*x5 - 5/7*x6 - 1/7*x7 -
        4/7*x8 - 7/7*x9 - 3/7*x10 - 6/7*x11 - 2/7*x12 - 5/7*x13 - 1/7*x14 - 4/7*x15 - 7/7*x16 -
        3/7*x17);
    x1dot = x1*(2 - 6/7*x0 - 2/7*x1 - 5/7*x2 - 1/7*x3 - 4/7*x4 - 7/7*x5 - 3/7*x6 - 6/7*x7 -
        2/7*x8 - 5/7*x9 - 1/7*x10 - 4/7*x11 - 7/7*x12 - 3/7*x13 - 6/7*x14 - 2/7*x15 - 5/7*x16 -
        1/7*x17);
    x2dot = x2*(3 - 4/7*x0 - 7/7*x1 - 3/7*x2 - 6/7*x3 - 2/7*x4 - 5/7*x5 - 1/7*x6 - 4/7*x7 -
        7/7*x8 - 3/7*x9 - 6/7*x10 - 2/7*x11 - 5/7*x12 - 1/7*x13 - 4/7*x14 - 7/7*x15 - 3/7*x16 -
        6/7*x17);
    x3dot = x3*(1 - 2/7*x0 - 5/7*x1 - 1/7*x2 - 4/7*x3 - 7/7*x4 - 3/7*x5 - 6/7*x6 - 2/7*x7 -
        5/7*x8 - 1/7*x9 - 4/7*x10 - 7/7*x11 - 3/7*x12 - 6/7*x13 - 2/7*x14 - 5/7*x15 - 1/7*x16 -
        4/7*x17);
    x4dot = x4*(2 - 7/7*x0 - 3/7*x1 - 6/7*x2 - 2/7*x3 - 5/7*x4 - 1/7*x5 - 4/7*x6 - 7/7*x7 -
        3/7*x8 - 6/7*x9 - 2/7*x10 - 5/7*x11 - 1/7*x12 - 4/7*x13 - 7/7*x14 - 3/7*x15 - 6/7*x16 -
        2/7*x17);
    x5dot = x5*(3 - 5/7*x0 - 1/7*x1 - 4/7*x2 - 7/7*x3 - 3/7*x4 - 6/7*x5 - 2/7*x6 - 5/7*x7 -
        1/7*x8 - 4/7*x9 - 7/7*x10 - 3/7*x11 - 6/7*x12 - 2/7*x13 - 5/7*x14 - 1/7*x15 - 4/7*x16 -
        7/7*x17);
    x6dot = x6*(1 - 3/7*x0 - 6/7*x1 - 2/7*x2 - 5/7*x3 - 1/7*x4 - 4/7*x5 - 7/7*x6 - 3/7*x7 -
        6/7*x8 - 2/7*x9 - 5/7*x10 - 1/7*x11 - 4/7*x12 - 7/7*x13 - 3/7*x14 - 6/7*x15 - 2/7*x16 -
        5/7*x17);
    x7dot = x7*(2 - 1/7*x0 - 4/7*x1 - 7/7*x2 - 3/7*x3 - 6/7*x4 - 2/7*x5 - 5/7*x6 - 1/7*x7 -
        4/7*x8 - 7/7*x9 - 3/7*x10 - 6/7*x11 - 2/7*x12 - 5/7*x13 - 1/7*x14 - 4/7*x15 - 7/7*x16 -
        3/7*x17);
    x8dot = x8*(3 - 6/7*x0 - 2/7*x1 - 5/7*x2 - 1/7*x3 - 4/7*x4 - 7/7*x5 - 3/7*x6 - 6/7*x7 -
        2/7*x8 - 5/7*x9 - 1/7*x10 - 4/7*x11 - 7/7*x12 - 3/7*x13 - 6/7*x14 - 2/7*x15 - 5/7*x16 -
        1/7*x17);
    x9dot = x9*(1 - 4/7*x0 - 7/7*x1 - 3/7*x2 - 6/7*x3 - 2/7*x4 - 5/7*x5 - 1/7*x6 - 4/7*x7 -
        7/7*x8 - 3/7*x9 - 6/7*x10 - 2/7*x11 - 5/7*x12 - 1/7*x13 - 4/7*x14 - 7/7*x15 - 3/7*x16 -
        6/7*x17);
    x10dot = x10*(2 - 2/7*x0 - 5/7*x1 - 1/7*x2 - 4/7*x3 - 7/7*x4 - 3/7*x5 - 6/7*x6 - 2/7*x7
        - 5/7*x8 - 1/7*x9 - 4/7*x10 - 7/7*x11 - 3/7*x12 - 6/7*x13 - 2/7*x14 - 5/7*x15 - 1/7*x16
        - 4/7*x17);
    x11dot = x11*(3 - 7/7*x0 - 3/7*x1 - 6/7*x2 - 2/7*x3 - 5/7*x4 - 1/7*x5 - 4/7*x6 - 7/7*x7
        - 3/7*x8 - 6/7*x9 - 2/7*x10 - 5/7*x11 - 1/7*x12 - 4/7*x13 - 7/7*x14 - 3/7*x15 - 6/7*x16
        - 2/7*x17);
    x12dot = x12*(1 - 5/7*x0 - 1/7*x1 - 4/7*x2 - 7/7*x3 - 3/7*x4 - 6/7*x5 - 2/7*x6 - 5/7*x7
        - 1/7*x8 - 4/7*x9 - 7/7*x10 - 3/7*x11 - 6/7*x12 - 2/7*x13 - 5/7*x14 - 1/7*x15 - 4/7*x16
        - 7/7*x17);
    x13dot = x13*(2 - 3/7*x0 - 6/7*x1 - 2/7*x2 - 5/7*x3 - 1/7*x4 - 4/7*x5 - 7/7*x6 - 3/7*x7
        - 6/7*x8 - 2/7*x9 - 5/7*x10 - 1/7*x11 - 4/7*x12 - 7/7*x13 - 3/7*x14 - 6/7*x15 - 2/7*x16
        - 5/7*x17);
    x14dot = x14*(3 - 1/7*x0 - 4/7*x1 - 7/7*x2 - 3/7*x3 - 6/7*x4 - 2/7*x5 - 5/7*x6 - 1/7*x7
        - 4/7*x8 - 7/7*x9 - 3/7*x10 - 6/7*x11 - 2/7*x12 - 5/7*x13 - 1/7*x14 - 4/7*x15 - 7/7*x16
        - 3/7*x17);
    x15dot = x15*(1 - 6/7*x0 - 2/7*x1 - 5/7*x2 - 1/7*x3 - 4/7*x4 - 7/7*x5 - 3/7*x6 - 6/7*x7
        - 2/7*x8 - 5/7*x9 - 1/7*x10 - 4/7*x11 - 7/7*x12 - 3/7*x13 - 6/7*x14 - 2/7*x15 - 5/7*x16
        - 1/7*x17);
    x16dot = x16*(2 - 4/7*x0 - 7/7*x1 - 3/7*x2 - 6/7*x3 - 2/7*x4 - 5/7*x5 - 1/7*x6 - 4/7*x7
        - 7/7*x8 - 3/7*x9 - 6/7*x10 - 2/7*x11 - 5/7*x12 - 1/7*x13 - 4/7*x14 - 7/7*x15 - 3/7*x16
        - 6/7*x17);
    x17dot = x17*(3 - 2/7*x0 - 5/7*x1 - 1/7*x2 - 4/7*x3 - 7/7*x4 - 3/7*x5 - 6/7*x6 - 2/7*x7
        - 5/7*x8 - 1/7*x9 - 4/7*x10 - 7/7*x11 - 3/7*x12 - 6/7*x13 - 2/7*x14 - 5/7*x15 - 1/7*x16
        - 4/7*x17);
}
