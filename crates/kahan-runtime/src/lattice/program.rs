//! The straight line of a site, run over one scalar or for several gathered sites at once.
//!
//! In: the plan of a line. Out: its results in the first registers. The operations and their order
//! are the plan's, so the bits are those of a compiled family. Over lanes an instruction is decoded
//! once for [`ROOM`] numbers, those of several sites one behind the other; it is compiled once, and
//! not into each kernel that asks for lines.

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::__private::chain::{GatheredLines, InLanes, Lanes, OverLanes, SiteLine, Sizes};
use kahan_core::{Level, Scalar};

use crate::literal::Literal;

/// The numbers of an operand for which an instruction is run: a multiple of all lanes.
const ROOM: usize = 64;

/// A line whose results, and with them whose registers, have places.
#[derive(Debug)]
pub(super) struct Program {
    instructions: Vec<Instruction>,
    /// How many registers results stand in, the first ones; no other value is put there.
    results: usize,
    registers: usize,
    /// Arrays and parameters a site.
    block: usize,
    parameters: usize,
}

#[derive(Clone, Copy, Debug)]
struct Instruction {
    kind: Kind,
    /// The register of the result, which is no operand's.
    to: usize,
    /// As many as the kind takes; the last stands for those behind it.
    operands: [Operand; 3],
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

/// A number that is read: a constant, an entry of `x` or of `c`, a register. Sites are counted from
/// the first one that the line sees.
#[derive(Clone, Copy, Debug)]
enum Operand {
    Constant(usize),
    State { site: usize, array: usize },
    Parameter { site: usize, index: usize },
    Register(usize),
}

/// What lines that are run one after another share: the numbers that sites see, and constants.
pub(super) struct Numbering<'a> {
    pub(super) symbols: &'a Symbols,
    pub(super) block: usize,
    pub(super) stencil: usize,
    pub(super) site_parameters: usize,
    /// How many constants are prepared; literals stand behind them.
    pub(super) prepared: usize,
}

impl Program {
    /// The line of a plan whose results are put into these registers, all below `results`; adds its
    /// literals.
    pub(super) fn of(
        plan: &Plan,
        places: impl IntoIterator<Item = usize>,
        results: usize,
        numbering: &Numbering<'_>,
        literals: &mut Vec<Literal>,
    ) -> Self {
        let mut last_use = vec![0; plan.operations.len()];
        for (k, operation) in plan.operations.iter().enumerate() {
            operation.operands().for_each(|operand| last_use[operand.0] = k);
        }
        let places: Vec<(usize, Node)> = places.into_iter().zip(plan.outputs.iter().copied()).collect();
        let (block, parameters) = (numbering.block, numbering.site_parameters);
        let mut program =
            Program { instructions: Vec::new(), results, registers: results, block, parameters };
        let mut values: Vec<Operand> = Vec::with_capacity(plan.operations.len());
        let mut free = Vec::new();
        for (k, operation) in plan.operations.iter().enumerate() {
            let kind = match operation {
                Operation::Input(variable) => {
                    values.push(numbering.operand(numbering.symbols.symbol(*variable)));
                    continue;
                }
                Operation::Constant(value) => {
                    values.push(Operand::Constant(numbering.prepared + literals.len()));
                    literals.push(Literal::from(value));
                    continue;
                }
                Operation::Prepared(_) => unreachable!("constants are inputs of a line"),
                Operation::Add(..) => Kind::Add,
                Operation::Subtract(..) => Kind::Subtract,
                Operation::Multiply(..) => Kind::Multiply,
                Operation::Divide(..) => Kind::Divide,
                Operation::Negate(_) => Kind::Negate,
                Operation::MultiplyAdd(..) => Kind::MultiplyAdd,
                Operation::MultiplySubtract(..) => Kind::MultiplySubtract,
                Operation::SubtractProduct(..) => Kind::SubtractProduct,
            };
            let place = places.iter().find(|(_, node)| node.0 == k).map(|(place, _)| *place);
            let to = place.or_else(|| free.pop()).unwrap_or_else(|| {
                program.registers += 1;
                program.registers - 1
            });
            program.put(kind, to, operation.operands().map(|operand| values[operand.0]));
            values.push(Operand::Register(to));
            // Registers whose values are read no more; an operand may stand there twice.
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
        program
    }

    fn put(&mut self, kind: Kind, to: usize, mut operands: impl Iterator<Item = Operand>) {
        let first = operands.next().unwrap_or_else(|| unreachable!("each kind takes an operand"));
        let second = operands.next().unwrap_or(first);
        let third = operands.next().unwrap_or(second);
        self.instructions.push(Instruction { kind, to, operands: [first, second, third] });
    }

    /// How many scalars a run computes in.
    pub(super) fn registers(&self) -> usize {
        self.registers
    }

    /// Runs the line over one scalar.
    pub(super) fn run<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], registers: &mut [L]) {
        for Instruction { kind, to, operands } in &self.instructions {
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
}

impl Numbering<'_> {
    /// Where an input stands: parameters of sites are one after the other among the states of
    /// symbols, and site by site among what lines are given.
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

/// Where numbers stand that the lines of gathered sites are computed in: constants and registers,
/// each [`ROOM`] numbers, and between them what the sites see, each array and each parameter by
/// itself, so that one site further is one register further.
#[derive(Clone, Copy, Debug)]
struct Layout {
    /// Numbers of a register of the lanes that sites are gathered in.
    width: usize,
    constants: usize,
    block: usize,
    reach: usize,
}

impl Layout {
    /// How many sites are computed at once.
    fn sites(self) -> usize {
        ROOM / self.width
    }

    /// The numbers of an array that these sites see.
    fn seen(self) -> usize {
        ROOM + 2 * self.reach * self.width
    }

    /// Where an array or, counted on, a parameter begins.
    fn array(self, index: usize) -> usize {
        self.constants * ROOM + index * self.seen()
    }

    /// Where the numbers of an operand begin, `registers` where registers do.
    fn place(self, operand: Operand, registers: usize) -> usize {
        match operand {
            Operand::Constant(k) => k * ROOM,
            Operand::State { site, array } => self.array(array) + site * self.width,
            Operand::Parameter { site, index } => self.array(self.block + index) + site * self.width,
            Operand::Register(k) => registers + k * ROOM,
        }
    }
}

/// The room that the lines of gathered sites take, in registers of the widest lanes.
pub(super) fn registers_abreast(program: &Program, reach: usize, constants: usize) -> usize {
    let layout = Layout { width: f64::MOST, constants, block: program.block, reach };
    (layout.array(program.block + program.parameters) + program.registers * ROOM).div_ceil(f64::MOST)
}

/// A line for gathered sites, some of them at a time.
pub(super) struct Abreast<'a> {
    program: &'a Program,
    layout: Layout,
    level: Level,
    x: &'a [f64],
    c: &'a [f64],
    /// Laid out as `layout` says.
    numbers: &'a mut [f64],
    /// Where the registers begin.
    registers: usize,
    /// The sites whose results stand in the registers.
    first: usize,
    end: usize,
}

