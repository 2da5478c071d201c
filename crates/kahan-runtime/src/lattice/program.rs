//! The straight-line program of a site, run over one scalar or for several sites in SIMD lanes.
//!
//! In: a plan. Out: its results, in the first registers. Operations and their order are those of
//! the plan, so that bits equal those of a compiled family.

use kahan_algebra::plan::{Input, Node, Operation, Plan};
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::__private::chain::{Gathered, SiteLine};
use kahan_core::__private::{InLanes, Lanes, OverLanes};
use kahan_core::Scalar;

use crate::literal::Literal;

/// Each decoded instruction runs for this number of sites, a multiple of the number of lanes of
/// every instruction set.
const SITES_PER_INSTRUCTION: usize = 128;

#[derive(Debug)]
pub(super) struct Program {
    instructions: Vec<Instruction>,
    /// The number of results. The first registers hold only results.
    results: usize,
    registers: usize,
    /// The number of arrays in a site.
    block: usize,
    parameters: usize,
    reach: usize,
}

#[derive(Clone, Copy, Debug)]
struct Instruction {
    kind: Kind,
    /// The register of the result, different from all operands.
    to: usize,
    /// The operands. An instruction with fewer than three operands repeats the last operand.
    operands: [Operand; 3],
    /// The positions of the operands in the memory that holds several sites.
    places: [OperandOffset; 3],
}

/// The offset of an operand, `numbers` + `registers`·L for L SIMD lanes. L is known at run time.
#[derive(Clone, Copy, Debug, Default)]
struct OperandOffset {
    numbers: usize,
    registers: usize,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Copy,
    Add,
    Subtract,
    Multiply,
    Divide,
    Negate,
    MultiplyAdd,
    MultiplySubtract,
    SubtractProduct,
}

/// An operand. A `site` is an offset from the first site of the stencil.
#[derive(Clone, Copy, Debug)]
enum Operand {
    Constant(usize),
    State { site: usize, array: usize },
    Parameter { site: usize, index: usize },
    Register(usize),
}

pub(super) struct OperandNumbering<'a> {
    pub(super) symbols: &'a Symbols,
    pub(super) block: usize,
    pub(super) stencil: usize,
    pub(super) site_parameters: usize,
    /// The number of prepared constants; in memory, the plan's literals come after them.
    pub(super) prepared: usize,
}

impl Program {
    /// Compiles a plan. Result k goes to register `places[k]`, which is less than `results`.
    pub(super) fn of(
        plan: &Plan,
        places: impl IntoIterator<Item = usize>,
        results: usize,
        numbering: &OperandNumbering<'_>,
        literals: &mut Vec<Literal>,
    ) -> Self {
        let mut last_use = vec![0; plan.operations.len()];
        for (k, operation) in plan.operations.iter().enumerate() {
            operation.operands().for_each(|operand| last_use[operand.0] = k);
        }
        let places: Vec<(usize, Node)> = places.into_iter().zip(plan.outputs.iter().copied()).collect();
        let (block, parameters) = (numbering.block, numbering.site_parameters);
        let (reach, instructions) = (numbering.stencil / 2, Vec::new());
        let mut program = Program { instructions, results, registers: results, block, parameters, reach };
        let mut values: Vec<Operand> = Vec::with_capacity(plan.operations.len());
        let mut free = Vec::new();
        for (k, operation) in plan.operations.iter().enumerate() {
            let kind = match operation {
                Operation::Input(Input::Variable(variable)) => {
                    values.push(numbering.operand(numbering.symbols.symbol(*variable)));
                    continue;
                }
                Operation::Constant(value) => {
                    values.push(Operand::Constant(numbering.prepared + literals.len()));
                    literals.push(Literal::from(value));
                    continue;
                }
                Operation::Input(Input::Prepared(_)) => unreachable!("constants are inputs of a line"),
                Operation::Add(..) => Kind::Add,
                Operation::Subtract(..) => Kind::Subtract,
                Operation::Multiply(..) => Kind::Multiply,
                Operation::Divide(..) => Kind::Divide,
                Operation::Negate(_) => Kind::Negate,
                Operation::MultiplyAdd(..) => Kind::MultiplyAdd,
                Operation::MultiplySubtract(..) => Kind::MultiplySubtract,
                Operation::SubtractProduct(..) => Kind::SubtractProduct,
                Operation::Call(function, ..) => match *function {},
            };
            let place = places.iter().find(|(_, node)| node.0 == k).map(|(place, _)| *place);
            let to = place.or_else(|| free.pop()).unwrap_or_else(|| {
                program.registers += 1;
                program.registers - 1
            });
            program.put(kind, to, operation.operands().map(|operand| values[operand.0]));
            values.push(Operand::Register(to));
            for operand in operation.operands().filter(|operand| last_use[operand.0] == k) {
                if let Operand::Register(register) = values[operand.0]
                    && register >= results
                    && !free.contains(&register)
                {
                    free.push(register);
                }
            }
        }
        for (place, node) in places {
            if !matches!(values[node.0], Operand::Register(register) if register == place) {
                program.put(Kind::Copy, place, [values[node.0]].into_iter());
            }
        }
        // Operands get their positions only now, because constants come after all registers.
        for k in 0..program.instructions.len() {
            program.instructions[k].places =
                program.instructions[k].operands.map(|operand| program.place(operand));
        }
        program
    }

