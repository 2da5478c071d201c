//! Who watches long work: tells the time, hears how far it is and what it found, and stops it.
//!
//! Libraries have neither clock nor threads nor screen of their own. Whoever asks a long question
//! brings them along as a [`Watch`], so that the same work runs at a prompt, in a notebook, and in
//! a browser, where there is no clock to read.

use std::fmt;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::Claim;

/// What long work may use, and whom it tells. Whoever watches says what it has a use for; all else
/// is as if nobody watched.
pub trait Watch: Sync {
    /// The time since a moment that stays the same; `None` where there is no clock. Then work that
    /// is bounded by time alone goes on to its other bounds.
    fn now(&self) -> Option<Duration> {
        None
    }

    /// Hears how far the work is. `Break` ends it: the watch hears no more, and what is known by
    /// then is the answer, as if the time were over. Work calls this when a stage begins,
    /// after each finding, and else some times a second at most, as far as there is a clock.
    fn look(&self, _progress: &Progress<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Hears of a finding as soon as it is proved.
    fn found(&self, _finding: &Finding) {}

    /// How many threads the work may use, at least 1. Answers do not depend on it.
    fn threads(&self) -> usize {
        1
    }
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

/// A count or a stage in words.
impl fmt::Display for Progress<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.of {
            Some(of) => write!(f, "{} of {of} {}", self.done, self.what),
            None if self.done > 0 => write!(f, "{} {}", self.done, self.what),
            None => f.write_str(self.what),
        }
    }
}

/// Something that a map keeps, as a claim of the language of `kahan!`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Integral, density, bracket, or drift.
    pub kind: ClaimKind,
    /// The claim's name.
    pub name: String,
    /// The claim as a line that can be pasted.
    pub text: String,
}

impl Finding {
    /// The finding that a claim with this line is.
    pub(crate) fn claimed(claim: &Claim, text: &str) -> Self {
        Finding { kind: claim.kind, name: claim.name.text.clone(), text: text.to_owned() }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Nobody watches: no clock, one thread, nothing is told and nothing stopped.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {}
