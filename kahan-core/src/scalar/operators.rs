//! The operators of numbers, written from functions.

/// + − × ÷ of a type, each from a function of two numbers; in brackets are its generic parameters.
macro_rules! operators {
    (one [$($generics:tt)*] $type:ty, $Operator:ident $method:ident $function:expr) => {
        impl<$($generics)*> ::core::ops::$Operator for $type {
            type Output = Self;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                $function(self, other)
            }
        }
    };
    ($generics:tt $type:ty: $add:expr, $sub:expr, $mul:expr, $div:expr) => {
        operators!(one $generics $type, Add add $add);
        operators!(one $generics $type, Sub sub $sub);
        operators!(one $generics $type, Mul mul $mul);
        operators!(one $generics $type, Div div $div);
    };
}

/// The assignments of a type, from its operators.
macro_rules! assignments {
    (one [$($generics:tt)*] $type:ty, $Assign:ident $method:ident $operator:tt) => {
        impl<$($generics)*> ::core::ops::$Assign for $type {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(&mut self, other: Self) {
                *self = ::core::clone::Clone::clone(self) $operator other;
            }
        }
    };
    ($generics:tt $type:ty) => {
        assignments!(one $generics $type, AddAssign add_assign +);
        assignments!(one $generics $type, SubAssign sub_assign -);
        assignments!(one $generics $type, MulAssign mul_assign *);
        assignments!(one $generics $type, DivAssign div_assign /);
    };
}

pub(crate) use {assignments, operators};
