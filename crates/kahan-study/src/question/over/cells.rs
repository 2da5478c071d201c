//! Computes the point, parameters and ε of a cell (a combination of axis values) from its number.

use kahan_algebra::rational::Rational;

use super::at_cell::column;
use super::axis::{AxisOver, Values};
use super::{Over, Question};
use crate::error::StudyError;
use crate::rows::{Column, StoredColumn};
use crate::study::Study;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::question) enum VariedQuantity {
    Variable(usize),
    Parameter(usize),
    Epsilon,
    Order,
    Scalar,
}

pub(in crate::question) struct ResolvedAxis<'a> {
    axis: &'a AxisOver,
    pub(in crate::question) target: VariedQuantity,
    values: Values<'a>,
}

/// Point, parameters and ε of a cell.
#[derive(Clone, Debug)]
pub(in crate::question) struct CellInputs<V> {
    pub(in crate::question) at: Vec<V>,
    pub(in crate::question) parameters: Vec<V>,
    pub(in crate::question) eps: V,
}

/// The cells (combinations of axis values) of a question. From one cell to the next, drawn axes
/// change first, then the last axis, and so on to the first axis; first points change last.
pub(in crate::question) struct Cells<'a> {
    pub(in crate::question) axes: Vec<ResolvedAxis<'a>>,
    /// The last `with_starts` axes have a value for each first point. The other axes are combined
    /// with all first points.
    with_starts: usize,
    starts: &'a [Vec<Rational>],
    /// Point, parameters and ε in the question, used unless an axis replaces them.
    exactly: CellInputs<Rational>,
    in_doubles: CellInputs<f64>,
    draws: u64,
    pub(in crate::question) count: u64,
}

/// The largest number of cells. The number of each cell must fit into an `i64`.
const MAX_CELLS: u64 = 1 << 62;

impl<'a> Cells<'a> {
    pub(super) fn of(over: &'a Over, study: &Study) -> Result<Self, StudyError> {
        Self::with_starts(over, 0, study)
    }

    /// Builds the cells. The last `with_starts` axes have one value for each first point, and do
    /// not multiply the number of cells.
    pub(in crate::question) fn with_starts(
        over: &'a Over,
        with_starts: usize,
        study: &Study,
    ) -> Result<Self, StudyError> {
        let (eps, at) = over.begins(study)?;
        let of = |place: usize| resolve_axis(over, place, study);
        let axes = (0..over.over.len()).map(of).collect::<Result<Vec<_>, _>>()?;
        let does_not_fit = |start: &&Vec<Rational>| start.len() != at.len();
        over.starts.iter().find(does_not_fit).map_or(Ok(()), |start| study.has_coordinates(start))?;
        for (place, along) in axes.iter().enumerate() {
            let is_start = matches!(along.target, VariedQuantity::Variable(_)) && !over.starts.is_empty();
            if is_start || axes[..place].iter().any(|other| other.target == along.target) {
                return Err(StudyError::AxisTwice { name: along.axis.name.clone() });
            }
        }
        let varies = |k: usize| axes.iter().any(|along| along.target == VariedQuantity::Parameter(k));
        let exactly = CellInputs { at, parameters: study.values_but(varies)?, eps };
        let rounded = |numbers: &[Rational]| numbers.iter().map(Rational::to_f64).collect::<Vec<_>>();
        let in_doubles = CellInputs {
            at: rounded(&exactly.at),
            parameters: rounded(&exactly.parameters),
            eps: exactly.eps.to_f64(),
        };
        let draws = if axes.iter().any(|along| along.values.count().is_none()) { over.draws } else { 1 };
        let (multiplied, beside) = axes.split_at(axes.len() - with_starts);
        let starts = over.starts.len().max(1) as u64;
        if let Some(along) = beside.iter().find(|along| along.values.count() != Some(starts)) {
            let why = format!("one value for each of the {starts} first points is needed");
            return Err(StudyError::AxisValues { name: along.axis.name.clone(), why });
        }
        let counts = multiplied.iter().filter_map(|along| along.values.count());
        let counts = counts.chain([draws, over.starts.len().max(1) as u64]);
        let count = counts.fold(1, |count: u64, own| count.saturating_mul(own));
        match count {
            0 => Err(StudyError::NotPositive { what: "draws", value: Rational::zero() }),
            1..=MAX_CELLS => {
                Ok(Cells { axes, with_starts, starts: &over.starts, exactly, in_doubles, draws, count })
            }
            _ => Err(StudyError::ManyPoints { most: MAX_CELLS as usize }),
        }
    }