    fn put(&mut self, kind: Kind, to: usize, mut operands: impl Iterator<Item = Operand>) {
        let first = operands.next().unwrap_or_else(|| unreachable!("each kind takes an operand"));
        let second = operands.next().unwrap_or(first);
        let third = operands.next().unwrap_or(second);
        let (operands, places) = ([first, second, third], [OperandOffset::default(); 3]);
        self.instructions.push(Instruction { kind, to, operands, places });
    }

    /// Returns the position of an operand in memory: first registers, then arrays and site
    /// parameters, then constants. A register or constant takes one number for each of
    /// [`SITES_PER_INSTRUCTION`] sites. An array also holds neighbours of these sites.
    fn place(&self, operand: Operand) -> OperandOffset {
        let (numbers, registers) = match operand {
            Operand::Register(k) => (k * SITES_PER_INSTRUCTION, 0),
            Operand::State { site, array } => (self.array(array), site),
            Operand::Parameter { site, index } => (self.array(self.block + index), site),
            Operand::Constant(k) => (self.array(self.block + self.parameters) + k * SITES_PER_INSTRUCTION, 0),
        };
        OperandOffset { numbers, registers }
    }

    /// Returns the offset of array `index`; site parameters are the arrays from `block` on.
    fn array(&self, index: usize) -> usize {
        self.registers * SITES_PER_INSTRUCTION + index * (SITES_PER_INSTRUCTION + 2 * self.reach * f64::MOST)
    }

    /// Returns the size of the memory, counted in registers of the widest SIMD instruction set.
    pub(super) fn registers_abreast(&self, constants: usize) -> usize {
        self.place(Operand::Constant(constants)).numbers.div_ceil(f64::MOST)
    }

    pub(super) fn registers(&self) -> usize {
        self.registers
    }

    pub(super) fn run<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], registers: &mut [L]) {
        for Instruction { kind, to, operands, .. } in &self.instructions {
            let at = |k: usize| match operands[k] {
                Operand::Constant(place) => constants[place].clone(),
                Operand::State { site, array } => x[site * self.block + array].clone(),
                Operand::Parameter { site, index } => c[site * self.parameters + index].clone(),
                Operand::Register(place) => registers[place].clone(),
            };
            registers[*to] = match kind {
                Kind::Copy => at(0),
                Kind::Add => at(0) + at(1),
                Kind::Subtract => at(0) - at(1),
                Kind::Multiply => at(0) * at(1),
                Kind::Divide => at(0) / at(1),
                Kind::Negate => -at(0),
                Kind::MultiplyAdd => at(0).multiply_add(at(1), at(2)),
                Kind::MultiplySubtract => at(0).multiply_subtract(at(1), at(2)),
                Kind::SubtractProduct => at(0).subtract_product(at(1), at(2)),
            };
        }
    }

    /// Returns the results at the next site from a buffer, which is refilled if it is used up.
    #[inline(always)]
    pub(super) fn line<L: Lanes<f64>, const B: usize, const C: usize, const SITES: usize>(
        &self,
        sites: &mut Gathered<'_, f64, L, C>,
    ) -> SiteLine<L, B, SITES> {
        if sites.site >= sites.computed.end {
            self.compute(sites, L::WIDTH);
        }
        let results = &sites.registers[..(B + B * SITES * B) * SITES_PER_INSTRUCTION];
        let mut place = (sites.site - sites.computed.start) * L::WIDTH;
        assert!(place <= SITES_PER_INSTRUCTION - L::WIDTH, "sites are asked for in order");
        sites.site += 1;
        let mut line = SiteLine { f: [L::zero(); B], a: [[[L::zero(); B]; SITES]; B] };
        for b in 0..B {
            line.f[b] = L::load(results, place);
            place += SITES_PER_INSTRUCTION;
        }
        for b in 0..B {
            for k in 0..SITES {
                for e in 0..B {
                    line.a[b][k][e] = L::load(results, place);
                    place += SITES_PER_INSTRUCTION;
                }
            }
        }
        line
    }

    fn compute<L, const C: usize>(&self, gathered: &mut Gathered<'_, f64, L, C>, width: usize) {
        let Gathered { constants, x, c, level, site, .. } = *gathered;
        let numbers = &mut *gathered.registers;
        if gathered.computed.is_empty() {
            for (k, constant) in constants.iter().enumerate() {
                numbers[self.place(Operand::Constant(k)).numbers..][..SITES_PER_INSTRUCTION].fill(*constant);
            }
            // Set all results to 0, because no instruction writes those that are 0 in every state.
            numbers[..self.results * SITES_PER_INSTRUCTION].fill(0.0);
        }
        let sites = SITES_PER_INSTRUCTION / width;
        gathered.computed = site..site + sites;
        f64::run(RunOverLanes { program: self, x, c, numbers, width, site, sites }, level);
    }
}

