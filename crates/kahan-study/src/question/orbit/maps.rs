//! Orbits of Kahan's map: in floats, in double-double, exactly, and through poles.

use std::num::NonZeroU64;

use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::Zero;
use kahan_core::{Composition, Dd};
use kahan_runtime::interpreted::round;
use kahan_runtime::orbit::{ExactOrbit, ProjectiveOrbit, ProjectiveScalar};
use kahan_runtime::{Follow, Followed, Fraction, Map, MapAt, RuntimeFloat};

use crate::count::WorkCount;
use crate::error::StudyError;
use crate::lifted_step::LiftedStep;
use crate::numbers::{DoubleDouble, Number, Printable};
use crate::rows::{self, Values};
use crate::study::Study;

use super::points::{EarlyEnd, EndReason, OrbitPoints, one_by_one, rows_in_milliseconds};
use super::{NoOrbit, Orbit};

/// An arithmetic in which orbits are computed, and whose numbers can be cells of tables.
pub(super) trait PointArithmetic: Printable {
    type Cell: Clone;

    /// The cell of a coordinate at infinity.
    const INFINITE: Self::Cell;

    const UNDEFINED: Self::Cell;

    /// The library's scalar type that corresponds to these numbers.
    type Scalar: ProjectiveScalar + Into<Self::Value>;

    /// Returns the cell of a number. A number that is not finite gives the cell of an undefined
    /// value.
    fn cell(number: &Self::Value) -> Self::Cell;

    /// Returns the cell of a number; `None` gives the cell of an undefined value.
    fn cell_of(number: Option<Self::Value>) -> Self::Cell {
        number.map_or(Self::UNDEFINED, |number| Self::cell(&number))
    }

    fn values(cells: &[Self::Cell]) -> Values<'_>;

    /// Rounds an integer to the nearest number, faster than [`Printable::round`].
    fn whole(n: i64) -> Self::Value;

    /// Rounds a double-double to a float of this arithmetic; `None` if the arithmetic is exact.
    fn narrow(number: Dd) -> Option<Self::Value>;

    /// Prepares the orbit of Kahan's map, or of a composition, at its first point.
    fn kahan<'a>(
        study: &'a Study,
        asked: &Orbit,
        composition: Composition,
        start: &[Rational],
    ) -> Result<Box<dyn OrbitPoints<Self> + 'a>, StudyError>;
}

/// Implements [`PointArithmetic`] for an arithmetic of floats.
macro_rules! of_float {
    ($arithmetic:ident, $float:ident as $values:ident, [$infinite:expr, $nan:expr], $narrow:expr, $whole:expr, $lifted:expr) => {
        impl PointArithmetic for $arithmetic {
            type Cell = $float;
            type Scalar = $float;

            const INFINITE: $float = $infinite;
            const UNDEFINED: $float = $nan;

            fn cell(number: &$float) -> $float {
                if number.is_finite() { *number } else { Self::UNDEFINED }
            }

            fn values(cells: &[$float]) -> Values<'_> {
                Values::$values(cells)
            }

            fn whole(n: i64) -> $float {
                $whole(n)
            }

            fn narrow(number: Dd) -> Option<$float> {
                Some($narrow(number))
            }

            fn kahan<'a>(
                study: &'a Study,
                asked: &Orbit,
                composition: Composition,
                start: &[Rational],
            ) -> Result<Box<dyn OrbitPoints<Self> + 'a>, StudyError> {
                let at = study.map()?.at(round::<$float>(&asked.eps));
                let at = if composition == Composition::KAHAN { at } else { at.composed(composition) };
                let lifted = $lifted(study, &at, asked.reembed);
                let x = start.iter().map(round).collect();
                Ok(Box::new(FloatOrbit { at, composition, lifted, x, points: Vec::new() }))
            }
        }
    };
}

of_float!(Float64, f64 as F64, [f64::INFINITY, f64::NAN], Dd::high, |n| n as f64, Study::steps);
of_float!(
    Float32,
    f32 as F32,
    [f32::INFINITY, f32::NAN],
    |x: Dd| x.high() as f32,
    |n| n as f32,
    |study, at, _| Study::lifted_step(study, at)
);
of_float!(
    DoubleDouble,
    Dd as Dd,
    [Dd::new(f64::INFINITY, 0.0), Dd::new(f64::NAN, 0.0)],
    std::convert::identity,
    // The difference between an `i64` and the nearest double is itself a double.
    |n: i64| Dd::new(n as f64, (i128::from(n) - n as f64 as i128) as f64),
    |study, at, _| Study::lifted_step(study, at)
);

impl PointArithmetic for Exact {
    type Cell = rows::Exact;
    type Scalar = BigRational;

    const INFINITE: rows::Exact = rows::Exact::Infinite;
    const UNDEFINED: rows::Exact = rows::Exact::Undefined;

    fn cell(number: &Rational) -> rows::Exact {
        rows::Exact::Number(number.into())
    }

    fn values(cells: &[rows::Exact]) -> Values<'_> {
        Values::Exact(cells)
    }

    fn whole(n: i64) -> Rational {
        n.into()
    }

    fn narrow(_: Dd) -> Option<Rational> {
        None
    }

    fn kahan<'a>(
        study: &'a Study,
        asked: &Orbit,
        _: Composition,
        start: &[Rational],
    ) -> Result<Box<dyn OrbitPoints<Self> + 'a>, StudyError> {
        Ok(Box::new(study.map()?.exact_orbit(&asked.eps, start).expect("the point is of the field")))
    }
}

struct FloatOrbit<'a, T: RuntimeFloat> {
    at: MapAt<T>,
    composition: Composition,
    lifted: Option<LiftedStep<'a, MapAt<T>>>,
    x: Vec<T>,
    points: Vec<T>,
}

