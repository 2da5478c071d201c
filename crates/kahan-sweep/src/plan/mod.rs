//! A plan: which field, which starts, parameters and ε, what to do with each, what to write.
//!
//! In: a text in TOML, and before anything runs all that is wrong with it. Out: a number of points,
//! and each of them from its index alone.

mod axis;
mod mistakes;
mod read;
mod table;

use std::fmt::Write as _;

use kahan_algebra::rational::Rational;
use kahan_algebra::render::macro_block;
use kahan_algebra::system::System;
use kahan_runtime::Field;
use sha2::{Digest, Sha256};

use crate::task::Task;

pub(crate) use axis::{Axis, Target};
pub use mistakes::{Mistake, Mistakes};

/// A plan that can be run.
#[derive(Clone, Debug)]
pub struct Plan {
    pub(crate) field: Field,
    /// In the order of the plan; the last changes fastest, but for the draws.
    pub(crate) axes: Vec<Axis>,
    /// Values of every drawn axis, which change together and fastest; 1 where none is drawn.
    pub(crate) draws: u64,
    pub(crate) task: Task,
    /// Rows of a part, but for the last.
    pub(crate) rows_per_part: u64,
    /// Which columns are written, `None` for all.
    pub(crate) columns: Option<Vec<String>>,
    seed: u64,
}

/// One point of a sweep.
#[derive(Clone, Debug)]
pub(crate) struct Point<V> {
    pub(crate) start: Vec<V>,
    pub(crate) parameters: Vec<V>,
    pub(crate) eps: V,
    pub(crate) order: u32,
    pub(crate) bits: u32,
}

impl Point<f64> {
    /// Whether the map is the same: parameters, ε, order and scalar.
    pub(crate) fn has_the_map_of(&self, other: &Self) -> bool {
        let same = |a: &[f64], b: &[f64]| a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()));
        same(&self.parameters, &other.parameters)
            && self.eps.to_bits() == other.eps.to_bits()
            && (self.order, self.bits) == (other.order, other.bits)
    }
}

impl Plan {
    /// Reads a plan; `origin` is what it is called in reports.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn read(text: &str, origin: &str) -> Result<Self, Mistakes> {
        read::plan(text, origin)
    }

    pub(crate) fn system(&self) -> &System {
        self.field.system()
    }

    /// How many points it has.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.draws * self.axes.iter().filter_map(Axis::count).product::<u64>()
    }

    /// Whether points that follow each other mostly differ in their starts alone.
    pub(crate) fn neighbours_share_a_map(&self) -> bool {
        let is_start = |axis: &&Axis| matches!(axis.target, Target::Variable(_));
        if self.draws > 1 {
            return self.axes.iter().filter(|axis| axis.count().is_none()).all(|axis| is_start(&axis));
        }
        self.axes.iter().rev().find(|axis| axis.varies()).is_some_and(|axis| is_start(&axis))
    }

    /// How many parts it is written in.
    #[must_use]
    pub fn parts(&self) -> u64 {
        self.points().div_ceil(self.rows_per_part)
    }

    /// The points of a part.
    pub(crate) fn rows(&self, part: u64) -> std::ops::Range<u64> {
        let first = part * self.rows_per_part;
        first..self.points().min(first + self.rows_per_part)
    }

    /// The values of the axes at a point, in their order.
    pub(crate) fn values<V>(&self, index: u64, value: impl Fn(&Axis, u64) -> V) -> Vec<V> {
        let (draw, mut rest) = (index % self.draws, index / self.draws);
        let mut values: Vec<V> = Vec::with_capacity(self.axes.len());
        for axis in self.axes.iter().rev() {
            values.push(match axis.count() {
                None => value(axis, draw),
                Some(count) => {
                    let place = rest % count;
                    rest /= count;
                    value(axis, place)
                }
            });
        }
        values.reverse();
        values
    }

    /// The point at these values of the axes.
    pub(crate) fn point<V: Clone + Default>(&self, values: &[V], number: impl Fn(&V) -> u32) -> Point<V> {
        let symbols = &self.system().field.symbols;
        let mut point = Point {
            start: vec![V::default(); symbols.states.len()],
            parameters: vec![V::default(); symbols.parameters.len()],
            eps: V::default(),
            order: 2,
            bits: 64,
        };
        for (axis, value) in self.axes.iter().zip(values) {
            match axis.target {
                Target::Variable(k) => point.start[k] = value.clone(),
                Target::Parameter(k) => point.parameters[k] = value.clone(),
                Target::Epsilon => point.eps = value.clone(),
                Target::Order => point.order = number(value),
                Target::Bits => point.bits = number(value),
            }
        }
        point
    }

    /// The exact point with this index.
    pub(crate) fn exact_point(&self, index: u64) -> Point<Rational> {
        self.point(&self.values(index, Axis::value), |value| value.to_f64() as u32)
    }

    /// The plan in one form, however it was written.
    #[must_use]
    pub fn canonical(&self) -> String {
        let mut text = format!("{}\n", macro_block(self.system()));
        for axis in &self.axes {
            let _ = writeln!(text, "{axis}");
        }
        let _ = writeln!(text, "draws = {}\nseed = {}\n{}", self.draws, self.seed, self.task);
        let _ = writeln!(text, "rows_per_part = {}", self.rows_per_part);
        let columns = self.columns.as_ref().map_or("all".to_owned(), |columns| columns.join(", "));
        let _ = writeln!(text, "columns = {columns}");
        text
    }

    /// What tells this plan from others: SHA-256 of its [one form](Self::canonical).
    #[must_use]
    pub fn hash(&self) -> String {
        Sha256::digest(self.canonical()).iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        })
    }

    /// The seed of what is drawn.
    #[must_use]
    pub fn seed(&self) -> u64 {
        self.seed
    }
}
