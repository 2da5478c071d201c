//! A field owned by a Python object: its names, and questions about it.

use std::sync::Mutex;

use kahan_algebra::coefficients::Coefficient;
use kahan_algebra::rational::Rational;
use kahan_judge::Extremes;
use kahan_runtime::{Coefficients, Map, MapAt};
use kahan_study::numbers::number;
use kahan_study::{LiftCriterion, Lifting, Question, Study, StudyError, Subject, Systems};
use numpy::ndarray::ArrayView1;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Eps, Places, doubles, places};
use crate::background::{Listener, run_detached};
use crate::errors::{of_dimension, of_study};
use crate::orbit::wrong_shape;

/// A field with the values of its parameters. `kahan.System` is derived from this class.
#[pyclass(subclass, frozen, module = "kahan._kahan")]
pub(crate) struct Field {
    study: Study,
    last: Mutex<MapCache>,
}

#[derive(Default)]
pub(crate) struct MapCache {
    double: Option<MapAt<f64>>,
    single: Option<MapAt<f32>>,
    with_integrals: Option<MapAt<f64>>,
    /// The parameter values of the last call that gave values, and the map at these values.
    valued: Option<(Vec<Option<f64>>, MapAt<f64>)>,
}

/// A type of floats in NumPy arrays: `f64` or `f32`.
pub(crate) trait Float:
    kahan_runtime::MachineFloat + kahan_core::EmbedScalar + kahan_core::Pivot + numpy::Element
{
    /// Rounds a double, which is Python's float, to this type.
    fn near(number: f64) -> Self;
    /// Returns the entry for this precision in the cache.
    fn last(last: &mut MapCache) -> &mut Option<MapAt<Self>>;
}

impl Float for f64 {
    fn near(number: f64) -> Self {
        number
    }

    fn last(last: &mut MapCache) -> &mut Option<MapAt<f64>> {
        &mut last.double
    }
}

impl Float for f32 {
    fn near(number: f64) -> Self {
        number as f32
    }

    fn last(last: &mut MapCache) -> &mut Option<MapAt<f32>> {
        &mut last.single
    }
}

impl Field {
    pub(crate) fn map(&self, py: Python<'_>) -> PyResult<Map> {
        self.study.map().cloned().map_err(|error| of_study(py, &error))
    }

    /// Returns the map at ε, and caches it.
    pub(crate) fn at<T: Float>(&self, py: Python<'_>, eps: f64) -> PyResult<MapAt<T>> {
        let mut last = self.last.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let last = T::last(&mut last);
        let eps = T::near(eps);
        match last {
            Some(at) if at.eps() == eps => return Ok(at.clone()),
            Some(at) => *last = Some(at.map().at(eps)),
            None => *last = Some(self.map(py)?.at(eps)),
        }
        Ok(last.clone().expect("it was put there"))
    }

    /// Returns the map with all its integrals, also those that are claimed only at this ε.
    pub(crate) fn with_integrals(&self, py: Python<'_>, eps: f64) -> PyResult<MapAt<f64>> {
        let mut last = self.last.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(at) = last.with_integrals.as_ref().filter(|at| at.eps() == eps) {
            return Ok(at.clone());
        }
        // Claims may need an exact ε. Parse the decimal of `eps`; NaN and infinity become 0.
        let exact = number(&eps.to_string()).unwrap_or_else(|_| Rational::zero());
        let at = self.study.at_step(&exact).and_then(|study| Ok(study.map()?.at(eps)));
        let at = at.map_err(|error| of_study(py, &error))?;
        last.with_integrals = Some(at.clone());
        Ok(at)
    }

