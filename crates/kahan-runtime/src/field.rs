//! A field read at run time.

use std::sync::Arc;

use kahan_algebra::derived::Derived;
use kahan_algebra::system::System;

use crate::engine::Engine;
use crate::machine_code::{InstructionSet, StepKind};
use crate::parameters::values_of;
use crate::{Diagnostics, FieldText, Map, ParameterError, ParameterValue};

/// A quadratic vector field with its derived map. Clones share the derived data.
#[derive(Clone, Debug)]
pub struct Field {
    pub(crate) engine: Arc<Engine>,
}

impl Field {
    /// Reads a field and proves its claims.
    ///
    /// The text is in the language of `kahan!`, with or without a header, or in another common
    /// notation for equations. Without a header, undeclared names are parameters.
    ///
    /// # Errors
    /// [`Diagnostics`] with the mistakes of the text, including false claims.
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

    /// Reads the field in a text, and proves its claims.
    ///
    /// # Errors
    /// [`Diagnostics`], as for [`parse`](Self::parse).
    pub fn read(text: &FieldText) -> Result<Self, Diagnostics> {
        text.system().map(|system| Self::of(&system))
    }

    /// Derives the map of a system; does not prove the claims of the system again.
    #[must_use]
    pub fn of(system: &System) -> Self {
        Field { engine: Arc::new(Engine::new(system)) }
    }

    /// Returns the map at values of the parameters: pairs of names and numbers, in any order.
    ///
    /// Values may be `f64`, `f32`, integers or rationals. In each scalar, a value is rounded once.
    ///
    /// # Errors
    /// [`ParameterError`] for a name that is unknown, missing or given twice, and for a value that
    /// is not finite. A field that divides by zero is an error, too.
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
        Ok(Map::new(self.clone(), values_of(self.derived(), values)?, StepKind::INTERPRETER_FUSES))
    }

    /// Returns the map of a field without parameters.
    ///
    /// # Errors
    /// [`ParameterError`] if the field has parameters.
    pub fn map(&self) -> Result<Map, ParameterError> {
        self.with::<&str, f64>([])
    }

    /// Returns whether [`Map::fused`] returns a map for this field on this processor.
    #[must_use]
    pub fn has_fused_steps(&self) -> bool {
        InstructionSet::least(true).is_available() && self.engine.steps().form(false).has_lanes()
    }

    /// Returns the names of the state variables, in the order of a state's entries.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.system().field.symbols.states
    }

    /// Returns the names of the parameters, in order.
    #[must_use]
    pub fn parameters(&self) -> &[String] {
        &self.system().field.symbols.parameters
    }

    pub(crate) fn has_divisors(&self) -> bool {
        self.system().field.components.iter().any(|component| !component.denominator().is_one())
    }

    /// Returns the names of the integrals that are claimed without a condition `when`, in order.
    #[must_use]
    pub fn integrals(&self) -> &[String] {
        &self.derived().integral_names
    }

    /// Returns the names of the brackets that are claimed without a condition `when`, in order.
    pub fn brackets(&self) -> impl ExactSizeIterator<Item = &str> {
        self.derived().brackets.iter().map(|(name, _)| name.as_str())
    }

    /// Returns the field with its claims.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.derived().system
    }

    /// Returns every plan of the field.
    #[must_use]
    pub fn derived(&self) -> &Derived {
        &self.engine.derived
    }
}
