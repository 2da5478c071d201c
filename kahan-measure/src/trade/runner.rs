//! Orbits of one scene in every kind of arithmetic, behind one face: what chooses and what draws need not know types.

use std::time::Instant;

use kahan_core::__private::Dual;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{
    Dd, FloatScalar, KahanMap, Lift, PreparedStep, QuadraticField, Scalar, StepCost, ThroughF64,
};

use crate::reference::{Limits, NoReference, Reference, Trajectory};
use kahan_runtime::interpreted::{Interpreted, constant};

use super::kind::{Kind, ScalarKind};

/// A system at a starting point.
pub(super) trait Runner {
    /// Shows the first point of an orbit with ε = `eps` and those after the numbers of steps in
    /// `stops`, which grow; the seconds that it took, without the preparations. The orbit begins at
    /// `from`, or at the scene's own point.
    fn follow(&self, kind: Kind, eps: f64, from: Option<&[Dd]>, stops: Stops<'_>, visit: Visit<'_>) -> f64;

    /// The trajectory to compare with.
    fn reference(&self, asked: &Trajectory<'_>, limits: &Limits) -> Result<Reference, NoReference>;

    /// ‖f′(x₀)‖∞
    fn slope(&self) -> f64;

    /// The declared integrals at this ε.
    fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd>;

    /// Their Taylor coefficients at ε = 0: the values, and those of ε².
    fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]>;

    /// What a step of the generated code costs.
    fn cost(&self) -> StepCost;
}

/// What looks at points: the number of steps so far, and the point.
pub(super) type Visit<'a> = &'a mut dyn FnMut(u64, &[Dd]);

/// Numbers of steps, each larger than the one before.
pub(super) type Stops<'a> = &'a mut dyn Iterator<Item = u64>;

/// A map over ℚ, from which every scalar rounds its own, and its first point.
#[derive(Clone, Debug)]
pub(super) struct Subject<M, const N: usize> {
    pub(super) exact: M,
    pub(super) start: SVector<BigRational, N>,
    /// The claims.
    pub(super) claims: Interpreted<BigRational, N>,
    pub(super) cost: StepCost,
}

/// Binds the map, the first point and ε of a kind's scalar.
macro_rules! with_scalar {
    ($subject:expr, $kind:expr, $to:expr, $from:expr, |$map:ident, $start:ident, $eps:ident| $body:expr) => {
        match $kind.scalar {
            ScalarKind::F32 => {
                let ($map, $start, $eps) = $subject.rounded::<f32>($to, $from);
                $body
            }
            ScalarKind::F32ThroughF64 => {
                let (map, $start, $eps) = $subject.rounded::<f32>($to, $from);
                let $map = ThroughF64(map);
                $body
            }
            ScalarKind::F64 => {
                let ($map, $start, $eps) = $subject.rounded::<f64>($to, $from);
                $body
            }
            ScalarKind::Dd => {
                let ($map, $start, $eps) = $subject.rounded::<Dd>($to, $from);
                $body
            }
        }
    };
}

/// Binds the orbit of a kind's order and accumulation.
macro_rules! with_orbit {
    ($map:expr, $start:expr, $eps:expr, $kind:expr, |$orbit:ident| $body:expr) => {
        match ($kind.order, $kind.compensated) {
            (2, false) => {
                let mut $orbit = $map.orbit($start, $eps);
                $body
            }
            (2, true) => {
                let mut $orbit = $map.orbit($start, $eps).compensated();
                $body
            }
            (_, false) => {
                let mut $orbit = $map.orbit($start, $eps).composed($kind.composition());
                $body
            }
            (_, true) => {
                let mut $orbit = $map.orbit($start, $eps).composed($kind.composition()).compensated();
                $body
            }
        }
    };
}

impl<M: Lift<BigRational, N>, const N: usize> Subject<M, N> {
    /// A system whose steps are compiled.
    pub(super) fn compiled(exact: M, start: &[BigRational], claims: Interpreted<BigRational, N>) -> Self {
        let cost = <M::Prepared as PreparedStep<BigRational, N>>::COST;
        Subject { exact, start: SVector::from_fn(|i, _| start[i].clone()), claims, cost }
    }

