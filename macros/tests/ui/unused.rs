//! A warning is underlined in the equation file, and the caller compiles.
assur::equations! { "unused.eqn" }

/// Uses what was emitted all the same.
pub fn use_it() -> f64 {
    unused::Oscillator::default().m
}
