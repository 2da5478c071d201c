//! Systems written as the macro writes them: two reduced closed forms, one with a parameter, and one elimination.

use crate::{Quotients, Scalar};

/// E3: ẋ = −xz, ẏ = −yz, ż = x² + y²; its map loses the factor 1 + εz of det A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct E3;

/// E7: ẋ = −x², ẏ = −ξxy, ż = 2ξy² + xz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct E7<T> {
    pub(super) xi: T,
}

/// E1: E7 at ξ = 1; its map loses the factor 1 + εx of det A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct E1;

/// ẋ = yz − w + 1, ẏ = xw − 2y, ż = x² − y² + z, ẇ = yz + x: a quadratic, a linear and a constant part, stepped by
/// elimination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coupled;

fn two<T: Scalar>() -> T {
    T::one() + T::one()
}

fn half<T: Scalar>() -> T {
    T::constant(&crate::Constant::ratio(1, 2))
}

/// The increments 2ε·vᵢ/det.
fn over<T: Scalar>(velocity: [T; 3], two_eps: &T, det: &T) -> Option<Quotients<T, 3>> {
    let reciprocal = Some(det.reciprocal()?);
    let numerators = velocity.map(|entry| two_eps.clone() * entry);
    Some(Quotients { numerators, reciprocals: [reciprocal.clone(), reciprocal.clone(), reciprocal] })
}

