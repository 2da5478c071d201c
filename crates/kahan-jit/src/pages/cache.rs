//! Synchronisation of the instruction caches of 64-bit Arm.
#![expect(unsafe_code, reason = "only instructions of their own reach the caches")]

use core::arch::asm;

/// Makes newly written code visible to instruction fetch on every processor.
///
/// The sequence follows the Arm Architecture Reference Manual (B2.2.5, "Concurrent modification and
/// execution of instructions"): clean the data cache, then invalidate the instruction cache. Each
/// thread must also call [`discard_fetched`].
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

/// Returns the shortest line of the data and of the instruction caches, in bytes. Systems that
/// reserve the register emulate the read.
fn line_lengths() -> [usize; 2] {
    let types: u64;
    // SAFETY: user programs may read this register.
    unsafe { asm!("mrs {}, ctr_el0", out(reg) types, options(nomem, nostack, preserves_flags)) };
    // The fields are log₂ of the line length in 4-byte words.
    [16, 0].map(|shift| 4 << (types >> shift & 0xf))
}

/// Returns an address in each cache line that contains a byte of `code`.
fn lines(code: &[u8], length: usize) -> impl Iterator<Item = usize> {
    let start = code.as_ptr().expose_provenance();
    (start / length * length..start + code.len()).step_by(length)
}

/// Discards prefetched instructions, so that this thread runs [published](publish) code.
pub(super) fn discard_fetched() {
    // SAFETY: only prefetched instructions are discarded.
    unsafe { asm!("isb", options(nostack, preserves_flags)) };
}
