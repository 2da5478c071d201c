//! What is found at a cell by a question about one point or one map, in a row.
//!
//! In: the question of the cell, and the field at its parameters. Out: entries. What a search finds
//! must not depend on how fast a machine is, so nobody watches, and degrees end it.

use kahan_algebra::rational::Rational;
use kahan_discover::Unwatched;
use kahan_discover::claims::Formula;
use kahan_discover::hilbert::default_degree;

use super::cells::Entry;
use crate::error::StudyError;
use crate::numbers::Number;
use crate::question::{Answer, Question};
use crate::rows::{Column, Kept};
use crate::study::Study;

/// The columns of what is found; none where the question has no row a cell.
pub(super) fn columns(question: &Question, variables: &[String]) -> Vec<(Column, Kept)> {
    let column = |name: &str, meaning: &str| Column { name: name.to_owned(), meaning: meaning.to_owned() };
    let integer = |name: &str, meaning: &str| (column(name, meaning), Kept::Integer(Vec::new()));
    let float = |name: &str, meaning: &str| (column(name, meaning), Kept::F64(Vec::new()));
    let text = |name: &str, meaning: &str| (column(name, meaning), Kept::Text(Vec::new()));
    let each = |before: &str, meaning: &str| {
        variables.iter().map(|name| float(&format!("{before}{name}"), meaning)).collect::<Vec<_>>()
    };
    match question {
        Question::Heights(_) => [
            vec![
                integer("steps", "steps that were made"),
                text(
                    "growth",
                    "how heights grow: bounded, logarithmic, linear, quadratic, exponential or undecided",
                ),
                float("entropy", "logarithm of the last quotient of heights where these grow exponentially"),
            ],
            each("height_", "logarithmic height at the last step, natural logarithm"),
        ]
        .concat(),
        Question::Discover(_) => vec![
            integer("independent_integrals", "number of independent algebraic integrals that were seen"),
            text("growth", "how the degrees of iterates grow"),
            float("entropy", "algebraic entropy"),
            text("integrals", "integrals in the language of kahan!, proved"),
            text("densities", "invariant densities, proved"),
        ],
        Question::Evaluate(_) => [
            each("next_", "value one step later"),
            vec![
                float("det_A", "determinant of the matrix of the step"),
                float("det_jacobian", "determinant of the Jacobian of the map"),
            ],
        ]
        .concat(),
        _ => Vec::new(),
    }
}

/// The question at a cell.
pub(super) fn at(question: &Question, eps: &Rational, at: &[Rational], study: &Study) -> Question {
    let mut question = question.clone();
    match &mut question {
        Question::Heights(asked) => (asked.eps, asked.at) = (eps.clone(), at.to_vec()),
        Question::Evaluate(asked) => (asked.eps, asked.at) = (eps.clone(), at.to_vec()),
        Question::Discover(asked) => {
            asked.eps = Some(eps.clone());
            asked.degree = asked.degree.or(Some(default_degree(study.variables().len())));
        }
        _ => {}
    }
    question
}

/// What is found.
pub(super) fn entries(question: &Question, study: &Study) -> Vec<Entry> {
    let variables = study.variables().len();
    let texts = |formulas: &[Formula]| {
        Entry::Text(formulas.iter().map(|formula| formula.text.as_str()).collect::<Vec<_>>().join("\n"))
    };
    let number = |number: Option<&Number>| Entry::Float(number.map_or(f64::NAN, Number::to_f64));
    let heights = |steps: usize, growth: String, entropy: f64, last: Option<&[f64]>| {
        let last = last.map_or(vec![f64::NAN; variables], <[f64]>::to_vec);
        let growth = [Entry::Integer(steps as i64), Entry::Text(growth), Entry::Float(entropy)];
        growth.into_iter().chain(last.into_iter().map(Entry::Float)).collect()
    };
    match (question, question.ask(study, &Unwatched)) {
        (_, Ok(Answer::Heights(found))) => match found.survey.heights.last() {
            Some(last) => {
                let (growth, entropy) = (found.survey.growth.to_string(), found.survey.entropy);
                heights(found.steps(), growth, entropy, Some(&last.logarithms))
            }
            None => heights(0, "undecided".to_owned(), f64::NAN, None),
        },
        (_, Ok(Answer::Discover(found))) => {
            let report = &found.report;
            vec![
                Entry::Integer(report.independent_integrals() as i64),
                Entry::Text(report.growth.growth.word().to_owned()),
                Entry::Float(report.growth.growth.entropy()),
                texts(&report.integrals),
                texts(&report.densities),
            ]
        }
        (_, Ok(Answer::Evaluate(values))) => {
            let next = |k: usize| number(values.x_next.as_ref().map(|next| &next[k]));
            let det = [number(Some(&values.det_matrix)), number(values.det_jacobian.as_ref())];
            (0..variables).map(next).chain(det).collect()
        }
        (Question::Heights(_), _) => heights(0, "undefined".to_owned(), f64::NAN, None),
        (Question::Discover(_), Err(why)) => {
            let why = match why {
                StudyError::Discover { why, .. } => why.to_string(),
                other => other.to_string(),
            };
            let none = || Entry::Text(String::new());
            vec![Entry::Integer(-1), Entry::Text(why), Entry::Float(f64::NAN), none(), none()]
        }
        _ => vec![Entry::Float(f64::NAN); variables + 2],
    }
}
