//! Runs and times the orbits of a system from a point.

use std::iter::once;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::{Dd, Dual, ExtendScalars, Scalar};
use kahan_dynamics::{Precision, Scheme};
use kahan_runtime::interpreted::{Padded, round};
use kahan_runtime::{Field, Map, MapAt, RuntimeFloat};

use crate::map::CannotRun;

use super::CannotTrade;

pub(super) struct Runner<'a> {
    pub(super) map: Map,
    pub(super) wide: Padded<Dd>,
    pub(super) start: Vec<Rational>,
    pub(super) clock: Clock<'a>,
}

/// A function that returns the time since a fixed moment.
pub(super) type Clock<'a> = &'a dyn Fn() -> Duration;

/// A callback that gets the number of steps and the point, and decides whether the orbit continues.
pub(super) type PointVisitor<'a> = &'a mut dyn FnMut(u64, &[Dd]) -> ControlFlow<()>;

pub(super) type StopSteps<'a> = &'a mut dyn Iterator<Item = u64>;

impl<'a> Runner<'a> {
    pub(super) fn new(
        field: &Field,
        parameters: &[Rational],
        start: &[Rational],
        clock: Clock<'a>,
    ) -> Result<Self, CannotTrade> {
        let map = field.with(field.parameters().iter().zip(parameters));
        let map = map.map_err(|why| CannotTrade::CannotRun(CannotRun::Parameters(why)))?;
        let wide = map.as_padded_kahan_map();
        let wide = wide.map_err(|why| CannotTrade::CannotRun(CannotRun::Dimension(why)))?;
        Ok(Runner { map, wide, start: start.to_vec(), clock })
    }

    /// Prepares system E6, whose steps are timed in place of interpreted steps.
    pub(super) fn stand_in(clock: Clock<'a>) -> Result<Self, CannotTrade> {
        let field = Field::parse("xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);");
        let start = [1, -2, 3].map(|x| Rational::new(x, 4));
        Runner::new(&field.expect("a field"), &[], &start, clock)
    }

    pub(super) fn is_code(&self) -> bool {
        self.map.at(1.0).is_code()
    }

    /// Returns how many seconds the computation of `steps` steps from the start takes.
    pub(super) fn seconds(&self, scheme: Scheme, eps: f64, steps: u64) -> f64 {
        self.follow(scheme, eps, None, &mut once(steps), &mut |_, _| ControlFlow::Continue(()))
    }

    /// Follows an orbit from the point `from`, by default `self.start`. Calls `visit` with the
    /// first point and the points at `stops`, until `visit` breaks. Returns the time in seconds.
    pub(super) fn follow(
        &self,
        scheme: Scheme,
        eps: f64,
        from: Option<&[Dd]>,
        stops: StopSteps<'_>,
        visit: PointVisitor<'_>,
    ) -> f64 {
        let exact = |entry: &Dd| &rational(entry.high()) + &rational(entry.low());
        let start = from.map_or_else(|| self.start.clone(), |point| point.iter().map(exact).collect());
        let (map, eps) = (&self.map, &rational(eps));
        match scheme.precision {
            Precision::Single => self.run(scheme, map.at(round::<f32>(eps)), rounded(&start), stops, visit),
            Precision::SingleThroughDouble => {
                let x = rounded::<f32>(&start).into_iter().map(f64::from).collect();
                self.run(scheme, map.through_f64(round(eps)), x, stops, visit)
            }
            Precision::Double => self.run(scheme, map.at(round::<f64>(eps)), rounded(&start), stops, visit),
            Precision::DoubleDouble => {
                self.run(scheme, map.at(round::<Dd>(eps)), rounded(&start), stops, visit)
            }
        }
    }

    fn run<T: RuntimeFloat>(
        &self,
        Scheme { composition, compensated, .. }: Scheme,
        at: MapAt<T>,
        mut x: Vec<T>,
        stops: StopSteps<'_>,
        visit: PointVisitor<'_>,
    ) -> f64
    where
        Dd: From<T>,
    {
        let at = at.composed(composition);
        let (mut carry, mut point) = (vec![T::zero(); x.len()], vec![Dd::default(); x.len()]);
        let mut show = |step: u64, x: &[T]| {
            point.iter_mut().zip(x).for_each(|(entry, x)| *entry = Dd::from(*x));
            visit(step, &point)
        };
        let begun = (self.clock)();
        let mut step = 0;
        let mut go_on = show(step, &x);
        for stop in stops {
            if go_on.is_break() {
                break;
            }
            let advanced = match compensated {
                true => at.advance_with_carry(&mut x, &mut carry, stop - step),
                false => at.advance(&mut x, stop - step),
            };
            advanced.expect("the point has an entry for every variable");
            step = stop;
            go_on = show(step, &x);
        }
        (self.clock)().saturating_sub(begun).as_secs_f64()
    }
}

impl Runner<'_> {
    /// Returns the claimed integrals at this ε; NaN for undefined values.
    pub(super) fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd> {
        let values = self.wide.integrals(&padded(x, |value| value), &Dd::from(eps));
        values.into_iter().map(|value| value.unwrap_or(Dd::from(f64::NAN))).collect()
    }

    /// Returns the coefficients of ε⁰ and ε² of each claimed integral.
    pub(super) fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]> {
        // Dual numbers ε = d + d′ with d² = d′² = 0 give the second derivative as the coefficient
        // of dd′.
        let fixed = |value: Dd| Dual::<_, 1>::from_value(Dual::<_, 1>::from_value(value));
        let eps =
            Dual { value: Dual::coordinate(Dd::from(0.0), 0), gradient: [Dual::from_value(Dd::from(1.0))] };
        let claims = self.wide.extend_scalars(|parameter| fixed(*parameter));
        let half = Dd::from(0.5);
        let coefficients = claims.integrals(&padded(x, fixed), &eps).into_iter().map(|value| match value {
            Some(value) => [value.value.value, value.gradient[0].gradient[0] * half],
            None => [Dd::from(f64::NAN); 2],
        });
        coefficients.collect()
    }
}

/// Converts the coordinates of a point by `number`, and appends zeros up to N coordinates.
fn padded<T: Scalar, const N: usize>(x: &[Dd], number: impl Fn(Dd) -> T) -> SVector<T, N> {
    SVector::from_fn(|i, _| number(x.get(i).copied().unwrap_or_default()))
}

fn rounded<T: Scalar>(x: &[Rational]) -> Vec<T> {
    x.iter().map(round).collect()
}

fn rational(value: f64) -> Rational {
    Rational::from_f64(value).expect("what orbits begin with is finite")
}
