//! Checks with an independent disassembler all forms of all instructions, with all registers.

use iced_x86::{
    Code, Decoder, DecoderOptions, FlowControl, Instruction, Mnemonic, OpKind, Register, RoundingControl,
};

use super::general::Condition;
use super::{
    Assembler, Binary, Element, FrameNeeds, Fused, FusedOrder, GeneralRegister, Memory, OperandForm, Source,
    Vector, Width,
};

const FORMS: [OperandForm; 8] = {
    const fn form(element: Element, width: Width) -> OperandForm {
        OperandForm { element, width }
    }
    [
        form(Element::Single, Width::Scalar),
        form(Element::Single, Width::Bits128),
        form(Element::Single, Width::Bits256),
        form(Element::Single, Width::Bits512),
        form(Element::Double, Width::Scalar),
        form(Element::Double, Width::Bits128),
        form(Element::Double, Width::Bits256),
        form(Element::Double, Width::Bits512),
    ]
};

const GENERAL: [(GeneralRegister, Register); 16] = [
    (GeneralRegister::Rax, Register::RAX),
    (GeneralRegister::Rcx, Register::RCX),
    (GeneralRegister::Rdx, Register::RDX),
    (GeneralRegister::Rbx, Register::RBX),
    (GeneralRegister::Rsp, Register::RSP),
    (GeneralRegister::Rbp, Register::RBP),
    (GeneralRegister::Rsi, Register::RSI),
    (GeneralRegister::Rdi, Register::RDI),
    (GeneralRegister::R8, Register::R8),
    (GeneralRegister::R9, Register::R9),
    (GeneralRegister::R10, Register::R10),
    (GeneralRegister::R11, Register::R11),
    (GeneralRegister::R12, Register::R12),
    (GeneralRegister::R13, Register::R13),
    (GeneralRegister::R14, Register::R14),
    (GeneralRegister::R15, Register::R15),
];

/// Offsets whose encodings take zero, one or four bytes.
const OFFSETS: [i32; 9] = [0, 1, -1, 127, -128, 128, -129, 0x1234_5678, i32::MIN];

fn decoded(write: impl FnOnce(&mut Assembler), form: OperandForm) -> Instruction {
    let mut assembler = Assembler::new(form);
    write(&mut assembler);
    let length = assembler.bytes.len();
    let bytes = assembler.finish();
    let mut decoder = Decoder::new(64, &bytes, DecoderOptions::NONE);
    let instruction = decoder.decode();
    assert!(!instruction.is_invalid(), "{form:?}: {:02x?} is no instruction", &bytes[..length]);
    assert_eq!(instruction.len(), length, "{form:?}: {instruction:?} is shorter than what was written");
    assert_is_plain(&instruction);
    instruction
}

fn assert_is_plain(instruction: &Instruction) {
    assert_eq!(instruction.op_mask(), Register::None, "{instruction:?}");
    assert!(!instruction.zeroing_masking() && !instruction.is_broadcast(), "{instruction:?}");
    assert_eq!(instruction.rounding_control(), RoundingControl::None, "{instruction:?}");
    assert!(!instruction.suppress_all_exceptions(), "{instruction:?}");
}

fn vector(form: OperandForm, Vector(number): Vector) -> Register {
    let first = match form.width {
        Width::Scalar | Width::Bits128 => Register::XMM0,
        Width::Bits256 => Register::YMM0,
        Width::Bits512 => Register::ZMM0,
    };
    first + u32::from(number)
}

fn suffix(form: OperandForm) -> &'static str {
    match (form.width, form.element) {
        (Width::Scalar, Element::Single) => "ss",
        (Width::Scalar, Element::Double) => "sd",
        (_, Element::Single) => "ps",
        (_, Element::Double) => "pd",
    }
}

fn assert_mnemonic(instruction: &Instruction, expected: &str) {
    assert_eq!(format!("{:?}", instruction.mnemonic()).to_lowercase(), expected, "{instruction:?}");
}

