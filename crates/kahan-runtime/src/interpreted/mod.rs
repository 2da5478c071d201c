//! A run-time system as a map over any scalar, with the traits that generated code implements.
//!
//! In: a [`Map`](crate::Map). Out: a [`KahanMap`](kahan_core::KahanMap) whose results equal those
//! of generated code bit for bit. Code that is generic over maps thus accepts run-time fields;
//! their steps take several times as long as those of compiled fields.

mod dimension;
mod map;
mod step;

use std::marker::PhantomData;
use std::sync::Arc;

use kahan_algebra::plan;
use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{ExtendScalars, Scalar, StepCost};
use smallvec::SmallVec;

use crate::engine::{EliminationPattern, Engine, Factors, MapObject};
use crate::line::{Line, Results, has_value};

pub use crate::literal::round;
pub use dimension::{LARGEST_DIMENSION, Padded, UnsupportedDimension};
pub use step::InterpretedStep;

/// A run-time system over the scalar T in N variables; made by
/// [`Map::as_kahan_map`](crate::Map::as_kahan_map).
///
/// Clones share their field. Two systems are equal if they share their field and have equal
/// parameters.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_runtime::Field;
///
/// let third: BigRational = "1/3".parse().unwrap();
/// let field = Field::parse("xdot = mu*x*y; ydot = x - y;").unwrap();
/// let map = field.with([("mu", third)]).unwrap().as_kahan_map::<f64, 2>().unwrap();
///
/// let mu = 1.0 / 3.0;
/// let compiled = kahan! { xdot = mu*x*y; ydot = x - y; };
/// let x = vector![0.5, -0.25];
/// assert_eq!(map.step(&x, 0.1), compiled.step(&x, 0.1));
/// ```
#[derive(Clone, Debug)]
pub struct Interpreted<T, const N: usize> {
    engine: Arc<Engine>,
    parameters: Arc<[T]>,
    dimension: PhantomData<[(); N]>,
}

impl<const N: usize> Interpreted<BigRational, N> {
    /// Returns the system over another scalar, with each parameter rounded once.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> Interpreted<T, N> {
        self.extend_scalars(|parameter: &BigRational| round(&Rational::from(parameter.clone())))
    }
}

impl<T: Scalar, const N: usize> Interpreted<T, N> {
    /// Wraps a field that is defined at these parameters and has at most N variables.
    pub(crate) fn of(engine: &Arc<Engine>, parameters: Arc<[T]>) -> Self {
        Interpreted { engine: Arc::clone(engine), parameters, dimension: PhantomData }
    }

    /// Returns the cost of a step in the code that `kahan!` generates for this system.
    #[must_use]
    pub fn cost(&self) -> StepCost {
        let of_plan = |plan::StepCost { operations, divisions, critical_path }| StepCost {
            operations,
            divisions,
            critical_path,
        };
        match self.engine.derived.step() {
            Some(step) => of_plan(step.cost()),
            None => {
                let couplings = self.engine.derived.couplings();
                let couplings = couplings.unwrap_or_else(|| unreachable!("it is eliminated"));
                of_plan(couplings.cost(self.engine.derived.field()))
            }
        }
    }

    /// Returns the system with these parameter values, given in the order of declaration. If the
    /// field divides by zero at these values, a float step is not finite, and an exact step panics.
    ///
    /// # Panics
    /// If the number of values is not the number of parameters.
    #[must_use]
    pub fn with_parameters(&self, parameters: &[T]) -> Self {
        assert_eq!(parameters.len(), self.parameters.len(), "a system has as many parameters as it declares");
        Self::of(&self.engine, parameters.into())
    }

    /// Returns the names of the state variables, in order.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.engine.derived.system.field.symbols.states
    }

    /// Returns, in order, the names of the integrals that are claimed without a condition `when`.
    pub fn integral_names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.engine.derived.integral_names.iter().map(String::as_str)
    }

    /// Returns the integrals at x and at ε = `eps`, half the time step. In an exact scalar, an
    /// integral that divides by zero at x is `None`.
    pub fn integrals(&self, x: &SVector<T, N>, eps: &T) -> Vec<Option<T>> {
        let value = |line: &Line| {
            let mut registers = Registers::new();
            let registers = sized(&mut registers, line.registers());
            Some(line.results(self.constants(eps), registers, x.as_slice())?.get(0))
        };
        self.engine.single_integrals().iter().map(value).collect()
    }

    /// Returns x̃ − x by sparse elimination; `None` for a dense field, or if a pivot is small.
    fn along_couplings(&self, state: &[T], eps: &T) -> Option<Vec<T>> {
        let (tables, mut factors) = self.factors(state, eps)?;
        let mut velocity =
            self.list(self.engine.known_line(self.engine.at_eps(MapObject::Field)), state, eps);
        tables.solve(&mut factors, &mut velocity, 1, 0);
        let time_step = eps.clone() + eps.clone();
        Some(velocity.into_iter().map(|entry| time_step.clone() * entry).collect())
    }

    fn factors(&self, state: &[T], eps: &T) -> Option<(&EliminationPattern, Factors<T>)> {
        let (slopes, tables) = self.engine.steps().form(false).couplings()?;
        let mut factors = Factors::default();
        tables.factor(&self.list(slopes, state, eps), eps, &mut factors).then_some((tables, factors))
    }

    fn list(&self, line: &Line, state: &[T], eps: &T) -> Vec<T> {
        self.run(line, state, eps, |results| results.iter().collect())
    }

    fn constants<'a>(&'a self, eps: &'a T) -> impl Iterator<Item = T> + use<'a, T, N> {
        self.parameters.iter().chain([eps]).cloned()
    }

    /// Runs a program and passes its results to `see`.
    ///
    /// # Panics
    /// For exact scalars, at a division by zero.
    fn run<R>(&self, line: &Line, state: &[T], eps: &T, see: impl FnOnce(Results<'_, T>) -> R) -> R {
        let mut registers = Registers::new();
        let registers = sized(&mut registers, line.registers());
        see(has_value(line.results(self.constants(eps), registers, state)))
    }
}

type Registers<T> = SmallVec<[T; 64]>;

/// Resizes the registers and returns them as a slice.
#[inline]
fn sized<T: Scalar>(registers: &mut Registers<T>, size: usize) -> &mut [T] {
    registers.resize(size, T::zero());
    registers.as_mut_slice()
}

impl<T: PartialEq, const N: usize> PartialEq for Interpreted<T, N> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.engine, &other.engine) && self.parameters == other.parameters
    }
}
