//! What a step costs.

/// What a step costs, counted in the plan that it runs: the deterministic measure by which settings
/// are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// Additions, subtractions, multiplications and divisions; a multiply-add counts as two.
    pub operations: u32,
    /// The divisions among them.
    pub divisions: u32,
    /// Cycles from one state to the next in an orbit, where each step waits for the one before, on
    /// a core of today: additions take 3, multiplications 4, divisions 14.
    pub critical_path: u32,
}

impl StepCost {
    /// So many operations, divisions among them, and cycles from one state to the next.
    pub const fn of(operations: u32, divisions: u32, critical_path: u32) -> Self {
        StepCost { operations, divisions, critical_path }
    }

    /// The cycles of a step: the longer of what it waits for and what it has to do, at two
    /// operations a cycle and four cycles a division.
    pub fn cycles(self) -> f64 {
        let work = f64::from(self.operations) / 2.0 + 4.0 * f64::from(self.divisions);
        work.max(f64::from(self.critical_path))
    }

    /// What elimination in n variables costs, a multiplication and an addition an entry of each row
    /// below a pivot; A(x,ε) and f(x) are taken as dense.
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
