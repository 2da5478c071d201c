//! A field that was read, about which questions can be asked.

use std::fmt::Display;
use std::sync::{Arc, OnceLock};

use kahan_algebra::coefficients::Coefficient;
use kahan_algebra::interpret::Interpreter;
use kahan_algebra::kahan::RationalMap;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Formulas, Text};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, Condition, System};
use kahan_runtime::{Field, FieldText, Map, MapAt};

use crate::error::StudyError;
use crate::lifted::Lifted;
use crate::range::Axis;
use crate::subject::{Catalog, Named, Subject, SubjectSource};

/// The most variables of a chain whose equations are written out.
pub const MOST_VARIABLES: usize = 200;

/// The reason why a point has no image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoStep {
    /// Kahan's map in lowest terms has a pole at the point.
    Pole,
    /// The matrix of Kahan's map is singular at the point. The map has too many terms to be
    /// reduced, so the image may exist nevertheless.
    Unreduced,
    /// The image is beyond the range of the scalar.
    Range,
}

/// A field with parameter values, usable from any thread. Clones share all computed data.
#[derive(Clone, Debug)]
pub struct Study {
    read: Arc<ReadField>,
    here: Arc<MapAtParameters>,
}

#[derive(Clone, Debug)]
struct ReadField {
    named: Option<Named>,
    text: FieldText,
    sites: Option<usize>,
    lifted: Option<Lifted>,
    system: System,
    proved: OnceLock<Result<(), StudyError>>,
    field: OnceLock<Field>,
    interpreter: OnceLock<Interpreter>,
    /// Whether steps in floats use fused multiply-adds.
    fuses: bool,
}

#[derive(Debug)]
struct MapAtParameters {
    /// The values, in the order of the parameters; `None` for a value not given.
    given: Vec<Option<Rational>>,
    map: OnceLock<Map>,
}

impl Subject {
    /// Reads the field. The map is derived when a question first needs it.
    ///
    /// # Errors
    /// An unknown system, a text with mistakes, or an unknown parameter.
    pub fn study(&self, catalog: &dyn Catalog) -> Result<Study, StudyError> {
        let (named, text) = match &self.field {
            SubjectSource::Text(text) => (None, text.clone()),
            SubjectSource::Name(name) => {
                let named = catalog.find(name).ok_or_else(|| StudyError::unknown_system(name, catalog))?;
                let text = FieldText::new(named.text.to_owned(), named.name.to_owned());
                (Some(named), text)
            }
        };
        let (lifted, text, system) = match (&self.lifting, self.sites) {
            (Some(lifting), None) => {
                let (lifted, text, system) = Lifted::of(&text, lifting, &self.parameters)?;
                (Some(lifted), text, system)
            }
            (_, Some(sites)) => {
                let system = chain(&text, sites)?;
                (None, text, system)
            }
            (None, None) => {
                let system = text.unproved_system().map_err(StudyError::Field)?;
                (None, text, system)
            }
        };
        let read = ReadField {
            named,
            text,
            sites: self.sites,
            lifted,
            system,
            proved: OnceLock::new(),
            field: OnceLock::new(),
            interpreter: OnceLock::new(),
            fuses: false,
        };
        Study::new(Arc::new(read), Vec::new()).given_by_name(&self.parameters)?.fusing(self.fuses)
    }
}

impl Study {
    fn new(read: Arc<ReadField>, given: Vec<Option<Rational>>) -> Self {
        Study { read, here: Arc::new(MapAtParameters { given, map: OnceLock::new() }) }
    }

    /// Returns a study whose answers show the new variables of a lift.
    #[must_use]
    pub fn showing_all(&self) -> Self {
        let lifted = self.lifted().map(Lifted::showing_all);
        let read = ReadField { lifted, ..(*self.read).clone() };
        Study { read: Arc::new(read), here: Arc::clone(&self.here) }
    }

