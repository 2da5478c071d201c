//! The cost of a step.

/// The cost of a step, in numbers of operations and in cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// The number of additions, subtractions, multiplications and divisions. A multiply-add is
    /// counted twice.
    pub operations: u32,
    /// The number of divisions, which `operations` also counts.
    pub divisions: u32,
    /// The latency from one state to the next, in cycles. An addition takes 3 cycles, a
    /// multiplication 4 cycles, a division 14 cycles.
    pub critical_path: u32,
}

impl StepCost {
    /// Creates a cost. `operations` must include the `divisions`.
    pub const fn of(operations: u32, divisions: u32, critical_path: u32) -> Self {
        StepCost { operations, divisions, critical_path }
    }

    /// Returns the cycles of a step: the larger of the latency `critical_path` and the throughput
    /// limit, half a cycle per operation plus four cycles per division.
    pub fn cycles(self) -> f64 {
        let work = f64::from(self.operations) / 2.0 + 4.0 * f64::from(self.divisions);
        work.max(f64::from(self.critical_path))
    }

    /// Returns the cost of a step by elimination in n variables, with dense A(x,ε) and f(x).
    pub const fn of_elimination(n: usize) -> Self {
        let n = n as u32;
        let (matrix, field) = (2 * n * n * n, n * n * (n + 1));
        let elimination = (2 * n * n * n + 9 * n * n) / 3;
        StepCost {
            operations: matrix + field + elimination + 3 * n,
            divisions: n,
            critical_path: 12 + n * 36,
        }
    }
}
