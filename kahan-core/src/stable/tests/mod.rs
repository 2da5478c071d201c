//! The running bound beside exact rationals, one topic a file.

mod rules;
mod underflow;
mod worst;