fn assert_registers(instruction: &Instruction, form: OperandForm, expected: &[Vector]) {
    for (place, &register) in (0..).zip(expected) {
        assert_eq!(instruction.op_kind(place), OpKind::Register, "{instruction:?}");
        assert_eq!(instruction.op_register(place), vector(form, register), "{instruction:?}");
    }
}

fn assert_memory(instruction: &Instruction, place: u32, bytes: usize, memory: Memory) {
    assert_eq!(instruction.op_kind(place), OpKind::Memory, "{instruction:?}");
    assert_eq!(instruction.memory_size().size(), bytes, "{instruction:?}");
    let register = |general: GeneralRegister| GENERAL[general as usize].1;
    let (base, index, offset) = match memory {
        Memory::At { base, offset } => (register(base), Register::None, i64::from(offset)),
        Memory::Indexed { base, index } => (register(base), register(index), 0),
        Memory::Pool(_) => unreachable!("the pool has a test of its own"),
    };
    assert_eq!(instruction.memory_base(), base, "{instruction:?}");
    assert_eq!(instruction.memory_index(), index, "{instruction:?}");
    assert_eq!(instruction.memory_index_scale(), 1, "{instruction:?}");
    assert_eq!(instruction.memory_displacement64() as i64, offset, "{instruction:?}");
}

fn places() -> impl Iterator<Item = Memory> {
    let at = |(base, _)| OFFSETS.map(|offset| Memory::At { base, offset });
    let indices = GENERAL.into_iter().filter(|(index, _)| *index != GeneralRegister::Rsp);
    let indexed = indices.flat_map(|(index, _)| GENERAL.map(|(base, _)| Memory::Indexed { base, index }));
    GENERAL.into_iter().flat_map(at).chain(indexed)
}

fn triples() -> impl Iterator<Item = [Vector; 3]> {
    (0..32_u32).flat_map(|k| {
        let [a, b] = [(k * 7 + 3) % 32, (k * 13 + 5) % 32];
        let all = [[k, a, b], [a, k, b], [a, b, k], [k % 8, a % 8, b % 8], [k % 16, a % 16, b % 16]];
        all.map(|numbers| numbers.map(|number| Vector(number as u8)))
    })
}

/// Checks an instruction with three operands. The last operand is a register or lies in memory.
fn check(
    name: &str,
    form: OperandForm,
    bytes: usize,
    write: impl Fn(&mut Assembler, Vector, Vector, Source),
) {
    for [to, a, b] in triples() {
        let instruction = decoded(|assembler| write(assembler, to, a, Source::Register(b)), form);
        // In AVX-512F the mnemonics of bitwise and copy instructions end with the element type.
        let is_evex = form.width == Width::Bits512 || [to, a, b].iter().any(|register| register.0 >= 16);
        assert_mnemonic(&instruction, &named(name, form, is_evex));
        assert_registers(&instruction, form, &[to, a, b]);
        assert_eq!(instruction.op_count(), 3, "{instruction:?}");
    }
    for (k, memory) in (0_u32..).zip(places()) {
        let (to, a) = (Vector((k % 32) as u8), Vector((k / 3 % 32) as u8));
        let instruction = decoded(|assembler| write(assembler, to, a, Source::Memory(memory)), form);
        let is_evex = form.width == Width::Bits512 || to.0 >= 16 || a.0 >= 16;
        assert_mnemonic(&instruction, &named(name, form, is_evex));
        assert_registers(&instruction, form, &[to, a]);
        assert_memory(&instruction, 2, bytes, memory);
    }
}

/// Returns the expected mnemonic. AVX-512F has only the integer form of xor.
fn named(name: &str, form: OperandForm, is_evex: bool) -> String {
    match (name, form.element) {
        ("vxor", Element::Single) if is_evex => "vpxord".to_owned(),
        ("vxor", Element::Double) if is_evex => "vpxorq".to_owned(),
        ("vxor", Element::Single) => "vxorps".to_owned(),
        ("vxor", Element::Double) => "vxorpd".to_owned(),
        _ => format!("{name}{}", suffix(form)),
    }
}

