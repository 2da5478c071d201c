//! Fuzzes the compiler: random programs run as machine code, in all available instruction sets.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::run_program(bytes));
