//! Degrees.

use kahan_core::prelude::*;

// The sum cancels the squares, not the cubes.
kahan! {
    pub struct AfterExpansion;
    xdot = (x + y)*(x - y)*y - x^2 + y^2;
    ydot = x;
}

// Parameters do not count, states do.
kahan! {
    pub struct BehindAParameter { mu }
    xdot = y;
    ydot = mu*(1 - x^2)*y - x;
}

// A cubic term.
kahan! {
    pub struct Cube;
    xdot = x^3 - x;
}

// Quadratic, squared.
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
