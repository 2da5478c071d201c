//! Fields whose degree is too high.

use kahan_core::prelude::*;

// The squares cancel, but the cubes remain.
kahan! {
    pub struct AfterExpansion;
    xdot = (x + y)*(x - y)*y - x^2 + y^2;
    ydot = x;
}

// The degree in the states is 3. The parameter `mu` does not count.
kahan! {
    pub struct BehindAParameter { mu }
    xdot = y;
    ydot = mu*(1 - x^2)*y - x;
}

// The field contains a cubic term.
kahan! {
    pub struct Cube;
    xdot = x^3 - x;
}

// The field contains the square of a quadratic term.
kahan! {
    pub struct PowerOfASum;
    xdot = 1 + (x^2 + y)^2;
    ydot = x;
}

// The third factor raises the degree.
kahan! {
    pub struct ProductOfThree;
    xdot = y*z;
    ydot = -x*y*z;
    zdot = x;
}

fn main() {}
