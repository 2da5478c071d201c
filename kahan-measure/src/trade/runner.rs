//! A system at a starting point: its orbits, its flow, its integrals, whatever its type.

use std::time::Instant;

use kahan_algebra::system::System;
use kahan_core::__private::Dual;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, QuadraticField, Scalar, Scheme, StepCost};
use kahan_runtime::interpreted::{CannotInterpret, Interpreted, VisitDimension, visit_dimension};

use crate::reference::{Limits, NoReference, Reference, Trajectory};

use super::CannotTrade;
use super::catalog::{Compiled, compiled};
use super::walk::{Walker, point, rational, walk};

/// A system at a starting point.
pub(super) struct Runner {
    pub(super) map: Box<dyn Map>,
    /// The orbits of compiled code, for a system of the catalog: the interpreter's take ten to
    /// fifty times as long.
    compiled: Option<Compiled>,
    start: Vec<BigRational>,
}

/// What looks at points: the number of steps so far, and the point.
pub(super) type Visit<'a> = &'a mut dyn FnMut(u64, &[Dd]);

/// Numbers of steps, each larger than the one before.
pub(super) type Stops<'a> = &'a mut dyn Iterator<Item = u64>;

impl Runner {
    /// A system of any name; the catalog's are compiled.
    pub(super) fn new(
        system: &System,
        command: &str,
        parameters: &[BigRational],
        start: &[BigRational],
    ) -> Result<Self, CannotTrade> {
        let read = visit_dimension(system.field.dimension(), Reader { system, parameters });
        let map = read.map_err(CannotTrade::Dimension)?.map_err(CannotTrade::System)?;
        Ok(Runner { map, compiled: compiled(command, parameters), start: start.to_vec() })
    }

    /// E6 at a point of ordinary size: what is timed in place of a field without compiled code.
    pub(super) fn stand_in() -> Result<Self, CannotTrade> {
        let reading = kahan_algebra::read(&kahan_algebra::lexer::lex(kahan_systems::e6::ENTRY.text()).tokens);
        let start = [1, -2, 3].map(|x| BigRational::new(x.into(), 4.into()));
        Runner::new(&reading.system, kahan_systems::e6::ENTRY.command, &[], &start)
    }

    /// Whether its steps are compiled code.
    pub(super) fn is_compiled(&self) -> bool {
        self.compiled.is_some()
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
        let exact = |entry: &Dd| rational(entry.high()) + rational(entry.low());
        let start = from.map_or_else(|| self.start.clone(), |point| point.iter().map(exact).collect());
        let mut seconds = 0.0;
        let walker: Walker<'_> = &mut |orbit| {
            let (mut step, mut points) = (0, 0);
            let clock = Instant::now();
            while let Some(point) = orbit.nth(points) {
                visit(step, &point[..start.len()]);
                let Some(stop) = stops.next() else { break };
                points = index(stop - step - 1);
                step = stop;
            }
            seconds = clock.elapsed().as_secs_f64();
        };
        match &self.compiled {
            Some(compiled) => compiled(&start, scheme, eps, walker),
            None => self.map.walk(&start, scheme, eps, walker),
        }
        seconds
    }
}

/// A system that was read, in whatever number of variables.
pub(super) trait Map {
    /// Hands over an orbit.
    fn walk(&self, start: &[BigRational], scheme: Scheme, eps: f64, walker: Walker<'_>);
    /// The trajectory to compare with.
    fn reference(&self, asked: &Trajectory<'_>, limits: &Limits) -> Result<Reference, NoReference>;
    /// ‖f′(x₀)‖∞
    fn slope(&self, start: &[BigRational]) -> f64;
    /// The declared integrals at this ε.
    fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd>;
    /// Their Taylor coefficients at ε = 0: the values, and those of ε².
    fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]>;
    /// What a step of the generated code costs.
    fn cost(&self) -> StepCost;
}

impl<const N: usize> Map for Interpreted<BigRational, N> {
    fn walk(&self, start: &[BigRational], scheme: Scheme, eps: f64, walker: Walker<'_>) {
        walk(self, start, scheme, eps, walker);
    }

    fn reference(&self, asked: &Trajectory<'_>, limits: &Limits) -> Result<Reference, NoReference> {
        Reference::of(&self.rounded::<Dd>(), asked, limits)
    }

    fn slope(&self, start: &[BigRational]) -> f64 {
        let slopes = self.rounded::<f64>().field_jacobian(&point(start));
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

/// Reads a system in whatever number of variables it has.
struct Reader<'a> {
    system: &'a System,
    parameters: &'a [BigRational],
}

impl VisitDimension for Reader<'_> {
    type Output = Result<Box<dyn Map>, CannotInterpret>;

    fn visit<const N: usize>(self) -> Self::Output {
        Ok(Box::new(Interpreted::<BigRational, N>::padded(self.system, self.parameters)?))
    }
}

/// A point in numbers made from its coordinates, with zeros for the variables that stand still.
fn padded<T: Scalar, const N: usize>(x: &[Dd], number: impl Fn(Dd) -> T) -> SVector<T, N> {
    SVector::from_fn(|i, _| number(x.get(i).copied().unwrap_or_default()))
}

fn number(value: Option<Dd>) -> Dd {
    value.unwrap_or(Dd::from(f64::NAN))
}

/// A number of steps; those beyond the address space are never run.
fn index(steps: u64) -> usize {
    usize::try_from(steps).unwrap_or(usize::MAX)
}
