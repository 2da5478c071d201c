//! Tests that questions report progress to a watch, and that the watch can cancel them.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use kahan_study::{Answer, Progress, Subject, Watch};
use serde_json::json;

use super::{Clock, Listening, question, study};

#[test]
fn findings_are_told_when_they_are_proved() {
    let e6 = study(Subject::named("e6"));
    for stops_at_first in [false, true] {
        let watch = Listening { clock: Clock::default(), heard: Mutex::default(), stops_at_first };
        let asked = question(json!({"ask": "discover", "degree": 2})).expect("a question");
        let Ok(Answer::Discover(found)) = e6.ask(&asked, &watch) else { panic!("a report") };
        let heard = watch.heard.into_inner().expect("no listener fails");
        let claims: Vec<&str> = found.claims().map(|(text, _)| text).collect();
        assert!(heard.iter().all(|text| claims.contains(&text.as_str())), "{heard:?} of {claims:?}");
        assert_eq!(heard.len(), if stops_at_first { 1 } else { claims.len() });
        assert_eq!(found.report.out_of_time, stops_at_first);
    }
}

/// A watch that asks to stop at each check, and counts the checks.
struct Ending {
    clock: Clock,
    looks: AtomicU32,
}

impl Watch for Ending {
    fn now(&self) -> Option<Duration> {
        Some(self.clock.read())
    }

    fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
        self.looks.fetch_add(1, Ordering::Relaxed);
        ControlFlow::Break(())
    }
}

#[test]
fn a_question_that_was_stopped_asks_no_more() {
    let lv = study(Subject::named("lv"));
    let over = json!({"eps": "1/10:1:9"});
    for object in [
        json!({"ask": "orbit", "eps": "1/10", "at": [1, 2], "steps": 100_000}),
        json!({"ask": "observe", "eps": "1/10", "at": [1, 2], "steps": 100_000}),
        json!({"ask": "section", "eps": "1/10", "at": [1, 2], "steps": 100_000, "plane": "x - y"}),
        json!({"ask": "periodic", "at": [1, 1], "over": over}),
        json!({"ask": "heights", "eps": "9/14", "at": ["1/2", "5/3"], "steps": 9}),
        json!({"ask": "poles"}),
        json!({"ask": "discover"}),
        json!({"ask": "scan", "over": over}),
        json!({"ask": "trade", "at": [1, 2], "horizon": 5}),
    ] {
        let watch = Ending { clock: Clock::default(), looks: AtomicU32::new(0) };
        lv.ask(&question(object.clone()).expect("a question"), &watch).expect("what is known by then");
        assert_eq!(watch.looks.into_inner(), 1, "{object}");
    }
}
