//! Runs long computations without the interpreter's lock, on threads of their own. The calling
//! thread reports progress, and handles Ctrl-C.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use kahan_runtime::threads;
use kahan_study::{Finding, Progress, Watch};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

const LOOK: Duration = Duration::from_millis(10);
const TOLD: Duration = Duration::from_millis(100);
/// Work that computes at most this many numbers runs without a check for signals.
const SHORT: u64 = 1 << 16;
/// The stack size of a working thread. Recursion over long formulas needs more than the default.
const STACK: usize = 64 << 20;

/// A [`Watch`] that tells the waiting thread about progress, and may stop the computation.
pub(crate) struct Caller {
    stop: AtomicBool,
    is_done: AtomicBool,
    /// The thread that waits for the work.
    waiting: thread::Thread,
    since: Instant,
    threads: usize,
    made: AtomicU64,
    news: Mutex<PendingNews>,
}

#[derive(Default)]
struct PendingNews {
    progress: Option<(String, u64, Option<u64>)>,
    found: Vec<[String; 3]>,
}

impl Caller {
    fn new(threads: Option<usize>) -> Self {
        Caller {
            stop: AtomicBool::new(false),
            is_done: AtomicBool::new(false),
            waiting: thread::current(),
            since: Instant::now(),
            threads: threads.unwrap_or_else(threads::available).max(1),
            made: AtomicU64::new(0),
            news: Mutex::default(),
        }
    }

    /// Adds finished steps, out of `of` steps in all; returns `Break` if the work must end.
    pub(crate) fn made(&self, steps: u64, of: u64) -> ControlFlow<()> {
        let done = self.made.fetch_add(steps, Ordering::Relaxed) + steps;
        self.look(&Progress { what: "steps", done, of: Some(of) })
    }

    /// Returns whether the work must end.
    pub(crate) fn wants_no_more(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Returns `Break` if the work must end.
    pub(crate) fn goes_on(&self) -> ControlFlow<()> {
        if self.wants_no_more() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Does the work, and then wakes the waiting thread, even after a panic.
    fn does<R>(&self, work: impl FnOnce(&Caller) -> R) -> R {
        let _woken = WakeOnDrop(self);
        work(self)
    }

    /// Waits for the work, and reports progress and findings. A Python exception ends the work.
    fn wait(&self, py: Python<'_>, listener: &Listener<'_>) -> PyResult<()> {
        let mut told = Instant::now();
        while !self.is_done.load(Ordering::Acquire) {
            py.detach(|| thread::park_timeout(LOOK));
            let mut raised = py.check_signals();
            if raised.is_ok() && told.elapsed() >= TOLD {
                told = Instant::now();
                raised = listener.hears(self.news());
            }
            raised.inspect_err(|_| self.stop.store(true, Ordering::Relaxed))?;
        }
        Ok(())
    }

    fn news(&self) -> PendingNews {
        std::mem::take(&mut self.news.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn tell(&self, add: impl FnOnce(&mut PendingNews)) {
        add(&mut self.news.lock().unwrap_or_else(PoisonError::into_inner));
    }
}

impl Watch for Caller {
    fn now(&self) -> Option<Duration> {
        Some(self.since.elapsed())
    }

    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        self.tell(|news| news.progress = Some((progress.what.to_owned(), progress.done, progress.of)));
        self.goes_on()
    }

    fn found(&self, finding: &Finding) {
        let Finding { kind, name, text } = finding;
        self.tell(|news| news.found.push([kind.keyword().to_owned(), name.clone(), text.clone()]));
    }

    fn threads(&self) -> usize {
        self.threads
    }
}

/// A listener in Python. Progress is passed as a name, a number and the total. A finding is passed
/// as `found`, kind, name and text.
pub(crate) struct Listener<'py>(pub(crate) Option<Bound<'py, PyAny>>);

impl Listener<'_> {
    fn hears(&self, news: PendingNews) -> PyResult<()> {
        let Some(listener) = &self.0 else { return Ok(()) };
        for finding in news.found {
            listener.call1(("found", finding, ()))?;
        }
        match news.progress {
            Some((what, done, of)) => listener.call1((what, done, of)).map(|_| ()),
            None => Ok(()),
        }
    }
}

/// Does work on another thread, and releases the interpreter's lock meanwhile.
///
/// # Errors
/// Fails if a signal handler or the listener raises an exception, or if the work panics.
pub(crate) fn run_watched<R: Send>(
    py: Python<'_>,
    threads: Option<usize>,
    listener: &Listener<'_>,
    work: impl FnOnce(&Caller) -> R + Send,
) -> PyResult<R> {
    let caller = Caller::new(threads);
    thread::scope(|scope| {
        let worker = worker().spawn_scoped(scope, || caller.does(work)).map_err(no_thread)?;
        let raised = caller.wait(py, listener);
        // After the request to end, the work ends within a moment.
        let result = py.detach(|| worker.join());
        raised?;
        listener.hears(caller.news())?;
        result.map_err(|_| internal_error())
    })
}

/// Works like [`run_watched`], but does short work on the caller's thread, because starting a
/// thread takes some tens of microseconds.
pub(crate) fn run_watched_if_long<R: Send>(
    py: Python<'_>,
    numbers: u64,
    listener: &Listener<'_>,
    work: impl FnOnce(&Caller) -> R + Send,
) -> PyResult<R> {
    if numbers > SHORT {
        return run_watched(py, Some(1), listener, work);
    }
    let caller = Caller::new(Some(1));
    let result = catch_unwind(AssertUnwindSafe(|| work(&caller))).map_err(|_| internal_error())?;
    listener.hears(caller.news())?;
    Ok(result)
}

/// Works like [`run_watched`], but does not wait for the end of cancelled work.
pub(crate) fn run_detached<R: Send + 'static>(
    py: Python<'_>,
    threads: Option<usize>,
    listener: &Listener<'_>,
    work: impl FnOnce(&Caller) -> R + Send + 'static,
) -> PyResult<R> {
    let caller = Arc::new(Caller::new(threads));
    let theirs = Arc::clone(&caller);
    let worker = worker().spawn(move || theirs.does(work)).map_err(no_thread)?;
    caller.wait(py, listener)?;
    let result = worker.join();
    listener.hears(caller.news())?;
    result.map_err(|_| internal_error())
}

fn worker() -> thread::Builder {
    thread::Builder::new().stack_size(STACK)
}

fn no_thread(error: std::io::Error) -> PyErr {
    PyRuntimeError::new_err(format!("no thread can be had: {error}"))
}

fn internal_error() -> PyErr {
    PyRuntimeError::new_err("kahan has a mistake here; please report what was asked")
}

/// Marks the work as done on drop, and wakes the waiting thread.
struct WakeOnDrop<'a>(&'a Caller);

impl Drop for WakeOnDrop<'_> {
    fn drop(&mut self) {
        self.0.is_done.store(true, Ordering::Release);
        self.0.waiting.unpark();
    }
}
