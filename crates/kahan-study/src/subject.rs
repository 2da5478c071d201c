//! The subject of a question: a field, parameter values, the number of sites of a family, and
//! options such as a lift.

use std::collections::BTreeMap;

use kahan_algebra::rational::Rational;
use kahan_lift::LiftCriterion;
use kahan_runtime::FieldText;
use serde::de::Error;
use serde::{Deserialize, Deserializer};

use crate::lifted::Lifting;
use crate::numbers::exact;

/// A field given by a user.
///
/// In JSON a subject has a `name` in the catalog or a text `field`, and optionally `params`,
/// `sites`, a `lift` and `fused`: `{"field": "xdot = y; ydot = a - x^2;", "params": {"a": "1/2"}}`.
///
/// ```
/// use kahan_algebra::rational::Rational;
/// use kahan_study::{Subject, Systems};
///
/// let swing = Subject::text("xdot = y; ydot = a - x^2;").with("a", Rational::from(1));
/// assert_eq!(swing.study(&Systems).unwrap().variables(), ["x", "y"]);
/// assert!(Subject::named("e6").study(&Systems).is_ok());
/// ```
#[derive(Clone, Debug)]
pub struct Subject {
    pub(crate) field: SubjectSource,
    pub(crate) parameters: Vec<(String, Rational)>,
    pub(crate) sites: Option<usize>,
    pub(crate) lifting: Option<Lifting>,
    pub(crate) fuses: bool,
}

#[derive(Clone, Debug)]
pub(crate) enum SubjectSource {
    /// A name in a catalog.
    Name(String),
    /// A text in the language of `kahan!`.
    Text(FieldText),
}

/// A collection of named fields.
pub trait Catalog {
    /// Returns the name and the type name of every system and family.
    fn names(&self) -> Vec<[&'static str; 2]>;

    /// Finds a system or family by one of its names, in upper or lower case.
    fn find(&self, name: &str) -> Option<Named>;
}

/// A field of a catalog.
#[derive(Clone, Debug)]
pub struct Named {
    /// The name in answers.
    pub name: &'static str,
    /// The name of its type in Rust; `None` for a family.
    pub type_name: Option<&'static str>,
    /// A description of one line.
    pub title: &'static str,
    /// The block in the language of `kahan!`.
    pub text: &'static str,
    /// The source of each claim, by the claim's name.
    pub sources: &'static [(&'static str, &'static str)],
}

impl Subject {
    /// Selects a system or a family of the catalog.
    #[must_use]
    pub fn named(name: impl Into<String>) -> Self {
        Self::of(SubjectSource::Name(name.into()))
    }

    /// Reads a field in the language of `kahan!` or in the usual notation of equations. Values of
    /// parameters in the text are defaults.
    #[must_use]
    pub fn text(text: impl Into<String>) -> Self {
        Self::block(FieldText::new(text.into(), "field".to_owned()))
    }

    /// Creates a subject from the text of a field.
    #[must_use]
    pub fn block(text: FieldText) -> Self {
        Self::of(SubjectSource::Text(text))
    }

    fn of(field: SubjectSource) -> Self {
        Subject { field, parameters: Vec::new(), sites: None, lifting: None, fuses: false }
    }

    /// Gives a parameter a value.
    #[must_use]
    pub fn with(mut self, name: impl Into<String>, value: Rational) -> Self {
        self.parameters.push((name.into(), value));
        self
    }

    /// Sets the number of sites of a family, whose chain is then written out.
    #[must_use]
    pub fn sites(self, sites: usize) -> Self {
        Subject { sites: Some(sites), ..self }
    }

    /// Lifts to a quadratic field, so that equations may have functions, quotients and powers.
    ///
    /// ```
    /// use kahan_study::{Subject, Systems, LiftCriterion};
    ///
    /// let pendulum = Subject::text("xdot = v; vdot = -sin(x);").lifted(LiftCriterion::Automatic);
    /// let pendulum = pendulum.study(&Systems).unwrap();
    /// assert_eq!(pendulum.coordinates(), ["x", "v"]);
    /// assert_eq!(pendulum.variables(), ["x", "v", "sin_x", "cos_x"]);
    /// ```
    #[must_use]
    pub fn lifted(self, which: LiftCriterion) -> Self {
        self.lifting(Lifting { which, ..Lifting::default() })
    }

    /// Lifts the field to a quadratic field, with the given options.
    #[must_use]
    pub fn lifting(self, lifting: Lifting) -> Self {
        Subject { lifting: Some(lifting), ..self }
    }

    /// Selects whether steps in floats fuse multiply-adds; see [`Map::fused`](kahan_runtime::Map).
    #[must_use]
    pub fn fusing(self, fuses: bool) -> Self {
        Subject { fuses, ..self }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Object {
    name: Option<String>,
    field: Option<String>,
    #[serde(default)]
    params: BTreeMap<String, Value>,
    sites: Option<usize>,
    lift: Option<String>,
    #[serde(default)]
    fused: bool,
}

#[derive(Deserialize)]
struct Value(#[serde(with = "exact")] Rational);

impl<'de> Deserialize<'de> for Subject {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Object { name, field, params, sites, lift, fused } = Object::deserialize(deserializer)?;
        let subject = match (name, field) {
            (Some(name), None) => Subject::named(name),
            (None, Some(text)) => Subject::text(text),
            _ => return Err(D::Error::custom("a subject has either `name` or `field`")),
        };
        let subject =
            params.into_iter().fold(subject, |subject, (name, Value(value))| subject.with(name, value));
        let which = |name: String| {
            let known = LiftCriterion::ALL.into_iter().find(|which| which.name() == name);
            known.ok_or_else(|| D::Error::custom(format!("`{name}` is no lift; there is `automatic`")))
        };
        let lifting = lift.map(which).transpose()?.map(|which| Lifting { which, ..Lifting::default() });
        Ok(Subject { sites, lifting, fuses: fused, ..subject })
    }
}