#[test]
fn operations_are_what_was_asked_for() {
    let operations = [
        ("vadd", Binary::Add),
        ("vsub", Binary::Subtract),
        ("vmul", Binary::Multiply),
        ("vdiv", Binary::Divide),
        ("vmax", Binary::Maximum),
        ("vmin", Binary::Minimum),
    ];
    for form in FORMS {
        for (name, operator) in operations {
            check(name, form, form.bytes(), |assembler, to, a, b| assembler.binary(operator, to, a, b));
        }
        let write = |assembler: &mut Assembler, to, a, b| assembler.binary(Binary::ExclusiveOr, to, a, b);
        check("vxor", form, form.bytes().max(16), write);
    }
}

#[test]
fn fused_operations_are_what_was_asked_for() {
    let operators = [
        ("vfmadd", Fused::MultiplyAdd),
        ("vfmsub", Fused::MultiplySubtract),
        ("vfnmadd", Fused::SubtractProduct),
    ];
    let orders = [("132", FusedOrder::D132), ("213", FusedOrder::D213), ("231", FusedOrder::D231)];
    for form in FORMS {
        for (name, operator) in operators {
            for (digits, order) in orders {
                check(&format!("{name}{digits}"), form, form.bytes(), |assembler, to, b, c| {
                    assembler.fused(operator, order, to, b, c);
                });
            }
        }
    }
}

#[test]
fn numbers_are_moved_as_was_asked_for() {
    for form in FORMS {
        let is_scalar = form.width == Width::Scalar;
        let moved = if is_scalar { "vmov" } else { "vmovu" };
        for [to, from, _] in triples() {
            let instruction = decoded(|assembler| assembler.copy(to, from), form);
            let whole = OperandForm { width: form.width.max(Width::Bits128), ..form };
            assert_mnemonic(&instruction, &format!("vmova{}", suffix(whole)));
            assert_registers(&instruction, form, &[to, from]);
        }
        for (k, memory) in (0_u32..).zip(places()) {
            let register = Vector((k % 32) as u8);
            let load = decoded(|assembler| assembler.load(register, memory), form);
            assert_mnemonic(&load, &format!("{moved}{}", suffix(form)));
            assert_registers(&load, form, &[register]);
            assert_memory(&load, 1, form.bytes(), memory);
            let store = decoded(|assembler| assembler.store(memory, register), form);
            assert_mnemonic(&store, &format!("{moved}{}", suffix(form)));
            assert_memory(&store, 0, form.bytes(), memory);
            assert_eq!(store.op1_register(), vector(form, register), "{store:?}");
        }
    }
}

fn all(bytes: &[u8]) -> Vec<Instruction> {
    let instructions: Vec<Instruction> = Decoder::new(64, bytes, DecoderOptions::NONE).iter().collect();
    assert!(instructions.iter().all(|instruction| !instruction.is_invalid()));
    instructions.iter().for_each(assert_is_plain);
    instructions
}

#[test]
fn numbers_are_rounded_to_single_precision_and_taken_back() {
    for form in FORMS.into_iter().filter(|form| form.element == Element::Double) {
        // Single-precision numbers fill half of the register. The shortest registers have 128 bits.
        let half = match form.width {
            Width::Bits512 => Width::Bits256,
            _ => Width::Bits128,
        };
        let half = OperandForm { width: half, ..form };
        for [to, from, _] in triples() {
            let mut assembler = Assembler::new(form);
            assembler.round_to_single(to, from);
            let [narrow, wide] = all(&assembler.bytes)[..] else { panic!("two instructions") };
            if form.width == Width::Scalar {
                assert_mnemonic(&narrow, "vcvtsd2ss");
                assert_registers(&narrow, form, &[to, from, from]);
                assert_mnemonic(&wide, "vcvtss2sd");
                assert_registers(&wide, form, &[to, to, to]);
            } else {
                assert_mnemonic(&narrow, "vcvtpd2ps");
                assert_mnemonic(&wide, "vcvtps2pd");
                let registers = |instruction: &Instruction| [0, 1].map(|k| instruction.op_register(k));
                assert_eq!(registers(&narrow), [vector(half, to), vector(form, from)], "{narrow:?}");
                assert_eq!(registers(&wide), [vector(form, to), vector(half, to)], "{wide:?}");
            }
        }
    }
    for form in FORMS.into_iter().filter(|form| form.element == Element::Single) {
        let copied = decoded(|assembler| assembler.round_to_single(Vector(17), Vector(3)), form);
        assert_registers(&copied, form, &[Vector(17), Vector(3)]);
    }
}

