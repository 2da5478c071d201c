//! A watch that records its calls.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use kahan_discover::{Finding, Progress, Watch};

#[derive(Debug, Default)]
pub(crate) struct Recording {
    /// The clock in µs, which advances by 100 µs at each reading.
    clock: Option<AtomicU64>,
    most_findings: Option<usize>,
    is_ended: AtomicBool,
    looks: Mutex<Vec<String>>,
    findings: Mutex<Vec<Finding>>,
}

impl Recording {
    pub(crate) fn with_a_clock() -> Self {
        Recording { clock: Some(AtomicU64::new(0)), ..Recording::default() }
    }

    pub(crate) fn ending_after(self, findings: usize) -> Self {
        Recording { most_findings: Some(findings), ..self }
    }

    pub(crate) fn looks(&self) -> Vec<String> {
        self.looks.lock().expect("no thread panics").clone()
    }

    pub(crate) fn findings(&self) -> Vec<Finding> {
        self.findings.lock().expect("no thread panics").clone()
    }

    fn is_called(&self) {
        assert!(!self.is_ended.load(Ordering::Relaxed), "work that is ended goes on");
    }
}

impl Watch for Recording {
    fn now(&self) -> Option<Duration> {
        self.is_called();
        Some(Duration::from_micros(self.clock.as_ref()?.fetch_add(100, Ordering::Relaxed)))
    }

    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        self.is_called();
        self.looks.lock().expect("no thread panics").push(progress.to_string());
        let ends = self.most_findings.is_some_and(|most| self.findings().len() >= most);
        self.is_ended.store(ends, Ordering::Relaxed);
        if ends { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn found(&self, finding: &Finding) {
        self.is_called();
        self.findings.lock().expect("no thread panics").push(finding.clone());
    }
}