    /// The map, the first point and ε in another scalar.
    fn rounded<T: FloatScalar>(&self, eps: f64, from: Option<&[Dd]>) -> (M::Lifted<T>, SVector<T, N>, T) {
        let start = SVector::from_fn(|i, _| match from {
            Some(point) => round(&(rational(point[i].high()) + rational(point[i].low()))),
            None => round(&self.start[i]),
        });
        (self.exact.lift(round), start, round(&rational(eps)))
    }

    fn double_double(&self) -> Interpreted<Dd, N> {
        self.claims.rounded()
    }
}

impl<const N: usize> Subject<Interpreted<BigRational, N>, N> {
    /// A system that was read at run time.
    pub(super) fn interpreted(exact: Interpreted<BigRational, N>, start: &[BigRational]) -> Self {
        let cost = exact.cost();
        Subject { claims: exact.clone(), exact, start: SVector::from_fn(|i, _| start[i].clone()), cost }
    }
}

impl<M: Lift<BigRational, N>, const N: usize> Runner for Subject<M, N> {
    fn follow(&self, kind: Kind, eps: f64, from: Option<&[Dd]>, stops: Stops<'_>, visit: Visit<'_>) -> f64 {
        with_scalar!(self, kind, eps, from, |map, start, eps| with_orbit!(map, start, eps, kind, |orbit| {
            let (mut step, mut next) = (0, orbit.next());
            let clock = Instant::now();
            while let Some(point) = next {
                visit(step, point.map(Dd::from).as_slice());
                let Some(stop) = stops.next() else { break };
                next = orbit.nth(index(stop - step - 1));
                step = stop;
            }
            clock.elapsed().as_secs_f64()
        }))
    }

    fn reference(&self, asked: &Trajectory<'_>, limits: &Limits) -> Result<Reference, NoReference> {
        Reference::within(&self.exact.lift::<Dd>(round), asked, limits)
    }

    fn slope(&self) -> f64 {
        let map = self.exact.lift::<f64>(round);
        let slopes = map.field_jacobian(&SVector::from_fn(|i, _| round(&self.start[i])));
        slopes.row_iter().map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max)
    }

    fn integrals(&self, x: &[Dd], eps: f64) -> Vec<Dd> {
        let x = SVector::from_fn(|i, _| x[i]);
        self.double_double().integrals(&x, &Dd::from(eps)).into_iter().map(number).collect()
    }

    fn integrals_at_zero(&self, x: &[Dd]) -> Vec<[Dd; 2]> {
        // ε = d + d′ with d² = d′² = 0: the coefficient of dd′ is the second derivative.
        let fixed = |value: Dd| Dual::<_, 1>::lift(Dual::<_, 1>::lift(value));
        let eps = Dual { value: Dual::coordinate(Dd::from(0.0), 0), gradient: [Dual::lift(Dd::from(1.0))] };
        let x = SVector::from_fn(|i, _| fixed(x[i]));
        let claims = self.double_double().lift(|parameter| fixed(*parameter));
        let half = Dd::from(0.5);
        let coefficients = claims.integrals(&x, &eps).into_iter().map(|value| match value {
            Some(value) => [value.value.value, value.gradient[0].gradient[0] * half],
            None => [number(None); 2],
        });
        coefficients.collect()
    }

    fn cost(&self) -> StepCost {
        self.cost
    }
}

fn round<T: Scalar>(value: &BigRational) -> T {
    T::constant(&constant(&value.clone().into()))
}

/// A float as the number that it is; 0 for what is none.
fn rational(value: f64) -> BigRational {
    BigRational::from_float(value).unwrap_or_else(|| BigRational::from_integer(0.into()))
}

fn number(value: Option<Dd>) -> Dd {
    value.unwrap_or(Dd::from(f64::NAN))
}

/// A number of steps; those beyond the address space are never run.
fn index(steps: u64) -> usize {
    usize::try_from(steps).unwrap_or(usize::MAX)
}
