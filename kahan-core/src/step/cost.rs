//! The cost of a step.

/// The cost of a step, counted in its plan; deterministic, for comparing settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// Additions, subtractions, multiplications and divisions; a multiply-add counts as two.
    pub operations: u32,
    /// Divisions, which are also counted in `operations`.
    pub divisions: u32,
    /// Latency in cycles from one state to the next, with 3 cycles per addition, 4 per
    /// multiplication and 14 per division.
    pub critical_path: u32,
}

impl StepCost {
    /// Creates a cost; `operations` includes the `divisions`.
    pub const fn of(operations: u32, divisions: u32, critical_path: u32) -> Self {
        StepCost { operations, divisions, critical_path }
    }

    /// Returns the cycles of a step: the larger of latency and throughput, at two operations per
    /// cycle and four cycles per division.
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
