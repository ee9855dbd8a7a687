//! The mistake is underlined in the equation file.
assur::equations! { "broken.eqn" }
