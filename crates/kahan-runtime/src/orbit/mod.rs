//! Orbits in any scheme, chosen at run time: precision, order, compensation.
//!
//! In: the plans of a field, exact values of its parameters, a scheme, ε, a first point. Out: the
//! points of the library's own orbit of that scheme, bit for bit, by machine code where it can be
//! had and else by the interpreter.

mod coded;
mod exact;
mod interpreted;
mod projective;
#[cfg(test)]
mod tests;

use core::fmt::Debug;

use kahan_algebra::rational::Rational;
use kahan_core::{Dd, FloatScalar, Precision, Scheme};

use crate::Map;
use crate::engine::{Scratches, stage_constants};
use crate::interpreted::round;

pub use exact::ExactOrbit;
pub use projective::{ProjectiveOrbit, ProjectiveScalar};

use coded::Coding;
use interpreted::{Interpreting, Walk};

/// An orbit that is at some point, in a scheme that was chosen at run time; begun by
/// [`Map::orbit`].
#[derive(Debug)]
pub struct SchemeOrbit {
    running: Box<dyn Running>,
    is_code: bool,
    /// The same orbit interpreted, put at a point where something is asked about it.
    interpreter: Box<dyn Interpreting>,
    point: Vec<Dd>,
}

/// An orbit in the numbers that it runs in.
trait Running: Debug + Send + Sync {
    /// So many steps further; `false` where it cannot tell, and the state is as before.
    fn advance(&mut self, steps: u64) -> bool;

    /// The coordinates of the point.
    fn point(&self, point: &mut [Dd]);

    /// A copy.
    fn boxed(&self) -> Box<dyn Running>;
}

/// What an orbit is begun with. Each number is rounded once to a `G`, what ε and points are, and
/// widened to what steps are computed in.
struct Asked<'a> {
    map: &'a Map,
    scheme: Scheme,
    eps: &'a Rational,
    start: &'a [Rational],
}

impl Asked<'_> {
    fn start<G: FloatScalar, V>(&self, widen: fn(G) -> V) -> impl Iterator<Item = V> {
        self.start.iter().map(move |value| widen(round(value)))
    }

    /// The parameters, and ε behind them.
    fn constants<G: FloatScalar>(&self) -> Vec<G> {
        self.map.parameters().iter().chain([self.eps]).map(round).collect()
    }

    /// The same of each stage that differs, the middle one last.
    fn stages<G: FloatScalar, V>(&self, widen: fn(G) -> V) -> Vec<Vec<V>> {
        let stages = stage_constants(&self.constants::<G>(), self.scheme.composition);
        stages.into_iter().map(|own| own.into_iter().map(widen).collect()).collect()
    }

    /// The orbit by the interpreter, and by code where there is some.
    fn begin(&self) -> (Box<dyn Interpreting>, Option<Box<dyn Running>>) {
        match self.scheme.precision {
            Precision::Single => self.begin_in(|x: f32| x, |x| x.high() as f32, |x| [x]),
            Precision::SingleThroughDouble => {
                self.begin_in(|x: f32| f64::from(x), |x| f64::from(x.high() as f32), |x| [x])
            }
            Precision::Double => self.begin_in(|x: f64| x, Dd::high, |x| [x]),
            Precision::DoubleDouble => self.begin_in(|x: Dd| x, |x| x, |x| [x.high(), x.low()]),
        }
    }

    /// The same whose points are a `G` and whose steps are computed in a `V`, which is the `numbers`
    /// that code takes; `narrow` puts a coordinate of a point into it.
    fn begin_in<G: FloatScalar, V, T: Scratches, const N: usize>(
        &self,
        widen: fn(G) -> V,
        narrow: fn(Dd) -> V,
        numbers: fn(V) -> [T; N],
    ) -> (Box<dyn Interpreting>, Option<Box<dyn Running>>)
    where
        V: FloatScalar + Send + Sync,
        Dd: From<V> + From<T>,
        f64: From<T>,
    {
        (Walk::begin(self, widen, narrow), Coding::begin(self, widen, numbers))
    }
}

/// Where an orbit ends: no step leads from there to a point that is finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// How many steps led there.
    pub steps: u64,
    /// Whether the step from there divides by a number that is exactly 0; where not, the numbers
    /// leave the range.
    pub is_pole: bool,
}

impl SchemeOrbit {
    /// The orbit of a map at its first point, which has a coordinate a variable.
    pub(crate) fn begin(map: &Map, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Self {
        let (interpreter, code) = Asked { map, scheme, eps, start }.begin();
        let is_code = code.is_some();
        let running = code.unwrap_or_else(|| interpreter.boxed());
        let mut orbit =
            SchemeOrbit { running, is_code, interpreter, point: vec![Dd::default(); start.len()] };
        orbit.look();
        orbit
    }

    /// Whether it is machine code.
    #[must_use]
    pub fn is_code(&self) -> bool {
        self.is_code
    }

    /// The point.
    #[must_use]
    pub fn point(&self) -> &[Dd] {
        &self.point
    }

    /// The integrals that are claimed without `when`, at the point, in the numbers that steps are
    /// computed in. What divides by zero there is not finite.
    #[must_use]
    pub fn integrals(&mut self) -> Vec<Dd> {
        self.interpreter.put(&self.point);
        self.interpreter.integrals()
    }

    /// So many steps further. Where a step has no value, the point is not finite from then on.
    pub fn advance(&mut self, steps: u64) {
        if !self.running.advance(steps) {
            // The interpreter goes on, from the point before.
            self.interpreter.put(&self.point);
            (self.running, self.is_code) = (self.interpreter.boxed(), false);
            self.running.advance(steps);
        }
        self.look();
    }

    /// So many steps further, or to the last point that is finite.
    ///
    /// # Errors
    /// [`End`] where that comes before; what a compensated orbit carries beside its point is not
    /// looked at to say why.
    pub fn advance_while_finite(&mut self, steps: u64) -> Result<(), End> {
        let start = (self.running.boxed(), self.is_code);
        self.advance(steps);
        let Some(largest) = steps.checked_ilog2().filter(|_| !self.is_finite()) else { return Ok(()) };
        self.return_to(start);
        let mut taken = 0;
        // What is not finite stays so: the steps that are left to take are a sum of powers of 2.
        for power in (0..=largest).rev() {
            let before = (self.running.boxed(), self.is_code);
            self.advance(1 << power);
            if self.is_finite() {
                taken += 1 << power;
            } else {
                self.return_to(before);
            }
        }
        self.interpreter.put(&self.point);
        Err(End { steps: taken, is_pole: self.interpreter.divides_by_zero() })
    }

    fn return_to(&mut self, before: (Box<dyn Running>, bool)) {
        (self.running, self.is_code) = before;
        self.look();
    }

    fn is_finite(&self) -> bool {
        self.point.iter().all(|x| x.is_finite())
    }

    fn look(&mut self) {
        self.running.point(&mut self.point);
    }
}
