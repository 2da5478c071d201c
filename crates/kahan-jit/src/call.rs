//! Calls into machine code.
//!
//! Each call checks that its slices are as long as the code requires. No other module enters
//! machine code.
#![expect(unsafe_code, reason = "machine code is entered by the address of its first byte")]

use std::marker::PhantomData;

use crate::CompileError;
use crate::pages::Pages;

/// The minimum sizes of the arrays that the code reads and writes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MemoryExtent {
    /// The number of lanes of a register. The other fields are array lengths in units of `width`.
    pub(crate) width: usize,
    pub(crate) states: usize,
    pub(crate) constants: usize,
    pub(crate) results: usize,
}

impl MemoryExtent {
    pub(crate) fn numbers(self) -> [usize; 3] {
        [self.states * self.width, self.constants * self.width, self.results * self.width]
    }
}

#[derive(Debug)]
pub(crate) struct Code<T> {
    pages: Pages,
    extent: MemoryExtent,
    floats: PhantomData<fn(T)>,
}

impl<T: 'static> Code<T> {
    /// Copies code into executable memory.
    ///
    /// # Safety
    /// The bytes must begin with a function on numbers of type `T`, in instructions of this
    /// processor. Its calling convention must be that of System V on x86-64, or of C on 64-bit Arm.
    /// If its arrays have the lengths in `extent`, it must access only them and its stack. Callers
    /// may call only methods of `Code` that pass the arguments of this function.
    pub(crate) unsafe fn new(bytes: &[u8], extent: MemoryExtent) -> Result<Self, CompileError> {
        Ok(Code { pages: Pages::new(bytes).map_err(CompileError::Pages)?, extent, floats: PhantomData })
    }

    pub(crate) fn extent(&self) -> MemoryExtent {
        self.extent
    }

    pub(crate) fn function(&self, states: &[T], constants: &[T], results: &mut [T]) {
        self.check(states, constants);
        let [.., r] = self.extent.numbers();
        assert!(results.len() >= r, "room for {r} results, not {}", results.len());
        // SAFETY: `check` and the assertion bound the slices, and `results` is borrowed
        // exclusively.
        unsafe { self.enter([read(states), read(constants), written(results), 0, 0]) }
    }

    pub(crate) fn orbit(&self, state: &mut [T], constants: &[T], steps: u64) {
        self.check(state, constants);
        let state = written(state);
        // SAFETY: `check` bounds the slices, and `state` is borrowed exclusively.
        unsafe { self.enter([state, read(constants), step_count(steps), state, 0]) }
    }

    /// Makes one step from `state` to `next`. The code must write states only at its end.
    pub(crate) fn orbit_step(&self, state: &[T], constants: &[T], next: &mut [T]) {
        self.check(state, constants);
        self.check(next, constants);
        // SAFETY: `check` bounds the slices. The code writes only `next`, which is borrowed
        // exclusively.
        unsafe { self.enter([read(state), read(constants), 1, written(next), 0]) }
    }

    pub(crate) fn composed_orbit<'a>(
        &self,
        state: &mut [T],
        stages: impl Iterator<Item = &'a [T]>,
        steps: u64,
    ) {
        /// The maximum number of stages. Each stage runs the program once, with its own constants.
        const MOST: usize = 64;

        let (mut table, mut count) = ([0; MOST], 0);
        for constants in stages {
            assert!(count < MOST, "at most {MOST} stages");
            self.check(state, constants);
            table[count] = read(constants);
            count += 1;
        }
        assert!(count > 0, "at least one stage");
        // SAFETY: `check` bounds the slices, `state` is exclusive, and `table` holds every stage.
        unsafe { self.enter([written(state), read(&table), count, step_count(steps), 0]) }
    }

    fn check(&self, state: &[T], constants: &[T]) {
        let [s, c, _] = self.extent.numbers();
        assert!(
            state.len() >= s && constants.len() >= c,
            "{s} states and {c} constants, not {} and {}",
            state.len(),
            constants.len()
        );
    }

    /// Runs `steps` rounds of a [`Sweep`](crate::Sweep). If `own` is true, `constants` holds one
    /// set for each group of trajectories that share a SIMD register.
    pub(crate) fn sweep(&self, columns: &mut [impl AsMut<[T]>], constants: &[T], own: bool, steps: u64) {
        /// The length of the address table for few columns. A longer table takes longer to clear.
        const FEW: usize = 32;
        /// The maximum number of columns. Fields with more variables run in the interpreter.
        const MOST: usize = 256;

        if columns.len() <= FEW {
            self.sweep_by([0; FEW], columns, constants, own, steps);
        } else {
            self.sweep_by([0; MOST], columns, constants, own, steps);
        }
    }

    fn sweep_by<const ROOM: usize>(
        &self,
        mut table: [usize; ROOM],
        columns: &mut [impl AsMut<[T]>],
        constants: &[T],
        own: bool,
        steps: u64,
    ) {
        let MemoryExtent { width, states: s, .. } = self.extent;
        assert!(columns.len() >= s && columns.len() <= ROOM, "{s} columns, not {}", columns.len());
        let len = columns.first_mut().map_or(0, |column| column.as_mut().len());
        assert!(len.is_multiple_of(width), "columns of whole registers");
        for (entry, column) in table.iter_mut().zip(columns) {
            let column = column.as_mut();
            assert!(column.len() == len, "columns of one length");
            *entry = written(column);
        }
        if len == 0 || steps == 0 {
            return;
        }
        let [_, c, _] = self.extent.numbers();
        let stride = if own { c } else { 0 };
        let most = (len / width - 1).saturating_mul(stride).saturating_add(c);
        assert!(constants.len() >= most, "{most} constants, not {}", constants.len());
        let bytes = |numbers: usize| numbers * size_of::<T>();
        // SAFETY: the columns have equal lengths, which are multiples of the register width, and
        // are borrowed exclusively. The table holds their addresses. By the assertion, `constants`
        // holds every set that the code reads.
        unsafe { self.enter([read(&table), bytes(len), read(constants), bytes(stride), step_count(steps)]) }
    }

    /// Enters the code.
    ///
    /// # Safety
    /// The arguments must be those that the code expects: addresses of all memory that it reads or
    /// writes. The caller must borrow the written memory exclusively.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    unsafe fn enter(&self, [a, b, c, d, e]: [usize; 5]) {
        #[cfg(target_arch = "x86_64")]
        type Entry = unsafe extern "sysv64" fn(usize, usize, usize, usize, usize);
        #[cfg(target_arch = "aarch64")]
        type Entry = unsafe extern "C" fn(usize, usize, usize, usize, usize);
        // SAFETY: the pages begin with a function of this calling convention, and outlive the call.
        let entry: Entry = unsafe { core::mem::transmute(self.pages.entry()) };
        // SAFETY: the caller guarantees the arguments. Code is compiled only for an available
        // instruction set.
        unsafe { entry(a, b, c, d, e) }
    }

    /// Panics, because no code is compiled for other processors.
    ///
    /// # Safety
    /// Every call is safe.
    #[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
    unsafe fn enter(&self, _: [usize; 5]) {
        unreachable!("code at {:p} was made for another processor", self.pages.entry())
    }
}

fn read<T>(numbers: &[T]) -> usize {
    numbers.as_ptr().expose_provenance()
}

fn written<T>(numbers: &mut [T]) -> usize {
    numbers.as_mut_ptr().expose_provenance()
}

/// Converts a number of steps to `usize`. A number that does not fit becomes `usize::MAX`.
fn step_count(steps: u64) -> usize {
    usize::try_from(steps).unwrap_or(usize::MAX)
}
