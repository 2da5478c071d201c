//! A library without the standard library.

#![no_std]
#![deny(missing_docs, unused, warnings)]
#![deny(clippy::pedantic)]

use kahan_core::prelude::*;

kahan! {
    /// Predator and prey.
    pub struct LotkaVolterra { a, b }
    xdot = a*x*(1 - y);
    ydot = b*y*(x - 1);
    density rho = 1/(x*y);
}

/// Makes one step of `LotkaVolterra` in single precision.
#[must_use]
pub fn step(x: &SVector<f32, 2>, eps: f32) -> SVector<f32, 2> {
    LotkaVolterra { a: 1.0, b: 0.5 }.step(x, eps)
}
