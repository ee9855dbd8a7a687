//! The macros of Assur: equations in, checked Rust out. Use them through the facade, `assur`.
//!
//! The language itself is the crate `assur-model`; nothing here knows algebra. A macro reads rustc's tokens
//! (`tokens`), has them compiled, and prints the resulting programs as Rust (`assur-emit`) and the messages as errors of
//! rustc that point into the equation file (`report`).

mod expand;
mod files;
mod parts;
mod report;
#[cfg(test)]
mod tests;
mod tokens;

use proc_macro::TokenStream;

/// Equations of a mechanism as Rust items: a type for each scene, and `MECHANISM`, the mechanism as data.
///
/// ```ignore
/// assur::mechanism! {
///     /// A point mass on a massless rod.
///     Pendulum from "any textbook";
///
///     dimension l = 1 m;
///     parameter m = 2 kg, g = 9.81 [m/s^2];
///     coordinate phi: rad = 0.1;
///
///     kinetic   m*(l*dot(phi))^2/2;
///     potential -m*g*l*cos(phi);
///
///     scene swing "two swings or so" { run time 0 .. 4 s; }
/// }
///
/// use assur::problem::{Equations, Scene};
///
/// let pendulum = Swing { l: 0.5, ..Swing::default() };
/// let equations = pendulum.prepare::<f64>();
/// let mut rate = [0.0; 2];
/// equations.derivative(&equations.instant(0.0), &[0.1, 0.0], &mut rate);
/// assert!((rate[1] + 9.81 / 0.5 * 0.1_f64.sin()).abs() < 1e-12);
/// ```
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    expand::mechanism(input.into()).into()
}

/// Equation files as modules, and `REGISTRY`, the table of their mechanisms. Paths are relative to the file of the
/// invocation.
///
/// ```ignore
/// assur::equations! { "batten.eqn", "needle.eqn" }
///
/// let batten = batten::Batten::default();
/// assert_eq!(REGISTRY[0].name, "batten");
/// ```
#[proc_macro]
pub fn equations(input: TokenStream) -> TokenStream {
    files::equations(input.into()).into()
}
