//! Prints programs as text: one line such as `v2 = x + y` for each operation except inputs and
//! constants.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::Display;
use core::ops::Deref;

use crate::Program;
use crate::operation::{Function, Node, Operation};

impl<I, C, F: Function + Display> Operation<I, C, F> {
    /// Writes the operation as text such as `x*y + z`, with operands named by `name`; `None` for an
    /// input or a constant.
    pub fn text<S: Display>(&self, name: impl Fn(Node) -> S) -> Option<String> {
        Some(match *self {
            Operation::Input(_) | Operation::Constant(_) => return None,
            Operation::Negate(a) => format!("-{}", name(a)),
            Operation::Add(a, b) => format!("{} + {}", name(a), name(b)),
            Operation::Subtract(a, b) => format!("{} - {}", name(a), name(b)),
            Operation::Multiply(a, b) => format!("{}*{}", name(a), name(b)),
            Operation::Divide(a, b) => format!("{}/{}", name(a), name(b)),
            Operation::MultiplyAdd(a, b, c) => format!("{}*{} + {}", name(a), name(b), name(c)),
            Operation::MultiplySubtract(a, b, c) => format!("{}*{} - {}", name(a), name(b), name(c)),
            Operation::SubtractProduct(a, b, c) => format!("{} - {}*{}", name(a), name(b), name(c)),
            Operation::Call(ref function, a, b) if function.arguments() == 2 => {
                format!("{function}({}, {})", name(a), name(b))
            }
            Operation::Call(ref function, a, _) => format!("{function}({})", name(a)),
        })
    }
}

impl<I, C, F, O, N> Program<O, N>
where
    C: Display,
    F: Function + Display,
    O: Deref<Target = [Operation<I, C, F>]>,
    N: Deref<Target = [Node]>,
{
    /// Writes one line `vk = …` for each operation except inputs and constants.
    pub fn text(&self, input: impl Fn(&I) -> String) -> String {
        let names: Vec<String> = (self.operations.iter().enumerate())
            .map(|(index, operation)| match operation {
                Operation::Input(name) => input(name),
                Operation::Constant(value) => value.to_string(),
                _ => format!("v{index}"),
            })
            .collect();
        let mut text = String::new();
        for (operation, name) in self.operations.iter().zip(&names) {
            if let Some(right) = operation.text(|node| &names[node.0]) {
                text.push_str(&format!("{name} = {right}\n"));
            }
        }
        text
    }
}
