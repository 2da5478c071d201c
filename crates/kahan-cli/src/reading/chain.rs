//! Reads a chain with any number of sites: its map, and its first state.

use kahan_algebra::rational::Rational;
use kahan_runtime::Lattice;
use kahan_study::columns::{ExpectedColumns, OtherColumns};
use kahan_study::formula::{Formula, NamedConstants};
use kahan_study::number_file::Numbers;
use kahan_study::{Chain, StudyError};

use super::points::{is_number_file, read};
use super::source::Start;
use super::values::{formula, formulas, named, number};
use crate::printing::{UsageError, joined};

impl Start {
    /// Reads the chain with the initial values that `--start` gives. Variables get names only if
    /// there are at most `most_names` variables.
    pub(crate) fn chain(&self, start: &str, most_names: usize) -> Result<Chain, UsageError> {
        const MOST_SITES: usize = 1 << 28;

        let block = self.source.required_block()?;
        let family = block.family("--start")?;
        let sites = self.source.sites.ok_or_else(|| {
            UsageError::new(
                "--start is for a chain of some number of sites: add --sites N, as in --sites 1000",
            )
        })?;
        if sites.saturating_mul(family.block()) > MOST_SITES {
            return Err(UsageError::new(format!(
                "--sites {sites}: at most {MOST_SITES} numbers are stepped"
            )));
        }
        let eps = self.step.half()?.ok_or(StudyError::MissingStep)?.to_f64();
        if !eps.is_finite() {
            return Err(UsageError::new("the step is beyond the range of f64"));
        }
        let size = ("n".to_owned(), sites as f64);
        let given = self.source.parameters.iter();
        let known = std::slice::from_ref(&size);
        let values: Vec<(&str, Vec<f64>)> =
            given.map(|given| parameter(given, sites, known)).collect::<Result<_, _>>()?;
        let is_other = |(name, _): &&(String, Rational)| values.iter().all(|(given, _)| given != name);
        let own = block.parameters().iter().filter(is_other);
        let own: Vec<_> = own.map(|(name, value)| (name.as_str(), vec![value.to_f64()])).collect();
        let values = [values, own].concat();
        let lattice = Lattice::of(&family);
        let map = lattice
            .at(eps, sites, values.iter().map(|(name, value)| (name, value)))
            .map_err(|error| UsageError::new(format!("--param: {error}")))?;
        let once = |name: &String| {
            let (name, value) = values.iter().find(|(given, _)| given == name)?;
            Some(((*name).to_owned(), *value.first()?))
        };
        let parameters: Vec<(String, f64)> = lattice.parameters().iter().filter_map(once).collect();
        let known: Vec<(String, f64)> = known.iter().chain(&parameters).cloned().collect();
        let state = state(start, lattice.arrays(), sites, &known)?;
        let has_names = map.unknowns() <= most_names;
        let variables = if has_names { family.symbols_at(sites).states } else { Vec::new() };
        let name = family.name().to_owned();
        Ok(Chain { name, variables, map, sites, eps, parameters, state, lattice })
    }
}

/// Reads `--param NAME=V`, in which V gives one number or a number for each site.
fn parameter<'a>(
    given: &'a str,
    sites: usize,
    known: &NamedConstants,
) -> Result<(&'a str, Vec<f64>), UsageError> {
    let (name, value) = named(given, "--param", "c=1/2")?;
    let option = format!("--param {name}");
    if is_number_file(value) {
        let Numbers { names, values, .. } = read(value, &option)?;
        // If the file has several columns, the one with the parameter's name is used.
        let Some(names) = names.filter(|names| names.len() > 1) else { return Ok((name, values)) };
        let wanted = [name.to_owned()];
        let place = ExpectedColumns::new(&wanted, &[], OtherColumns::Ignored).places(&names);
        let place =
            place.map_err(|why| UsageError::new(format!("{option}: the file {value} {why}")))?.states[0];
        return Ok((name, values.into_iter().skip(place).step_by(names.len()).collect()));
    }
    if let Ok(number) = number(value, &option) {
        return Ok((name, vec![number.to_f64()]));
    }
    let formula = formula(value, known, &option)?;
    let places = if formula.last_variable().is_some() { sites } else { 1 };
    let value = formula.function();
    Ok((name, (0..places).map(|site| value(&[site as f64])).collect()))
}

