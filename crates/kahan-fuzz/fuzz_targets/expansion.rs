//! Fuzzes the expansion of texts as the macro does it.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::expand(bytes));