    /// Returns a study with fused multiply-adds in float steps if `fuses`; see [`Map::fused`].
    ///
    /// # Errors
    /// [`StudyError::NoFusedSteps`] if the field has no fused steps on this processor.
    pub fn fusing(&self, fuses: bool) -> Result<Self, StudyError> {
        if fuses == self.fuses() {
            return Ok(self.clone());
        }
        if fuses && !self.field().has_fused_steps() {
            return Err(StudyError::NoFusedSteps { system: self.name().to_owned() });
        }
        Ok(Study::new(Arc::new(ReadField { fuses, ..(*self.read).clone() }), self.here.given.clone()))
    }

    /// Returns whether [`fusing`](Self::fusing) selected fused multiply-adds for steps in floats.
    #[must_use]
    pub fn fuses(&self) -> bool {
        self.read.fuses
    }

    /// Returns the name in the catalog, or else the name of the type, or else `field`.
    #[must_use]
    pub fn name(&self) -> &str {
        self.entry().map_or_else(|| self.system().name(), |named| named.name)
    }

    /// Returns the name in the catalog, for a field from the catalog.
    #[must_use]
    pub fn catalog_name(&self) -> Option<&'static str> {
        self.read.named.as_ref().map(|named| named.name)
    }

    /// Returns the description in the catalog, for a system of the catalog.
    #[must_use]
    pub fn title(&self) -> Option<&'static str> {
        self.entry().map(|named| named.title)
    }

    /// Returns the source that the catalog cites for a claim.
    #[must_use]
    pub fn source(&self, claim: &str) -> Option<&'static str> {
        let sources = self.entry()?.sources;
        sources.iter().find(|(name, _)| *name == claim).map(|(_, source)| *source)
    }

    /// Returns the name of the field if it is a catalog system without given parameter values.
    #[must_use]
    pub fn as_it_stands(&self) -> Option<&'static str> {
        self.entry().filter(|_| self.given().iter().all(Option::is_none)).map(|named| named.name)
    }

    /// Returns the random seed with which the macro proves the claims of this field.
    #[must_use]
    pub fn seed(&self) -> [u8; 32] {
        self.read.text.seed()
    }

    /// Returns the entry of a system in the catalog; `None` for a family.
    fn entry(&self) -> Option<&Named> {
        self.read.named.as_ref().filter(|named| named.type_name.is_some())
    }

    /// Returns the name of the type in Rust, from the catalog or from the header of the text.
    #[must_use]
    pub fn type_name(&self) -> Option<&str> {
        let of_catalog = self.entry().and_then(|named| named.type_name);
        of_catalog.or_else(|| self.system().header.as_ref().map(|header| header.name.text.as_str()))
    }

    /// Returns the text of the field in the language of `kahan!`.
    #[must_use]
    pub fn text(&self) -> &str {
        self.read.text.text()
    }

    pub(crate) fn lifted(&self) -> Option<&Lifted> {
        self.read.lifted.as_ref()
    }

    fn given_text(&self) -> &FieldText {
        self.lifted().map_or(&self.read.text, |lifted| &lifted.given)
    }

    /// Returns notes on unusual interpretations of the text.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        self.given_text().notes()
    }

    /// Returns the first point of the text, if the text gives a first value to each variable.
    #[must_use]
    pub fn start(&self) -> Option<Vec<Rational>> {
        self.coordinates().iter().map(|state| named(self.given_text().start(), state)).collect()
    }

    /// Returns the value of each parameter: the given value, or else the value in the text.
    #[must_use]
    pub fn valued(&self) -> Vec<Option<Rational>> {
        let own = |name| named(self.given_text().parameters(), name);
        let values = self.parameters().iter().zip(self.given());
        values.map(|(name, given)| given.clone().or_else(|| own(name))).collect()
    }

    /// Returns the state variables, in order.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.system().field.symbols.states
    }

    /// Returns the parameters, in order.
    #[must_use]
    pub fn parameters(&self) -> &[String] {
        &self.system().field.symbols.parameters
    }

    /// Returns the checked system, with claims not yet proved.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.read.system
    }

    /// Returns the system after proving its claims as the macro does, or the claims that do not
    /// hold.
    pub fn proved(&self) -> Result<&System, StudyError> {
        let proof = || match self.read.sites {
            // The claims of a family were proved for all chain lengths when the family was read.
            Some(_) => Ok(()),
            None => self.read.text.prove(self.system()).map_err(StudyError::Field),
        };
        self.read.proved.get_or_init(proof).clone()?;
        Ok(self.system())
    }

    /// Returns the values of the parameters, in order; `None` for a value not given.
    #[must_use]
    pub fn given(&self) -> &[Option<Rational>] {
        &self.here.given
    }

    /// Returns the study with these parameter values only; all earlier given values are dropped.
    /// Both studies use the same proofs and plans.
    ///
    /// # Errors
    /// An unknown name, or a name given twice.
    pub fn given_by_name(&self, values: &[(String, Rational)]) -> Result<Self, StudyError> {
        let mut given = vec![None; self.parameters().len()];
        for (name, value) in values {
            if given[self.parameter(name)?].replace(value.clone()).is_some() {
                return Err(StudyError::ParameterTwice { name: name.clone() });
            }
        }
        Ok(self.at(given))
    }

    pub(crate) fn parameter(&self, name: &str) -> Result<usize, StudyError> {
        let place = self.parameters().iter().position(|known| known == name);
        place.ok_or_else(|| StudyError::UnknownParameter {
            system: self.name().to_owned(),
            name: name.to_owned(),
            known: self.parameters().to_vec(),
        })
    }

    pub(crate) fn with(&self, place: usize, value: Rational) -> Self {
        let mut given = self.given().to_vec();
        given[place] = Some(value);
        self.at(given)
    }

    /// Returns the study at this ε. Claims whose condition `when` holds at this ε become
    /// unconditional.
    ///
    /// # Errors
    /// Claims that do not hold, or a field that divides by zero.
    pub fn at_step(&self, eps: &Rational) -> Result<Self, StudyError> {
        let is_open = |claim: &Claim| !claim.is_unconditional();
        if !self.proved()?.claims.iter().any(is_open) {
            return Ok(self.clone());
        }
        let here = self.at(self.valued()).specialised()?;
        let symbol = here.field.symbols.epsilon();
        let is_here =
            |condition: &Condition| condition.variable == symbol && condition.number().as_ref() == Some(eps);
        let holds = |claim: &Claim| {
            here.claims
                .iter()
                .any(|own| own.name.text == claim.name.text && own.conditions.iter().all(is_here))
        };
        if !self.system().claims.iter().any(|claim| is_open(claim) && holds(claim)) {
            return Ok(self.clone());
        }
        let mut system = self.system().clone();
        for place in 0..system.claims.len() {
            // A field has at most one unconditional density. A second density keeps its condition.
            let claim = &system.claims[place];
            let is_second =
                claim.kind == ClaimKind::Density && system.accessors(ClaimKind::Density).next().is_some();
            if is_open(claim) && holds(claim) && !is_second {
                system.claims[place].conditions.clear();
            }
        }
        let (field, interpreter) = (OnceLock::new(), OnceLock::new());
        let read = ReadField { system, field, interpreter, ..ReadField::clone(&self.read) };
        Ok(Study::new(Arc::new(read), self.given().to_vec()))
    }

    /// Returns the study at other values of the parameters. Both use the same proofs and plans.
    pub(crate) fn at(&self, given: Vec<Option<Rational>>) -> Self {
        Study::new(Arc::clone(&self.read), given)
    }

    /// Returns the parameters that have given values; the other parameters are generic.
    #[must_use]
    pub fn fixed(&self) -> Vec<(String, Rational)> {
        let values = self.parameters().iter().zip(self.given());
        values.filter_map(|(name, value)| Some((name.clone(), value.clone()?))).collect()
    }

    /// Returns the system with the given parameters substituted; the other parameters stay symbols.
    /// Claims that do not apply at these values are dropped.
    ///
    /// # Errors
    /// The field divides by zero at the values.
    pub fn specialised(&self) -> Result<System, StudyError> {
        let given = self.given().iter().cloned().enumerate();
        let fixed: Vec<(usize, Rational)> = given.filter_map(|(k, value)| Some((k, value?))).collect();
        if fixed.is_empty() {
            return Ok(self.system().clone());
        }
        self.system().specialise(&fixed).ok_or_else(|| self.undefined_field())
    }

    /// Returns the coefficients of the field at the values of its parameters.
    ///
    /// # Errors
    /// A missing value, a division by zero, or coefficients that depend on ε.
    pub fn coefficients(&self) -> Result<Vec<Coefficient>, StudyError> {
        let values = self.values()?;
        let system = self.at(values.into_iter().map(Some).collect()).specialised()?;
        if system.field.depends_on_eps() {
            return Err(StudyError::CoefficientsOfEps { system: self.name().to_owned() });
        }
        system.coefficients().ok_or_else(|| self.undefined_field())
    }

    /// Returns the values of all parameters, in order. Fails if a value is missing.
    pub fn values(&self) -> Result<Vec<Rational>, StudyError> {
        self.values_but(|_| false)
    }

    /// Returns the values of the parameters; those for which `varies` returns true need no value.
    pub(crate) fn values_but(&self, varies: impl Fn(usize) -> bool) -> Result<Vec<Rational>, StudyError> {
        let values = self.valued();
        let missing = (0..values.len()).filter(|k| values[*k].is_none() && !varies(*k));
        let names: Vec<String> = missing.map(|k| self.parameters()[k].clone()).collect();
        if names.is_empty() {
            Ok(values.into_iter().map(Option::unwrap_or_default).collect())
        } else {
            Err(StudyError::MissingParameters { system: self.name().to_owned(), names })
        }
    }

    pub(crate) fn axis(&self, axis: &Axis) -> Result<Option<usize>, StudyError> {
        let place = self.parameters().iter().position(|name| *name == axis.name);
        if place.is_some() || axis.name == "eps" {
            return Ok(place);
        }
        Err(self.unknown("no parameter", &axis.name, &[self.parameters(), &["eps".to_owned()]]))
    }

    pub(crate) fn variable(&self, name: &str) -> Result<usize, StudyError> {
        let place = self.variables().iter().position(|known| known == name);
        place.ok_or_else(|| self.unknown("no variable", name, &[self.variables()]))
    }

    pub(crate) fn unknown(&self, what: &'static str, name: &str, known: &[&[String]]) -> StudyError {
        let (system, name, known) = (self.name().to_owned(), name.to_owned(), known.concat());
        StudyError::UnknownAxis { what, system, name, known }
    }

    /// Extends a point to all variables. The given point may have a coordinate for each variable,
    /// or for each original variable of a lifted field.
    ///
    /// # Errors
    /// A wrong number of coordinates, or a new variable that is undefined at the point.
    pub fn point(&self, at: &[Rational]) -> Result<Vec<Rational>, StudyError> {
        self.has_coordinates(at)?;
        self.embedded(at)
    }

    pub(crate) fn has_coordinates(&self, at: &[Rational]) -> Result<(), StudyError> {
        let variables = self.coordinates();
        if [self.variables(), variables, self.shown()].iter().any(|known| known.len() == at.len()) {
            return Ok(());
        }
        Err(StudyError::Coordinates { what: "at", variables: variables.to_vec(), given: at.len() })
    }

    /// Returns the field. The first call derives the map.
    #[must_use]
    pub fn field(&self) -> &Field {
        self.read.field.get_or_init(|| Field::of(self.system()))
    }

    /// Returns the component ẋ of the field for a variable x, as a formula.
    pub fn rate(&self, variable: &str) -> Result<String, StudyError> {
        let place = self.variable(variable)?;
        let field = &self.system().field;
        Ok(Formulas { field, map: None, notation: &Text }.field().swap_remove(place))
    }

    /// Returns the map at the values of the parameters, with its plans and compiled code.
    ///
    /// # Errors
    /// A missing value, or a field that divides by zero.
    pub fn map(&self) -> Result<&Map, StudyError> {
        if let Some(map) = self.here.map.get() {
            return Ok(map);
        }
        let map = self.map_at(&self.values()?).ok_or_else(|| self.undefined_field())?;
        Ok(self.here.map.get_or_init(|| map))
    }

    /// Returns the map at other values of the parameters; `None` if the field divides by zero.
    pub(crate) fn map_at(&self, values: &[Rational]) -> Option<Map> {
        let map = self.field().with(self.parameters().iter().zip(values)).ok()?;
        if self.fuses() { map.fused() } else { Some(map) }
    }

    pub(crate) fn in_floats(
        &self,
        at: &[Rational],
        eps: &Rational,
    ) -> Result<(MapAt<f64>, Vec<f64>), StudyError> {
        let (point, map) = (self.point(at)?, self.map()?);
        let start: Vec<f64> = point.iter().map(Rational::to_f64).collect();
        let eps = eps.to_f64();
        self.within_range(&start, eps)?;
        Ok((map.at(eps), start))
    }

    pub(crate) fn within_range(&self, at: &[f64], eps: f64) -> Result<(), StudyError> {
        let beyond = at.iter().zip(self.variables()).find(|(value, _)| !value.is_finite());
        match beyond {
            Some((_, variable)) => {
                Err(StudyError::OutOfRange { what: "at", variable: Some(variable.clone()) })
            }
            None if eps.is_finite() => Ok(()),
            None => Err(StudyError::OutOfRange { what: "eps", variable: None }),
        }
    }

    /// Describes a point together with the parameters and ε; shortens long numbers.
    #[must_use]
    pub fn place(&self, at: &[impl Display], eps: &Rational) -> String {
        let values = self.valued();
        let parameters = self.parameters().iter().zip(values.iter().flatten());
        assigned(self.variables().iter().zip(at))
            .chain(assigned(parameters))
            .chain(assigned([("eps", eps)]))
            .collect::<Vec<_>>()
            .join(", ")
    }

    /// Returns why a point with det A = 0 has no known image: a pole, or a map too large to reduce.
    pub(crate) fn pole(&self) -> NoStep {
        if RationalMap::of(&self.system().field).is_some() { NoStep::Pole } else { NoStep::Unreduced }
    }

    pub(crate) fn interpreter(&self) -> &Interpreter {
        self.read.interpreter.get_or_init(|| Interpreter::new(self.system()))
    }

    pub(crate) fn undefined_field(&self) -> StudyError {
        StudyError::UndefinedField { system: self.name().to_owned(), parameters: self.fixed() }
    }

    pub(crate) fn undefined_field_at(&self, eps: &Rational) -> StudyError {
        let eps = self.system().field.depends_on_eps().then(|| ("eps".to_owned(), eps.clone()));
        let parameters = self.fixed().into_iter().chain(eps).collect();
        StudyError::UndefinedField { system: self.name().to_owned(), parameters }
    }
}