#[cfg(target_arch = "x86_64")]
fn all_operations(form: OperandForm, registers: u8, has_fused: bool) -> Vec<Instruction> {
    let mut assembler = Assembler::new(form);
    let ends = [Vector(0), Vector(7), Vector(15), Vector(registers - 1)];
    let memory = Memory::At { base: GeneralRegister::Rdi, offset: 256 };
    for to in ends {
        for a in ends {
            for b in ends.map(Source::Register).into_iter().chain([Source::Memory(memory)]) {
                for operator in [
                    Binary::Add,
                    Binary::Subtract,
                    Binary::Multiply,
                    Binary::Divide,
                    Binary::Maximum,
                    Binary::Minimum,
                    Binary::ExclusiveOr,
                ] {
                    assembler.binary(operator, to, a, b);
                }
                for operator in [Fused::MultiplyAdd, Fused::MultiplySubtract, Fused::SubtractProduct] {
                    if has_fused {
                        assembler.fused(operator, FusedOrder::D231, to, a, b);
                    }
                }
            }
            assembler.copy(to, a);
            assembler.round_to_single(to, a);
        }
        assembler.load(to, memory);
        assembler.store(memory, to);
    }
    assembler.zero_upper();
    assembler.ret();
    all(&assembler.bytes)
}

#[cfg(target_arch = "x86_64")]
#[test]
fn a_set_of_instructions_is_available_where_all_of_them_are() {
    use crate::{InstructionSet, LaneCount, Shape};
    use iced_x86::CpuidFeature;

    const EVERYWHERE: [CpuidFeature; 3] =
        [CpuidFeature::INTEL8086, CpuidFeature::INTEL386, CpuidFeature::X64];

    for instructions in [InstructionSet::Avx, InstructionSet::Avx2, InstructionSet::Avx512] {
        let asked: Vec<String> =
            instructions.extensions().iter().map(|(name, _)| name.to_uppercase()).collect();
        for lanes in [LaneCount::One, LaneCount::All] {
            let shape = Shape { instructions, lanes, fuses: instructions.has_fused() };
            for form in [shape.form::<f32>(), shape.form::<f64>()] {
                for instruction in all_operations(form, instructions.registers(), shape.fuses) {
                    let mut needed = instruction.cpuid_features().iter();
                    let is_asked = |needed: &CpuidFeature| {
                        EVERYWHERE.contains(needed) || asked.contains(&format!("{needed:?}"))
                    };
                    assert!(needed.all(is_asked), "{shape:?}: {:?}", instruction.code());
                }
            }
        }
    }
}

#[test]
fn numbers_of_the_pool_stand_behind_the_code_in_every_lane() {
    for form in FORMS {
        let mut assembler = Assembler::new(form);
        let numbers = [0x3ff0_0000_3f80_0000, 0x8000_0000_8000_0000, 0x8000_0000_3f80_0000];
        for (k, bits) in (0..).zip(numbers.into_iter().chain(numbers)) {
            let entry = assembler.constant(bits);
            assembler.binary(Binary::Add, Vector(k), Vector(20), Source::Memory(Memory::Pool(entry)));
        }
        let code = assembler.bytes.len();
        let bytes = assembler.finish();
        assert_eq!(bytes.len(), code.next_multiple_of(64) + 3 * form.bytes().max(16), "each number once");
        for (instruction, bits) in all(&bytes[..code]).iter().zip(numbers.into_iter().chain(numbers)) {
            assert_eq!(instruction.memory_base(), Register::RIP);
            let place = usize::try_from(instruction.memory_displacement64()).expect("behind the code");
            let element = if form.element == Element::Double { 8 } else { 4 };
            let found = &bytes[place..place + form.bytes().max(16)];
            assert!(found.chunks(element).all(|lane| *lane == bits.to_le_bytes()[..element]), "{form:?}");
        }
    }
}

