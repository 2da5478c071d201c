//! Systems written as the macro writes them: two reduced closed forms, one with a parameter, and one elimination.

use crate::Scalar;

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

const _: () = {
    use crate::__private as __kahan;

    fn reduced<S: __kahan::Scalar>(
        state: &__kahan::SVector<S, 3>,
        half_step: &S,
    ) -> (__kahan::SVector<S, 3>, S) {
        let [x, y, z] = __kahan::components(state);
        let radius = x.clone() * x.clone() + y.clone() * y.clone();
        let ez = half_step.clone() * z.clone();
        let er = half_step.clone() * radius.clone();
        let common = -(z.clone() + er.clone());
        let det = S::one() + ez.clone() + two::<S>() * half_step.clone() * er;
        let numerators =
            [x.clone() * common.clone(), y.clone() * common.clone(), radius.clone() * (S::one() - ez)];
        (__kahan::vector(numerators), det)
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
        fn increment(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 3>> {
            let (numerators, det) = reduced(state, half_step);
            __kahan::increment_from_quotient(numerators, det, half_step)
        }

        fn jacobian(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> __kahan::SMatrix<T, 3, 3> {
            __kahan::jacobian_of_reduced(
                |state, half_step| {
                    let (numerators, det) = reduced(state, half_step);
                    __kahan::increment_from_quotient(numerators, det, half_step)
                },
                state,
                &half_step,
            )
        }
    }
};

const _: () = {
    use crate::__private as __kahan;

    fn reduced<S: __kahan::Scalar>(
        system: &E7<S>,
        state: &__kahan::SVector<S, 3>,
        half_step: &S,
    ) -> (__kahan::SVector<S, 3>, S) {
        let [x, y, z] = __kahan::components(state);
        let ex = half_step.clone() * x.clone();
        let xi_ex = system.xi.clone() * ex.clone();
        let (plus, minus) = (S::one() + ex.clone(), S::one() - ex.clone());
        let (double, other) = (plus.clone() + ex.clone(), S::one() + xi_ex.clone());
        let xi_y = system.xi.clone() * y.clone();
        let numerators = [
            -(x.clone() * x.clone()) * other.clone() * minus.clone(),
            -(x.clone() * xi_y.clone()) * plus.clone() * minus.clone(),
            two::<S>() * xi_y * y.clone() * (double.clone() - xi_ex)
                + other.clone() * x.clone() * z.clone() * plus,
        ];
        (__kahan::vector(numerators), double * other * minus)
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
        fn increment(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 3>> {
            let (numerators, det) = reduced(self, state, half_step);
            __kahan::increment_from_quotient(numerators, det, half_step)
        }

        fn jacobian(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> __kahan::SMatrix<T, 3, 3> {
            let lifted = E7 { xi: __kahan::Dual::lift(__kahan::Clone::clone(&self.xi)) };
            __kahan::jacobian_of_reduced(
                |state, half_step| {
                    let (numerators, det) = reduced(&lifted, state, half_step);
                    __kahan::increment_from_quotient(numerators, det, half_step)
                },
                state,
                &half_step,
            )
        }

        fn det_matrix(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> T {
            reduced(self, state, &half_step).1
        }
    }
};

const _: () = {
    use crate::__private as __kahan;

    /// E1 in the terms of E7, whose field it shares; its reduced map is its own.
    fn general<T: __kahan::Scalar>() -> E7<T> {
        E7 { xi: T::one() }
    }

    fn reduced<S: __kahan::Scalar>(
        state: &__kahan::SVector<S, 3>,
        half_step: &S,
    ) -> (__kahan::SVector<S, 3>, S) {
        let [x, y, z] = __kahan::components(state);
        let ex = half_step.clone() * x.clone();
        let (plus, minus) = (S::one() + ex.clone(), S::one() - ex.clone());
        let numerators = [
            -(x.clone() * x.clone()) * minus.clone(),
            -(x.clone() * y.clone()) * minus.clone(),
            two::<S>() * y.clone() * y.clone() + x.clone() * z.clone() * plus.clone(),
        ];
        (__kahan::vector(numerators), (plus + ex) * minus)
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
        fn increment(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 3>> {
            let (numerators, det) = reduced(state, half_step);
            __kahan::increment_from_quotient(numerators, det, half_step)
        }

        fn jacobian(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> __kahan::SMatrix<T, 3, 3> {
            __kahan::jacobian_of_reduced(
                |state, half_step| {
                    let (numerators, det) = reduced(state, half_step);
                    __kahan::increment_from_quotient(numerators, det, half_step)
                },
                state,
                &half_step,
            )
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
        fn increment(
            &self,
            state: &__kahan::SVector<T, 4>,
            half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 4>> {
            __kahan::increment_by_elimination(self, state, half_step)
        }
    }
};
