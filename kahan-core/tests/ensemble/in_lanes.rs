//! More maps for ensembles, with one to six variables.

use kahan_core::prelude::*;
use kahan_core::{Elimination, QuadraticField};

use crate::systems::LotkaVolterra;

kahan! {
    pub(crate) struct Logistic { rate }
    xdot = rate*x*(1 - x);
}

kahan! {
    pub(crate) struct E3;
    xdot = -x*z;
    ydot = -y*z;
    zdot = x^2 + y^2;
}

kahan! {
    /// A field whose step divides twice in succession for one orbit, but once in SIMD lanes.
    pub(crate) struct E5;
    xdot = x*y;
    ydot = -x^2;
    zdot = y*(2*x - z);
}

kahan! {
    /// The Clebsch case of a body in a fluid.
    pub(crate) struct Clebsch { w1, w2, w3 }
    m1dot = (w3 - w2)*p2*p3;
    m2dot = (w1 - w3)*p3*p1;
    m3dot = (w2 - w1)*p1*p2;
    p1dot = m3*p2 - m2*p3;
    p2dot = m1*p3 - m3*p1;
    p3dot = m2*p1 - m1*p2;
}

/// A Lotka–Volterra field written by hand, whose map has no closed form.
#[derive(Clone, Copy)]
pub(crate) struct ByElimination;

impl<T: Scalar> QuadraticField<T, 2> for ByElimination {
    fn field(&self, x: &SVector<T, 2>) -> SVector<T, 2> {
        LotkaVolterra.field(x)
    }

    fn field_jacobian(&self, x: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        LotkaVolterra.field_jacobian(x)
    }

    fn bilinear(&self, x: &SVector<T, 2>, y: &SVector<T, 2>) -> SVector<T, 2> {
        LotkaVolterra.bilinear(x, y)
    }

    fn polarized(&self, x: &SVector<T, 2>, y: &SVector<T, 2>) -> SVector<T, 2> {
        LotkaVolterra.polarized(x, y)
    }
}

impl<T: Scalar> KahanMap<T, 2> for ByElimination {
    type Prepared = Elimination<Self, T>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        Elimination::new(*self, eps.clone())
    }
}
