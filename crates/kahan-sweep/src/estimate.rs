//! Estimates a sweep's time and size by computing a sample of its points.

use std::time::{Duration, Instant};

use kahan_study::{StoredColumn, Unwatched};
use serde_json::{Value, json};

use crate::plan::Plan;

#[derive(Clone, Debug)]
pub(crate) struct Estimate<'a> {
    plan: &'a Plan,
    /// The size of the merged file in bytes. The parts need about as much space in addition.
    bytes: f64,
    core_seconds: f64,
    cores: usize,
    measured: u64,
}

const TIMING_DURATION: Duration = Duration::from_millis(500);
/// The largest number of neighbouring points that are computed together.
const MAX_POINTS_TOGETHER: u64 = 256;

impl<'a> Estimate<'a> {
    pub(crate) fn of(plan: &'a Plan) -> Self {
        let points = plan.points();
        let begun = Instant::now();
        let (mut measured, mut bytes, mut seconds) = (0u64, 0u64, 0.0);
        // Costs differ, so the sample consists of groups of neighbours, spread over all points. The
        // stride is never 0, even for fewer than 997 points.
        let stride = (points / 997) | 1;
        let (mut place, mut together) = (0u64, 1);
        while measured < points.min(100_000) && (measured == 0 || begun.elapsed() < TIMING_DURATION) {
            let first = place.wrapping_mul(stride) % points;
            let began = Instant::now();
            let found = plan.rows(first..points.min(first + together), &Unwatched);
            let took = began.elapsed();
            if took < TIMING_DURATION / 50 && together < MAX_POINTS_TOGETHER.min(points) {
                together *= 4;
                (measured, bytes, seconds) = (0, 0, 0.0);
            }
            bytes += found.values.iter().map(size).sum::<u64>();
            measured += found.count() as u64;
            seconds += took.as_secs_f64();
            place += 1;
        }
        let of_all = |measure: f64| measure / measured as f64 * points as f64;
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        Estimate { plan, bytes: of_all(bytes as f64), core_seconds: of_all(seconds), cores, measured }
    }

    fn columns(&self) -> Vec<&str> {
        self.plan.empty.columns.iter().map(|column| &*column.name).collect()
    }

    fn seconds(&self) -> f64 {
        self.core_seconds / self.cores as f64
    }

    pub(crate) fn json(&self) -> Value {
        json!({
            "points": self.plan.points(),
            "parts": self.plan.parts(),
            "columns": self.columns(),
            "bytes": self.bytes,
            "core_seconds": self.core_seconds,
            "cores": self.cores,
            "seconds": self.seconds(),
            "points_measured": self.measured,
        })
    }

    pub(crate) fn text(&self) -> String {
        format!(
            "points     {}\nparts      {}\ncolumns    {}\nsize       {}, and as much again in parts\ntime       {} on the {} cores of this machine, {} on one; measured on {} points\n",
            self.plan.points(),
            self.plan.parts(),
            self.columns().join(", "),
            size_in_words(self.bytes),
            time_in_words(self.seconds()),
            self.cores,
            time_in_words(self.core_seconds),
            self.measured
        )
    }
}

fn size(column: &StoredColumn) -> u64 {
    match column {
        StoredColumn::Text(list) => list.iter().map(|text| 4 + text.len() as u64).sum(),
        numbers => 8 * numbers.values().count() as u64,
    }
}

fn size_in_words(bytes: f64) -> String {
    let units = [(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    let unit = units.into_iter().find(|(size, _)| bytes >= *size);
    unit.map_or_else(|| format!("{bytes:.0} bytes"), |(size, unit)| format!("{:.1} {unit}", bytes / size))
}

fn time_in_words(seconds: f64) -> String {
    let units = [(86_400.0 * 365.25, "years"), (86_400.0, "days"), (3_600.0, "hours"), (60.0, "minutes")];
    let unit = units.into_iter().find(|(size, _)| seconds >= 2.0 * size);
    unit.map_or_else(
        || format!("{seconds:.1} seconds"),
        |(size, unit)| format!("{:.1} {unit}", seconds / size),
    )
}
