//! Compares the running error bound with exact rationals.

mod rules;
mod steps;
mod underflow;
mod worst;
