//! Macros that define lane types over vector registers, from the names of a processor's intrinsics.
//! Each module of a processor defines `machine!`, a macro that runs an intrinsic.

#[cfg(test)]
pub(super) mod tests;

use super::lanes::Square;

/// The comparisons and selections that [`Lanes`](crate::ensemble::lanes::Lanes) requires.
pub(in crate::ensemble) trait SelectLanes: Copy {
    type Float;
    type Mask: Copy;
    fn exceeds(a: Self, b: Self) -> Self::Mask;
    fn any(mask: Self::Mask) -> bool;
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;
    fn transposed(rows: Square<Self::Float>) -> Square<Self::Float>;
}

macro_rules! choosing {
    ($register:ident of $float:ty, $mask:ty: |$a:ident, $b:ident| $exceeds:expr, |$asked:ident| $any:expr, |$chosen:ident, $yes:ident, $no:ident| $choose:expr, transposed $transposed:path) => {
        impl SelectLanes for $register {
            type Float = $float;
            type Mask = $mask;

            #[inline(always)]
            fn exceeds($a: Self, $b: Self) -> $mask {
                machine!($exceeds)
            }

            #[inline(always)]
            fn any($asked: $mask) -> bool {
                machine!($any)
            }

            #[inline(always)]
            fn choose($chosen: $mask, $yes: Self, $no: Self) -> Self {
                machine!($choose)
            }

            #[inline(always)]
            fn transposed(rows: Square<$float>) -> Square<$float> {
                $transposed(rows)
            }
        }
    };
}

/// Defines a lane type from its name, its register, the number of lanes, the float, and the
/// intrinsic of each operation. The fused operations are a·b + c, a·b − c and c − a·b.
macro_rules! lanes {
    (
        $name:ident($register:ty), $lanes:literal lanes of $float:ident as $constant:ident,
        $load:ident, $store:ident, $set:ident, $add:ident, $sub:ident, $mul:ident, $div:ident,
        fused $multiply_add:path, $multiply_subtract:path, $subtract_product:path, quotient $quotient:path
    ) => {
        #[derive(Clone, Copy, Debug)]
        pub(in crate::ensemble) struct $name($register);

        impl $name {
            #[inline(always)]
            fn splat(value: $float) -> Self {
                Self(machine!($set(value)))
            }

            fn to_array(self) -> [$float; $lanes] {
                let mut group = [0.0; 16];
                self.store(&mut group, 0);
                core::array::from_fn(|k| group[k])
            }
        }

        impl Lanes<$float> for $name {
            const WIDTH: usize = $lanes;

            type Mask = <$register as SelectLanes>::Mask;

            #[inline(always)]
            fn load(entries: &[$float], place: usize) -> Self {
                let entries = &entries[place..place + $lanes];
                // SAFETY: the slice holds as many floats as the register, and the address need not
                // be aligned. On the instruction itself, see `machine!`.
                Self(unsafe { $load(entries.as_ptr()) })
            }

            #[inline(always)]
            fn store(self, entries: &mut [$float], place: usize) {
                let entries = &mut entries[place..place + $lanes];
                // SAFETY: as in `load`, the slice is long enough and the instruction exists.
                unsafe { $store(entries.as_mut_ptr(), self.0) };
            }

            #[inline(always)]
            fn spread(value: &$float) -> Self {
                Self::splat(*value)
            }

            #[inline(always)]
            fn exceeds(self, other: Self) -> Self::Mask {
                <$register as SelectLanes>::exceeds(self.0, other.0)
            }

            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                <$register as SelectLanes>::any(mask)
            }

            #[inline(always)]
            fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self {
                Self(<$register as SelectLanes>::choose(mask, yes.0, no.0))
            }

            #[inline(always)]
            fn transposed(rows: Square<$float>) -> Square<$float> {
                <$register as SelectLanes>::transposed(rows)
            }
        }

        impl Scalar for $name {
            #[inline(always)]
            fn constant(c: &Constant<'_>) -> Self {
                Self::splat(c.$constant())
            }

            #[inline(always)]
            fn reciprocal(&self) -> Option<Self> {
                Some($quotient(Self::splat(1.0), *self))
            }

            #[inline(always)]
            fn quotient(self, divisor: Self) -> Option<Self> {
                Some($quotient(self, divisor))
            }

            #[inline(always)]
            fn multiply_add(self, factor: Self, addend: Self) -> Self {
                Self(machine!($multiply_add(self.0, factor.0, addend.0)))
            }

            #[inline(always)]
            fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
                Self(machine!($multiply_subtract(self.0, factor.0, subtrahend.0)))
            }

            #[inline(always)]
            fn subtract_product(self, a: Self, b: Self) -> Self {
                Self(machine!($subtract_product(a.0, b.0, self.0)))
            }
        }

        impl Neg for $name {
            type Output = Self;

            /// Computes −0 − x, which equals −x for every x.
            #[inline(always)]
            fn neg(self) -> Self {
                Self::splat(-0.0) - self
            }
        }

        lanes!(operators of $name: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        assignments!([] $name);

        impl Zero for $name {
            #[inline(always)]
            fn zero() -> Self {
                Self::splat(0.0)
            }

            fn is_zero(&self) -> bool {
                self.to_array().iter().all(|lane| *lane == 0.0)
            }
        }

        impl One for $name {
            #[inline(always)]
            fn one() -> Self {
                Self::splat(1.0)
            }
        }

        impl PartialEq for $name {
            fn eq(&self, other: &Self) -> bool {
                self.to_array() == other.to_array()
            }
        }
    };
    (operators of $name:ident: $($operator:ident $method:ident $intrinsic:ident),*) => { $(
        impl $operator for $name {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(machine!($intrinsic(self.0, other.0)))
            }
        }
    )* };
}
pub(super) use {choosing, lanes};
