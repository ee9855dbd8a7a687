//! An equation file with a part in another folder, which has parts itself.
assur::equations! { "hung.eqn" }

/// Texts of the files of parts.
pub const PARTS: &[(&str, &str)] = hung::MECHANISM.parts;
