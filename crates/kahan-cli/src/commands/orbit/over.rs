//! One table of many orbits: an orbit for each start and each combination of values.

use kahan_algebra::rational::Rational;
use kahan_study::numbers::ScalarKind;
use kahan_study::{Axis, End, Ending, Exact, StoredColumn, Study, StudyError};
use serde_json::json;

use super::{Orbit, Question};
use crate::printing::{Answer, UsageError};
use crate::reading;

struct AxisCombinations<'a> {
    study: &'a Study,
    axes: &'a [Axis],
    count: usize,
    /// One study for each of the first `CACHED_COMBINATIONS` combinations of values.
    few: Vec<Study>,
}

impl Orbit {
    pub(super) fn over(&self) -> Result<Answer, UsageError> {
        let axes: Vec<Axis> = self.over.iter().map(|text| reading::over(text)).collect::<Result<_, _>>()?;
        let (study, starts, eps) = self.start.starts_over(&axes)?;
        let study = self.stepped(&study)?;
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
        let mut all = AxisCombinations::of(&study, &axes)?;
        let asked = |start: &[Rational], values: &[Rational]| -> Result<Question, StudyError> {
            let (mut at, mut eps) = (start.to_vec(), eps.clone());
            for (axis, value) in axes.iter().zip(values) {
                let coordinate = study.coordinates().iter().position(|name| *name == axis.name);
                match coordinate {
                    Some(place) => at[place] = value.clone(),
                    None if axis.name == "eps" => eps = Some(value.clone()),
                    None => {}
                }
            }
            Ok(self.question(eps.ok_or(StudyError::MissingStep)?, at))
        };
        // The arguments of all orbits are checked before the first row, to leave no partial table.
        for index in 0..all.count {
            let study = all.study(index)?;
            asked(&starts[0], &all.values(index))?.begin(&study)?;
            if index < CACHED_COMBINATIONS {
                all.few.push(study);
            }
        }
        let (first, study) = (all.values(0), &all.few[0]);
        let head = json!(asked(&starts[0], &first)?.begin(study)?.head);
        for start in &starts[1..] {
            asked(start, &first)?.begin(study)?;
        }
        let names: Vec<String> =
            [&"start".to_owned()].into_iter().chain(axes.iter().map(|axis| &axis.name)).cloned().collect();
        let count = starts.len() * all.count;
        let orbits = (0..count).map(|index| {
            let (start, index) = (index / all.count, index % all.count);
            let values = all.values(index);
            let cells = values.iter().map(|value| self.cell(value));
            let place = [StoredColumn::Integer(vec![start as i64])].into_iter().chain(cells).collect();
            (place, (&starts[start], index, values))
        });
        self.write(head, &names, orbits, |(start, index, values), table, watch| {
            let ending = asked(start, &values)
                .and_then(|asked| Ok(asked.begin(&all.study(index)?)?.rows(0..u64::MAX, table, watch)));
            Ok(ending.unwrap_or_else(|why| Ending {
                end: End::Range(0),
                step: 0,
                why: Some(why.to_string()),
                instead: None,
                note: None,
            }))
        })
    }

    fn cell(&self, value: &Rational) -> StoredColumn {
        match self.scalar {
            ScalarKind::Exact => StoredColumn::Exact(vec![Exact::Number(value.into())]),
            _ => StoredColumn::F64(vec![value.to_f64()]),
        }
    }
}

impl<'a> AxisCombinations<'a> {
    fn of(study: &'a Study, axes: &'a [Axis]) -> Result<Self, StudyError> {
        let count = axes.iter().try_fold(1_usize, |count, axis| count.checked_mul(axis.range.count()));
        let count = count.filter(|count| *count <= MOST).ok_or(StudyError::ManyPoints { most: MOST })?;
        Ok(AxisCombinations { study, axes, count, few: Vec::new() })
    }

    fn values(&self, index: usize) -> Vec<Rational> {
        let mut rest = index;
        let mut values: Vec<Rational> = self
            .axes
            .iter()
            .rev()
            .map(|axis| {
                let value = axis.range.value(rest % axis.range.count());
                rest /= axis.range.count();
                value
            })
            .collect();
        values.reverse();
        values
    }

    fn study(&self, index: usize) -> Result<Study, StudyError> {
        if let Some(study) = self.few.get(index) {
            return Ok(study.clone());
        }
        let values = self.values(index);
        let names = |axis: &Axis| axis.name == "eps" || self.study.coordinates().contains(&axis.name);
        let own = self.axes.iter().zip(&values).filter(|(axis, _)| !names(axis));
        let own = own.map(|(axis, value)| (axis.name.clone(), value.clone()));
        let given: Vec<(String, Rational)> = self.study.fixed().into_iter().chain(own).collect();
        self.study.given_by_name(&given)
    }
}

const MOST: usize = 1 << 20;

const CACHED_COMBINATIONS: usize = 1024;