impl<'a> Abreast<'a> {
    pub(super) fn new(
        (program, sizes): (&'a Program, Sizes),
        constants: &[f64],
        [x, c]: [&'a [f64]; 2],
        numbers: &'a mut [f64],
        (level, width): (Level, usize),
    ) -> Self {
        let layout = Layout { width, constants: constants.len(), block: sizes.block, reach: sizes.reach };
        for (k, constant) in constants.iter().enumerate() {
            numbers[k * ROOM..][..ROOM].fill(*constant);
        }
        let registers = layout.array(sizes.block + sizes.parameters);
        // What no instruction writes is zero for every state.
        numbers[registers..][..program.results * ROOM].fill(0.0);
        Abreast { program, layout, level, x, c, numbers, registers, first: 0, end: 0 }
    }

    /// Computes the lines from a site on.
    fn compute(&mut self, site: usize) {
        (self.first, self.end) = (site, site + self.layout.sites());
        let level = self.level;
        f64::run(Run { abreast: self }, level);
    }
}

/// One run of a line, for as many sites as there is room for.
struct Run<'a, 'b> {
    abreast: &'a mut Abreast<'b>,
}

impl OverLanes<f64> for Run<'_, '_> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<f64>>(self) {
        let Abreast { program, layout, x, c, ref mut numbers, registers, first, .. } = *self.abreast;
        for (gathered, count, from) in [(x, program.block, 0), (c, program.parameters, program.block)] {
            for index in 0..count {
                let to = &mut numbers[layout.array(from + index)..][..layout.seen()];
                let (from, stride) = ((first - layout.reach) * count + index, count * layout.width);
                // Behind the last site there is nothing, and nobody asks for it.
                let sites = (gathered.len() / layout.width - from).div_ceil(count);
                for site in 0..sites.min(layout.sites() + 2 * layout.reach) {
                    for lane in 0..layout.width / L::WIDTH {
                        let lane = lane * L::WIDTH;
                        L::load(gathered, from * layout.width + site * stride + lane)
                            .store(to, site * layout.width + lane);
                    }
                }
            }
        }
        for &Instruction { kind, to, operands } in &program.instructions {
            let (before, rest) = numbers.split_at_mut(registers + to * ROOM);
            let (result, after) = rest.split_at_mut(ROOM);
            let numbers = |operand| match layout.place(operand, registers) {
                place if place < before.len() => &before[place..][..ROOM],
                place => &after[place - before.len() - ROOM..][..ROOM],
            };
            let (a, b, c) = (numbers(operands[0]), numbers(operands[1]), numbers(operands[2]));
            // A macro, as closures need not be compiled for the instructions of lanes.
            macro_rules! each {
                (|$($operand:ident),*| $value:expr) => {
                    for k in 0..ROOM / L::WIDTH {
                        $(let $operand = L::load($operand, k * L::WIDTH);)*
                        $value.store(result, k * L::WIDTH);
                    }
                };
            }
            match kind {
                Kind::Copy => each!(|a| a),
                Kind::Add => each!(|a, b| (a + b)),
                Kind::Subtract => each!(|a, b| (a - b)),
                Kind::Multiply => each!(|a, b| (a * b)),
                Kind::Divide => each!(|a, b| (a / b)),
                Kind::Negate => each!(|a| (-a)),
                Kind::MultiplyAdd => each!(|a, b, c| a.multiply_add(b, c)),
                Kind::MultiplySubtract => each!(|a, b, c| a.multiply_subtract(b, c)),
                Kind::SubtractProduct => each!(|a, b, c| a.subtract_product(b, c)),
            }
        }
    }
}

impl<L: Lanes<f64>, const B: usize, const SITES: usize> GatheredLines<L, B, SITES> for Abreast<'_> {
    #[inline(always)]
    fn at(&mut self, site: usize) -> SiteLine<L, B, SITES> {
        if site >= self.end {
            self.compute(site);
        }
        let results = &self.numbers[self.registers..];
        let mut line = SiteLine { f: [L::zero(); B], a: [[[L::zero(); B]; SITES]; B] };
        let mut place = (site - self.first) * L::WIDTH;
        for b in 0..B {
            line.f[b] = L::load(results, place);
            place += ROOM;
        }
        for b in 0..B {
            for k in 0..SITES {
                for e in 0..B {
                    line.a[b][k][e] = L::load(results, place);
                    place += ROOM;
                }
            }
        }
        line
    }
}