impl OperandNumbering<'_> {
    /// Returns the operand that holds the value of a symbol.
    fn operand(&self, symbol: Symbol) -> Operand {
        let states = self.stencil * self.block;
        match symbol {
            Symbol::Parameter(k) => Operand::Constant(k),
            Symbol::State(k) if k < states => Operand::State { site: k / self.block, array: k % self.block },
            Symbol::State(k) => {
                Operand::Parameter { site: (k - states) % self.stencil, index: (k - states) / self.stencil }
            }
            Symbol::Epsilon | Symbol::SecondState(_) => unreachable!("no line of a site reads these"),
        }
    }
}

struct RunOverLanes<'a> {
    program: &'a Program,
    x: &'a [f64],
    c: &'a [f64],
    numbers: &'a mut [f64],
    width: usize,
    site: usize,
    sites: usize,
}

impl OverLanes<f64> for RunOverLanes<'_> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<f64>>(self) {
        let RunOverLanes { program, width, site, sites, .. } = self;
        for (gathered, count, array) in
            [(self.x, program.block, 0), (self.c, program.parameters, program.block)]
        {
            for index in 0..count {
                let to = &mut self.numbers[program.array(array + index)..];
                let from = &gathered[(site - program.reach) * count * width..];
                // The chain may end before the last stencils do, whose results are never read.
                let seen = (from.len() / (count * width)).min(sites + 2 * program.reach);
                for site in 0..seen {
                    for register in 0..width / L::WIDTH {
                        let place = register * L::WIDTH;
                        let numbers = L::load(from, (site * count + index) * width + place);
                        numbers.store(to, site * width + place);
                    }
                }
            }
        }
        for &Instruction { kind, to, places, .. } in &program.instructions {
            let (before, rest) = self.numbers.split_at_mut(to * SITES_PER_INSTRUCTION);
            let (result, after) = rest.split_at_mut(SITES_PER_INSTRUCTION);
            // A macro, because closures may be compiled without this function's SIMD instructions.
            macro_rules! each {
                (|$($operand:ident: $k:literal),*| $value:expr) => {{
                    $(
                        let place = places[$k].numbers + places[$k].registers * width;
                        let $operand = match place.checked_sub(before.len() + SITES_PER_INSTRUCTION) {
                            Some(place) => &after[place..][..SITES_PER_INSTRUCTION],
                            None => &before[place..][..SITES_PER_INSTRUCTION],
                        };
                    )*
                    for k in 0..SITES_PER_INSTRUCTION / L::WIDTH {
                        $(let $operand = L::load($operand, k * L::WIDTH);)*
                        $value.store(result, k * L::WIDTH);
                    }
                }};
            }
            match kind {
                Kind::Copy => each!(|a: 0| a),
                Kind::Add => each!(|a: 0, b: 1| (a + b)),
                Kind::Subtract => each!(|a: 0, b: 1| (a - b)),
                Kind::Multiply => each!(|a: 0, b: 1| (a * b)),
                Kind::Divide => each!(|a: 0, b: 1| (a / b)),
                Kind::Negate => each!(|a: 0| (-a)),
                Kind::MultiplyAdd => each!(|a: 0, b: 1, c: 2| a.multiply_add(b, c)),
                Kind::MultiplySubtract => each!(|a: 0, b: 1, c: 2| a.multiply_subtract(b, c)),
                Kind::SubtractProduct => each!(|a: 0, b: 1, c: 2| a.subtract_product(b, c)),
            }
        }
    }
}