    /// Returns whether most consecutive cells differ only in their first points.
    pub(super) fn neighbours_share_a_map(&self) -> bool {
        let is_start = |along: &ResolvedAxis<'_>| matches!(along.target, VariedQuantity::Variable(_));
        if self.draws > 1 {
            return self.axes.iter().filter(|along| along.values.count().is_none()).all(is_start);
        }
        let last = self.axes.iter().rev().find(|along| along.varies());
        last.map_or(!self.starts.is_empty(), is_start)
    }

    /// Returns the columns that describe a cell: its number, its first point, the varying axes.
    pub(super) fn columns(&self, variables: &[String]) -> Vec<(Column, StoredColumn)> {
        let index = column("index", "place of the point in the plan, from 0 on", StoredColumn::Integer);
        let starts = if self.starts.is_empty() { &[] } else { variables };
        let starts = starts.iter().map(|name| column(name, STARTS, StoredColumn::F64));
        let axes = self.axes.iter().filter(|along| along.varies()).map(|along| {
            let name = &along.axis.name;
            match along.target {
                VariedQuantity::Variable(_) => column(name, STARTS, StoredColumn::F64),
                VariedQuantity::Parameter(_) => column(name, "value of the parameter", StoredColumn::F64),
                VariedQuantity::Epsilon => {
                    column(name, "half the time step, in units of time", StoredColumn::F64)
                }
                VariedQuantity::Order => column(name, "order of the method", StoredColumn::Integer),
                VariedQuantity::Scalar => column(name, "scalar of the orbit: f64 or f32", StoredColumn::Text),
            }
        });
        [index].into_iter().chain(starts).chain(axes).collect()
    }

    pub(super) fn entries(&self, index: u64, place: &CellInputs<f64>, values: &[f64]) -> Vec<CellEntry> {
        let starts = if self.starts.is_empty() { &[] } else { &place.at[..] };
        let varying = self.axes.iter().zip(values).filter(|(along, _)| along.varies());
        let axes = varying.map(|(along, &value)| match along.target {
            VariedQuantity::Order => CellEntry::Integer(value as i64),
            VariedQuantity::Scalar => CellEntry::Text(if value == 32.0 { "f32" } else { "f64" }.to_owned()),
            _ => CellEntry::Float(value),
        });
        let starts = starts.iter().map(|value| CellEntry::Float(*value));
        [CellEntry::Integer(index as i64)].into_iter().chain(starts).chain(axes).collect()
    }

    /// Returns the names of the varying axes. An axis of a variable x, which sets first points, is
    /// called `start_x`.
    pub(in crate::question) fn names(&self) -> Vec<String> {
        let names = self.axes.iter().filter(|along| along.varies()).map(|along| match along.target {
            VariedQuantity::Variable(_) => format!("start_{}", along.axis.name),
            _ => along.axis.name.clone(),
        });
        names.collect()
    }

    pub(in crate::question) fn varying(&self, values: &[f64]) -> Vec<f64> {
        let varying = self.axes.iter().zip(values).filter(|(along, _)| along.varies());
        varying.map(|(_, value)| *value).collect()
    }

    /// Returns the index of a cell's first point in the list of first points.
    pub(in crate::question) fn start(&self, index: u64) -> u64 {
        index / (self.count / self.starts.len().max(1) as u64)
    }

    /// Returns the number of values on the last axis, not counting the `with_starts` axes.
    pub(in crate::question) fn last_count(&self) -> u64 {
        let multiplied = &self.axes[..self.axes.len() - self.with_starts];
        multiplied.last().and_then(|along| along.values.count()).unwrap_or(1)
    }

