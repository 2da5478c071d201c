//! AVX-512 lanes whose reciprocals and quotients start from a 14-bit estimate of 1/x. The operator
//! `/` divides.
//!
//! A division instruction would make the other operations of a step wait. Newton's iteration r +
//! r·(1 − x·r) doubles the number of correct bits of r ≈ 1/x by two multiply-adds.

use core::arch::x86_64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{One, Zero};

use crate::ensemble::lanes::{Lanes, Square};
use crate::ensemble::registers::{SelectLanes, lanes};
use crate::scalar::assignments;
use crate::{Constant, Scalar};

use super::lanes::{lanes_of_avx512, machine};

lanes_of_avx512!(F64x8Estimated(__m512d), quotient estimated_f64);

lanes_of_avx512!(F32x16Estimated(__m512), quotient estimated_f32);

#[inline(always)]
fn estimated_f64(a: F64x8Estimated, b: F64x8Estimated) -> F64x8Estimated {
    let estimate = F64x8Estimated(machine!(_mm512_rcp14_pd(b.0)));
    a * newton_iteration(b, newton_iteration(b, estimate))
}

#[inline(always)]
fn estimated_f32(a: F32x16Estimated, b: F32x16Estimated) -> F32x16Estimated {
    a * newton_iteration(b, F32x16Estimated(machine!(_mm512_rcp14_ps(b.0))))
}

/// Returns r + r·(1 − x·r) for a reciprocal r of x. A relative error δ of r becomes δ².
#[inline(always)]
fn newton_iteration<L: Scalar + Copy>(x: L, reciprocal: L) -> L {
    let error = L::one().subtract_product(x, reciprocal);
    reciprocal.multiply_add(error, reciprocal)
}
