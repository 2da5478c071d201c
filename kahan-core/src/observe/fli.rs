//! The fast Lyapunov indicator.

use core::cmp::Ordering;

use super::TangentMap;
use super::carried::{Carried, Follower, Indicator};
use super::growth::Size;

/// The fast Lyapunov indicator: the logarithm of the greatest length that a tangent vector has had,
/// its first length being 1.
///
/// Over n steps it grows like log n on a torus and like n where motion is chaotic. C. Froeschlé, E.
/// Lega, R. Gonczi, Celest. Mech. Dyn. Astron. 67 (1997) 41.
///
/// Cost: a tangent vector, about that of a step, and its square; see `benches/results`.
///
/// It reports not a number from a pole on.
///
/// An [`Observer`](super::Observer) of points, made by `Fli::new(&map)`; `map` is a
/// [`TangentMap`].
pub type Fli<M> = Follower<Greatest, M, 1>;

/// The squares of a vector's first and greatest lengths.
#[derive(Clone, Debug)]
pub struct Greatest {
    first: Size,
    greatest: Size,
}

impl Indicator<1> for Greatest {
    type Report = f64;

    const LOOKS_AT_EACH: bool = true;

    fn new([first]: [Size; 1]) -> Self {
        Self { first, greatest: first }
    }

    #[inline(always)]
    fn look(&mut self, step: u64, [size]: [Size; 1]) {
        if step == 0 {
            (self.first, self.greatest) = (size, size);
        }
        match size.partial_cmp(&self.greatest) {
            Some(Ordering::Greater) => self.greatest = size,
            // One of them is not a number, and so it stays.
            None => self.greatest = Size::of(f64::NAN),
            _ => {}
        }
    }

    fn report<M: TangentMap>(self, _carried: Carried<M, 1>) -> f64 {
        0.5 * (self.greatest.ln() - self.first.ln())
    }
}
