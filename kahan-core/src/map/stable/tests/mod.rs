//! The running bound beside exact rationals, one topic a file.

mod rules;
mod steps;
mod underflow;
mod worst;
