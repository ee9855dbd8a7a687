mod everywhere;
#[cfg(feature = "synthesis")]
mod polished;
