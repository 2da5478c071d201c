//! Synchronisation of the instruction caches of 64-bit Arm.
#![expect(unsafe_code, reason = "only instructions of their own reach the caches")]

use core::arch::asm;

/// Lets every processor fetch code that was just written.
///
/// The sequence is that of the Arm Architecture Reference Manual (B2.2.5, "Concurrent modification
/// and execution of instructions"): clean the data caches to the point from which instructions are
/// fetched, then invalidate the instruction caches. Each thread discards the instructions that it
/// has already fetched by [`discard_fetched`].
pub(super) fn publish(code: &[u8]) {
    let [data, instructions] = line_lengths();
    for line in lines(code, data) {
        // SAFETY: the line contains a byte of `code`, and keeps its contents.
        unsafe { asm!("dc cvau, {}", in(reg) line, options(nostack, preserves_flags)) };
    }
    // SAFETY: the barrier only waits for the instructions before it.
    unsafe { asm!("dsb ish", options(nostack, preserves_flags)) };
    for line in lines(code, instructions) {
        // SAFETY: the line contains a byte of `code`; it is fetched again.
        unsafe { asm!("ic ivau, {}", in(reg) line, options(nostack, preserves_flags)) };
    }
    // SAFETY: the barriers only wait for the instructions before them.
    unsafe { asm!("dsb ish", "isb", options(nostack, preserves_flags)) };
}

/// Returns the shortest lines of the data caches and of the instruction caches, in bytes. A system
/// that reserves the register emulates the read.
fn line_lengths() -> [usize; 2] {
    let types: u64;
    // SAFETY: the instruction reads a register that programs may read.
    unsafe { asm!("mrs {}, ctr_el0", out(reg) types, options(nomem, nostack, preserves_flags)) };
    // Logarithms of lengths in words of four bytes.
    [16, 0].map(|shift| 4 << (types >> shift & 0xf))
}

/// Returns an address in each cache line that contains a byte of `code`.
fn lines(code: &[u8], length: usize) -> impl Iterator<Item = usize> {
    let start = code.as_ptr().expose_provenance();
    (start / length * length..start + code.len()).step_by(length)
}

/// Discards the instructions that this thread has already fetched, so that it runs
/// [published](publish) code.
pub(super) fn discard_fetched() {
    // SAFETY: the following instructions are only fetched again.
    unsafe { asm!("isb", options(nostack, preserves_flags)) };
}
