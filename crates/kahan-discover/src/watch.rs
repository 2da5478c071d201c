//! Who watches long work: tells the time, hears how far it is and what it found, and stops it.
//!
//! Libraries have neither clock nor threads nor screen of their own. Whoever asks a long question
//! brings them along as a [`Watch`], so that the same work runs at a prompt, in a notebook, and in a
//! browser, where there is no clock to read.

use std::fmt;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::syntax::ClaimKind;

/// What long work may use, and whom it tells.
pub trait Watch: Sync {
    /// The time since a moment that stays the same; `None` where there is no clock. Then work that
    /// is bounded by time alone goes on to its other bounds.
    fn now(&self) -> Option<Duration>;

    /// Hears how far the work is; `Break` ends it, and what is known by then is the answer. Work
    /// calls this some times a second at most, and at least when a stage begins.
    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()>;

    /// Hears of a finding as soon as it is proved.
    fn found(&self, finding: &Finding);

    /// How many threads the work may use, at least 1. Answers do not depend on it.
    fn threads(&self) -> usize;
}

/// How far work is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress<'a> {
    /// What is counted, `steps`, or the stage that begins, `degrees of iterates`.
    pub what: &'a str,
    /// How many of these are done.
    pub done: u64,
    /// How many there will be, where that is known.
    pub of: Option<u64>,
}

impl<'a> Progress<'a> {
    /// A stage that begins.
    #[must_use]
    pub fn stage(what: &'a str) -> Self {
        Progress { what, done: 0, of: None }
    }
}

/// Something that a map keeps, as a claim of the language of `kahan!`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Integral, density, or bracket.
    pub kind: ClaimKind,
    /// The claim's name.
    pub name: String,
    /// The claim as a line that can be pasted.
    pub text: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Nobody watches: no clock, one thread, nothing is told and nothing stopped.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn now(&self) -> Option<Duration> {
        None
    }

    fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn found(&self, _: &Finding) {}

    fn threads(&self) -> usize {
        1
    }
}
