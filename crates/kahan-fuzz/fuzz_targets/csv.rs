//! Fuzzes the reader of tables of numbers.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::read_csv(bytes));
