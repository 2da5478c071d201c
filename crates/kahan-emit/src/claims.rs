//! Emits accessors of claims: `integrals`, one method for each integral, `density`, `bracket_NAME`
//! and `drift_NAME`. A claim with `when` has an accessor of its own, for example `density_NAME`.

use kahan_algebra::plan::Plan;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::Claim;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::field::{emit_body, emit_vector};
use super::{Context, docs, items};

#[derive(Default)]
pub(super) struct EmittedClaims {
    pub(super) constants: TokenStream,
    pub(super) methods: TokenStream,
    pub(super) implementations: TokenStream,
}

/// Emits the accessors of all claims. A marker trait says that a type has no integrals or no
/// density. With this trait, rustc explains errors about missing accessors.
pub(super) fn emit_claims(context: &Context<'_>) -> EmittedClaims {
    let mut emitted = emit_integrals(context);
    let (system, derived) = (context.system, context.derived);
    let density = system.accessors(ClaimKind::Density).zip(&derived.density);
    let brackets = system.accessors(ClaimKind::Bracket).zip(derived.brackets.iter().map(|(_, plan)| plan));
    let drifts = system.accessors(ClaimKind::Drift).zip(derived.drifts.iter().map(|(_, plan)| plan));
    let conditional = system.conditional().zip(&derived.conditional);
    for (claim, plan) in density.chain(brackets).chain(drifts).chain(conditional) {
        emitted.methods.extend(emit_accessor(context, claim, plan));
    }
    let (this, scalar, generics) = (context.this.path(), &context.this.scalar, context.this.generics());
    let lacks = |kind: ClaimKind, marker: TokenStream| {
        let is_lacking = context.system.accessors(kind).next().is_none();
        is_lacking.then(|| quote! { #[doc(hidden)] impl #generics __kahan::#marker for #this {} })
    };
    let lacking = [
        lacks(ClaimKind::Integral, quote!(WithoutIntegrals)),
        lacks(ClaimKind::Density, quote!(WithoutDensity)),
        context.this.has_parameters().then(|| {
            quote! { #[doc(hidden)] impl<#scalar: __kahan::PrimInt> __kahan::IntegerParameters for #this {} }
        }),
    ];
    emitted.implementations.extend(lacking.into_iter().flatten());
    emitted
}

/// Expands to `pub fn NAME(&self, x, eps) -> …`. The method is generic over the scalar if the type
/// has no parameters.
fn emit_method(
    context: &Context<'_>,
    documentation: &TokenStream,
    name: &str,
    result: &TokenStream,
    body: &TokenStream,
) -> TokenStream {
    let (scalar, vector, name) = (&context.this.scalar, context.vector(), format_ident!("{name}"));
    let stand_in = (!context.is_proved).then(|| docs::placeholder_docs(false));
    let documentation = stand_in.as_ref().unwrap_or(documentation);
    let generics = if context.this.has_parameters() { quote!() } else { quote!(<#scalar: __kahan::Scalar>) };
    quote! {
        #documentation
        pub fn #name #generics (&self, x: &#vector, eps: #scalar) -> #result {
            #body
        }
    }
}

fn emit_integrals(context: &Context<'_>) -> EmittedClaims {
    let claims: Vec<&Claim> = context.system.accessors(ClaimKind::Integral).collect();
    if claims.is_empty() {
        return EmittedClaims::default();
    }
    let names = &context.derived.integral_names;
    let (this, scalar, dimension) = (context.this.path(), &context.this.scalar, &context.dimension);
    let vector = context.vector();
    let count = Literal::usize_unsuffixed(claims.len());
    let result = quote!(__kahan::SVector<#scalar, #count>);
    let body = emit_vector(context, &context.derived.integrals);
    let mut methods = emit_method(context, &docs::integrals(&claims), "integrals", &result, &body);
    for (place, claim) in claims.iter().enumerate() {
        let place = Literal::usize_unsuffixed(place);
        let body = quote!(self.integrals(x, eps)[#place].clone());
        let name = name_of_integral(&claim.name.text, names);
        methods.extend(emit_method(context, &docs::integral(claim), &name, &quote!(#scalar), &body));
    }
    EmittedClaims {
        constants: items::emit_name_list("INTEGRALS", "The names of the integrals, in order.", names),
        methods,
        implementations: quote! {
            impl<#scalar: __kahan::Scalar> __kahan::Integrals<#scalar, #dimension, #count> for #this {
                fn integral_names(&self) -> &'static [&'static __kahan::str] {
                    &Self::INTEGRALS
                }
                fn integrals(&self, x: &#vector, eps: #scalar) -> #result {
                    Self::integrals(self, x, eps)
                }
            }
        },
    }
}

/// Returns the integral's own name, or `integral_NAME` if that name is taken.
fn name_of_integral(name: &str, integrals: &[String]) -> String {
    /// Names of methods that the type or its traits already have.
    const EXISTING_METHODS: &str = "embed project field field_jacobian bilinear polarized prepare matrix rhs step try_step try_prepared \
        step_back jacobian det_matrix det_jacobian rational_map reduced_map at orbit extend_scalars carry_tangent variables \
        parameters integral_names integrals density clone clone_from eq ne fmt into try_into to_owned borrow \
        borrow_mut type_id";
    let is_of_another =
        name.strip_prefix("integral_").is_some_and(|base| integrals.iter().any(|other| other == base));
    let is_taken = EXISTING_METHODS.split_whitespace().chain(items::LISTS).any(|taken| taken == name)
        || name.starts_with("bracket_")
        || name.starts_with("density_")
        || name.starts_with("drift_")
        || is_of_another
        || syn::parse_str::<Ident>(name).is_err();
    if is_taken { format!("integral_{name}") } else { name.to_owned() }
}

/// Expands to the method of a claim. A density with `when` has the method `density_NAME`.
fn emit_accessor(context: &Context<'_>, claim: &Claim, plan: &Plan) -> TokenStream {
    let name = match claim.kind {
        ClaimKind::Integral => name_of_integral(&claim.name.text, &context.derived.integral_names),
        ClaimKind::Density if claim.is_unconditional() => "density".to_owned(),
        kind => format!("{}_{}", kind.keyword(), claim.name.text),
    };
    let (bindings, results) = emit_body(context, plan);
    let scalar = &context.this.scalar;
    let (result, value) = match claim.kind {
        ClaimKind::Integral | ClaimKind::Density => (quote!(#scalar), quote!(#(#results)*)),
        ClaimKind::Bracket => (context.matrix(), quote!(__kahan::antisymmetric([#(#results),*]))),
        ClaimKind::Drift => (quote!([#scalar; 2]), quote!([#(#results),*])),
    };
    emit_method(context, &docs::accessor(context, claim), &name, &result, &quote!(#bindings #value))
}
