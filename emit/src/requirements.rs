//! The conditions that a mechanism puts on its values.

use assur_model::checked::RequirementInfo;
use proc_macro2::TokenStream;
use quote::quote;

use crate::layout::Layout;

/// The method of `Scene` that checks them.
pub fn check(layout: &Layout<'_>) -> TokenStream {
    let (name, requirements) = (&layout.parameters, &layout.scene.requirements);
    let names = (0..requirements.len()).map(|index| quote::format_ident!("require_{index}_"));
    let compute = (!requirements.is_empty()).then(|| {
        let names = names.clone();
        quote!(let [#(#names),*] = self.requirements_::<f64>();)
    });
    let assembled = layout
        .scene
        .augmented
        .as_ref()
        .map(|_| quote!(::assur::model::assemble(self, self.start_::<f64>().to_vec())?;));
    let each = requirements.iter().zip(names).map(|(requirement, held)| {
        let refused = refused(layout, requirement);
        quote!(if !<f64 as ::assur::scalar::Scalar>::holds(#held) { return #refused; })
    });
    quote! {
        fn check(&self) -> ::core::result::Result<(), ::assur::problem::Refused> {
            ::assur::registry::check_values(shapes_::#name.constants, &self.values())?;
            #compute
            #(#each)*
            #assembled
            ::core::result::Result::Ok(())
        }
    }
}

/// That the values do not meet it.
fn refused(layout: &Layout<'_>, requirement: &RequirementInfo) -> TokenStream {
    let (scene, RequirementInfo { names, message, text, .. }) = (&layout.parameters, requirement);
    quote! {
        ::core::result::Result::Err(::assur::registry::unmet(
            shapes_::#scene.constants, &self.values(), &[#(#names),*], (#message, #text),
        ))
    }
}