    /// Returns the map at eps = 0 with these parameter values, and caches the map.
    pub(crate) fn valued(&self, py: Python<'_>, values: &[Option<f64>]) -> PyResult<MapAt<f64>> {
        if values.iter().all(Option::is_none) {
            return self.at(py, 0.0);
        }
        let mut last = self.last.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some((_, at)) = last.valued.as_ref().filter(|(known, _)| known == values) {
            return Ok(at.clone());
        }
        let given: Vec<Vec<f64>> = values.iter().map(|value| value.iter().copied().collect()).collect();
        let at: MapAt<f64> = self.map_with(py, &given)?.at(0.0);
        let own = at.map().parameters().iter().map(Rational::to_f64);
        let constants: Vec<f64> = values.iter().zip(own).map(|(value, own)| value.unwrap_or(own)).collect();
        let constants: Vec<&[f64]> = constants.iter().map(std::slice::from_ref).collect();
        let at = at.each(&[], &constants).map_err(|error| of_dimension(&error))?.swap_remove(0);
        last.valued = Some((values.to_vec(), at.clone()));
        Ok(at)
    }
}

impl Field {
    pub(crate) fn study(&self) -> &Study {
        &self.study
    }

    pub(crate) fn dimension(&self) -> usize {
        self.study.variables().len()
    }

    /// Builds the error for points of a wrong shape.
    pub(crate) fn wrong_points(&self, name: &str, wanted: &[&str], found: &[usize]) -> PyErr {
        let shown = self.study.shown().len();
        let given = found.iter().enumerate().map(|(axis, size)| {
            let is_embedded = axis + 1 == found.len() && *size == self.dimension();
            if is_embedded { shown } else { *size }
        });
        let wanted = match wanted {
            [] => format!("({shown},)"),
            axes => format!("({}, {shown})", axes.join(", ")),
        };
        wrong_shape(name, &wanted, &given.collect::<Vec<_>>())
    }

    pub(crate) fn parameter(&self, k: usize) -> &str {
        &self.study.parameters()[k]
    }

    /// Returns the map. If parameter k was given no value, the first number in `first[k]` is used.
    pub(crate) fn map_with<T: Float>(&self, py: Python<'_>, first: &[Vec<T>]) -> PyResult<Map> {
        if self.study.given().iter().all(Option::is_some) {
            return self.map(py);
        }
        let field = self.study.field();
        let own = self.study.valued();
        let values =
            self.study.parameters().iter().zip(self.study.given()).enumerate().map(|(k, (name, given))| {
                let other = first.get(k).and_then(|values| values.first());
                // NaN and infinity become 1 here, and callers replace this 1 by the float.
                let exactly =
                    |value: &T| Rational::from_f64(value.approximate()).unwrap_or_else(Rational::one);
                let other = other.map(exactly);
                Ok((name, given.clone().or(other).or_else(|| own[k].clone()).ok_or(name)?))
            });
        match values.collect::<Result<Vec<_>, &String>>() {
            Ok(values) => field.with(values).map_err(|error| PyValueError::new_err(error.to_string())),
            Err(_) => self.map(py),
        }
    }
}

/// The options of a lift: the criterion, the values and the names of an initial point, the initial
/// time, and whether arrays contain the new variables.
type Lift = (String, Option<(Vec<String>, Vec<String>)>, String, bool);

fn lifting((which, start, time, shows_all): Lift) -> PyResult<Lifting> {
    let known = LiftCriterion::ALL.iter().find(|one| one.name() == which);
    let which = *known.ok_or_else(|| {
        let names: Vec<&str> = LiftCriterion::ALL.iter().map(|one| one.name()).collect();
        PyValueError::new_err(format!("lift: there is no `{which}`; there are True and {}", names.join(", ")))
    })?;
    let read = |what: &str, value: &str| {
        number(value).map_err(|why| PyValueError::new_err(format!("{what}: {why}")))
    };
    let (start, names) = start.map_or((None, Vec::new()), |(start, names)| (Some(start), names));
    let start = start.map(|start| start.iter().map(|value| read("at", value)).collect::<PyResult<Vec<_>>>());
    let (start, time) = (start.transpose()?, read("t0", &time)?);
    Ok(Lifting { which, start, names, time, shows_all, ..Lifting::default() })
}

