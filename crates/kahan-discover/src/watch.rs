//! The interface to the observer of a long computation: clock, threads, progress, findings, and
//! stop.
//!
//! Libraries have no clock, threads or screen of their own. The caller provides them as a
//! [`Watch`], so computations also run in a notebook, and in a browser without a clock.

use std::fmt;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::Claim;

/// The observer of a long computation. Default methods provide no clock and one thread, and ignore
/// all calls.
pub trait Watch: Sync {
    /// Returns the time since a fixed moment; `None` without a clock, so time limits do not apply.
    fn now(&self) -> Option<Duration> {
        None
    }

    /// Receives the progress; `Break` ends the computation. After `Break` the watch is called no
    /// more, and the result is that of an elapsed time limit. `look` is called when a stage begins,
    /// after each finding, and otherwise at most a few times a second if a clock exists.
    fn look(&self, _progress: &Progress<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Receives a finding as soon as it is proved.
    fn found(&self, _finding: &Finding) {}

    /// Returns the number of threads to use, at least 1; results do not depend on it.
    fn threads(&self) -> usize {
        1
    }
}

/// The progress of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress<'a> {
    /// The unit of the count, for example `steps`, or the stage that begins.
    pub what: &'a str,
    /// The number of units done.
    pub done: u64,
    /// The total number of units, if known.
    pub of: Option<u64>,
}

impl<'a> Progress<'a> {
    /// Announces a stage.
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
    /// The claim as a line that can be pasted.
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

/// A watch without a clock, with one thread, that ignores all calls.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {}
