//! The straight line of a site, run over one scalar or for several gathered sites at once.
//!
//! In: the plan of a line. Out: its results in the first registers. The operations and their order
//! are the plan's, so the bits are those of a compiled family. Over lanes an instruction is decoded
//! once for [`ROOM`] numbers, those of several sites one behind the other; it is compiled once, and
//! not into each kernel that asks for lines.

use kahan_algebra::plan::{Input, Node, Operation, Plan};
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::__private::chain::{Gathered, SiteLine};
use kahan_core::__private::{InLanes, Lanes, OverLanes};
use kahan_core::Scalar;

use crate::literal::Literal;

/// The numbers of an operand for which an instruction is run. This is a multiple of the lanes of
/// every level. Decoding costs little beside it, and the nearest cache holds the registers.
const ROOM: usize = 128;

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
    reach: usize,
}

#[derive(Clone, Copy, Debug)]
struct Instruction {
    kind: Kind,
    /// The register of the result, which is no operand's.
    to: usize,
    /// As many as the kind takes; the last stands for those behind it.
    operands: [Operand; 3],
    /// Where they stand among the numbers of gathered sites.
    places: [Place; 3],
}

/// Where the numbers of an operand begin, counted from the first number of all: a distance in
/// numbers, and to be added to it one in registers of the lanes that sites are gathered in.
#[derive(Clone, Copy, Debug, Default)]
struct Place {
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

/// A number that is read: a constant, an entry of `x` or of `c`, a register. Sites are counted from
/// the first one that the line sees.
#[derive(Clone, Copy, Debug)]
enum Operand {
    Constant(usize),
    State { site: usize, array: usize },
    Parameter { site: usize, index: usize },
    Register(usize),
}

/// The numbers that sites see, and constants: lines that are run one after another share them.
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
        // Constants stand behind all registers.
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
        let (operands, places) = ([first, second, third], [Place::default(); 3]);
        self.instructions.push(Instruction { kind, to, operands, places });
    }

    /// Where an operand stands: registers come first, each [`ROOM`] numbers; what sites see is
    /// next, each array and each parameter by itself, so that one site further is one register of
    /// the lanes further; constants are last, each `ROOM` numbers, too.
    fn place(&self, operand: Operand) -> Place {
        let (numbers, registers) = match operand {
            Operand::Register(k) => (k * ROOM, 0),
            Operand::State { site, array } => (self.array(array), site),
            Operand::Parameter { site, index } => (self.array(self.block + index), site),
            Operand::Constant(k) => (self.array(self.block + self.parameters) + k * ROOM, 0),
        };
        Place { numbers, registers }
    }

    /// Where the numbers of an array begin or, counted on, of a parameter.
    fn array(&self, index: usize) -> usize {
        self.registers * ROOM + index * (ROOM + 2 * self.reach * f64::MOST)
    }

    /// The room that gathered sites take, in registers of the widest lanes.
    pub(super) fn registers_abreast(&self, constants: usize) -> usize {
        self.place(Operand::Constant(constants)).numbers.div_ceil(f64::MOST)
    }

    /// How many scalars a run computes in.
    pub(super) fn registers(&self) -> usize {
        self.registers
    }

    /// Runs the line over one scalar.
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

    /// The line of the next of some gathered sites; computes those of the sites behind it, too.
    #[inline(always)]
    pub(super) fn line<L: Lanes<f64>, const B: usize, const C: usize, const SITES: usize>(
        &self,
        sites: &mut Gathered<'_, f64, L, C>,
    ) -> SiteLine<L, B, SITES> {
        if sites.site >= sites.computed.end {
            self.compute(sites, L::WIDTH);
        }
        let results = &sites.registers[..(B + B * SITES * B) * ROOM];
        let mut place = (sites.site - sites.computed.start) * L::WIDTH;
        assert!(place <= ROOM - L::WIDTH, "sites are asked for in order");
        sites.site += 1;
        let mut line = SiteLine { f: [L::zero(); B], a: [[[L::zero(); B]; SITES]; B] };
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

    /// Computes the lines of as many sites as there is room for, from the next one on.
    fn compute<L, const C: usize>(&self, gathered: &mut Gathered<'_, f64, L, C>, width: usize) {
        let Gathered { constants, x, c, level, site, .. } = *gathered;
        let numbers = &mut *gathered.registers;
        if gathered.computed.is_empty() {
            for (k, constant) in constants.iter().enumerate() {
                numbers[self.place(Operand::Constant(k)).numbers..][..ROOM].fill(*constant);
            }
            // A result that no instruction writes is zero for every state.
            numbers[..self.results * ROOM].fill(0.0);
        }
        let sites = ROOM / width;
        gathered.computed = site..site + sites;
        f64::run(Run { program: self, x, c, numbers, width, site, sites }, level);
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

/// One run of a line, for as many sites as there is room for, from one on.
struct Run<'a> {
    program: &'a Program,
    x: &'a [f64],
    c: &'a [f64],
    numbers: &'a mut [f64],
    width: usize,
    site: usize,
    sites: usize,
}

impl OverLanes<f64> for Run<'_> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<f64>>(self) {
        let Run { program, width, site, sites, .. } = self;
        for (gathered, count, array) in
            [(self.x, program.block, 0), (self.c, program.parameters, program.block)]
        {
            for index in 0..count {
                let to = &mut self.numbers[program.array(array + index)..];
                let from = &gathered[(site - program.reach) * count * width..];
                // Behind the last site there is nothing, and nobody asks for it.
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
            let (before, rest) = self.numbers.split_at_mut(to * ROOM);
            let (result, after) = rest.split_at_mut(ROOM);
            // A macro, as closures need not be compiled for the instructions of lanes.
            macro_rules! each {
                (|$($operand:ident: $k:literal),*| $value:expr) => {{
                    $(
                        let place = places[$k].numbers + places[$k].registers * width;
                        let $operand = match place.checked_sub(before.len() + ROOM) {
                            Some(place) => &after[place..][..ROOM],
                            None => &before[place..][..ROOM],
                        };
                    )*
                    for k in 0..ROOM / L::WIDTH {
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
