//! A file that is not there.
assur::equations! { "missing.eqn", "no module" }
