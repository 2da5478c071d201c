//! Fuzzes programs as machine code, in every instruction set of this machine.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::run_program(bytes));
