//! A field that is read at run time.

use std::sync::Arc;

use kahan_algebra::derived::Derived;
use kahan_algebra::system::System;

use crate::engine::Engine;
use crate::parameters::values_of;
use crate::{Diagnostics, FieldText, Map, ParameterError, ParameterValue};

/// A quadratic vector field with its map derived.
///
/// Copies share all that is made of it, on whichever thread.
#[derive(Clone, Debug)]
pub struct Field {
    pub(crate) engine: Arc<Engine>,
}

impl Field {
    /// Reads a field in the language of `kahan!`, with or without a header, or as people write
    /// equations, and proves its claims; without a header its free names are parameters.
    ///
    /// Cost: some milliseconds for a field of ordinary size.
    ///
    /// # Errors
    /// The mistakes of the text, false claims among them, as the macro reports them.
    ///
    /// ```
    /// use kahan_runtime::Field;
    ///
    /// let mistake = Field::parse("xdot = x*y; ydot = z*sin(x);").unwrap_err();
    /// assert!(mistake.to_string().contains("1 | xdot = x*y; ydot = z*sin(x);\n"));
    /// ```
    pub fn parse(text: &str) -> Result<Self, Diagnostics> {
        Self::read(&FieldText::new(text.to_owned(), "field".to_owned()))
    }

    /// The same for a text with a name of its own, or a part of one.
    ///
    /// # Errors
    /// As [`parse`](Self::parse).
    pub fn read(text: &FieldText) -> Result<Self, Diagnostics> {
        text.system().map(|system| Self::of(&system))
    }

    /// The field of a system, whose claims are taken as they are.
    #[must_use]
    pub fn of(system: &System) -> Self {
        Field { engine: Arc::new(Engine::new(system)) }
    }

    /// The map at these values of the parameters: pairs of names and numbers, in any order.
    ///
    /// Numbers are taken as they are, and rounded once for each scalar: `f64`, `f32`, integers,
    /// rationals.
    ///
    /// # Errors
    /// [`ParameterError`] for a name that is no parameter, or given twice, or not given, for a
    /// value that is not finite, and where the field divides by zero.
    ///
    /// ```
    /// use kahan_runtime::Field;
    ///
    /// let field = Field::parse("xdot = a*x - b*x*y; ydot = x*y - y;").unwrap();
    /// assert!(field.with([("a", 1.5), ("b", 0.5)]).is_ok());
    /// let missing = field.with([("a", 1)]).unwrap_err();
    /// assert_eq!(missing.to_string(), "the field needs a value for each of its parameters: add one for `b`");
    /// ```
    pub fn with<N, V>(&self, values: impl IntoIterator<Item = (N, V)>) -> Result<Map, ParameterError>
    where
        N: AsRef<str>,
        V: ParameterValue,
    {
        Ok(Map::new(self.clone(), values_of(self.derived(), values)?))
    }

    /// The map of a field without parameters.
    ///
    /// # Errors
    /// [`ParameterError`] where it has some.
    pub fn map(&self) -> Result<Map, ParameterError> {
        self.with::<&str, f64>([])
    }

    /// The state variables, in the order of a state's entries.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.system().field.symbols.states
    }

    /// The parameters, in their order.
    #[must_use]
    pub fn parameters(&self) -> &[String] {
        &self.system().field.symbols.parameters
    }

    /// Whether the field divides by something that depends on parameters or ε.
    pub(crate) fn has_divisors(&self) -> bool {
        self.system().field.components.iter().any(|component| !component.denominator().is_one())
    }

    /// The integrals that are claimed without `when`, in their order.
    #[must_use]
    pub fn integrals(&self) -> &[String] {
        &self.derived().integral_names
    }

    /// The brackets that are claimed without `when`, in their order.
    pub fn brackets(&self) -> impl ExactSizeIterator<Item = &str> {
        self.derived().brackets.iter().map(|(name, _)| name.as_str())
    }

    /// The system that was read.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.derived().system
    }

    /// Every plan of it.
    #[must_use]
    pub fn derived(&self) -> &Derived {
        &self.engine.derived
    }
}
