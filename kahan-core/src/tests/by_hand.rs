//! Test systems. One has a handwritten map; for most of the others the macro makes a closed form.

use nalgebra::{SMatrix, SVector};

use crate::{Elimination, KahanMap, QuadraticField, Scalar};

crate::kahan! {
    /// A system whose det A has the factor 1 + εz, which cancels in the map.
    pub(super) struct E3;
    xdot = -x*z;
    ydot = -y*z;
    zdot = x^2 + y^2;
}

crate::kahan! {
    /// A system that uses the same formulas for single orbits and for SIMD lanes.
    pub(super) struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}

crate::kahan! {
    /// A system whose closed form serves every ξ. At ξ = 1 a common factor remains.
    pub(super) struct E7 { xi }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
}

crate::kahan! {
    /// E7 at ξ = 1. Here det A has the factor 1 + εx, which cancels in the map.
    pub(super) struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
}

crate::kahan! {
    struct CoupledField;
    xdot = y*z - w + 1;
    ydot = x*w - 2*y;
    zdot = x^2 - y^2 + z;
    wdot = y*z + x;
}

/// A field with quadratic, linear and constant terms, whose steps use elimination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coupled;

/// Implements the field of one type for another type, which has a handwritten map.
macro_rules! field_of {
    ($field:expr, for $name:ident in $n:literal) => {
        impl<T: Scalar> QuadraticField<T, $n> for $name {
            fn field(&self, x: &SVector<T, $n>) -> SVector<T, $n> {
                $field.field(x)
            }

            fn field_jacobian(&self, x: &SVector<T, $n>) -> SMatrix<T, $n, $n> {
                $field.field_jacobian(x)
            }

            fn bilinear(&self, x: &SVector<T, $n>, y: &SVector<T, $n>) -> SVector<T, $n> {
                $field.bilinear(x, y)
            }

            fn polarized(&self, x: &SVector<T, $n>, y: &SVector<T, $n>) -> SVector<T, $n> {
                $field.polarized(x, y)
            }
        }
    };
}

pub(super) use field_of;

field_of!(CoupledField, for Coupled in 4);

impl<T: Scalar> KahanMap<T, 4> for Coupled {
    type Prepared = Elimination<Self, T>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        Elimination::new(*self, eps.clone())
    }
}