    /// Returns point, parameters and ε of a cell in doubles, and the value of each axis.
    pub(in crate::question) fn in_doubles(&self, index: u64) -> (CellInputs<f64>, Vec<f64>) {
        self.place(index, &self.in_doubles, Rational::to_f64, Values::double)
    }

    pub(in crate::question) fn exactly(&self, index: u64) -> CellInputs<Rational> {
        self.place(index, &self.exactly, Rational::clone, Values::exactly).0
    }

    fn place<V: Clone>(
        &self,
        index: u64,
        base: &CellInputs<V>,
        coordinate: fn(&Rational) -> V,
        value: fn(&Values<'a>, u64) -> V,
    ) -> (CellInputs<V>, Vec<V>) {
        let (draw, mut rest) = (index % self.draws, index / self.draws);
        let (start, first_beside) = (self.start(index), self.axes.len() - self.with_starts);
        let (mut place, mut values) = (base.clone(), Vec::with_capacity(self.axes.len()));
        for (number, along) in self.axes.iter().enumerate().rev() {
            let index = match along.values.count() {
                None => draw,
                Some(_) if number >= first_beside => start,
                Some(count) => {
                    let index = rest % count;
                    rest /= count;
                    index
                }
            };
            let value = value(&along.values, index);
            match along.target {
                VariedQuantity::Variable(k) => place.at[k] = value.clone(),
                VariedQuantity::Parameter(k) => place.parameters[k] = value.clone(),
                VariedQuantity::Epsilon => place.eps = value.clone(),
                VariedQuantity::Order | VariedQuantity::Scalar => {}
            }
            values.push(value);
        }
        if let Some(start) = self.starts.get(start as usize) {
            place.at = start.iter().map(coordinate).collect();
        }
        values.reverse();
        (place, values)
    }
}

const STARTS: &str = "first value of the variable";

impl ResolvedAxis<'_> {
    fn varies(&self) -> bool {
        self.values.count() != Some(1)
    }
}

/// Finds the variable, parameter or other quantity that the axis with index `place` varies, and
/// checks that the question allows it.
fn resolve_axis<'a>(over: &'a Over, place: usize, study: &Study) -> Result<ResolvedAxis<'a>, StudyError> {
    let (axis, observes) = (&over.over[place], matches!(*over.question, Question::Observe(_)));
    let wrong = |why: String| StudyError::AxisValues { name: axis.name.clone(), why };
    let values = Values::of(&over.over, place, over.draws, over.seed).map_err(wrong)?;
    let named = |names: &[String]| names.iter().position(|name| *name == axis.name);
    let target = named(study.coordinates()).map(VariedQuantity::Variable);
    let target = target.or_else(|| named(study.parameters()).map(VariedQuantity::Parameter));
    let target = target.or(match &*axis.name {
        "eps" => Some(VariedQuantity::Epsilon),
        "order" if observes => Some(VariedQuantity::Order),
        "scalar" if observes => Some(VariedQuantity::Scalar),
        _ => None,
    });
    let Some(target) = target else {
        let known = [study.coordinates(), study.parameters(), &["eps".to_owned()]];
        return Err(study.unknown("neither a variable nor a parameter", &axis.name, &known));
    };
    let known: &[f64] = match target {
        VariedQuantity::Variable(_) if matches!(*over.question, Question::Discover(_)) => {
            return Err(wrong("is a start, and a search has none; leave it out".to_owned()));
        }
        VariedQuantity::Order => &[2.0, 4.0, 6.0, 8.0],
        _ => return Ok(ResolvedAxis { axis, target, values }),
    };
    let mut own = (0..values.count().unwrap_or(1)).map(|index| match values.count() {
        Some(_) => values.double(index),
        // A drawn value cannot be an order of a method; NaN lets the check below refuse it.
        None => f64::NAN,
    });
    match own.find(|value| !known.contains(value)) {
        Some(value) => {
            let known: Vec<String> = known.iter().map(f64::to_string).collect();
            Err(wrong(format!("{value} is none of {}", known.join(", "))))
        }
        None => Ok(ResolvedAxis { axis, target, values }),
    }
}

#[derive(Clone, Debug)]
pub(in crate::question) enum CellEntry {
    Integer(i64),
    Float(f64),
    Text(String),
}
