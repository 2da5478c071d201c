//! Fuzzes the TOML reader for parameter sweeps.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::read_plan(bytes));
