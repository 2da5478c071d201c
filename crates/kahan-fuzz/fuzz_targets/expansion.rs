//! Fuzzes the macro's expansion of a text.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::expand(bytes));
