//! The caches of instructions.
#![expect(unsafe_code, reason = "only instructions of their own reach the caches")]

use core::arch::asm;

/// Lets every processor fetch code that was just written.
///
/// The sequence is that of the Arm Architecture Reference Manual (B2.2.5, "Concurrent modification
/// and execution of instructions"): what was written goes from the caches of data to where
/// instructions are fetched from, and afterwards no cache of instructions has what was there
/// before. Each thread discards what it has fetched already by [`discard_fetched`].
pub(super) fn publish(code: &[u8]) {
    let [data, instructions] = line_lengths();
    for line in lines(code, data) {
        // SAFETY: the line has a byte of `code`, and what it holds stays as it is.
        unsafe { asm!("dc cvau, {}", in(reg) line, options(nostack, preserves_flags)) };
    }
    // SAFETY: it waits for what came before.
    unsafe { asm!("dsb ish", options(nostack, preserves_flags)) };
    for line in lines(code, instructions) {
        // SAFETY: the line has a byte of `code`; it is fetched anew.
        unsafe { asm!("ic ivau, {}", in(reg) line, options(nostack, preserves_flags)) };
    }
    // SAFETY: they wait for what came before.
    unsafe { asm!("dsb ish", "isb", options(nostack, preserves_flags)) };
}

/// The shortest lines of the caches of data and of instructions, in bytes. Where a system keeps the
/// register for itself, it answers in its stead.
fn line_lengths() -> [usize; 2] {
    let types: u64;
    // SAFETY: it reads a register that programs may read.
    unsafe { asm!("mrs {}, ctr_el0", out(reg) types, options(nomem, nostack, preserves_flags)) };
    // Logarithms of words of four bytes.
    [16, 0].map(|shift| 4 << (types >> shift & 0xf))
}

/// An address in each line that has a byte of some code.
fn lines(code: &[u8], length: usize) -> impl Iterator<Item = usize> {
    let start = code.as_ptr().expose_provenance();
    (start / length * length..start + code.len()).step_by(length)
}

/// Discards what this thread has fetched before now, so that it runs what was
/// [published](publish) before.
pub(super) fn discard_fetched() {
    // SAFETY: instructions that follow are fetched anew.
    unsafe { asm!("isb", options(nostack, preserves_flags)) };
}