fn named(values: &[(String, Rational)], name: &String) -> Option<Rational> {
    values.iter().find(|(known, _)| known == name).map(|(_, value)| value.clone())
}

/// Formats `x = 1`, `y = 2`, …; shortens long numbers to their first digits.
pub(crate) fn assigned<N: Display, V: Display>(
    values: impl IntoIterator<Item = (N, V)>,
) -> impl Iterator<Item = String> {
    const DIGITS: usize = 40;
    values.into_iter().map(|(name, value)| {
        let value = value.to_string();
        match value.char_indices().nth(DIGITS) {
            Some(_) => format!("{name} = {}…", &value[..DIGITS - 1]),
            None => format!("{name} = {value}"),
        }
    })
}

/// Builds the system of a chain with this number of sites, with proved claims.
fn chain(text: &FieldText, sites: usize) -> Result<System, StudyError> {
    let family = text.family().map_err(StudyError::Field)?.ok_or(StudyError::NoFamily)?;
    if sites.saturating_mul(family.block()) > MOST_VARIABLES {
        return Err(StudyError::ManySites { sites });
    }
    family.at_sites(sites).ok_or_else(|| StudyError::UndefinedField {
        system: family.name().to_owned(),
        parameters: vec![("sites".to_owned(), Rational::from(sites as i64))],
    })
}
