//! A published case: a field, facts on its map, and their source.

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_algebra::{lexer, read};
use serde_json::{Map, Value};

/// A field, and published facts on its map.
#[derive(Debug)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) system: System,
    /// The values of fixed parameters.
    pub(crate) parameters: Vec<(String, Rational)>,
    pub(crate) known: Known,
    /// The reason why a known fact is out of reach.
    pub(crate) limit: Option<String>,
    /// Proved claims in their shortest known form.
    pub(crate) shortest: Vec<String>,
}

/// Facts on the map that a publication states.
#[derive(Debug)]
pub(crate) struct Known {
    /// The number of independent integrals, exactly.
    pub(crate) independent_integrals: Option<usize>,
    /// The growth class of degrees, as one word.
    pub(crate) growth: Option<String>,
    /// The least number of densities.
    pub(crate) densities: usize,
    /// The least number of drifts.
    pub(crate) drifts: usize,
    /// Ranks of invariant Poisson brackets.
    pub(crate) bracket_ranks: Vec<usize>,
    /// The most seconds for the whole discovery.
    pub(crate) seconds: Option<f64>,
}

impl Case {
    /// Reads a line of a file of cases, and proves its claims.
    pub(crate) fn read(line: &str) -> Result<Self, String> {
        let value: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
        let entries = Entries::of(&value, "the case")?;
        entries.are_among(&["name", "source", "field", "params", "known", "limit", "shortest", "comment"])?;
        let name = entries.text("name")?.ok_or("a case needs a `name`")?;
        entries.text("source")?.ok_or_else(|| format!("{name}: a case needs a `source`"))?;
        let field = entries.text("field")?.ok_or_else(|| format!("{name}: a case needs a `field`"))?;
        let known = value.get("known").ok_or_else(|| format!("{name}: a case needs `known`"))?;
        let params = value.get("params").map(|params| Entries::of(params, "`params`")).transpose()?;
        let parameters = params.iter().flat_map(|params| params.0).map(|(parameter, value)| {
            let number =
                value.as_i64().ok_or_else(|| format!("{name}: `{parameter}` needs a whole number"))?;
            Ok((parameter.clone(), Rational::from(number)))
        });
        let shortest = entries.list("shortest", |value| value.as_str().map(str::to_owned))?;
        Ok(Case {
            system: proved(&field, &shortest).map_err(|why| format!("{name}: {why}"))?,
            parameters: parameters.collect::<Result<_, String>>()?,
            known: Known::read(known).map_err(|why| format!("{name}: {why}"))?,
            limit: entries.text("limit")?,
            shortest,
            name,
        })
    }
}

impl Known {
    fn read(value: &Value) -> Result<Self, String> {
        let entries = Entries::of(value, "`known`")?;
        let keys = ["independent_integrals", "growth", "densities", "drifts", "bracket_ranks", "seconds"];
        entries.are_among(&keys)?;
        Ok(Known {
            independent_integrals: entries.whole("independent_integrals")?,
            growth: entries.text("growth")?,
            densities: entries.whole("densities")?.unwrap_or(0),
            drifts: entries.whole("drifts")?.unwrap_or(0),
            bracket_ranks: entries.list("bracket_ranks", |value| value.as_u64()?.try_into().ok())?,
            seconds: entries.whole("seconds")?.map(|seconds| seconds as f64),
        })
    }
}

/// The entries of a JSON object.
struct Entries<'a>(&'a Map<String, Value>);

impl<'a> Entries<'a> {
    fn of(value: &'a Value, what: &str) -> Result<Self, String> {
        value.as_object().map(Entries).ok_or_else(|| format!("{what} must be a JSON object"))
    }

    fn are_among(&self, keys: &[&str]) -> Result<(), String> {
        match self.0.keys().find(|key| !keys.contains(&key.as_str())) {
            Some(key) => Err(format!("`{key}` is none of {}", keys.join(", "))),
            None => Ok(()),
        }
    }

    fn text(&self, key: &str) -> Result<Option<String>, String> {
        let text = |value: &Value| value.as_str().map(str::to_owned).ok_or(format!("`{key}` must be a text"));
        self.0.get(key).map(text).transpose()
    }

    fn whole(&self, key: &str) -> Result<Option<usize>, String> {
        let whole = |value: &Value| {
            let number = value.as_u64().and_then(|number| number.try_into().ok());
            number.ok_or(format!("`{key}` must be a whole number"))
        };
        self.0.get(key).map(whole).transpose()
    }

    fn list<T>(&self, key: &str, item: impl Fn(&Value) -> Option<T>) -> Result<Vec<T>, String> {
        let Some(value) = self.0.get(key) else { return Ok(Vec::new()) };
        let items = value.as_array().and_then(|values| values.iter().map(item).collect());
        items.ok_or(format!("`{key}` must be a list"))
    }
}

/// Reads a field and proves claims of it.
fn proved(field: &str, claims: &[String]) -> Result<System, String> {
    let read = |text: &str| {
        let reading = read(&lexer::lex(text).tokens);
        match reading.diagnostics() {
            [] => reading.system().map_err(|_| "the field is a family".to_owned()),
            diagnostics => Err(format!("{diagnostics:?}")),
        }
    };
    // Each claim is read alone, as names may repeat. A drift is read after the earlier drifts,
    // which it may name.
    let mut drifts = String::new();
    for claim in claims {
        read(&format!("{field} {drifts} {claim}")).map_err(|why| format!("{claim} is not proved: {why}"))?;
        if claim.starts_with("drift ") {
            drifts += claim;
        }
    }
    read(field)
}
