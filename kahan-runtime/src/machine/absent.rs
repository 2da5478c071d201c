//! Without the feature `jit` there is no code, and what has code has no value.

use std::convert::Infallible;
use std::marker::PhantomData;
use std::sync::Arc;

use kahan_algebra::Derived;

use crate::engine::Object;

use super::{Form, StepKind};

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

/// The code of an orbit: none.
#[derive(Debug)]
pub(crate) struct OrbitCode<T>(Infallible, PhantomData<T>);

/// The code of an object: none.
#[derive(Debug)]
pub(crate) struct FunctionCode<T>(Infallible, PhantomData<T>);

/// The code of columns: none.
#[derive(Debug)]
pub(crate) struct ColumnsCode<T>(Infallible, PhantomData<T>);

/// The code of orbits side by side: none.
#[derive(Debug)]
pub(crate) struct Sweep<T>(Infallible, PhantomData<T>);

impl Codes {
    pub(crate) fn new(_: usize) -> Self {
        Codes {}
    }

    pub(crate) fn orbit<T>(&self, _: &Derived, _: StepKind, _: Form, _: bool) -> Option<Arc<OrbitCode<T>>> {
        None
    }

    pub(crate) fn abreast<T>(
        &self,
        _: &Derived,
        _: (StepKind, Form),
        _: usize,
        _: InstructionSet,
    ) -> Option<Arc<Sweep<T>>> {
        None
    }

    pub(crate) fn integrals<T>(&self, _: &Derived, _: InstructionSet) -> Option<Arc<Sweep<T>>> {
        None
    }

    pub(crate) fn function<T>(&self, _: &Derived, _: Object) -> Option<&FunctionCode<T>> {
        None
    }

    pub(crate) fn columns<T>(&self, _: &Derived, _: (InstructionSet, bool)) -> Option<Arc<ColumnsCode<T>>> {
        None
    }
}

impl<T> OrbitCode<T> {
    pub(crate) fn step(&self, _: &[T], _: &[Vec<T>], _: &mut [T]) {
        match self.0 {}
    }

    pub(crate) fn advance(&self, _: &mut [T], _: &[Vec<T>], _: u64) {
        match self.0 {}
    }
}

impl<T> Sweep<T> {
    pub(crate) fn constants(&self) -> usize {
        match self.0 {}
    }

    pub(crate) fn width(&self) -> usize {
        match self.0 {}
    }

    pub(crate) fn run(&self, _: &mut [impl AsMut<[T]>], _: &[T], _: u64) {
        match self.0 {}
    }
}

impl<T> FunctionCode<T> {
    pub(crate) fn has_run(&self, _: &[T], _: &[T], _: &mut [T]) -> bool {
        match self.0 {}
    }
}

impl<T> ColumnsCode<T> {
    pub(crate) fn width(&self) -> usize {
        match self.0 {}
    }

    pub(crate) fn prepare(&self, _: &[T], _: &mut Vec<T>) {
        match self.0 {}
    }

    pub(crate) fn advance(&self, _: &mut [&mut [T]], _: &[T], _: bool, _: u64) {
        match self.0 {}
    }
}
