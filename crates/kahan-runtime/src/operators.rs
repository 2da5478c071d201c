//! The operators of numbers, written from functions.

/// The four operators of a type that is copied, with their assignments, each from a function of two
/// numbers; the generic parameters of the type are in brackets.
macro_rules! operators {
    (one [$($generics:tt)*] $type:ty, $Operator:ident $method:ident, $Assign:ident $assign:ident, $function:expr) => {
        impl<$($generics)*> ::core::ops::$Operator for $type {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                $function(self, other)
            }
        }

        impl<$($generics)*> ::core::ops::$Assign for $type {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = ::core::ops::$Operator::$method(*self, other);
            }
        }
    };
    ($generics:tt $type:ty: $add:expr, $sub:expr, $mul:expr, $div:expr) => {
        operators!(one $generics $type, Add add, AddAssign add_assign, $add);
        operators!(one $generics $type, Sub sub, SubAssign sub_assign, $sub);
        operators!(one $generics $type, Mul mul, MulAssign mul_assign, $mul);
        operators!(one $generics $type, Div div, DivAssign div_assign, $div);
    };
}

pub(crate) use operators;
