//! Implements `kahan-core`'s trait [`LatticeMap`] for a family whose parameters have values.

use std::sync::Arc;

use kahan_core::__private::chain::{Gathered, SiteLine, StencilMenu};
use kahan_core::__private::{Boundary, Lanes, LatticeMap, Sizes};
use kahan_core::Scalar;

use super::LatticeCode;

#[derive(Clone, Debug)]
pub(super) struct RuntimeFamily {
    pub(super) code: Arc<LatticeCode>,
    pub(super) parameters: Arc<[f64]>,
    pub(super) site_parameters: Arc<[Vec<f64>]>,
}

/// Names and sizes are known at run time, so the constants of the trait are placeholders.
impl LatticeMap<f64> for RuntimeFamily {
    const ARRAYS: &'static [&'static str] = &[];
    const REACH: usize = 0;
    const HAMILTONIAN: Option<&'static str> = Some("");

    type Kernels = StencilMenu;

    fn sizes(&self) -> Sizes {
        self.code.sizes
    }

    fn boundary(&self) -> Boundary {
        self.code.boundary
    }

    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&f64) -> L) -> Option<Vec<L>> {
        let line = &self.code.constants;
        let mut registers = vec![L::zero(); line.registers()];
        let given = self.parameters.iter().map(convert).chain([eps]);
        let prepared = line.results(given, &mut registers, &[])?;
        let literals = self.code.literals.iter().map(|literal| L::constant(&literal.as_constant()));
        Some(prepared.iter().chain(literals).collect())
    }

    fn site_parameter(&self, index: usize) -> &[f64] {
        &self.site_parameters[index]
    }

    fn rows<L: Scalar>(
        &self,
        constants: &[L],
        x: &[L],
        c: &[L],
        registers: &mut [L],
        f: &mut [L],
        a: &mut [L],
    ) {
        let block = self.code.sizes.block;
        self.code.rows.run(constants, x, c, registers);
        f.clone_from_slice(&registers[..block]);
        for &entry in &self.code.entries {
            a[entry] = registers[block + entry].clone();
        }
    }

    #[inline(always)]
    fn line<L: Lanes<f64>, const B: usize, const P: usize, const C: usize, const SITES: usize>(
        &self,
        sites: &mut Gathered<'_, f64, L, C>,
    ) -> SiteLine<L, B, SITES> {
        self.code.rows.line(sites)
    }

    fn integral_count(&self) -> usize {
        self.code.family.integrals.len()
    }

    fn densities<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], registers: &mut [L], s: &mut [L]) {
        self.code.sums.run(constants, x, c, registers);
        s.iter_mut().zip(registers).for_each(|(sum, density)| sum.clone_from(density));
    }
}