fn state(
    start: &str,
    arrays: &[String],
    sites: usize,
    known: &NamedConstants,
) -> Result<Vec<f64>, UsageError> {
    let state = if is_number_file(start) {
        of_file(start, arrays, sites)?
    } else {
        let formulas = in_order(formulas(start, known, "--start")?, arrays)?;
        let values: Vec<_> = formulas.into_iter().map(Formula::function).collect();
        (0..sites).flat_map(|site| values.iter().map(move |value| value(&[site as f64]))).collect()
    };
    match state.iter().position(|value| !value.is_finite()) {
        Some(place) => {
            let (array, site, value) = (&arrays[place % arrays.len()], place / arrays.len(), state[place]);
            Err(UsageError::new(format!("--start: {array}[{site}] is {value}; a state needs finite numbers")))
        }
        None => Ok(state),
    }
}

fn of_file(path: &str, arrays: &[String], sites: usize) -> Result<Vec<f64>, UsageError> {
    let Numbers { names, sizes, mut values } = read::<f64>(path, "--start")?;
    if let Some(names) = names {
        let places = ExpectedColumns::new(arrays, &[], OtherColumns::Refused).places(&names);
        let places = places.map_err(|why| UsageError::new(format!("--start: the file {path} {why}")))?.states;
        let rows = values.chunks_exact(names.len());
        values = rows.flat_map(|row| places.iter().map(|place| row[*place])).collect();
    }
    // A single array may be a vector or a column. A file of several states gives the last.
    let mut state = vec![sites, arrays.len()];
    let mut found = &sizes[..];
    if arrays.len() == 1 {
        state.pop();
        if found.len() > 1 && found.ends_with(&[1]) && found[..found.len() - 1].ends_with(&[sites]) {
            found = &found[..found.len() - 1];
        }
    }
    if found == state || (found.len() == state.len() + 1 && found[0] > 0 && found[1..] == state) {
        let first = values.len() - sites * arrays.len();
        return Ok(values[first..].to_vec());
    }
    Err(UsageError::new(format!(
        "--start: the file {path} has {} numbers, and {sites} sites take {}: a row a site, each with its {}; of several states \
         the last is taken",
        joined(&sizes, " x "),
        joined([sites, arrays.len()], " x "),
        arrays.join(", ")
    )))
}

fn in_order(given: Vec<(String, Formula)>, arrays: &[String]) -> Result<Vec<Formula>, UsageError> {
    let mut formulas: Vec<Option<Formula>> = vec![None; arrays.len()];
    for (name, formula) in given {
        let Some(index) = arrays.iter().position(|array| *array == name) else {
            let known = arrays.join(", ");
            return Err(UsageError::new(format!(
                "--start: there is no array `{name}`; the family has {known}"
            )));
        };
        if formulas[index].replace(formula).is_some() {
            return Err(UsageError::new(format!("--start: `{name}` is given twice; leave one of them out")));
        }
    }
    let missing = arrays.iter().zip(&formulas).filter(|(_, formula)| formula.is_none());
    let missing = joined(missing.map(|(name, _)| format!("`{name} = …`")), ", ");
    if missing.is_empty() {
        return Ok(formulas.into_iter().flatten().collect());
    }
    Err(UsageError::new(format!(
        "--start: add {missing}; a start is a file F.npy or F.csv, or a formula for each array, as in 'x = 1 + 1/2*cos(2*pi*i/n)'"
    )))
}
