/// u_t = −6 u u_x − u_xxx by differences of width h.
///
/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for a chain of any number of sites, closed to a ring:
///
/// ```text
/// u[i]dot = (1/2*u[i-2] - u[i-1] + u[i+1] - 1/2*u[i+2] + 3/2*h^2*u[i-1]^2 - 3/2*h^2*u[i+1]^2)/h^3
/// ```
///
/// Proved while compiling, for every number of sites:
///
/// ```text
/// integral mass = sum(u[i])
/// hamiltonian H = sum((u[i+1] - u[i])^2/(2*h^2) - u[i]^3)
/// ```
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Kdv<T> {
    /// The parameter `h`.
    pub h: T,
}
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
#[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
const _: () = {
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl<T: __kahan::LatticeScalar> __kahan::LatticeMap<T> for Kdv<T> {
        const ARRAYS: &'static [&'static __kahan::str] = &["u"];
        const REACH: __kahan::usize = 2;
        type Kernels = __kahan::Stencil<1, 2, 0, 7, 2, 2, 5, 5>;
        fn sizes(&self) -> __kahan::Sizes {
            Self::Kernels::SIZES
        }
        fn boundary(&self) -> __kahan::Boundary {
            __kahan::Boundary::Periodic
        }
        fn constants<L: __kahan::Scalar>(
            &self,
            eps: L,
            convert: impl __kahan::Fn(&T) -> L,
        ) -> __kahan::Option<__kahan::Vec<L>> {
            let __p_h = convert(&self.h);
            let __c_1_2 = __kahan::ratio::<L>(1, 2);
            let __t_h_squared = __p_h.clone() * __p_h.clone();
            let __reciprocal_1 = (__p_h.clone() * __t_h_squared.clone()).reciprocal()?;
            let __product_1 = __c_1_2.clone() * __reciprocal_1.clone();
            let __reciprocal_2 = __p_h.reciprocal()?;
            let __product_2 = __product_1.clone() * eps.clone();
            let __reciprocal_3 = __c_1_2.quotient(__t_h_squared)?;
            __kahan::Some(
                __kahan::Vec::from([
                    __product_1,
                    __kahan::ratio::<L>(3, 2) * __reciprocal_2.clone(),
                    __product_2.clone(),
                    -__product_2,
                    eps.clone() * (__reciprocal_2 * __kahan::integer::<L>(3)),
                    __reciprocal_1 * eps,
                    __reciprocal_3,
                ]),
            )
        }
        #[inline(always)]
        fn rows<L: __kahan::Scalar>(
            &self,
            constants: &[L],
            x: &[L],
            c: &[L],
            _: &mut [L],
            f: &mut [L],
            a: &mut [L],
        ) {
            let __s_u_before_2 = &x[0];
            let __s_u_before_1 = &x[1];
            let __s_u_after_1 = &x[3];
            let __s_u_after_2 = &x[4];
            let __p_constant_1 = &constants[0];
            let __p_constant_2 = &constants[1];
            let __p_constant_3 = &constants[2];
            let __p_constant_4 = &constants[3];
            let __p_constant_5 = &constants[4];
            let __p_constant_6 = &constants[5];
            let __c_2 = __kahan::integer::<L>(2);
            f[0] = __p_constant_1
                .clone()
                .multiply_add(
                    __c_2
                        .clone()
                        .multiply_add(
                            __s_u_after_1.clone(),
                            __s_u_before_2
                                .clone()
                                .subtract_product(__c_2, __s_u_before_1.clone()),
                        ) - __s_u_after_2.clone(),
                    __p_constant_2.clone()
                        * (__s_u_before_1.clone() * __s_u_before_1.clone())
                            .subtract_product(
                                __s_u_after_1.clone(),
                                __s_u_after_1.clone(),
                            ),
                );
            a[0] = __p_constant_4.clone();
            a[1] = __p_constant_6
                .clone()
                .subtract_product(__s_u_before_1.clone(), __p_constant_5.clone());
            a[2] = __kahan::integer::<L>(1);
            a[3] = __s_u_after_1
                .clone()
                .multiply_subtract(__p_constant_5.clone(), __p_constant_6.clone());
            a[4] = __p_constant_3.clone();
        }
        const INTEGRALS: &'static [&'static __kahan::str] = &["mass"];
        const HAMILTONIAN: __kahan::Option<&'static __kahan::str> = __kahan::Some("H");
        #[inline(always)]
        fn densities<L: __kahan::Scalar>(
            &self,
            constants: &[L],
            x: &[L],
            c: &[L],
            _: &mut [L],
            s: &mut [L],
        ) {
            let __s_u = &x[2];
            let __s_u_after_1 = &x[3];
            let __p_constant_7 = &constants[6];
            let __t_u_squared = __s_u.clone() * __s_u.clone();
            s[0] = __s_u.clone();
            s[1] = __p_constant_7
                .clone()
                .multiply_subtract(
                    __s_u_after_1
                        .clone()
                        .multiply_add(
                            __s_u_after_1
                                .clone()
                                .subtract_product(__kahan::integer::<L>(2), __s_u.clone()),
                            __t_u_squared.clone(),
                        ),
                    __s_u.clone() * __t_u_squared,
                );
        }
    }
};
