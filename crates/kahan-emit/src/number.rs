//! Emits exact constants as Rust.

use kahan_algebra::rational::Rational;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Emits a constant, such as `__kahan::integer::<T>(3)` or `__kahan::ratio::<T>(1, 2)`.
pub(super) fn emit_constant(value: &Rational, scalar: &Ident) -> TokenStream {
    if let Some((kind, parts)) = short_constant(value) {
        return quote!(__kahan::#kind::<#scalar>(#parts));
    }
    let exact = emit_exact(value);
    quote!(<#scalar as __kahan::Scalar>::constant(&#exact))
}

fn short_constant(value: &Rational) -> Option<(Ident, TokenStream)> {
    if let Some(integer) = value.as_i64() {
        let integer = Literal::i64_unsuffixed(integer);
        return Some((format_ident!("integer"), quote!(#integer)));
    }
    let [above, below] = <[i64; 2]>::from(value.as_short_ratio()?).map(Literal::i64_unsuffixed);
    Some((format_ident!("ratio"), quote!(#above, #below)))
}

pub(super) fn emit_exact(value: &Rational) -> TokenStream {
    if let Some((kind, parts)) = short_constant(value) {
        return quote!(__kahan::Constant::#kind(#parts));
    }
    let negative = value.is_negative();
    let limbs = |digits: Vec<u64>| {
        let digits = digits.into_iter().map(Literal::u64_unsuffixed);
        quote!(&[#(#digits),*])
    };
    let numerator = limbs(value.numerator().iter_u64_digits().collect());
    let denominator = limbs(value.denominator().iter_u64_digits().collect());
    let (high, low) = value.to_double_double();
    let (single, double, low) = (value.to_f32().to_bits(), high.to_bits(), low.to_bits());
    let bits = |bits: u64| Literal::u64_unsuffixed(bits);
    let (single, double, low) = (bits(single.into()), bits(double), bits(low));
    quote! {
        __kahan::Constant::exact(
            #negative, #numerator, #denominator,
            __kahan::f32::from_bits(#single),
            __kahan::f64::from_bits(#double),
            __kahan::f64::from_bits(#low),
        )
    }
}
