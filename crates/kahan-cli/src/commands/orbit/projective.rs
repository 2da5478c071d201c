//! Orbits through poles: points at infinity are rows, too.

use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use kahan_core::Dd;
use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::Zero;
use kahan_runtime::Field;
use kahan_runtime::orbit::{ProjectiveOrbit, ProjectiveScalar};

use super::Orbit;
use crate::numbers::{DoubleDouble, Printable};
use crate::printing::{Answer, Broken, Cell, Refusal, Table};
use crate::reading::Request;

/// An arithmetic whose numbers are those of a scalar of the library.
pub(super) trait OfScalar: Printable {
    /// That scalar.
    type Scalar: ProjectiveScalar;

    /// Its number as one of the arithmetic.
    fn value(number: &Self::Scalar) -> Self::Value;
}

impl OfScalar for Exact {
    type Scalar = BigRational;

    fn value(number: &BigRational) -> Rational {
        number.clone().into()
    }
}

/// Arithmetics whose values are the scalar's.
macro_rules! of_float {
    ($arithmetic:ty, $float:ty) => {
        impl OfScalar for $arithmetic {
            type Scalar = $float;

            fn value(number: &$float) -> $float {
                *number
            }
        }
    };
}

of_float!(Float32, f32);
of_float!(Float64, f64);
of_float!(DoubleDouble, Dd);

impl Orbit {
    /// The rows of orbits through their poles.
    pub(super) fn through_poles<A: OfScalar>(
        &self,
        arithmetic: &A,
        request: &Request,
        starts: &[Vec<Rational>],
    ) -> Result<Answer, Refusal> {
        if self.order != 2 {
            return Err(Refusal::new(
                "--projective follows Kahan's map itself, not compositions; leave --order out",
            ));
        }
        let (parameters, eps) = request.rounded::<A>(starts)?;
        let field = Field::of(&request.system);
        // What differs exactly may be one number in the scalar.
        if !field.derived().is_defined_at(arithmetic, &parameters) {
            return Err(request.undefined_field());
        }
        let point = &request.point;
        let values = field.parameters().iter().zip(&point.parameters);
        let map = field.with(values).map_err(|_| request.undefined_field())?;
        let orbits = starts.iter().map(|start| map.projective_orbit::<A::Scalar>(&point.eps, start));
        let orbits = orbits.collect::<Result<Vec<_>, _>>();
        let orbits = orbits.map_err(|why| Refusal::new(format!("--projective: {why}")))?;
        let mut head = self.head::<A>(request, &parameters, &eps, field.integrals(), starts.len());
        head.insert("projective".to_owned(), true.into());
        let time_step = arithmetic.add(&eps, &eps);
        self.write(head, orbits, |mut orbit, rows, table| {
            rows.follow(
                &mut orbit,
                1,
                |orbit, n| row(arithmetic, table, n, &time_step, orbit.as_ref()),
                |orbit, n, _| orbit.advance().map_err(|why| request.end(n, why)),
            )
        })
    }
}

/// Writes the point n as a row.
fn row<A: OfScalar>(
    arithmetic: &A,
    table: &mut Table,
    n: i64,
    time_step: &A::Value,
    orbit: &dyn ProjectiveOrbit<A::Scalar>,
) -> Result<(), Broken> {
    let number = arithmetic.constant(&Rational::from(n));
    let time = number.map(|n| Cell::Value(arithmetic.multiply(&n, time_step)));
    let is_infinite = orbit.is_infinite();
    let coordinate = |x: &A::Scalar| match is_infinite {
        false => Cell::Value(A::value(x)),
        true if x.is_zero() => Cell::Undefined,
        true => Cell::Infinite,
    };
    let integral = |value: Option<A::Scalar>| {
        let value = value.filter(|_| !is_infinite);
        value.map_or(Cell::Undefined, |value| Cell::Value(A::value(&value)))
    };
    let cells = std::iter::once(time.unwrap_or(Cell::Undefined))
        .chain(orbit.coordinates().iter().map(coordinate))
        .chain(orbit.integrals().into_iter().map(integral));
    table.projective::<A>(n, cells)
}
