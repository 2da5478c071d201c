//! The calls into machine code: the only place where it is entered.
//!
//! In: code of this crate, and slices. Out: what it computed. Each call checks that its slices are
//! as long as the code needs them; what code reads and writes beside them is its own stack.
#![expect(unsafe_code, reason = "machine code is entered by the address of its first byte")]

use std::marker::PhantomData;

use crate::Refusal;
use crate::pages::Pages;

/// How much code reads and writes at least.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    /// How many numbers a register holds; the others are so many registers.
    pub(crate) width: usize,
    pub(crate) states: usize,
    pub(crate) constants: usize,
    pub(crate) results: usize,
}

impl Extent {
    /// How many numbers the states, the constants and the results are.
    pub(crate) fn numbers(self) -> [usize; 3] {
        [self.states * self.width, self.constants * self.width, self.results * self.width]
    }
}

/// Code in memory, and what it needs.
#[derive(Debug)]
pub(crate) struct Code<T> {
    pages: Pages,
    extent: Extent,
    floats: PhantomData<fn(T)>,
}

impl<T: 'static> Code<T> {
    /// Puts code where it may run.
    ///
    /// # Safety
    /// The bytes begin with a function on numbers of type `T`, of the calling convention of System
    /// V on x86-64 and of the C language on 64-bit Arm, in instructions that this processor has. It
    /// is entered by that method below which passes the arguments that it takes, and no other. Given
    /// these, and slices as long as `extent` says, it reads and writes nothing else but its own
    /// stack.
    pub(crate) unsafe fn new(bytes: &[u8], extent: Extent) -> Result<Self, Refusal> {
        Ok(Code { pages: Pages::new(bytes).map_err(Refusal::Pages)?, extent, floats: PhantomData })
    }

    /// How much it reads and writes.
    pub(crate) fn extent(&self) -> Extent {
        self.extent
    }

    /// Runs the code of a [`Function`](crate::Function).
    pub(crate) fn function(&self, states: &[T], constants: &[T], results: &mut [T]) {
        self.check(states, constants);
        let [.., r] = self.extent.numbers();
        assert!(results.len() >= r, "room for {r} results, not {}", results.len());
        // SAFETY: the slices are as long as the code needs them, and `results` is borrowed alone.
        unsafe { self.enter([read(states), read(constants), written(results), 0, 0]) }
    }

    /// Runs the code of an [`Orbit`](crate::Orbit), `steps` rounds.
    pub(crate) fn orbit(&self, state: &mut [T], constants: &[T], steps: u64) {
        self.check(state, constants);
        let state = written(state);
        // SAFETY: the slices are as long as the code needs them, and `state` is borrowed alone.
        unsafe { self.enter([state, read(constants), counted(steps), state, 0]) }
    }

    /// Runs one round of it from a state to another; it must be code that writes the last state
    /// alone.
    pub(crate) fn orbit_step(&self, state: &[T], constants: &[T], next: &mut [T]) {
        self.check(state, constants);
        self.check(next, constants);
        // SAFETY: the slices are as long as the code needs them, and `next`, to which alone it
        // writes, is borrowed alone.
        unsafe { self.enter([read(state), read(constants), 1, written(next), 0]) }
    }

    /// Runs the code of a [`ComposedOrbit`](crate::ComposedOrbit), `steps` rounds of all stages.
    pub(crate) fn composed_orbit<'a>(
        &self,
        state: &mut [T],
        stages: impl Iterator<Item = &'a [T]>,
        steps: u64,
    ) {
        /// As many as the longest composition has, with room.
        const MOST: usize = 64;

        let (mut table, mut count) = ([0; MOST], 0);
        for constants in stages {
            assert!(count < MOST, "at most {MOST} stages");
            self.check(state, constants);
            table[count] = read(constants);
            count += 1;
        }
        assert!(count > 0, "at least one stage");
        // SAFETY: the slices are as long as the code needs them, `state` is borrowed alone, and the
        // table has an address for each stage.
        unsafe { self.enter([written(state), read(&table), count, counted(steps), 0]) }
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

    /// Runs the code of a [`Sweep`](crate::Sweep) over columns, `steps` times; constants are the same
    /// for all registers, or each register's `own`.
    pub(crate) fn sweep(&self, columns: &mut [impl AsMut<[T]>], constants: &[T], own: bool, steps: u64) {
        /// Columns of nearly every field: a larger table takes longer to clear than their step.
        const FEW: usize = 32;
        /// More variables are stepped by other means.
        const MOST: usize = 256;

        if columns.len() <= FEW {
            self.sweep_by([0; FEW], columns, constants, own, steps);
        } else {
            self.sweep_by([0; MOST], columns, constants, own, steps);
        }
    }

    /// The same by a table that has room for the addresses of the columns.
    fn sweep_by<const ROOM: usize>(
        &self,
        mut table: [usize; ROOM],
        columns: &mut [impl AsMut<[T]>],
        constants: &[T],
        own: bool,
        steps: u64,
    ) {
        let Extent { width, states: s, .. } = self.extent;
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
        // SAFETY: the columns are of one length, a multiple of what is read and written at once,
        // and are borrowed alone; the table has their addresses. The constants reach as far as the
        // last register needs them.
        unsafe { self.enter([read(&table), bytes(len), read(constants), bytes(stride), counted(steps)]) }
    }

    /// Enters the code.
    ///
    /// # Safety
    /// The arguments are what the routine takes: addresses of as many numbers as it reads and
    /// writes, those that are written borrowed by the caller alone.
    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
    unsafe fn enter(&self, [a, b, c, d, e]: [usize; 5]) {
        #[cfg(target_arch = "x86_64")]
        type Entry = unsafe extern "sysv64" fn(usize, usize, usize, usize, usize);
        #[cfg(target_arch = "aarch64")]
        type Entry = unsafe extern "C" fn(usize, usize, usize, usize, usize);
        // SAFETY: the pages begin with the first instruction of a function of this calling
        // convention, and stay as long as `self` does.
        let entry: Entry = unsafe { core::mem::transmute(self.pages.entry()) };
        // SAFETY: the caller vouches for the arguments. The processor has the instructions, as no
        // code is made where it lacks them.
        unsafe { entry(a, b, c, d, e) }
    }

    /// There is no code on other machines.
    ///
    /// # Safety
    /// None is needed.
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

/// A number of steps; those beyond the address space are never run.
fn counted(steps: u64) -> usize {
    usize::try_from(steps).unwrap_or(usize::MAX)
}