const _: () = {
    use crate::__private as __kahan;

    #[derive(Clone, Copy)]
    pub(super) struct Step<T> {
        eps: T,
        two_eps: T,
    }

    impl<T: __kahan::Scalar> __kahan::WideStep<T, 3> for Step<T> {
        const HAS_LANES: bool = true;

        type Wide<L: __kahan::Scalar> = Step<L>;

        fn widen<L: __kahan::Scalar>(&self, spread: impl Fn(&T) -> L) -> Step<L> {
            Step { eps: spread(&self.eps), two_eps: spread(&self.two_eps) }
        }
    }

    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 3> for Step<T> {
        #[inline(always)]
        fn quotients(&self, state: &__kahan::SVector<T, 3>) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            let [x, y, z] = __kahan::components(state);
            let radius = x.clone() * x.clone() + y.clone() * y.clone();
            let ez = self.eps.clone() * z.clone();
            let er = self.eps.clone() * radius.clone();
            let common = -(z.clone() + er.clone());
            let det = T::one() + ez.clone() + self.two_eps.clone() * er;
            let velocity =
                [x.clone() * common.clone(), y.clone() * common.clone(), radius.clone() * (T::one() - ez)];
            over(velocity, &self.two_eps, &det)
        }
    }

    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 3> for E3 {
        fn field(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SVector<T, 3> {
            self.bilinear(state, state)
        }

        fn field_jacobian(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SMatrix<T, 3, 3> {
            let [x, y, z] = __kahan::components(state);
            __kahan::matrix([
                [-z.clone(), T::zero(), -x.clone()],
                [T::zero(), -z.clone(), -y.clone()],
                [two::<T>() * x.clone(), two::<T>() * y.clone(), T::zero()],
            ])
        }

        fn bilinear(
            &self,
            first: &__kahan::SVector<T, 3>,
            second: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            let [x, y, z] = __kahan::components(first);
            let [u, v, w] = __kahan::components(second);
            __kahan::vector([
                -half::<T>() * (x.clone() * w.clone() + u.clone() * z.clone()),
                -half::<T>() * (y.clone() * w.clone() + v.clone() * z.clone()),
                x.clone() * u.clone() + y.clone() * v.clone(),
            ])
        }

        fn polarized(
            &self,
            first: &__kahan::SVector<T, 3>,
            second: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            self.bilinear(first, second)
        }
    }

    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 3> for E3 {
        type Prepared = Step<T>;

        fn prepare(&self, half_step: &T) -> Step<T> {
            let eps = __kahan::Clone::clone(half_step);
            Step { two_eps: two::<T>() * eps.clone(), eps }
        }

        fn jacobian(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> __kahan::SMatrix<T, 3, 3> {
            __kahan::jacobian_by_duals(self, state, &half_step)
        }
    }

    impl<T: __kahan::Scalar> __kahan::Lift<T, 3> for E3 {
        type Lifted<U: __kahan::Scalar> = E3;

        fn lift<U: __kahan::Scalar>(&self, _lift: impl Fn(&T) -> U) -> E3 {
            E3
        }
    }
};

const _: () = {
    use crate::__private as __kahan;

    #[derive(Clone, Copy)]
    pub(super) struct Step<T> {
        eps: T,
        two_eps: T,
        xi: T,
    }

    impl<T: __kahan::Scalar> __kahan::WideStep<T, 3> for Step<T> {
        const HAS_LANES: bool = true;

        type Wide<L: __kahan::Scalar> = Step<L>;

        fn widen<L: __kahan::Scalar>(&self, spread: impl Fn(&T) -> L) -> Step<L> {
            Step { eps: spread(&self.eps), two_eps: spread(&self.two_eps), xi: spread(&self.xi) }
        }
    }

    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 3> for Step<T> {
        #[inline(always)]
        fn quotients(&self, state: &__kahan::SVector<T, 3>) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            let [x, y, z] = __kahan::components(state);
            let ex = self.eps.clone() * x.clone();
            let xi_ex = self.xi.clone() * ex.clone();
            let (plus, minus) = (T::one() + ex.clone(), T::one() - ex.clone());
            let (double, other) = (plus.clone() + ex.clone(), T::one() + xi_ex.clone());
            let xi_y = self.xi.clone() * y.clone();
            let velocity = [
                -(x.clone() * x.clone()) * other.clone() * minus.clone(),
                -(x.clone() * xi_y.clone()) * plus.clone() * minus.clone(),
                two::<T>() * xi_y * y.clone() * (double.clone() - xi_ex)
                    + other.clone() * x.clone() * z.clone() * plus,
            ];
            over(velocity, &self.two_eps, &(double * other * minus))
        }
    }

    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 3> for E7<T> {
        fn field(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SVector<T, 3> {
            self.bilinear(state, state)
        }

        fn field_jacobian(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SMatrix<T, 3, 3> {
            let [x, y, z] = __kahan::components(state);
            let four_xi = two::<T>() * two::<T>() * self.xi.clone();
            __kahan::matrix([
                [-two::<T>() * x.clone(), T::zero(), T::zero()],
                [-self.xi.clone() * y.clone(), -self.xi.clone() * x.clone(), T::zero()],
                [z.clone(), four_xi * y.clone(), x.clone()],
            ])
        }

        fn bilinear(
            &self,
            first: &__kahan::SVector<T, 3>,
            second: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            let [x, y, z] = __kahan::components(first);
            let [u, v, w] = __kahan::components(second);
            __kahan::vector([
                -(x.clone() * u.clone()),
                -half::<T>() * self.xi.clone() * (x.clone() * v.clone() + u.clone() * y.clone()),
                two::<T>() * self.xi.clone() * y.clone() * v.clone()
                    + half::<T>() * (x.clone() * w.clone() + u.clone() * z.clone()),
            ])
        }

        fn polarized(
            &self,
            first: &__kahan::SVector<T, 3>,
            second: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            self.bilinear(first, second)
        }
    }

    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 3> for E7<T> {
        type Prepared = Step<T>;

        fn prepare(&self, half_step: &T) -> Step<T> {
            let eps = __kahan::Clone::clone(half_step);
            Step { two_eps: two::<T>() * eps.clone(), eps, xi: __kahan::Clone::clone(&self.xi) }
        }

        fn jacobian(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> __kahan::SMatrix<T, 3, 3> {
            __kahan::jacobian_by_duals(self, state, &half_step)
        }
    }

    impl<T: __kahan::Scalar> __kahan::Lift<T, 3> for E7<T> {
        type Lifted<U: __kahan::Scalar> = E7<U>;

        fn lift<U: __kahan::Scalar>(&self, lift: impl Fn(&T) -> U) -> E7<U> {
            E7 { xi: lift(&self.xi) }
        }
    }
};

const _: () = {
    use crate::__private as __kahan;

    /// E1 in the terms of E7, whose field it shares; its reduced map is its own.
    fn general<T: __kahan::Scalar>() -> E7<T> {
        E7 { xi: T::one() }
    }

    #[derive(Clone, Copy)]
    pub(super) struct Step<T> {
        eps: T,
        two_eps: T,
    }

    impl<T: __kahan::Scalar> __kahan::WideStep<T, 3> for Step<T> {
        const HAS_LANES: bool = true;

        type Wide<L: __kahan::Scalar> = Step<L>;

        fn widen<L: __kahan::Scalar>(&self, spread: impl Fn(&T) -> L) -> Step<L> {
            Step { eps: spread(&self.eps), two_eps: spread(&self.two_eps) }
        }
    }

    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 3> for Step<T> {
        #[inline(always)]
        fn quotients(&self, state: &__kahan::SVector<T, 3>) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            let [x, y, z] = __kahan::components(state);
            let ex = self.eps.clone() * x.clone();
            let (plus, minus) = (T::one() + ex.clone(), T::one() - ex.clone());
            let velocity = [
                -(x.clone() * x.clone()) * minus.clone(),
                -(x.clone() * y.clone()) * minus.clone(),
                two::<T>() * y.clone() * y.clone() + x.clone() * z.clone() * plus.clone(),
            ];
            over(velocity, &self.two_eps, &((plus + ex) * minus))
        }
    }

    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 3> for E1 {
        fn field(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SVector<T, 3> {
            general().field(state)
        }

        fn field_jacobian(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SMatrix<T, 3, 3> {
            general().field_jacobian(state)
        }

        fn bilinear(
            &self,
            first: &__kahan::SVector<T, 3>,
            second: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            general().bilinear(first, second)
        }

        fn polarized(
            &self,
            first: &__kahan::SVector<T, 3>,
            second: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            general().polarized(first, second)
        }
    }

    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 3> for E1 {
        type Prepared = Step<T>;

        fn prepare(&self, half_step: &T) -> Step<T> {
            let eps = __kahan::Clone::clone(half_step);
            Step { two_eps: two::<T>() * eps.clone(), eps }
        }

        fn jacobian(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> __kahan::SMatrix<T, 3, 3> {
            __kahan::jacobian_by_duals(self, state, &half_step)
        }
    }

    impl<T: __kahan::Scalar> __kahan::Lift<T, 3> for E1 {
        type Lifted<U: __kahan::Scalar> = E1;

        fn lift<U: __kahan::Scalar>(&self, _lift: impl Fn(&T) -> U) -> E1 {
            E1
        }
    }
};

const _: () = {
    use crate::__private as __kahan;

    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 4> for Coupled {
        fn field(&self, state: &__kahan::SVector<T, 4>) -> __kahan::SVector<T, 4> {
            self.polarized(state, state)
        }

        fn field_jacobian(&self, state: &__kahan::SVector<T, 4>) -> __kahan::SMatrix<T, 4, 4> {
            let [x, y, z, w] = __kahan::components(state);
            __kahan::matrix([
                [T::zero(), z.clone(), y.clone(), -T::one()],
                [w.clone(), -two::<T>(), T::zero(), x.clone()],
                [two::<T>() * x.clone(), -two::<T>() * y.clone(), T::one(), T::zero()],
                [T::one(), z.clone(), y.clone(), T::zero()],
            ])
        }

        fn bilinear(
            &self,
            first: &__kahan::SVector<T, 4>,
            second: &__kahan::SVector<T, 4>,
        ) -> __kahan::SVector<T, 4> {
            let [x, y, z, w] = __kahan::components(first);
            let [p, q, r, s] = __kahan::components(second);
            let yz = half::<T>() * (y.clone() * r.clone() + q.clone() * z.clone());
            __kahan::vector([
                yz.clone(),
                half::<T>() * (x.clone() * s.clone() + p.clone() * w.clone()),
                x.clone() * p.clone() - y.clone() * q.clone(),
                yz,
            ])
        }

        fn polarized(
            &self,
            first: &__kahan::SVector<T, 4>,
            second: &__kahan::SVector<T, 4>,
        ) -> __kahan::SVector<T, 4> {
            let [x, y, z, w] = __kahan::components(first);
            let [p, q, r, s] = __kahan::components(second);
            let quadratic = self.bilinear(first, second);
            let [a, b, c, d] = __kahan::components(&quadratic);
            __kahan::vector([
                a.clone() - half::<T>() * (w.clone() + s.clone()) + T::one(),
                b.clone() - (y.clone() + q.clone()),
                c.clone() + half::<T>() * (z.clone() + r.clone()),
                d.clone() + half::<T>() * (x.clone() + p.clone()),
            ])
        }
    }

    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 4> for Coupled {
        type Prepared = __kahan::Elimination<Self, T>;

        fn prepare(&self, half_step: &T) -> Self::Prepared {
            __kahan::Elimination::new(*self, __kahan::Clone::clone(half_step))
        }
    }
};
