//! A system read at run time as a map over any scalar: the traits of generated code, without
//! generated code.
//!
//! In: a [`Map`](crate::Map). Out: a [`KahanMap`](kahan_core::KahanMap)
//! with the bits of the code that the macro would have written for it, so that everything that is
//! generic over maps (orbits, compositions, the step with a promise) takes fields from the command
//! line too. It runs the same plans in the same order, several times as slowly.

mod code;
mod dimension;
mod literal;
mod map;
mod program;
mod step;
mod unplanned;

use std::marker::PhantomData;
use std::sync::Arc;

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Scalar, StepCost};

use program::{Inputs, Program, Registers};

pub(crate) use code::Code;
pub(crate) use literal::Literal;

pub use dimension::{LARGEST_DIMENSION, UnsupportedDimension, VisitDimension, visit_dimension};
pub use literal::round;
pub use step::InterpretedStep;

/// A system read at run time, over the scalar T in N variables; made by
/// [`Map::as_kahan_map`](crate::Map::as_kahan_map).
///
/// Copies share their programs. Two are equal where they share programs and have equal parameters.
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
    code: Arc<Code>,
    parameters: Arc<[T]>,
    dimension: PhantomData<[(); N]>,
}

impl<const N: usize> Interpreted<BigRational, N> {
    /// The system over another scalar, each parameter rounded once from its exact value.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> Interpreted<T, N> {
        self.over(|parameter: &BigRational| round(&Rational::from(parameter.clone())))
    }
}

impl<T: Scalar, const N: usize> Interpreted<T, N> {
    /// The map at these parameters, at which the field is defined; N is no less than its number of
    /// variables.
    pub(crate) fn of(code: &Arc<Code>, parameters: Arc<[T]>) -> Self {
        Interpreted { code: Arc::clone(code), parameters, dimension: PhantomData }
    }

    /// What a step of the generated code costs.
    #[must_use]
    pub fn cost(&self) -> StepCost {
        self.code.cost
    }

    /// The same system at other parameters, in their order. Where the field divides by zero at
    /// them, a float step is not finite and an exact one panics.
    ///
    /// # Panics
    /// If they are not as many as before.
    #[must_use]
    pub fn with_parameters(&self, parameters: &[T]) -> Self {
        assert_eq!(parameters.len(), self.parameters.len(), "a system has as many parameters as it declares");
        Interpreted { code: Arc::clone(&self.code), parameters: parameters.into(), dimension: PhantomData }
    }

    /// The names of the state variables, in order.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.code.states
    }

    /// The names of the integrals that the block claims without `when`, in order.
    pub fn integral_names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.code.integrals.iter().map(|integral| integral.name.as_str())
    }

    /// The integrals at x; ε, half the time step, is `eps`. `None` for one that divides by zero
    /// there in an exact scalar.
    pub fn integrals(&self, x: &SVector<T, N>, eps: &T) -> Vec<Option<T>> {
        let inputs = Inputs { eps: Some(eps), ..self.inputs(x) };
        let value = |program: &Program| Some(program.run(&inputs, &mut Registers::new())?.get(0));
        self.code.integrals.iter().map(|integral| value(&integral.program)).collect()
    }

    /// The same system over another scalar, each parameter put into it by `lift`.
    #[must_use]
    pub fn over<U>(&self, lift: impl Fn(&T) -> U) -> Interpreted<U, N> {
        let parameters = self.parameters.iter().map(lift).collect();
        Interpreted { code: Arc::clone(&self.code), parameters, dimension: PhantomData }
    }

    /// What a program of the state and the parameters reads.
    fn inputs<'a>(&'a self, x: &'a SVector<T, N>) -> Inputs<'a, T> {
        Inputs { state: x.as_slice(), parameters: &self.parameters, ..Inputs::default() }
    }
}

impl<T: PartialEq, const N: usize> PartialEq for Interpreted<T, N> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.code, &other.code) && self.parameters == other.parameters
    }
}
