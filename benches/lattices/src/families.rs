//! The families of lattices that are timed.

use kahan_core::prelude::*;

kahan! {
    pub(crate) struct Volterra;
    for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
}

kahan! {
    /// The equation u_t = −6 u u_x − u_xxx, discretised by central differences of width h.
    pub(crate) struct Kdv { h }
    for i in periodic {
        u[i]dot = -3*(u[i+1]^2 - u[i-1]^2)/(2*h) - (u[i+2] - 2*u[i+1] + 2*u[i-1] - u[i-2])/(2*h^3);
    }
}

kahan! {
    pub(crate) struct Toda;
    for i in periodic {
        a[i]dot = a[i]*(b[i+1] - b[i]);
        b[i]dot = 2*(a[i]^2 - a[i-1]^2);
    }
}
