//! An assembler for the instructions of x86-64 that straight lines of floats need.
#![allow(dead_code)]

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element { Single, Double }
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Width { Scalar, Bits128, Bits256, Bits512 }
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Form { pub(crate) element: Element, pub(crate) width: Width }
impl Form {
    pub(crate) fn bytes(self) -> usize {
        match self.width {
            Width::Scalar => if self.element == Element::Single { 4 } else { 8 },
            Width::Bits128 => 16, Width::Bits256 => 32, Width::Bits512 => 64,
        }
    }
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Vector(pub(crate) u8);
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum General { Rax, Rcx, Rdx, Rbx, Rsp, Rbp, Rsi, Rdi, R8, R9, R10, R11, R12, R13, R14, R15 }
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Entry(usize);
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Memory { At { base: General, offset: i32 }, Indexed { base: General, index: General, offset: i32 }, Pool(Entry) }
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source { Register(Vector), Memory(Memory) }
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Arithmetic { Add, Subtract, Multiply, Divide }
pub(crate) use crate::lines::Fused;
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order { D132, D213, D231 }
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Condition { Zero, NotZero, Below }
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label(usize);
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forward(usize);

pub(crate) struct Assembler { bytes: Vec<u8>, form: Form, pool: Vec<u64>, fixups: Vec<(usize, usize)> }

impl Assembler {
    pub(crate) fn new(form: Form) -> Self { Assembler { bytes: vec![], form, pool: vec![], fixups: vec![] } }
    fn pp(&self) -> u8 {
        match (self.form.width, self.form.element) {
            (Width::Scalar, Element::Single) => 2, (Width::Scalar, Element::Double) => 3,
            (_, Element::Single) => 0, (_, Element::Double) => 1,
        }
    }
    fn l(&self) -> u8 { match self.form.width { Width::Scalar | Width::Bits128 => 0, Width::Bits256 => 1, Width::Bits512 => 2 } }
    fn w(&self) -> u8 { u8::from(self.form.element == Element::Double) }
    fn instruction(&mut self, map: u8, pp: u8, w: u8, l: u8, opcode: u8, evex_opcode: Option<(u8,u8)>, reg: u8, vvvv: u8, rm: Source) {
        let high = |source: Source| matches!(source, Source::Register(Vector(n)) if n >= 16);
        let evex = l == 2 || reg >= 16 || vvvv >= 16 || high(rm);
        let (x, b, b4) = match rm {
            Source::Register(Vector(n)) => (n >> 4 & 1, n >> 3 & 1, n >> 4 & 1),
            Source::Memory(Memory::At { base, .. }) => (0, base as u8 >> 3, 0),
            Source::Memory(Memory::Indexed { base, index, .. }) => (index as u8 >> 3, base as u8 >> 3, 0),
            Source::Memory(Memory::Pool(_)) => (0, 0, 0),
        };
        let _ = b4;
        if evex {
            let (opcode, pp) = evex_opcode.unwrap_or((opcode, pp));
            self.bytes.push(0x62);
            self.bytes.push((!(reg >> 3) & 1) << 7 | (x ^ 1) << 6 | (b ^ 1) << 5 | (!(reg >> 4) & 1) << 4 | map);
            self.bytes.push(w << 7 | (!vvvv & 15) << 3 | 4 | pp);
            self.bytes.push(l << 5 | (!(vvvv >> 4) & 1) << 3);
            self.bytes.push(opcode);
        } else {
            self.bytes.push(0xC4);
            self.bytes.push((!(reg >> 3) & 1) << 7 | (x ^ 1) << 6 | (b ^ 1) << 5 | map);
            self.bytes.push(w << 7 | (!vvvv & 15) << 3 | l << 2 | pp);
            self.bytes.push(opcode);
        }
        self.modrm(reg & 7, rm, evex);
    }
    fn modrm(&mut self, reg: u8, rm: Source, evex: bool) {
        match rm {
            Source::Register(Vector(n)) => self.bytes.push(0xC0 | reg << 3 | n & 7),
            Source::Memory(Memory::Pool(Entry(e))) => {
                self.bytes.push(reg << 3 | 5);
                self.fixups.push((self.bytes.len(), e));
                self.bytes.extend([0; 4]);
            }
            Source::Memory(Memory::At { base, offset }) => {
                let small = !evex && i8::try_from(offset).is_ok();
                self.bytes.push(if small { 0x40 } else { 0x80 } | reg << 3 | base as u8 & 7);
                if base as u8 & 7 == 4 { self.bytes.push(0x24); }
                self.offset(offset, small);
            }
            Source::Memory(Memory::Indexed { base, index, offset }) => {
                let small = !evex && i8::try_from(offset).is_ok();
                self.bytes.push(if small { 0x40 } else { 0x80 } | reg << 3 | 4);
                self.bytes.push((index as u8 & 7) << 3 | base as u8 & 7);
                self.offset(offset, small);
            }
        }
    }
    fn offset(&mut self, offset: i32, small: bool) {
        if small { self.bytes.push(offset as u8) } else { self.bytes.extend(offset.to_le_bytes()) }
    }
    pub(crate) fn arithmetic(&mut self, op: Arithmetic, to: Vector, a: Vector, b: Source) {
        let opcode = match op { Arithmetic::Add => 0x58, Arithmetic::Multiply => 0x59, Arithmetic::Subtract => 0x5C, Arithmetic::Divide => 0x5E };
        self.instruction(1, self.pp(), self.w(), self.l(), opcode, None, to.0, a.0, b);
    }
    pub(crate) fn fused(&mut self, op: Fused, order: Order, to: Vector, b: Vector, c: Source) {
        let base = match order { Order::D132 => 0x98, Order::D213 => 0xA8, Order::D231 => 0xB8 };
        let kind = match op { Fused::MultiplyAdd => 0, Fused::MultiplySubtract => 2, Fused::SubtractProduct => 4 };
        let scalar = u8::from(self.form.width == Width::Scalar);
        self.instruction(2, 1, self.w(), self.l(), base + kind + scalar, None, to.0, b.0, c);
    }
    pub(crate) fn exclusive_or(&mut self, to: Vector, a: Vector, b: Source) {
        let pp = u8::from(self.form.element == Element::Double);
        self.instruction(1, pp, self.w(), self.l(), 0x57, Some((0xEF, 1)), to.0, a.0, b);
    }
    pub(crate) fn copy(&mut self, to: Vector, from: Vector) {
        let pp = u8::from(self.form.element == Element::Double);
        self.instruction(1, pp, self.w(), self.l(), 0x28, None, to.0, 0, Source::Register(from));
    }
    pub(crate) fn load(&mut self, to: Vector, from: Memory) {
        self.instruction(1, self.pp(), self.w(), self.l(), 0x10, None, to.0, 0, Source::Memory(from));
    }
    pub(crate) fn store(&mut self, to: Memory, from: Vector) {
        self.instruction(1, self.pp(), self.w(), self.l(), 0x11, None, from.0, 0, Source::Memory(to));
    }
    pub(crate) fn round_to_single(&mut self, to: Vector, from: Vector) {
        self.instruction(1, 3, 1, 0, 0x5A, None, to.0, from.0, Source::Register(from));
        self.instruction(1, 2, 0, 0, 0x5A, None, to.0, to.0, Source::Register(to));
    }
    fn general(&mut self, opcode: u8, reg: u8, rm: General) {
        self.bytes.push(0x48 | (reg >> 3) << 2 | rm as u8 >> 3);
        self.bytes.push(opcode);
        self.bytes.push(0xC0 | (reg & 7) << 3 | rm as u8 & 7);
    }
    pub(crate) fn move_general(&mut self, to: General, from: General) { self.general(0x89, from as u8, to); }
    pub(crate) fn add_general(&mut self, to: General, from: General) { self.general(0x01, from as u8, to); }
    pub(crate) fn compare(&mut self, a: General, b: General) { self.general(0x39, b as u8, a); }
    pub(crate) fn test(&mut self, a: General) { self.general(0x85, a as u8, a); }
    pub(crate) fn decrement(&mut self, a: General) { self.general(0xFF, 1, a); }
    pub(crate) fn add_immediate(&mut self, to: General, n: i32) { self.general(0x81, 0, to); self.bytes.extend(n.to_le_bytes()); }
    pub(crate) fn and_immediate(&mut self, to: General, n: i32) { self.general(0x81, 4, to); self.bytes.extend(n.to_le_bytes()); }
    pub(crate) fn load_general(&mut self, to: General, from: Memory) {
        let Memory::At { base, .. } = from else { unreachable!() };
        self.bytes.push(0x48 | (to as u8 >> 3) << 2 | base as u8 >> 3);
        self.bytes.push(0x8B);
        self.modrm(to as u8 & 7, Source::Memory(from), false);
    }
    pub(crate) fn push(&mut self, a: General) { if a as u8 >= 8 { self.bytes.push(0x41) } self.bytes.push(0x50 | a as u8 & 7); }
    pub(crate) fn pop(&mut self, a: General) { if a as u8 >= 8 { self.bytes.push(0x41) } self.bytes.push(0x58 | a as u8 & 7); }
    pub(crate) fn touch_stack(&mut self) { self.bytes.extend([0x48, 0x83, 0x0C, 0x24, 0]); }
    pub(crate) fn label(&self) -> Label { Label(self.bytes.len()) }
    fn condition(c: Condition) -> u8 { match c { Condition::Zero => 0x84, Condition::NotZero => 0x85, Condition::Below => 0x82 } }
    pub(crate) fn jump_if(&mut self, c: Condition, to: Label) {
        self.bytes.extend([0x0F, Self::condition(c)]);
        let d = to.0 as i64 - (self.bytes.len() as i64 + 4);
        self.bytes.extend((d as i32).to_le_bytes());
    }
    pub(crate) fn jump_if_forward(&mut self, c: Condition) -> Forward {
        self.bytes.extend([0x0F, Self::condition(c), 0, 0, 0, 0]);
        Forward(self.bytes.len())
    }
    pub(crate) fn bind(&mut self, f: Forward) {
        let d = (self.bytes.len() - f.0) as i32;
        self.bytes[f.0 - 4..f.0].copy_from_slice(&d.to_le_bytes());
    }
    pub(crate) fn vzeroupper(&mut self) { self.bytes.extend([0xC5, 0xF8, 0x77]); }
    pub(crate) fn ret(&mut self) { self.bytes.push(0xC3); }
    pub(crate) fn constant(&mut self, bits: u64) -> Entry {
        Entry(self.pool.iter().position(|x| *x == bits).unwrap_or_else(|| { self.pool.push(bits); self.pool.len() - 1 }))
    }
    pub(crate) fn finish(mut self) -> Vec<u8> {
        let size = self.form.bytes().max(16);
        while self.bytes.len() % 64 != 0 { self.bytes.push(0xCC); }
        let start = self.bytes.len();
        for bits in &self.pool {
            for _ in 0..size / if self.form.element == Element::Double { 8 } else { 4 } {
                match self.form.element { Element::Double => self.bytes.extend(bits.to_le_bytes()), Element::Single => self.bytes.extend((*bits as u32).to_le_bytes()) }
            }
        }
        for (at, e) in &self.fixups {
            let d = (start + e * size) as i32 - (*at as i32 + 4);
            self.bytes[*at..at + 4].copy_from_slice(&d.to_le_bytes());
        }
        self.bytes
    }
}
