//! The fast Lyapunov indicator.

use core::cmp::Ordering;

use super::TangentMap;
use super::carried::{Carried, Indicator, IndicatorObserver};
use super::growth::Size;

/// An observer of the fast Lyapunov indicator, the logarithm of the largest length so far of a
/// tangent vector with initial length 1.
///
/// Over n steps the indicator grows like log n for regular motion, and like n for chaotic motion.
/// C. Froeschlé, E. Lega, R. Gonczi, Celest. Mech. Dyn. Astron. 67 (1997) 41. After a pole the
/// indicator is NaN. `Fli::new(&map)` takes a [`TangentMap`].
pub type Fli<M> = IndicatorObserver<GreatestLength, M, 1>;

/// The initial and the largest squared length of a tangent vector.
#[derive(Clone, Debug)]
pub struct GreatestLength {
    first: Size,
    greatest: Size,
}

impl Indicator<1> for GreatestLength {
    type Report = f64;

    const LOOKS_AT_EACH: bool = true;

    fn new([first]: [Size; 1]) -> Self {
        Self { first, greatest: first }
    }

    #[inline(always)]
    fn read_lengths(&mut self, step: u64, [size]: [Size; 1]) {
        if step == 0 {
            (self.first, self.greatest) = (size, size);
        }
        match size.partial_cmp(&self.greatest) {
            Some(Ordering::Greater) => self.greatest = size,
            // A NaN is not comparable, and replaces the largest length.
            None => self.greatest = Size::of(f64::NAN),
            _ => {}
        }
    }

    fn report<M: TangentMap>(self, _carried: Carried<M, 1>) -> f64 {
        0.5 * (self.greatest.ln() - self.first.ln())
    }
}
