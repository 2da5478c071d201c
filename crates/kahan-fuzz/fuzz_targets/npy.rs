//! Fuzzes the reader of NumPy arrays.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kahan_fuzz::read_npy(bytes));
