//! A system at a starting point: its orbits, its flow, its integrals, whatever its type.

use std::time::Instant;

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, Dual, Precision, QuadraticField, Scalar, Scheme, StepCost};
use kahan_runtime::Field;
use kahan_runtime::interpreted::{Interpreted, VisitDimension, round, visit_dimension};

use crate::reference::{Limits, NoReference, Reference, Trajectory};

use super::CannotTrade;

/// A system at a starting point.
pub(super) struct Runner {
    pub(super) map: Box<dyn Map>,
    orbits: kahan_runtime::Map,
    start: Vec<Rational>,
}

/// What looks at points: the number of steps so far, and the point.
pub(super) type Visit<'a> = &'a mut dyn FnMut(u64, &[Dd]);

/// Numbers of steps, each larger than the one before.
pub(super) type Stops<'a> = &'a mut dyn Iterator<Item = u64>;

impl Runner {
    /// A system at these parameters and this point.
    pub(super) fn new(
        system: &System,
        parameters: &[Rational],
        start: &[Rational],
    ) -> Result<Self, CannotTrade> {
        let names = &system.field.symbols.parameters;
        let orbits = Field::of(system).with(names.iter().zip(parameters)).map_err(CannotTrade::Parameters)?;
        let map =
            visit_dimension(system.field.dimension(), Reader(&orbits)).map_err(CannotTrade::Dimension)?;
        Ok(Runner { map, orbits, start: start.to_vec() })
    }

    /// E6 at a point of ordinary size: what is timed in place of a field without code.
    pub(super) fn stand_in() -> Result<Self, CannotTrade> {
        let reading = kahan_algebra::read(&kahan_algebra::lexer::lex(kahan_systems::e6::ENTRY.text()).tokens);
        Runner::new(&reading.system, &[], &[1, -2, 3].map(|x| Rational::new(x, 4)))
    }

    /// Whether its steps are code.
    pub(super) fn is_code(&self) -> bool {
        let plain = Scheme::of(Precision::Double);
        self.orbits.orbit(plain, &Rational::one(), &self.start).is_ok_and(|orbit| orbit.is_code())
    }

    /// Shows the first point of an orbit with ε = `eps` and those after the numbers of steps in
    /// `stops`, which grow; the seconds that it took, without the preparations. The orbit begins at
    /// `from`, or at the scene's own point.
    pub(super) fn follow(
        &self,
        scheme: Scheme,
        eps: f64,
        from: Option<&[Dd]>,
        stops: Stops<'_>,
        visit: Visit<'_>,
    ) -> f64 {
        let exact = |entry: &Dd| &rational(entry.high()) + &rational(entry.low());
        let start = from.map_or_else(|| self.start.clone(), |point| point.iter().map(exact).collect());
        // The point has been read for this field.
        let Ok(mut orbit) = self.orbits.orbit(scheme, &rational(eps), &start) else { return f64::INFINITY };
        let clock = Instant::now();
        visit(0, orbit.point());
        let mut step = 0;
        for stop in stops {
            orbit.advance(stop - step);
            step = stop;
            visit(step, orbit.point());
        }
        clock.elapsed().as_secs_f64()
    }
}

/// A system that was read, in whatever number of variables.
pub(super) trait Map {
    /// The trajectory to compare with.
    fn reference(&self, asked: &Trajectory<'_>, limits: &Limits) -> Result<Reference, NoReference>;
    /// ‖f′(x₀)‖∞
    fn slope(&self, start: &[Rational]) -> f64;
    /// The declared integrals at this ε.
    fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd>;
    /// Their Taylor coefficients at ε = 0: the values, and those of ε².
    fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]>;
    /// What a step of the generated code costs.
    fn cost(&self) -> StepCost;
}

impl<const N: usize> Map for Interpreted<BigRational, N> {
    fn reference(&self, asked: &Trajectory<'_>, limits: &Limits) -> Result<Reference, NoReference> {
        Reference::of(&self.rounded::<Dd>(), asked, limits)
    }

    fn slope(&self, start: &[Rational]) -> f64 {
        let slopes =
            self.rounded::<f64>().field_jacobian(&SVector::from_fn(|i, _| start.get(i).map_or(0.0, round)));
        slopes.row_iter().map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max)
    }

    fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd> {
        let values = self.rounded().integrals(&padded(x, |value| value), &Dd::from(eps));
        values.into_iter().map(number).collect()
    }

    fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]> {
        // ε = d + d′ with d² = d′² = 0: the coefficient of dd′ is the second derivative.
        let fixed = |value: Dd| Dual::<_, 1>::lift(Dual::<_, 1>::lift(value));
        let eps = Dual { value: Dual::coordinate(Dd::from(0.0), 0), gradient: [Dual::lift(Dd::from(1.0))] };
        let claims = self.rounded::<Dd>().over(|parameter| fixed(*parameter));
        let half = Dd::from(0.5);
        let coefficients = claims.integrals(&padded(x, fixed), &eps).into_iter().map(|value| match value {
            Some(value) => [value.value.value, value.gradient[0].gradient[0] * half],
            None => [number(None); 2],
        });
        coefficients.collect()
    }

    fn cost(&self) -> StepCost {
        Interpreted::cost(self)
    }
}

/// Takes a map in whatever number of variables it has.
struct Reader<'a>(&'a kahan_runtime::Map);

impl VisitDimension for Reader<'_> {
    type Output = Box<dyn Map>;

    fn visit<const N: usize>(self) -> Box<dyn Map> {
        let map = self.0.as_kahan_map::<BigRational, N>();
        Box::new(map.unwrap_or_else(|why| unreachable!("the type was chosen for the field: {why}")))
    }
}

/// A point in numbers made from its coordinates, with zeros for the variables that stand still.
fn padded<T: Scalar, const N: usize>(x: &[Dd], number: impl Fn(Dd) -> T) -> SVector<T, N> {
    SVector::from_fn(|i, _| number(x.get(i).copied().unwrap_or_default()))
}

fn number(value: Option<Dd>) -> Dd {
    value.unwrap_or(Dd::from(f64::NAN))
}

/// A float as the number that it is; 0 for what is none.
fn rational(value: f64) -> Rational {
    Rational::from_f64(value).unwrap_or_else(Rational::zero)
}
