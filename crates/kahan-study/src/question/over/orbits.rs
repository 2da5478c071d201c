//! Observes the orbit of each cell, where a cell is a combination of axis values. Machine code
//! follows several orbits at once in SIMD lanes, even if their maps differ.

use std::ops::ControlFlow;

use kahan_core::{Composition, EmbedScalar};
use kahan_runtime::{End, Follow, Followed, MachineFloat, Map, MapAt, ObservedFloat};

use super::at_cell::column;
use super::cells::{CellEntry, CellInputs, Cells, VariedQuantity};
use crate::error::StudyError;
use crate::question::NoOrbit;
use crate::question::observe::{ARGUMENTS_FIT, Observable, Observe, ObservedValue, shown};
use crate::rows::{Column, StoredColumn};
use crate::study::Study;

const LANES: u64 = 16;
/// The number of steps in one block, of all its orbits together.
const AT_ONCE: u64 = 1 << 24;

const END_MEANING: &str =
    "how the orbit ended: complete, range (its next point is not finite), escaped or reembed";

pub(super) struct Orbits<'a> {
    study: &'a Study,
    cells: &'a Cells<'a>,
    asked: &'a Observe,
    numbers: usize,
}

struct StartedOrbit {
    index: u64,
    place: CellInputs<f64>,
    values: Vec<f64>,
    order: u32,
    bits: u32,
}

impl<'a> Orbits<'a> {
    pub(super) fn of(study: &'a Study, cells: &'a Cells<'a>, asked: &'a Observe) -> Result<Self, StudyError> {
        study.proved()?;
        asked.composition(study)?;
        if asked.reembed && cells.axes.iter().any(|along| along.target == VariedQuantity::Scalar) {
            return Err(StudyError::Orbit(NoOrbit::Reembed));
        }
        let (CellInputs { at, eps, .. }, _) = cells.in_doubles(0);
        study.within_range(&at, eps)?;
        // If no parameter varies, an error of the field is reported once instead of at every cell.
        let is_one_field =
            !cells.axes.iter().any(|along| matches!(along.target, VariedQuantity::Parameter(_)));
        if is_one_field {
            study.map()?;
        }
        let mut orbits = Orbits { study, cells, asked, numbers: 0 };
        orbits.numbers = orbits.columns().len() - 2;
        Ok(orbits)
    }

    pub(super) fn columns(&self) -> Vec<(Column, StoredColumn)> {
        let ended = column("ended", END_MEANING, StoredColumn::Text);
        let steps = column("ended_step", "steps to the last point of the orbit", StoredColumn::Integer);
        let seen = self.asked.columns(self.study).into_iter();
        let seen = seen.map(|column| (column, StoredColumn::F64(Vec::new())));
        [ended, steps].into_iter().chain(seen).collect()
    }

    /// Returns the smallest and the largest number of cells in a block.
    pub(super) fn at_once(&self) -> [u64; 2] {
        [LANES, (AT_ONCE / self.asked.steps_in_all().max(1)).clamp(LANES, 256)]
    }