/// Operands that fill a register must be aligned, so the pool begins with a cache line.
#[test]
fn the_pool_begins_with_a_cache_line() {
    for length in 0..=130 {
        let mut assembler = Assembler::new(FORMS[7]);
        (0..length).for_each(|_| assembler.ret());
        let entry = assembler.constant(1);
        assembler.load(Vector(0), Memory::Pool(entry));
        let code = assembler.bytes.len();
        let bytes = assembler.finish();
        let place = all(&bytes[..code]).last().expect("the load").memory_displacement64();
        assert_eq!(place % 64, 0, "{length}");
        assert!(place >= code as u64 && place < code as u64 + 64, "{length}: right behind the code");
    }
}

/// Short offsets take one byte. In EVEX offsets take four bytes, because EVEX scales short offsets.
#[test]
fn offsets_are_as_short_as_they_can_be() {
    let length = |offset: i32, register: u8| {
        let place = Memory::At { base: GeneralRegister::Rdi, offset };
        decoded(|assembler| assembler.load(Vector(register), place), FORMS[5]).len()
    };
    for offset in OFFSETS {
        let short = i8::try_from(offset).is_ok();
        assert_eq!(length(offset, 3), 4 + if short { 1 } else { 4 }, "{offset}");
        assert_eq!(length(offset, 19), 6 + 4, "{offset}");
    }
}

fn general(write: impl FnOnce(&mut Assembler)) -> Instruction {
    decoded(write, FORMS[0])
}

fn assert_general(instruction: &Instruction, mnemonic: Mnemonic, registers: &[Register]) {
    assert_eq!(instruction.mnemonic(), mnemonic, "{instruction:?}");
    for (place, register) in (0..).zip(registers) {
        assert_eq!(instruction.op_register(place), *register, "{instruction:?}");
    }
}

#[test]
fn addresses_and_counts_are_what_was_asked_for() {
    for (a, a_name) in GENERAL {
        for (b, b_name) in GENERAL {
            assert_general(&general(|x| x.move_general(a, b)), Mnemonic::Mov, &[a_name, b_name]);
            assert_general(&general(|x| x.add_general(a, b)), Mnemonic::Add, &[a_name, b_name]);
            assert_general(&general(|x| x.compare(a, b)), Mnemonic::Cmp, &[a_name, b_name]);
            for offset in OFFSETS {
                let load = general(|x| x.load_general(a, b, offset));
                assert_general(&load, Mnemonic::Mov, &[a_name]);
                assert_memory(&load, 1, 8, Memory::At { base: b, offset });
            }
        }
        assert_general(&general(|x| x.test(a)), Mnemonic::Test, &[a_name, a_name]);
        assert_general(&general(|x| x.decrement(a)), Mnemonic::Dec, &[a_name]);
        assert_general(&general(|x| x.push(a)), Mnemonic::Push, &[a_name]);
        assert_general(&general(|x| x.pop(a)), Mnemonic::Pop, &[a_name]);
        for number in OFFSETS {
            let add = general(|x| x.add_immediate(a, number));
            assert_general(&add, Mnemonic::Add, &[a_name]);
            assert_eq!(add.immediate(1) as i64, number.into());
            let and = general(|x| x.and_immediate(a, number));
            assert_general(&and, Mnemonic::And, &[a_name]);
            assert_eq!(and.immediate(1) as i64, number.into());
        }
    }
    assert_eq!(general(Assembler::zero_upper).code(), Code::VEX_Vzeroupper);
    assert_eq!(general(Assembler::ret).code(), Code::Retnq);
    let touch = general(Assembler::touch_stack);
    assert_eq!((touch.mnemonic(), touch.memory_base(), touch.immediate(1)), (Mnemonic::Or, Register::RSP, 0));
    assert_eq!(touch.memory_size().size(), 8);
}

