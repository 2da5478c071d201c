//! The interface to the observer of a long computation.
//!
//! The caller provides clock, threads and screen as a [`Watch`], so computations also run in a
//! notebook, and in a browser without a clock.

use std::fmt;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::Claim;

/// The observer of a long computation. The default methods provide no clock and one thread, and
/// ignore all calls.
pub trait Watch: Sync {
    /// Returns the time since a fixed moment, or `None` without a clock. Time limits then do not
    /// apply.
    fn now(&self) -> Option<Duration> {
        None
    }

    /// Receives the progress. The answer `Break` ends the computation as if its time limit had
    /// passed, and the watch is not called again.
    ///
    /// `look` is called at the start of each stage and after each finding. During a stage that
    /// counts items, a watch with a clock is called at most a few times a second.
    fn look(&self, _progress: &Progress<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Receives a finding as soon as it is proved.
    fn found(&self, _finding: &Finding) {}

    /// Returns the number of threads to use, at least 1. Results do not depend on the number.
    fn threads(&self) -> usize {
        1
    }
}

/// The progress of a computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress<'a> {
    /// The name of the counted items, for example `steps`, or of the stage that begins.
    pub what: &'a str,
    /// The number of finished items.
    pub done: u64,
    /// The total number of items, if known.
    pub of: Option<u64>,
}

impl<'a> Progress<'a> {
    /// Announces a stage by its name.
    #[must_use]
    pub fn stage(what: &'a str) -> Self {
        Progress { what, done: 0, of: None }
    }
}

impl fmt::Display for Progress<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.of {
            Some(of) => write!(f, "{} of {of} {}", self.done, self.what),
            None if self.done > 0 => write!(f, "{} {}", self.done, self.what),
            None => f.write_str(self.what),
        }
    }
}

/// A proved property of a map, as a claim in the language of `kahan!`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The kind of the claim.
    pub kind: ClaimKind,
    /// The name of the claim.
    pub name: String,
    /// The claim as a line of text that can be pasted.
    pub text: String,
}

impl Finding {
    pub(crate) fn claimed(claim: &Claim, text: &str) -> Self {
        Finding { kind: claim.kind, name: claim.name.text.clone(), text: text.to_owned() }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A watch that has no clock, provides one thread, and ignores all calls.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {}