#[derive(FromPyObject)]
enum FieldSource<'py> {
    Text(String),
    /// The names of states and parameters, and the columns of `kahan._coefficients.Entries`.
    Coefficients(Vec<String>, Vec<String>, Columns<'py>),
}

/// The component, the two states, the parameter and the value of each coefficient; −1 stands for no
/// parameter.
type Columns<'py> = (Indices<'py>, Indices<'py>, Indices<'py>, Indices<'py>, PyReadonlyArray1<'py, f64>);
type Indices<'py> = PyReadonlyArray1<'py, i64>;

impl FieldSource<'_> {
    fn subject(&self, py: Python<'_>, is_name: bool) -> PyResult<Subject> {
        let (states, parameters, columns) = match self {
            FieldSource::Text(text) if is_name => return Ok(Subject::named(text.as_str())),
            FieldSource::Text(text) => return Ok(Subject::text(text.as_str())),
            FieldSource::Coefficients(states, parameters, columns) => (states, parameters, columns),
        };
        let names = Coefficients::new(states, parameters);
        let mut field = names.map_err(|error| of_study(py, &StudyError::Field(error)))?;
        let (component, first, second, parameter, values) = columns;
        let [component, first, second, parameter] =
            [component, first, second, parameter].map(|one| one.as_array());
        for (at, value) in values.as_array().iter().enumerate() {
            let index = |of: &ArrayView1<'_, i64>| usize::try_from(of[at]).ok();
            let states = [index(&first), index(&second)];
            let component = index(&component).unwrap_or(usize::MAX);
            let added = field.add(component, states, index(&parameter), *value);
            added.map_err(|error| PyValueError::new_err(error.to_string()))?;
        }
        Ok(Subject::block(field.text()))
    }
}

pub(crate) fn question(json: &str) -> PyResult<Question> {
    serde_json::from_str(json).map_err(|error| PyValueError::new_err(error.to_string()))
}

