//! Programs for machine code, on every set of instructions of this machine.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::run_program(bytes));
