//! The Diophantine integrability test on one orbit: heights, growth and entropy.

use std::ops::ControlFlow;
use std::time::Duration;

use super::growth::Growth;
use super::orbit::HeightsOrbit;
use super::report::{Heights, Stop};

/// The results of the Diophantine test on one orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct DiophantineTest {
    /// The heights of x₀, x₁, …, as far as the orbit went.
    pub heights: Vec<Heights>,
    /// The growth class of the component whose height rises most.
    pub growth: Growth,
    /// log(h_n/h_{n−1}) at the last step n, for the coordinate with the largest height h at step n;
    /// 0 unless growth is exponential. For large n this tends to the Diophantine entropy.
    pub entropy: f64,
    /// The reason why the orbit ended before the last step; `None` if all steps were made.
    pub stopped: Option<Stop>,
}

impl DiophantineTest {
    /// Follows an orbit for `steps` steps.
    pub fn of(orbit: &mut HeightsOrbit, steps: u64) -> Self {
        DiophantineTest::within(orbit, steps, f64::INFINITY, &|| None, |_| ControlFlow::Continue(()))
    }

    /// Follows an orbit for `steps` steps, or until `clock` shows `seconds` seconds.
    ///
    /// A step that would probably end after `seconds` is not begun. If `clock` returns `None`,
    /// there is no time limit. `each` receives the heights in order, h(x₀) first, and may end the
    /// orbit.
    pub fn within(
        orbit: &mut HeightsOrbit,
        steps: u64,
        seconds: f64,
        clock: &dyn Fn() -> Option<Duration>,
        mut each: impl FnMut(&Heights) -> ControlFlow<()>,
    ) -> Self {
        let now = || clock().map(|now| now.as_secs_f64());
        let mut heights = Vec::new();
        let (mut last, mut goes_on, mut stopped) = (0.0, true, None);
        for step in 0..=steps {
            let begun = now();
            // `Stop::Digits` does not depend on the clock, so it is reported if both limits apply.
            let is_late = begun.is_some_and(|begun| begun + last * orbit.slowdown() > seconds)
                && orbit.check_expected_digits().is_ok();
            if step > 0 && (is_late || !goes_on) {
                stopped = Some(Stop::Seconds);
                break;
            }
            let Some(found) = orbit.next() else { break };
            last = now().zip(begun).map_or(0.0, |(now, begun)| now - begun);
            goes_on = each(&found).is_continue();
            heights.push(found);
        }
        let growth = Growth::of(series(&heights, steepest(&heights)).get(1..).unwrap_or_default());
        let series = series(&heights, largest(&heights));
        let entropy = match series.as_slice() {
            [.., before, last] if growth == Growth::Exponential => libm::log(last / before),
            _ => 0.0,
        };
        DiophantineTest { heights, growth, entropy, stopped: stopped.or(orbit.stopped()) }
    }

    /// Returns h(xᵢ) of component `i` at n = 0, 1, ….
    ///
    /// # Panics
    /// If the index is out of range.
    #[must_use]
    pub fn component(&self, i: usize) -> Vec<f64> {
        series(&self.heights, i)
    }

    /// Returns the component with the greatest height at the last step, or the first of equal ones.
    #[must_use]
    pub fn largest(&self) -> usize {
        largest(&self.heights)
    }
}

fn series(heights: &[Heights], component: usize) -> Vec<f64> {
    heights.iter().map(|heights| heights.logarithms[component]).collect()
}

fn largest(heights: &[Heights]) -> usize {
    let last = heights.last().map(|last| last.logarithms.as_slice()).unwrap_or_default();
    (1..last.len()).fold(0, |best, i| if last[i] > last[best] { i } else { best })
}

/// Returns the component whose height rises most, from h₁ to the last height.
fn steepest(heights: &[Heights]) -> usize {
    let (Some(first), Some(last)) = (heights.get(1), heights.last()) else { return 0 };
    let rise = |i: usize| last.logarithms[i] - first.logarithms[i];
    (1..last.logarithms.len()).fold(0, |best, i| if rise(i) > rise(best) { i } else { best })
}