#[pymethods]
impl Field {
    /// Reads a field from its name, its text or its coefficients. If `of` is given, returns a copy
    /// of `of` with other parameter values, which shares the compiled code of `of`.
    #[new]
    #[pyo3(signature = (text, *, is_name = false, sites = None, parameters = Vec::new(), lift = None, fused = false, of = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        py: Python<'_>,
        text: FieldSource<'_>,
        is_name: bool,
        sites: Option<usize>,
        parameters: Vec<(String, String)>,
        lift: Option<Lift>,
        fused: bool,
        of: Option<PyRef<'_, Field>>,
    ) -> PyResult<Self> {
        let exactly = |(name, value): (String, String)| match number(&value) {
            Ok(value) => Ok((name, value)),
            Err(why) => Err(PyValueError::new_err(format!("{name}: {why}"))),
        };
        let parameters = parameters.into_iter().map(exactly).collect::<PyResult<Vec<_>>>()?;
        if let Some(of) = of {
            let study = of.study.given_by_name(&parameters).and_then(|study| study.fusing(fused));
            let study = study.map_err(|error| of_study(py, &error))?;
            return Ok(Field { study, last: Mutex::default() });
        }
        let subject = text.subject(py, is_name)?;
        let subject = sites.into_iter().fold(subject, Subject::sites).fusing(fused);
        let lifting = lift.map(lifting).transpose()?;
        let subject = lifting.into_iter().fold(subject, Subject::lifting);
        let subject =
            parameters.into_iter().fold(subject, |subject, (name, value)| subject.with(name, value));
        let study = run_detached(py, Some(1), &Listener(None), move |_| {
            let study = subject.study(&Systems)?;
            study.proved()?;
            Ok(study)
        })?;
        Ok(Field { study: study.map_err(|error| of_study(py, &error))?, last: Mutex::default() })
    }

    /// The name of the field in answers.
    #[getter]
    fn name(&self) -> &str {
        self.study.name()
    }

    /// Whether steps in floats use fused multiply-adds.
    #[getter]
    fn fused(&self) -> bool {
        self.study.fuses()
    }

    /// The text in the language of `kahan!`.
    #[getter]
    fn text(&self) -> &str {
        self.study.text()
    }

    /// For each coefficient, returns the component, two states (−1 for none) and the value.
    #[pyo3(name = "_coefficients")]
    fn coefficients(&self, py: Python<'_>) -> PyResult<([Vec<i64>; 3], Vec<f64>)> {
        let coefficients = self.study.coefficients().map_err(|error| of_study(py, &error))?;
        let of = |index: &dyn Fn(&Coefficient) -> Option<usize>| {
            coefficients.iter().map(|one| index(one).map_or(-1, |index| index as i64)).collect()
        };
        let indices = [of(&|one| Some(one.component)), of(&|one| one.states[0]), of(&|one| one.states[1])];
        Ok((indices, coefficients.iter().map(|one| one.value.to_f64()).collect()))
    }

    /// The variables whose values arrays contain: the original variables, and the new variables of
    /// a lift if they were requested.
    #[getter]
    fn variables(&self) -> Vec<&str> {
        self.study.shown().iter().map(String::as_str).collect()
    }

    /// Finds the columns of the variables among these names. Errors mention `name`.
    #[pyo3(name = "_matched")]
    fn columns(&self, names: Vec<String>, name: &str, varies: bool) -> PyResult<Places> {
        let states = (self.study.shown(), self.study.coordinates().len());
        places(&names, states, self.study.parameters(), varies, name)
    }

    /// All variables; formulas may use each of them.
    #[getter(_all_variables)]
    fn all_variables(&self) -> Vec<&str> {
        self.study.variables().iter().map(String::as_str).collect()
    }

    /// The description of the lift as JSON; None for a field without a lift.
    #[getter(_lift)]
    fn lift(&self, py: Python<'_>) -> PyResult<Option<String>> {
        let found = self.study.lift_found(None).map_err(|error| of_study(py, &error))?;
        Ok(found.map(|found| serde_json::to_string(&found).expect("answers are JSON")))
    }

    /// The initial time, and the index of `t` among all variables if the lift made it a variable.
    #[getter(_time)]
    fn time(&self) -> (f64, Option<usize>) {
        (self.study.time().to_f64(), self.study.time_place())
    }

    /// The index, among all variables, of each variable that arrays have.
    #[getter(_places)]
    pub(crate) fn places(&self) -> Vec<usize> {
        self.study.project(&(0..self.study.variables().len()).collect::<Vec<_>>())
    }

    /// Extends points to all variables. A parameter has one number, one number for each point, or
    /// `None` for the field's own value.
    #[pyo3(name = "_embedded", signature = (x, parameters = Vec::new(), time = None))]
    pub(crate) fn embedded<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        parameters: Vec<Option<Bound<'py, PyAny>>>,
        time: Option<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = x.py();
        let x = doubles(x, "x")?;
        let mut sizes = x.shape().to_vec();
        let known = [self.study.coordinates().len(), self.study.shown().len(), self.dimension()];
        let width = sizes.pop().filter(|width| known.contains(width));
        let Some(width) = width else {
            return Err(wrong_shape("x", &format!("(…, {})", self.study.shown().len()), x.shape()));
        };
        let given = parameters.iter().map(|given| match given {
            Some(given) => Ok(doubles(given, "params")?.as_slice()?.to_vec()),
            None => Ok(Vec::new()),
        });
        let given = given.collect::<PyResult<Vec<Vec<f64>>>>()?;
        let own = self.study.valued();
        let value = |point: usize, k: usize| match given.get(k).map_or(&[][..], Vec::as_slice) {
            [] => own[k].as_ref().map(Rational::to_f64),
            [one] => Some(*one),
            many => many.get(point).copied(),
        };
        let mut all = Vec::new();
        for (point, at) in x.as_slice()?.chunks_exact(width.max(1)).enumerate() {
            let values = (0..own.len()).map(|k| value(point, k)).collect::<Option<Vec<f64>>>();
            let Some(values) = values else {
                let missing = self.study.values().err();
                let missing = missing.map(|error| of_study(py, &error));
                return Err(missing.unwrap_or_else(|| PyValueError::new_err("params: a value is missing")));
            };
            all.extend(self.study.embed_at(at, &values, time.unwrap_or_else(|| self.study.time().to_f64())));
        }
        sizes.push(self.dimension());
        Ok(PyArray1::from_vec(py, all).reshape(sizes)?.into_any())
    }

    /// Warns if errors of a lift's relations grow on the orbit of `x`.
    #[pyo3(name = "_relations_warning")]
    fn relations_warning(&self, x: &Bound<'_, PyAny>, eps: Eps) -> PyResult<Option<String>> {
        let x = doubles(x, "x")?;
        let at: Option<Vec<Rational>> = x.as_slice()?.iter().map(|x| Rational::from_f64(*x)).collect();
        Ok(at.and_then(|at| self.study.relations_warning(&at, eps.0)))
    }

    /// Returns a note if components change too fast for steps of 2ε at some of the points `x`.
    #[pyo3(name = "_rates_note")]
    fn rates_note(&self, x: &Bound<'_, PyAny>, eps: Eps) -> PyResult<Option<String>> {
        let x = doubles(x, "x")?;
        let Some(mut rates) = self.study.rates(eps.0) else { return Ok(None) };
        let stride = rates.stride(x.shape()[0] as u64) as usize;
        x.as_slice()?.chunks_exact(rates.variables().max(1)).step_by(stride).for_each(|x| rates.inspect(x));
        Ok(rates.note())
    }

    /// Notes about unusual interpretations of the text, and a warning about the lift.
    #[getter]
    fn notes(&self) -> Vec<String> {
        let warning = self.study.lift().and_then(kahan_study::Lift::warning);
        self.study.notes().iter().cloned().chain(warning).collect()
    }

    /// The initial point in the text of the field. Its coordinates are given as text.
    #[getter(_start)]
    fn start(&self) -> Option<Vec<String>> {
        Some(self.study.start()?.iter().map(Rational::to_string).collect())
    }

    /// The parameters with their values as text; `None` for a missing value.
    #[getter(_given)]
    fn given(&self) -> Vec<(&str, Option<String>)> {
        let values = self.study.valued().into_iter().map(|value| value.map(|value| value.to_string()));
        self.study.parameters().iter().map(String::as_str).zip(values).collect()
    }

    /// Answers a question. Question and answer are JSON; `listener` receives reports of progress.
    #[pyo3(name = "_answer", signature = (asked, *, threads = None, listener = None))]
    fn ask(
        &self,
        py: Python<'_>,
        asked: &str,
        threads: Option<usize>,
        listener: Option<Bound<'_, PyAny>>,
    ) -> PyResult<String> {
        let (question, study) = (question(asked)?, self.study.clone());
        let answer = run_detached(py, threads, &Listener(listener), move |caller| {
            let answer = study.ask(&question, caller)?;
            Ok(serde_json::to_string(&answer).expect("answers are JSON"))
        })?;
        answer.map_err(|error| of_study(py, &error))
    }

    /// Tests steps at extreme points, and returns the results as JSON.
    #[pyo3(name = "_judged", signature = (trials, seed, *, listener = None))]
    fn judged(
        &self,
        py: Python<'_>,
        trials: u64,
        seed: u64,
        listener: Option<Bound<'_, PyAny>>,
    ) -> PyResult<String> {
        let (asked, study) = (Extremes { trials, seed, ..Extremes::default() }, self.study.clone());
        let judged = run_detached(py, None, &Listener(listener), move |caller| asked.of(&[study], caller))?;
        let judged = judged.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(serde_json::to_string(&judged).expect("answers are JSON"))
    }
}
