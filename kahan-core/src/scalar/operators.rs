//! Macros that implement the arithmetic operators of a type from functions.

/// Implements + − × ÷ and the assignment operators from functions of two numbers. The generic
/// parameters of the type stand in brackets.
#[doc(hidden)]
#[macro_export]
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
        $crate::operators!(one $generics $type, Add add $add);
        $crate::operators!(one $generics $type, Sub sub $sub);
        $crate::operators!(one $generics $type, Mul mul $mul);
        $crate::operators!(one $generics $type, Div div $div);
        $crate::assignments!($generics $type);
    };
}

/// Implements the assignment operators of a type from + − × ÷.
#[doc(hidden)]
#[macro_export]
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
        $crate::assignments!(one $generics $type, AddAssign add_assign +);
        $crate::assignments!(one $generics $type, SubAssign sub_assign -);
        $crate::assignments!(one $generics $type, MulAssign mul_assign *);
        $crate::assignments!(one $generics $type, DivAssign div_assign /);
    };
}

#[cfg(all(feature = "std", any(target_arch = "x86_64", target_arch = "aarch64")))]
pub(crate) use assignments;
pub(crate) use operators;
