//! Fuzzes the compiler: each random program runs as machine code in a random instruction set.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::run_program(bytes));
