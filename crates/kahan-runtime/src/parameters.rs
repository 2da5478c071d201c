//! The values of a field's parameters, given by name.
//!
//! In: pairs of names and numbers. Out: one exact number for each parameter, in the order of the
//! field, or an error. A float stands for its exact value.

use core::fmt;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::check::nearest;
use kahan_algebra::derived::Derived;
use kahan_algebra::rational::Rational;
use kahan_core::num_rational::BigRational;

/// A type of numbers that a parameter can have.
pub trait ParameterValue {
    /// Returns the exact value; `None` if it is not finite.
    fn to_rational(&self) -> Option<Rational>;
}

macro_rules! parameter_values {
    ($($number:ty: $exact:expr;)*) => {$(
        impl ParameterValue for $number {
            fn to_rational(&self) -> Option<Rational> {
                $exact(self.clone())
            }
        }
    )*};
}

parameter_values! {
    f64: Rational::from_f64;
    f32: |x| Rational::from_f64(f64::from(x));
    i32: |n| Some(Rational::from(i64::from(n)));
    i64: |n| Some(Rational::from(n));
    Rational: Some;
    BigRational: |q| Some(Rational::from(q));
}

impl<V: ParameterValue> ParameterValue for &V {
    fn to_rational(&self) -> Option<Rational> {
        (**self).to_rational()
    }
}

/// An error in the values of a field's parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParameterError {
    /// The field has no parameter of this name.
    Unknown {
        /// The name given.
        name: String,
        /// The parameter that was probably meant.
        nearest: Option<String>,
        /// The field's parameters.
        parameters: Vec<String>,
    },
    /// Some parameters have no value.
    Missing(
        /// The names of these parameters, in order.
        Vec<String>,
    ),
    /// A parameter is given two values.
    Twice(
        /// The name of the parameter.
        String,
    ),
    /// The value of a parameter is infinite or NaN.
    NotFinite(
        /// The name of the parameter.
        String,
    ),
    /// The field divides by zero at the values of its parameters.
    Undefined(
        /// The name and the value of each parameter.
        Vec<(String, Rational)>,
    ),
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name, nearest, parameters } => {
                write!(f, "the field has no parameter `{name}`")?;
                match (nearest, &parameters[..]) {
                    (Some(nearest), _) => write!(f, "; did you mean `{nearest}`?"),
                    (None, []) => write!(f, ": it has none, so leave it out"),
                    (None, known) => write!(f, "; give a value for {}", quoted(known)),
                }
            }
            Self::Missing(names) => {
                write!(f, "the field needs a value for each of its parameters: add one for {}", quoted(names))
            }
            Self::Twice(name) => write!(f, "the parameter `{name}` is given twice; leave one of them out"),
            Self::NotFinite(name) => {
                write!(f, "the value of the parameter `{name}` is not a finite number; give one that is")
            }
            Self::Undefined(values) => {
                let values: Vec<String> =
                    values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
                write!(f, "the field divides by zero at {}; choose other values", values.join(", "))
            }
        }
    }
}

impl core::error::Error for ParameterError {}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Returns the value of each parameter, in order, after checking that the field is defined there.
pub(crate) fn values_of<N, V>(
    derived: &Derived,
    given: impl IntoIterator<Item = (N, V)>,
) -> Result<Vec<Rational>, ParameterError>
where
    N: AsRef<str>,
    V: ParameterValue,
{
    let names = &derived.system.field.symbols.parameters;
    let values = in_order(names, given, |name, value| {
        value.to_rational().ok_or_else(|| ParameterError::NotFinite(name.to_owned()))
    })?;
    if derived.at_eps_zero().is_defined_at(&Exact, &values, &Rational::ZERO) {
        Ok(values)
    } else {
        Err(ParameterError::Undefined(names.iter().cloned().zip(values).collect()))
    }
}

/// Reads each given value with `read`, and returns the results in the order of `names`.
pub(crate) fn in_order<N, V, R>(
    names: &[String],
    given: impl IntoIterator<Item = (N, V)>,
    read: impl Fn(&str, V) -> Result<R, ParameterError>,
) -> Result<Vec<R>, ParameterError>
where
    N: AsRef<str>,
{
    let mut values: Vec<Option<R>> = names.iter().map(|_| None).collect();
    for (name, value) in given {
        let name = name.as_ref();
        let Some(index) = names.iter().position(|known| known == name) else {
            return Err(ParameterError::Unknown {
                name: name.to_owned(),
                nearest: nearest(name, names).cloned(),
                parameters: names.to_vec(),
            });
        };
        if values[index].is_some() {
            return Err(ParameterError::Twice(name.to_owned()));
        }
        values[index] = Some(read(name, value)?);
    }
    let missing = names.iter().zip(&values).filter(|(_, value)| value.is_none());
    let missing: Vec<String> = missing.map(|(name, _)| name.clone()).collect();
    if missing.is_empty() {
        Ok(values.into_iter().flatten().collect())
    } else {
        Err(ParameterError::Missing(missing))
    }
}
