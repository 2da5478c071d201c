//! Scalars over NEON registers. Most operations are one instruction on all lanes.
#![expect(unused_unsafe, reason = "the multiply-adds are functions of this module, which are safe to call")]

use core::arch::aarch64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{One, Zero};

use crate::ensemble::lanes::{Lanes, Square};
use crate::ensemble::registers::{SelectLanes, choosing, lanes};
use crate::scalar::assignments;
use crate::{Constant, Scalar};

macro_rules! machine {
    ($expression:expr) => {
        // SAFETY: every 64-bit Arm target that has Rust's standard library supports NEON.
        unsafe { $expression }
    };
}

/// Defines a lane type over a NEON register. The second argument is its module of multiply-adds.
macro_rules! lanes_of_neon {
    ($name:ident(float64x2_t), $multiply_adds:ident) => {
        lanes! {
            $name(float64x2_t), 2 lanes of f64 as to_f64,
            vld1q_f64, vst1q_f64, vdupq_n_f64, vaddq_f64, vsubq_f64, vmulq_f64, vdivq_f64,
            fused $multiply_adds::add_f64, $multiply_adds::subtract_f64, $multiply_adds::subtract_from_f64,
            quotient divided
        }
    };
    ($name:ident(float32x4_t), $multiply_adds:ident) => {
        lanes! {
            $name(float32x4_t), 4 lanes of f32 as to_f32,
            vld1q_f32, vst1q_f32, vdupq_n_f32, vaddq_f32, vsubq_f32, vmulq_f32, vdivq_f32,
            fused $multiply_adds::add_f32, $multiply_adds::subtract_f32, $multiply_adds::subtract_from_f32,
            quotient divided
        }
    };
}

#[inline(always)]
fn divided<L: Scalar>(a: L, b: L) -> L {
    a / b
}

lanes_of_neon!(F64x2(float64x2_t), rounded_twice);
lanes_of_neon!(F32x4(float32x4_t), rounded_twice);
lanes_of_neon!(F64x2Fused(float64x2_t), rounded_once);
lanes_of_neon!(F32x4Fused(float32x4_t), rounded_once);

macro_rules! multiply_adds {
    ($($name:ident($a:ident, $b:ident, $c:ident: $register:ty) $result:expr;)*) => {
        use core::arch::aarch64::*;

        $(
            #[inline(always)]
            pub(super) fn $name($a: $register, $b: $register, $c: $register) -> $register {
                machine!($result)
            }
        )*
    };
}

/// The operations a·b + c, a·b − c and c − a·b with two roundings.
mod rounded_twice {
    multiply_adds! {
        add_f64(a, b, c: float64x2_t) vaddq_f64(vmulq_f64(a, b), c);
        subtract_f64(a, b, c: float64x2_t) vsubq_f64(vmulq_f64(a, b), c);
        subtract_from_f64(a, b, c: float64x2_t) vsubq_f64(c, vmulq_f64(a, b));
        add_f32(a, b, c: float32x4_t) vaddq_f32(vmulq_f32(a, b), c);
        subtract_f32(a, b, c: float32x4_t) vsubq_f32(vmulq_f32(a, b), c);
        subtract_from_f32(a, b, c: float32x4_t) vsubq_f32(c, vmulq_f32(a, b));
    }
}

/// The operations a·b + c, a·b − c and c − a·b with one rounding.
mod rounded_once {
    multiply_adds! {
        add_f64(a, b, c: float64x2_t) vfmaq_f64(c, a, b);
        subtract_f64(a, b, c: float64x2_t) vfmaq_f64(vnegq_f64(c), a, b);
        subtract_from_f64(a, b, c: float64x2_t) vfmsq_f64(c, a, b);
        add_f32(a, b, c: float32x4_t) vfmaq_f32(c, a, b);
        subtract_f32(a, b, c: float32x4_t) vfmaq_f32(vnegq_f32(c), a, b);
        subtract_from_f32(a, b, c: float32x4_t) vfmsq_f32(c, a, b);
    }
}

choosing! {
    float64x2_t of f64, uint64x2_t:
    |a, b| vcagtq_f64(a, b),
    |mask| vmaxvq_u32(vreinterpretq_u32_u64(mask)) != 0,
    |mask, yes, no| vbslq_f64(mask, yes, no),
    transposed doubles
}

choosing! {
    float32x4_t of f32, uint32x4_t:
    |a, b| vcagtq_f32(a, b),
    |mask| vmaxvq_u32(mask) != 0,
    |mask, yes, no| vbslq_f32(mask, yes, no),
    transposed singles
}

/// Transposes a 4 × 4 matrix of doubles by blocks of 2 × 2.
#[inline(always)]
fn doubles(rows: Square<f64>) -> Square<f64> {
    let mut square = [[0.0; 4]; 4];
    for (r, k) in [(0, 0), (0, 2), (2, 0), (2, 2)] {
        // SAFETY: r and k are at most 2; therefore each slice of a row has at least two numbers.
        unsafe {
            let (a, b) = (vld1q_f64(rows[r][k..].as_ptr()), vld1q_f64(rows[r + 1][k..].as_ptr()));
            vst1q_f64(square[k][r..].as_mut_ptr(), vtrn1q_f64(a, b));
            vst1q_f64(square[k + 1][r..].as_mut_ptr(), vtrn2q_f64(a, b));
        }
    }
    square
}

/// Transposes a 4 × 4 matrix of floats. `vld4q` loads every fourth number into one register.
#[inline(always)]
fn singles(rows: Square<f32>) -> Square<f32> {
    let mut square = [[0.0; 4]; 4];
    // SAFETY: the four rows together have sixteen numbers.
    let columns = unsafe { vld4q_f32(rows.as_flattened().as_ptr()) };
    for (column, register) in square.iter_mut().zip([columns.0, columns.1, columns.2, columns.3]) {
        // SAFETY: `column` has four numbers.
        unsafe { vst1q_f32(column.as_mut_ptr(), register) };
    }
    square
}
