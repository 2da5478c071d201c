//! A published case: a field, known facts about Kahan's map of the field, and the source.

use std::collections::BTreeMap;

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_algebra::{lexer, read};
use serde::Deserialize;

#[derive(Debug)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) system: System,
    pub(crate) parameters: Vec<(String, Rational)>,
    pub(crate) known: Known,
    /// The reason why the search cannot find a known fact.
    pub(crate) limit: Option<String>,
    /// Published claims in their shortest known form, which are proved when the case is read.
    pub(crate) shortest: Vec<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Known {
    pub(crate) independent_integrals: Option<usize>,
    pub(crate) growth: Option<String>,
    #[serde(default)]
    pub(crate) densities: usize,
    #[serde(default)]
    pub(crate) drifts: usize,
    #[serde(default)]
    pub(crate) bracket_ranks: Vec<usize>,
    pub(crate) seconds: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    name: String,
    #[serde(rename = "source")]
    _source: String,
    field: String,
    #[serde(default)]
    params: BTreeMap<String, i64>,
    known: Known,
    limit: Option<String>,
    #[serde(default)]
    shortest: Vec<String>,
    #[serde(rename = "comment")]
    _comment: Option<String>,
}

impl Case {
    pub(crate) fn read(line: &str) -> Result<Self, String> {
        let Line { name, field, params, known, limit, shortest, .. } =
            serde_json::from_str(line).map_err(|error| error.to_string())?;
        Ok(Case {
            system: proved(&field, &shortest).map_err(|why| format!("{name}: {why}"))?,
            parameters: params.into_iter().map(|(parameter, value)| (parameter, value.into())).collect(),
            name,
            known,
            limit,
            shortest,
        })
    }
}

fn proved(field: &str, claims: &[String]) -> Result<System, String> {
    let read = |text: &str| {
        let reading = read(&lexer::lex(text).tokens);
        match reading.diagnostics() {
            [] => reading.system().map_err(|_| "the field is a family".to_owned()),
            diagnostics => Err(format!("{diagnostics:?}")),
        }
    };
    // Each claim is read in a block of its own, because names may repeat. The block also has the
    // drifts before the claim, to which the claim may refer.
    let mut drifts = String::new();
    for claim in claims {
        read(&format!("{field} {drifts} {claim}")).map_err(|why| format!("{claim} is not proved: {why}"))?;
        if claim.starts_with("drift ") {
            drifts += claim;
        }
    }
    read(field)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Case;

    #[test]
    fn every_case_is_read_and_its_claims_are_proved() {
        let mut names = BTreeSet::new();
        for line in include_str!("cases.jsonl").lines() {
            let case = Case::read(line).unwrap_or_else(|why| panic!("{why}"));
            assert!(names.insert(case.name.clone()), "{} stands there twice", case.name);
        }
        assert!(names.len() >= 85, "{} cases", names.len());
    }

    #[test]
    fn what_is_wrong_with_a_case_is_said() {
        let case = |end: &str| {
            format!(r#"{{"name": "c", "source": "s", "field": "xdot = y; ydot = -x;", "known": {{}}{end}}}"#)
        };
        assert!(Case::read(&case("")).is_ok());
        for (end, why) in [
            (r#", "shortest": ["integral H = x^2 - y^2;"]"#, "integral H = x^2 - y^2; is not proved"),
            (r#", "shortest": "x""#, "expected a sequence"),
            (r#", "params": {"a": 0.5}"#, "expected i64"),
            (r#", "today": 1"#, "unknown field `today`"),
        ] {
            let said = Case::read(&case(end)).expect_err("the case is wrong");
            assert!(said.contains(why), "{said}");
        }
        let said = Case::read(r#"{"name": "c", "field": "xdot = y;", "known": {}}"#);
        assert!(said.expect_err("a source is missing").contains("missing field `source`"));
    }
}
