//! The functions that the page's worker calls, and the functions that the worker provides.
//!
//! The worker writes a question to the memory of `room`, calls `ask`, and reads `answer` and
//! `columns`. A later call makes these pointers invalid.
#![allow(unsafe_code)]

use std::cell::{Cell, RefCell};
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_study::{Finding, Progress, Watch};
use serde_json::json;

use crate::ask::{Answered, Asker};

// SAFETY: the worker provides functions with these signatures. A call reads the `length` bytes at
// `text`, and touches no other memory of this module.
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Returns the milliseconds since the worker began.
    safe fn now() -> f64;
    /// Receives the progress of work, or the reason why it failed, as JSON.
    safe fn look(text: *const u8, length: usize);
    /// Receives a finding, as JSON.
    safe fn found(text: *const u8, length: usize);
}

/// The page's worker as a receiver of progress.
struct Page;

impl Watch for Page {
    fn now(&self) -> Option<Duration> {
        Some(Duration::from_secs_f64(now() / 1e3))
    }

    /// Some orbits report every step, so at most ten reports a second are passed on.
    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        let time = now();
        if progress.of.is_some() && time - LAST_LOOK.get() < 100.0 {
            return ControlFlow::Continue(());
        }
        LAST_LOOK.set(time);
        let text = json!({"what": progress.what, "done": progress.done, "of": progress.of}).to_string();
        look(text.as_ptr(), text.len());
        ControlFlow::Continue(())
    }

    fn found(&self, finding: &Finding) {
        let text =
            json!({"kind": finding.kind.keyword(), "name": finding.name, "text": finding.text}).to_string();
        found(text.as_ptr(), text.len());
    }
}

#[derive(Default)]
struct State {
    question: Vec<u8>,
    asker: Asker,
    answered: Answered,
}

thread_local! {
    /// The time in milliseconds at which progress was passed on last.
    static LAST_LOOK: Cell<f64> = const { Cell::new(f64::NEG_INFINITY) };
    static STATE: RefCell<State> = RefCell::default();
}

// SAFETY of `no_mangle` below: no other crate in the WebAssembly module exports these names.

/// Returns the address at which the worker writes a question of `length` bytes.
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        state.question.clear();
        state.question.resize(length, 0);
        state.question.as_mut_ptr()
    })
}

/// Answers the question, and returns the length of the answer in bytes.
#[unsafe(no_mangle)]
extern "C" fn ask() -> usize {
    // A panic ends the worker. Before that, the page is told the reason.
    std::panic::set_hook(Box::new(|panic| {
        let text = json!({"failed": panic.payload_as_str()}).to_string();
        look(text.as_ptr(), text.len());
    }));
    STATE.with_borrow_mut(|State { question, asker, answered }| {
        *answered = asker.ask(&String::from_utf8_lossy(question), &Page);
        answered.json.len()
    })
}

#[unsafe(no_mangle)]
extern "C" fn answer() -> *const u8 {
    STATE.with_borrow(|state| state.answered.json.as_ptr())
}

#[unsafe(no_mangle)]
extern "C" fn columns() -> *const f64 {
    STATE.with_borrow(|state| state.answered.columns.as_ptr())
}

/// Returns the number of floats in all columns of the last answer together.
#[unsafe(no_mangle)]
extern "C" fn floats() -> usize {
    STATE.with_borrow(|state| state.answered.columns.len())
}