impl<T: RuntimeFloat> FloatOrbit<'_, T> {
    fn append<A: PointArithmetic<Value = T, Cell = T>>(&self, x: &[T], cells: &mut Vec<T>) {
        cells.extend_from_slice(x);
        let first = cells.len();
        cells.resize(first + self.at.map().field().integrals().len(), T::zero());
        self.at.integrals(x, &mut cells[first..]).expect("the room is for the integrals");
        cells[first..].iter_mut().for_each(|value| *value = A::cell(value));
    }

    fn halt<R>(&self, followed: &Followed<R>) -> Result<(), EarlyEnd> {
        EarlyEnd::of(followed, || match self.lifted.as_ref().and_then(|lifted| lifted.ends(&self.x)) {
            Some(ends) => EndReason::Lift(ends),
            None => match self.at.divides_by_zero(&self.x) {
                Ok(false) | Err(_) => EndReason::Range,
                Ok(true) if self.composition.stages() > 1 => EndReason::StagePole,
                Ok(true) => pole(self.at.map()),
            },
        })
    }
}

fn pole(map: &Map) -> EndReason {
    EndReason::Pole { is_reduced: map.field().derived().map.is_some() }
}

impl<T: RuntimeFloat, A: PointArithmetic<Value = T, Cell = T>> OrbitPoints<A> for FloatOrbit<'_, T> {
    fn row(&mut self, cells: &mut Vec<T>) {
        self.append::<A>(&self.x, cells);
    }

    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd> {
        let tell = |steps| progress.tell(steps);
        let followed = match &self.lifted {
            Some(lifted) => lifted.follow(&mut self.x, steps, tell),
            None => self.at.follow(&mut self.x, steps, tell),
        };
        self.halt(&followed.expect("the point is of the field"))
    }

    fn rows(
        &mut self,
        every: u64,
        count: usize,
        cells: &mut Vec<T>,
        progress: &WorkCount<'_>,
    ) -> Result<(), EarlyEnd> {
        let every = NonZeroU64::new(every).expect("rows are some steps apart");
        self.points.resize(count * self.x.len(), T::zero());
        let tell = |steps| progress.tell(steps);
        let followed = match &self.lifted {
            Some(lifted) => lifted.rows(&mut self.x, every, &mut self.points, tell),
            None => self.at.rows(&mut self.x, every, &mut self.points, tell),
        };
        let followed = followed.expect("the points are of the field");
        let points = self.points.chunks_exact(self.x.len()).take(followed.report);
        points.for_each(|x| self.append::<A>(x, cells));
        self.halt(&followed)
    }

    fn at_once(&self, every: u64) -> usize {
        rows_in_milliseconds(self.x.len(), every)
    }

    fn point(&self) -> Vec<Number> {
        self.x.iter().map(A::number).collect()
    }

    fn is_code(&self) -> Option<bool> {
        Some(self.at.is_code())
    }
}

impl OrbitPoints<Exact> for ExactOrbit {
    fn row(&mut self, cells: &mut Vec<rows::Exact>) {
        let (coordinates, integrals) = self.values();
        let cell = |value: Option<Fraction>| value.map_or(rows::Exact::Undefined, rows::Exact::Number);
        cells.extend(coordinates.into_iter().map(Some).chain(integrals).map(cell));
    }

    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd> {
        one_by_one(steps, progress, || if self.advance() { Ok(()) } else { Err(pole(self.map())) })
    }

    fn point(&self) -> Vec<Number> {
        self.point().into_iter().map(Number::Exact).collect()
    }
}

pub(super) fn projective<A: PointArithmetic>(
    map: &Map,
    eps: &Rational,
    start: &[Rational],
) -> Result<Box<dyn OrbitPoints<A>>, StudyError> {
    let orbit = map.projective_orbit::<A::Scalar>(eps, start);
    Ok(Box::new(orbit.map_err(|why| StudyError::Orbit(NoOrbit::Projective(why)))?))
}

impl<A: PointArithmetic> OrbitPoints<A> for Box<dyn ProjectiveOrbit<A::Scalar>> {
    fn row(&mut self, cells: &mut Vec<A::Cell>) {
        let is_infinite = self.is_infinite();
        cells.extend(self.coordinates().iter().map(|x| match is_infinite {
            false => A::cell(&x.clone().into()),
            true if x.is_zero() => A::UNDEFINED,
            true => A::INFINITE,
        }));
        let integral = |value: Option<A::Scalar>| A::cell_of(value.filter(|_| !is_infinite).map(Into::into));
        cells.extend(self.integrals().into_iter().map(integral));
    }

    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd> {
        one_by_one(steps, progress, || ProjectiveOrbit::advance(&mut **self).map_err(EndReason::NoLimit))
    }
}

#[cfg(test)]
mod tests {
    use std::fmt::Debug;

    use super::*;

    fn counts_are_rounded_as_numbers<A: PointArithmetic<Value: Debug + PartialEq>>() {
        let powers = (0..63).map(|power| 1_i64 << power);
        let near = powers.flat_map(|power| [power - 1, power, power + 1, power / 3]);
        near.chain([i64::MAX - 1, i64::MAX])
            .for_each(|n| assert_eq!(A::whole(n), A::round(&Rational::from(n))));
    }

    #[test]
    fn counts_are_rounded_once() {
        counts_are_rounded_as_numbers::<Float64>();
        counts_are_rounded_as_numbers::<Float32>();
        counts_are_rounded_as_numbers::<DoubleDouble>();
        counts_are_rounded_as_numbers::<Exact>();
    }
}
