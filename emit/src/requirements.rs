//! The conditions that a mechanism puts on its values.

use assur_model::checked::RequirementInfo;
use proc_macro2::TokenStream;
use quote::quote;

use crate::expression::number;
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

/// `found R = 75 mm, l = 70 mm; expected R < l`
fn refused(layout: &Layout<'_>, requirement: &RequirementInfo) -> TokenStream {
    let name =
        if requirement.message.is_empty() { &requirement.text } else { &requirement.message };
    let mut found = Vec::new();
    let mut values = Vec::new();
    for index in &requirement.names {
        let Some(constant) = layout.scene.constants.get(*index) else {
            continue;
        };
        let (field, quantity) = (&layout.constants[*index], &constant.quantity);
        found.push(
            format!("{} = {{}} {}", escape(&quantity.name), escape(&quantity.unit))
                .trim_end()
                .to_owned(),
        );
        let factor = number(quantity.factor);
        values.push(if quantity.factor == 1.0 {
            quote!(self.#field)
        } else {
            quote!(self.#field / #factor)
        });
    }
    let found =
        if found.is_empty() { String::new() } else { format!("found {}; ", found.join(", ")) };
    let reason = format!("{found}expected {}", escape(&requirement.text));
    quote! {
        ::core::result::Result::Err(::assur::problem::Refused {
            name: ::std::string::String::from(#name),
            reason: ::std::format!(#reason #(, #values)*),
        })
    }
}

/// A text inside a format string.
fn escape(text: &str) -> String {
    text.replace('{', "{{").replace('}', "}}")
}
