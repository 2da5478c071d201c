//! Tests of the running error bound against exact rationals.

mod rules;
mod steps;
mod underflow;
mod worst;
