//! Fuzzes the reader of equations in many notations.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::read_text(bytes));
