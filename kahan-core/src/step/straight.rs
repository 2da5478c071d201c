//! Steps as straight-line programs over constants that depend on ε and the parameters.

use core::array::from_fn;
use core::marker::PhantomData;
use core::mem::needs_drop;

use nalgebra::SVector;

use crate::Scalar;
use crate::field::linear::components;

use super::{PreparedStep, Quotients, StepCost};

/// The formulas of a step in N variables with C prepared constants.
pub trait Kernel<const N: usize, const C: usize> {
    /// The cost of one step.
    const COST: StepCost;

    /// Returns the increment as numerators and reciprocals, or `None` at a pole of an exact scalar.
    fn quotients<T: Scalar>(constants: &[Padded<T>; C], state: [T; N]) -> Option<Quotients<T, N>>;
}

/// A prepared constant, padded to 32 bytes.
///
/// Without padding, compilers load adjacent scalars as one vector, whose unpacking slows an orbit
/// down. The padding is zero, because compilers also compute with it, and subnormal numbers are
/// slow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct Padded<T>(T, [u32; 3]);

impl<T: Scalar> Padded<T> {
    /// Returns the constant without its padding.
    #[inline(always)]
    pub fn get(&self) -> T {
        self.0.prepared()
    }
}

/// The prepared step of a [`Kernel`].
pub struct StraightStep<K, T, const C: usize> {
    constants: [Padded<T>; C],
    kernel: PhantomData<fn() -> K>,
}

impl<K, T: Clone, const C: usize> StraightStep<K, T, C> {
    /// Creates the step from its prepared constants.
    #[inline(always)]
    pub fn new(constants: [T; C]) -> Self {
        Self { constants: from_fn(|i| Padded(constants[i].clone(), [0; 3])), kernel: PhantomData }
    }
}

impl<K, T: Clone, const C: usize> Clone for StraightStep<K, T, C> {
    #[inline(always)]
    fn clone(&self) -> Self {
        Self { constants: self.constants.clone(), kernel: PhantomData }
    }
}

impl<K, T: Copy, const C: usize> Copy for StraightStep<K, T, C> {}

impl<K, T, const N: usize, const C: usize> PreparedStep<T, N> for StraightStep<K, T, C>
where
    K: Kernel<N, C>,
    T: Scalar,
{
    const COST: StepCost = K::COST;
    const HAS_LANES: bool = true;

    type Wide<L: Scalar> = StraightStep<K, L, C>;

    #[inline(always)]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        let state = components(x).clone();
        if const { needs_drop::<T>() } {
            out_of_line::<K, T, N, C>(&self.constants, state)
        } else {
            K::quotients(&self.constants, state)
        }
    }

    #[inline(always)]
    fn widen<L: Scalar>(&self, spread: impl Fn(&T) -> L) -> StraightStep<K, L, C> {
        StraightStep::new(from_fn(|i| spread(&self.constants[i].0)))
    }

    #[inline(always)]
    fn gather<L: Scalar, const W: usize>(
        each: [&Self; W],
        pack: impl Fn([&T; W]) -> L,
    ) -> StraightStep<K, L, C> {
        StraightStep::new(from_fn(|i| pack(each.map(|step| &step.constants[i].0))))
    }
}

/// Evaluates the formulas for scalars that own memory. Operations of these scalars are calls, and
/// inlining would gain nothing.
#[inline(never)]
fn out_of_line<K, T, const N: usize, const C: usize>(
    constants: &[Padded<T>; C],
    state: [T; N],
) -> Option<Quotients<T, N>>
where
    K: Kernel<N, C>,
    T: Scalar,
{
    K::quotients(constants, state)
}

#[cfg(test)]
mod tests {
    use core::mem::{align_of, offset_of, size_of};

    use super::Padded;

    #[test]
    fn zeros_fill_the_register_behind_a_single_precision_constant() {
        assert_eq!((offset_of!(Padded<f32>, 0), offset_of!(Padded<f32>, 1)), (0, 4));
        assert_eq!((size_of::<Padded<f32>>(), align_of::<Padded<f32>>()), (32, 32));
    }
}
