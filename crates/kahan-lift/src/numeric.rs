//! Coordinates and their gradients in floats.
//!
//! Elementary functions are those of `libm`, without fused operations, so that values have the
//! same bits on every processor.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational_function::RationalFunction;

use crate::laurent::Laurent;
use crate::quadratic::Quadratic;
use crate::ring::{Function, Meaning, Ring};

/// A Laurent polynomial with coefficients in floats.
#[derive(Clone, Debug)]
pub(crate) struct NumericLaurent(Vec<(f64, Vec<(usize, i32)>)>);

impl NumericLaurent {
    /// The polynomial with these values of the parameters.
    pub(crate) fn new(polynomial: &Laurent, parameters: &[f64]) -> Self {
        let powers = |monomial: &crate::laurent::Monomial| {
            monomial.powers().map(|(coordinate, exponent)| (coordinate, i32::from(exponent))).collect()
        };
        NumericLaurent(
            polynomial.terms().map(|(one, value)| (coefficient(value, parameters), powers(one))).collect(),
        )
    }

    /// The value.
    pub(crate) fn value(&self, coordinates: &[f64]) -> f64 {
        self.0.iter().fold(0.0, |sum, (coefficient, powers)| {
            let product =
                |product, &(at, exponent): &(usize, i32)| product * power(coordinates[at], exponent);
            sum + powers.iter().fold(*coefficient, product)
        })
    }

    /// Adds the gradient by the states to `sum`, times `factor`.
    fn add_gradient(&self, coordinates: &[f64], gradients: &[Vec<f64>], factor: f64, sum: &mut [f64]) {
        for (coefficient, powers) in &self.0 {
            for (place, &(at, exponent)) in powers.iter().enumerate() {
                let mut slope =
                    factor * coefficient * f64::from(exponent) * power(coordinates[at], exponent - 1);
                for (other, &(at, exponent)) in powers.iter().enumerate() {
                    if other != place {
                        slope *= power(coordinates[at], exponent);
                    }
                }
                sum.iter_mut().zip(&gradients[at]).for_each(|(sum, gradient)| *sum += slope * gradient);
            }
        }
    }
}

/// base^exponent by squaring.
pub(crate) fn power(base: f64, exponent: i32) -> f64 {
    let power = num_traits::pow(base, exponent.unsigned_abs() as usize);
    if exponent < 0 { 1.0 / power } else { power }
}

/// The value of a coefficient.
pub(crate) fn coefficient(value: &RationalFunction, parameters: &[f64]) -> f64 {
    let polynomial = |polynomial: &Polynomial| {
        polynomial.terms().fold(0.0, |sum, (monomial, number)| {
            let powers = monomial.powers().iter();
            sum + powers.fold(number.to_f64(), |product, &(parameter, exponent)| {
                product * power(parameters[usize::from(parameter.0)], exponent.cast_signed())
            })
        })
    };
    polynomial(value.numerator()) / polynomial(value.denominator())
}

#[derive(Clone, Debug)]
enum Kind {
    State,
    Function(Function),
    Root(i16),
    Power(f64),
    Sum,
}

/// A ring with values of its parameters.
#[derive(Clone, Debug)]
pub(crate) struct Numeric {
    coordinates: Vec<(Kind, NumericLaurent, NumericLaurent)>,
    field: Vec<NumericLaurent>,
    parameters: Vec<f64>,
}

impl Numeric {
    /// The ring with these values of the parameters.
    pub(crate) fn new(ring: &Ring, parameters: &[f64]) -> Self {
        let laurent = |polynomial: &Laurent| NumericLaurent::new(polynomial, parameters);
        let nothing = Laurent::zero();
        let coordinates = ring.coordinates.iter().map(|coordinate| {
            let kind = match &coordinate.meaning {
                Meaning::State(_) => Kind::State,
                Meaning::Function(function, _) => Kind::Function(*function),
                Meaning::Root(_, index) => Kind::Root(*index),
                Meaning::Power(_, exponent) => Kind::Power(self::coefficient(exponent, parameters)),
                Meaning::Sum(_) => Kind::Sum,
            };
            let argument = coordinate.meaning.argument().unwrap_or(&nothing);
            (kind, laurent(argument), laurent(&coordinate.slope))
        });
        Numeric {
            coordinates: coordinates.collect(),
            field: ring.field.iter().map(laurent).collect(),
            parameters: parameters.to_vec(),
        }
    }

    /// A polynomial with the values of the parameters.
    pub(crate) fn laurent(&self, polynomial: &Laurent) -> NumericLaurent {
        NumericLaurent::new(polynomial, &self.parameters)
    }

    /// The coordinates at a point.
    pub(crate) fn coordinates(&self, states: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = states.to_vec();
        for (kind, argument, _) in &self.coordinates[states.len()..] {
            let argument = argument.value(&values);
            values.push(match kind {
                Kind::State | Kind::Sum => argument,
                Kind::Function(function) => function.at(argument),
                Kind::Root(1) => argument,
                Kind::Root(2) => libm::sqrt(argument),
                Kind::Root(3) => libm::cbrt(argument),
                Kind::Root(index) => libm::pow(argument, 1.0 / f64::from(*index)),
                Kind::Power(exponent) => libm::pow(argument, *exponent),
            });
        }
        values
    }

    /// The gradients of the coordinates by the states.
    pub(crate) fn gradients(&self, coordinates: &[f64]) -> Vec<Vec<f64>> {
        let states = self.field.len();
        let mut gradients: Vec<Vec<f64>> = Vec::new();
        for (index, (kind, argument, slope)) in self.coordinates.iter().enumerate() {
            let mut gradient = vec![0.0; states];
            if matches!(kind, Kind::State) {
                gradient[index] = 1.0;
            } else {
                argument.add_gradient(coordinates, &gradients, slope.value(coordinates), &mut gradient);
            }
            gradients.push(gradient);
        }
        gradients
    }

    /// The gradient of a polynomial by the states.
    pub(crate) fn gradient(
        &self,
        of: &NumericLaurent,
        coordinates: &[f64],
        gradients: &[Vec<f64>],
    ) -> Vec<f64> {
        let mut gradient = vec![0.0; self.field.len()];
        of.add_gradient(coordinates, gradients, 1.0, &mut gradient);
        gradient
    }

    /// The field at a point.
    pub(crate) fn field(&self, states: &[f64]) -> Vec<f64> {
        let coordinates = self.coordinates(states);
        self.field.iter().map(|component| component.value(&coordinates)).collect()
    }
}

/// A quadratic polynomial with values of its parameters, as products of variables.
pub(crate) fn quadratic(
    polynomial: &Quadratic,
    parameters: &[f64],
) -> Vec<(Option<usize>, Option<usize>, f64)> {
    polynomial.0.iter().map(|(&(left, right), value)| (left, right, coefficient(value, parameters))).collect()
}
