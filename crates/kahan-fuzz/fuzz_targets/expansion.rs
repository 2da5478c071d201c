//! Expands texts as the macro does.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::expand(bytes));
