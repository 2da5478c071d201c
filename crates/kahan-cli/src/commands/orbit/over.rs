//! Orbits of every start over all values of parameters, ε and coordinates, as one table.
//!
//! In: starts, and ranges by name. Out: for each start and each combination of values an orbit,
//! which begins when its turn comes, so that memory does not grow with its rows.

use kahan_algebra::rational::Rational;
use kahan_study::numbers::ScalarKind;
use kahan_study::{Axis, End, Ending, Exact, Kept, Study, StudyError};
use serde_json::json;

use super::{Orbit, Question};
use crate::printing::{Answer, Refusal};
use crate::reading;

/// The values that the ranges have together, and the field there.
struct Combination {
    study: Study,
    values: Vec<Rational>,
}

impl Orbit {
    /// Writes the orbits over the ranges.
    pub(super) fn over(&self) -> Result<Answer, Refusal> {
        let axes: Vec<Axis> = self.over.iter().map(|text| reading::over(text)).collect::<Result<_, _>>()?;
        let (study, starts, eps) = self.start.starts_over(&axes)?;
        let known = [study.coordinates(), study.parameters(), &["eps".to_owned()]].concat();
        for (place, Axis { name, .. }) in axes.iter().enumerate() {
            if !known.contains(name) {
                let (what, system) = ("neither a variable nor a parameter", study.name().to_owned());
                return Err(StudyError::UnknownAxis { what, system, name: name.clone(), known }.into());
            }
            if axes[..place].iter().any(|other| other.name == *name) {
                return Err(StudyError::AxisTwice { name: name.clone() }.into());
            }
        }
        let combinations = Combination::all(&study, &axes)?;
        let asked = |start: &[Rational], of: &Combination| -> Result<Question, StudyError> {
            let (mut at, mut eps) = (start.to_vec(), eps.clone());
            for (axis, value) in axes.iter().zip(&of.values) {
                let coordinate = study.coordinates().iter().position(|name| *name == axis.name);
                match coordinate {
                    Some(place) => at[place] = value.clone(),
                    None if axis.name == "eps" => eps = Some(value.clone()),
                    None => {}
                }
            }
            Ok(self.question(eps.ok_or(StudyError::MissingStep)?, at))
        };
        // Nothing is written before each value and each start has begun once.
        let first = asked(&starts[0], &combinations[0])?;
        let head = json!(first.begin(&combinations[0].study)?.head);
        for of in &combinations[1..] {
            asked(&starts[0], of)?.begin(&of.study)?;
        }
        for start in &starts[1..] {
            asked(start, &combinations[0])?.begin(&combinations[0].study)?;
        }
        let names: Vec<String> =
            [&"start".to_owned()].into_iter().chain(axes.iter().map(|axis| &axis.name)).cloned().collect();
        let all = starts.iter().enumerate().flat_map(|start| combinations.iter().map(move |of| (start, of)));
        let orbits = all.map(|((index, start), of)| {
            let values = of.values.iter().map(|value| self.cell(value));
            ([Kept::Integer(vec![index as i64])].into_iter().chain(values).collect(), (start, of))
        });
        self.write(head, &names, orbits.collect(), |(start, of), table, watch| {
            let ending = asked(start, of)
                .and_then(|asked| Ok(asked.begin(&of.study)?.rows(0..u64::MAX, table, watch)));
            // An orbit without a first point ends there.
            Ok(ending.unwrap_or_else(|why| Ending {
                end: End::Range(0),
                step: 0,
                why: Some(why.to_string()),
                instead: None,
                note: None,
            }))
        })
    }

    /// A value as it stands in the rows of its orbit.
    fn cell(&self, value: &Rational) -> Kept {
        match self.scalar {
            ScalarKind::Exact => Kept::Exact(vec![Exact::Number(value.into())]),
            _ => Kept::F64(vec![value.to_f64()]),
        }
    }
}

impl Combination {
    /// All of them, the last range running fastest.
    fn all(study: &Study, axes: &[Axis]) -> Result<Vec<Self>, StudyError> {
        let count = axes.iter().try_fold(1_usize, |count, axis| count.checked_mul(axis.range.count()));
        let count = count.filter(|count| *count <= MOST).ok_or(StudyError::ManyPoints { most: MOST })?;
        let names = |axis: &Axis| axis.name == "eps" || study.coordinates().contains(&axis.name);
        let of_field: Vec<bool> = axes.iter().map(|axis| !names(axis)).collect();
        let combination = |index: usize| {
            let mut rest = index;
            let mut values: Vec<Rational> = axes
                .iter()
                .rev()
                .map(|axis| {
                    let value = axis.range.value(rest % axis.range.count());
                    rest /= axis.range.count();
                    value
                })
                .collect();
            values.reverse();
            let own = axes.iter().zip(&values).zip(&of_field).filter(|(_, is_own)| **is_own);
            let own = own.map(|((axis, value), _)| (axis.name.clone(), value.clone()));
            let given: Vec<(String, Rational)> = study.fixed().into_iter().chain(own).collect();
            Ok(Combination { study: study.given_by_name(&given)?, values })
        };
        (0..count).map(combination).collect()
    }
}

/// The most combinations of values, each of which has a map.
const MOST: usize = 1 << 20;
