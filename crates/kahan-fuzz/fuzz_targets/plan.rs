//! Fuzzes the reader of plans of sweeps in TOML.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::read_plan(bytes));
