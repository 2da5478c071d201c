//! Makes new code visible to the instruction caches of 64-bit Arm.
#![expect(unsafe_code, reason = "only instructions of their own reach the caches")]

use core::arch::asm;

/// Makes newly written code visible to the instruction fetch of every processor.
///
/// The sequence follows the Arm Architecture Reference Manual (B2.2.5, "Concurrent modification and
/// execution of instructions"). Each thread that runs the code must also call [`discard_fetched`].
pub(super) fn publish(code: &[u8]) {
    let [data, instructions] = line_lengths();
    for line in lines(code, data) {
        // SAFETY: this cache line contains a byte of `code`. Writing it back changes nothing.
        unsafe { asm!("dc cvau, {}", in(reg) line, options(nostack, preserves_flags)) };
    }
    // SAFETY: the barrier only waits for the instructions before it.
    unsafe { asm!("dsb ish", options(nostack, preserves_flags)) };
    for line in lines(code, instructions) {
        // SAFETY: the line contains a byte of `code`, and the processor fetches the line again.
        unsafe { asm!("ic ivau, {}", in(reg) line, options(nostack, preserves_flags)) };
    }
    // SAFETY: the barriers only wait for the instructions before them.
    unsafe { asm!("dsb ish", "isb", options(nostack, preserves_flags)) };
}

/// Returns the lengths in bytes of the shortest lines of the data and the instruction cache.
fn line_lengths() -> [usize; 2] {
    let types: u64;
    // SAFETY: user programs may read this register.
    unsafe { asm!("mrs {}, ctr_el0", out(reg) types, options(nomem, nostack, preserves_flags)) };
    // Both fields hold log₂ of a line length, counted in words of 4 bytes.
    [16, 0].map(|shift| 4 << (types >> shift & 0xf))
}

fn lines(code: &[u8], length: usize) -> impl Iterator<Item = usize> {
    let start = code.as_ptr().expose_provenance();
    (start / length * length..start + code.len()).step_by(length)
}

/// Discards prefetched instructions, and lets this thread run [published](publish) code.
pub(super) fn discard_fetched() {
    // SAFETY: the instruction only discards prefetched instructions.
    unsafe { asm!("isb", options(nostack, preserves_flags)) };
}