    /// Returns the rows of consecutive cells. If `tell` ends the work, returns an empty list.
    pub(super) fn rows(
        &self,
        cells: std::ops::Range<u64>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Vec<Vec<CellEntry>> {
        let begun: Vec<StartedOrbit> = cells.map(|index| self.prepare_orbit(index)).collect();
        let (mut map, mut rows) = (CachedMap::default(), Vec::with_capacity(begun.len()));
        for same in begun.chunk_by(|a, b| (a.order, a.bits) == (b.order, b.bits)) {
            let found = match same[0].bits {
                32 => self.found(same, &mut map, |value| value as f32, tell),
                _ => self.found(same, &mut map, |value| value, tell),
            };
            if tell(0).is_break() {
                return Vec::new();
            }
            for (begun, found) in same.iter().zip(found) {
                let mut row = self.cells.entries(begun.index, &begun.place, &begun.values);
                // If the field is undefined at the parameters, the orbit ends after 0 steps.
                let end = found.as_ref().map_or(End::Range(0), |found| found.end);
                row.push(CellEntry::Text(end.name().to_owned()));
                row.push(CellEntry::Integer(end.steps(self.asked.transient + self.asked.steps) as i64));
                let numbers = found.as_ref().map_or_else(Vec::new, Observe::numbers).into_iter();
                let numbers = numbers.chain(std::iter::repeat(f64::NAN));
                row.extend(numbers.take(self.numbers).map(CellEntry::Float));
                rows.push(row);
            }
        }
        rows
    }

    fn prepare_orbit(&self, index: u64) -> StartedOrbit {
        let (place, values) = self.cells.in_doubles(index);
        let of = |target: VariedQuantity, usual: u32| {
            let axis = self.cells.axes.iter().position(|along| along.target == target);
            axis.map_or(usual, |axis| values[axis] as u32)
        };
        let (order, bits) = (of(VariedQuantity::Order, self.asked.order), of(VariedQuantity::Scalar, 64));
        StartedOrbit { index, place, values, order, bits }
    }

    fn found<T: ObservedFloat + EmbedScalar>(
        &self,
        begun: &[StartedOrbit],
        known: &mut CachedMap,
        nearest: fn(f64) -> T,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Vec<Option<Followed<Vec<ObservedValue>>>> {
        let composition = Composition::of_order(begun[0].order).expect("orders were looked at");
        let of_one_map = |a: &StartedOrbit, b: &StartedOrbit| {
            is_same(&a.place.parameters, &b.place.parameters) && is_same(&[a.place.eps], &[b.place.eps])
        };
        let groups = begun.chunk_by(of_one_map).map(|same| {
            let StartedOrbit { index, place, .. } = &same[0];
            let map =
                known.at(&place.parameters, || self.study.map_at(&self.cells.exactly(*index).parameters));
            (same, map.map(|map| map.at(nearest(place.eps)).composed(composition)))
        });
        let groups: Vec<(&[StartedOrbit], Option<MapAt<T>>)> = groups.collect();
        let defined = || groups.iter().filter_map(|(same, map)| Some((same, map.as_ref()?)));
        let own: Vec<&MapAt<T>> = defined().flat_map(|(same, map)| same.iter().map(move |_| map)).collect();
        let begins = defined().flat_map(|(same, _)| *same);
        let points: Vec<Vec<f64>> =
            begins.map(|begun| self.study.embed(&begun.place.at, &begun.place.parameters)).collect();
        let column = |k: usize| points.iter().map(|point| nearest(point[k])).collect();
        let starts: Vec<Vec<T>> = (0..self.study.variables().len()).map(column).collect();
        let of = self.asked.observables();
        // Steps of lifted fields may check or project new variables; `is_plain` steps do not.
        let is_plain = own.first().is_none_or(|map| self.study.steps(map, self.asked.reembed).is_none());
        let found = match own[..] {
            [] => Vec::new(),
            _ if is_plain
                && self.asked.escape.is_none()
                && self.asked.observe.iter().all(|one| *one == Observable::Last) =>
            {
                self.ends(&own, starts, tell)
            }
            [one] => {
                let start: Vec<T> = starts.iter().map(|column| column[0]).collect();
                vec![self.asked.observe_one(self.study, one, &start, &of, tell).0]
            }
            _ => self.asked.observe_many(self.study, &own, &starts, &of, tell),
        };
        let shown = |found: Followed<Vec<ObservedValue>>| Followed {
            report: found.report.into_iter().map(|seen| shown(self.study, seen)).collect(),
            ..found
        };
        let mut found = found.into_iter().map(shown);
        let of_each = groups.iter().flat_map(|(same, map)| same.iter().map(move |_| map.as_ref()));
        of_each.map(|map| map.and_then(|_| found.next())).collect()
    }

    /// Returns only the last point of each orbit.
    fn ends<T: MachineFloat>(
        &self,
        maps: &[&MapAt<T>],
        mut columns: Vec<Vec<T>>,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Vec<Followed<Vec<ObservedValue>>> {
        let steps = self.asked.transient + self.asked.steps;
        let is_short = steps <= AT_ONCE / LANES;
        let mut found = Vec::with_capacity(maps.len());
        for same in maps.chunk_by(|a, b| std::ptr::eq(*a, *b)) {
            let orbits = found.len()..found.len() + same.len();
            if self.cells.neighbours_share_a_map() && is_short {
                let mut own: Vec<&mut [T]> =
                    columns.iter_mut().map(|column| &mut column[orbits.clone()]).collect();
                found.extend(same[0].follow_columns(&mut own, &[], &[], steps).expect(ARGUMENTS_FIT));
                continue;
            }
            for orbit in orbits {
                let mut x: Vec<T> = columns.iter().map(|column| column[orbit]).collect();
                let followed = same[0].follow(&mut x, steps, tell);
                found.push(followed.expect(ARGUMENTS_FIT).end);
                columns.iter_mut().zip(x).for_each(|(column, x)| column[orbit] = x);
            }
        }
        let of = self.asked.observables();
        let told = found.into_iter().enumerate().map(|(orbit, end)| {
            let point =
                || ObservedValue::Point(columns.iter().map(|column| column[orbit].approximate()).collect());
            Followed { report: of.iter().map(|_| point()).collect(), end }
        });
        told.collect()
    }
}

/// The map at the parameters of the latest call; `None` if the field divides by zero there.
#[derive(Default)]
struct CachedMap(Option<(Vec<f64>, Option<Map>)>);

impl CachedMap {
    fn at(&mut self, parameters: &[f64], make: impl FnOnce() -> Option<Map>) -> Option<&Map> {
        if !self.0.as_ref().is_some_and(|(known, _)| is_same(known, parameters)) {
            self.0 = Some((parameters.to_vec(), make()));
        }
        self.0.as_ref().and_then(|(_, map)| map.as_ref())
    }
}

fn is_same(a: &[f64], b: &[f64]) -> bool {
    a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()))
}