#[test]
fn jumps_lead_where_they_are_bound() {
    let conditions = [
        (Condition::Below, Mnemonic::Jb),
        (Condition::Zero, Mnemonic::Je),
        (Condition::NotZero, Mnemonic::Jne),
    ];
    for (condition, mnemonic) in conditions {
        let mut assembler = Assembler::new(FORMS[0]);
        assembler.ret();
        let back = assembler.label();
        let forward = assembler.jump_if_forward(condition);
        assembler.zero_upper();
        assembler.jump_if(condition, back);
        assembler.bind(forward);
        assembler.ret();
        let instructions = all(&assembler.bytes);
        let target =
            |index: usize| (instructions[index].mnemonic(), instructions[index].near_branch_target());
        assert_eq!(target(1), (mnemonic, instructions[4].ip()));
        assert_eq!(target(3), (mnemonic, instructions[1].ip()));
        assert_eq!(instructions[1].flow_control(), FlowControl::ConditionalBranch);
    }
}

#[test]
fn a_function_leaves_the_registers_of_its_caller_as_they_were() {
    for (stack, uses_pointers) in [(0, false), (9000, false), (8, true)] {
        let mut assembler = Assembler::new(FORMS[7]);
        let needs = FrameNeeds { stack, uses_pointers, vectors: 32, instructions: 3 };
        assembler.open(&needs);
        let beginning = assembler.bytes.len();
        assembler.close(&needs);
        let (beginning, end) = (all(&assembler.bytes[..beginning]), all(&assembler.bytes[beginning..]));
        let of = |instructions: &[Instruction], mnemonic| -> Vec<Register> {
            let those = instructions.iter().filter(|instruction| instruction.mnemonic() == mnemonic);
            those.map(Instruction::op0_register).collect()
        };
        let saved = if uses_pointers {
            GeneralRegister::SAVED.map(|register| GENERAL[register as usize].1).to_vec()
        } else {
            vec![]
        };
        assert_eq!(of(&beginning, Mnemonic::Push), [&[Register::RBP], &saved[..]].concat());
        assert_eq!(of(&beginning, Mnemonic::Or).len(), stack.div_ceil(4096), "each page is touched");
        assert_eq!(of(&end, Mnemonic::Mov), [&saved[..], &[Register::RSP]].concat());
        assert_eq!(of(&end, Mnemonic::Pop), [Register::RBP]);
        assert_eq!(end.last().expect("it ends").code(), Code::Retnq);
    }
}

#[test]
fn rounds_are_counted_and_repeated() {
    let [a, b, ..] = GeneralRegister::ARGUMENTS;
    let mut assembler = Assembler::new(FORMS[0]);
    let again = assembler.label();
    let end = assembler.skip_if_zero(a);
    assembler.clear(b);
    assembler.count_down(a, again);
    assembler.repeat_below(a, b, again);
    assembler.bind(end);
    let found: Vec<Mnemonic> = all(&assembler.bytes).iter().map(Instruction::mnemonic).collect();
    use Mnemonic::{And, Cmp, Dec, Jb, Je, Jne, Test};
    assert_eq!(found, [Test, Je, And, Dec, Jne, Cmp, Jb]);
}

#[test]
fn registers_of_addresses_have_one_use_each() {
    let all =
        GeneralRegister::ARGUMENTS.into_iter().chain(GeneralRegister::SPARE).chain(GeneralRegister::POINTERS);
    let mut numbers: Vec<u8> =
        all.chain([GeneralRegister::STACK, GeneralRegister::Rbp]).map(|general| general as u8).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, (0..16).collect::<Vec<u8>>());
    assert_eq!(Assembler::new(FORMS[3]).form(), FORMS[3]);
}
