//! What the page's worker calls, and what it lends: a clock, an ear for progress, and one for
//! findings.
//!
//! A question is a text: the worker asks for `room`, writes the text there, calls `ask`, and reads
//! the answer at `answer` and the columns at `columns`, each with its length. What it was given
//! before is no longer valid then. `unsafe` are the names of what is exported, of which no library
//! below has one.
#![allow(unsafe_code)]

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_study::{Finding, Progress, Watch};
use serde_json::json;

use crate::ask::{Answered, Asker};

// SAFETY: the worker brings functions with these signatures, and none of them touches what is ours:
// they read `length` bytes from `text` on, which stay as they are while they run.
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// The milliseconds since the worker began.
    safe fn now() -> f64;
    /// Hears how far work is, or why it failed, as JSON.
    safe fn look(text: *const u8, length: usize);
    /// Hears of a finding, as JSON.
    safe fn found(text: *const u8, length: usize);
}

/// The worker.
struct Page;

impl Watch for Page {
    fn now(&self) -> Option<Duration> {
        Some(Duration::from_secs_f64(now() / 1e3))
    }

    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
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
    static STATE: RefCell<State> = RefCell::default();
}

// SAFETY of the exports: no other crate here exports these names.

/// Where the worker writes a question of so many bytes.
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        state.question.clear();
        state.question.resize(length, 0);
        state.question.as_mut_ptr()
    })
}

/// Answers the question, and gives the length of the answer.
#[unsafe(no_mangle)]
extern "C" fn ask() -> usize {
    // A panic ends the worker; the page is told why before that.
    std::panic::set_hook(Box::new(|panic| {
        let text = json!({"failed": panic.payload_as_str()}).to_string();
        look(text.as_ptr(), text.len());
    }));
    STATE.with_borrow_mut(|State { question, asker, answered }| {
        *answered = asker.ask(&String::from_utf8_lossy(question), &Page);
        answered.json.len()
    })
}

/// Where the answer stands.
#[unsafe(no_mangle)]
extern "C" fn answer() -> *const u8 {
    STATE.with_borrow(|state| state.answered.json.as_ptr())
}

/// Where the columns stand.
#[unsafe(no_mangle)]
extern "C" fn columns() -> *const f64 {
    STATE.with_borrow(|state| state.answered.columns.as_ptr())
}

/// How many floats these are.
#[unsafe(no_mangle)]
extern "C" fn floats() -> usize {
    STATE.with_borrow(|state| state.answered.columns.len())
}
