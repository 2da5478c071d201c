//! Without the feature `jit` there is no code, and what has code has no value.

use std::convert::Infallible;
use std::marker::PhantomData;
use std::sync::Arc;

use crate::engine::{Engine, Object};

use super::{SideBySide, StepKind};

/// The code of a field: none.
#[derive(Debug)]
pub(crate) struct Codes {}

/// A float that would have code.
pub trait Coded: Copy {}

impl Coded for f32 {}
impl Coded for f64 {}

/// A set of instructions: none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InstructionSet {
    Avx2,
    Avx512,
}

impl InstructionSet {
    pub(crate) fn best() -> Option<Self> {
        None
    }
}

/// Code of whatever kind: none.
#[derive(Debug)]
pub(crate) struct Absent<T>(Infallible, PhantomData<T>);

/// The code of an orbit.
pub(crate) type OrbitCode<T> = Absent<T>;
/// The code of columns.
pub(crate) type ColumnsCode<T> = Absent<T>;
/// The code of orbits side by side.
pub(crate) type Sweep<T> = Absent<T>;

impl Codes {
    pub(crate) fn new(_: usize) -> Self {
        Codes {}
    }

    pub(crate) fn orbit<T>(&self, _: &Engine, _: StepKind, _: bool) -> Option<Arc<OrbitCode<T>>> {
        None
    }

    pub(crate) fn abreast<T>(&self, _: &Engine, _: SideBySide, _: InstructionSet) -> Option<Arc<Sweep<T>>> {
        None
    }

    pub(crate) fn function<T>(&self, _: &Engine, _: Object) -> Option<&Absent<T>> {
        None
    }

    pub(crate) fn columns<T>(&self, _: &Engine, _: (InstructionSet, bool)) -> Option<Arc<ColumnsCode<T>>> {
        None
    }
}

impl<T> Absent<T> {
    pub(crate) fn step(&self, _: &[T], _: &[Vec<T>], _: &mut [T]) {
        match self.0 {}
    }

    pub(crate) fn advance(&self, _: &mut [T], _: &[Vec<T>], _: u64) {
        match self.0 {}
    }

    pub(crate) fn advance_columns(&self, _: &mut [&mut [T]], _: &[T], _: bool, _: u64) {
        match self.0 {}
    }

    pub(crate) fn run(&self, _: &mut [impl AsMut<[T]>], _: &[T], _: u64) {
        match self.0 {}
    }

    pub(crate) fn has_run(&self, _: &[T], _: &[T], _: &mut [T]) -> bool {
        match self.0 {}
    }

    pub(crate) fn prepare(&self, _: &[T], _: &mut Vec<T>) {
        match self.0 {}
    }

    pub(crate) fn constants(&self) -> usize {
        match self.0 {}
    }

    pub(crate) fn width(&self) -> usize {
        match self.0 {}
    }
}
