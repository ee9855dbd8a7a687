//! Slices as arrays, for emitted code.

/// A slice of a caller as an array of the length that emitted code states, in its place. One that is too short is a mistake
/// of the caller's, which debug builds report; nothing is done then.
#[doc(hidden)]
#[macro_export]
macro_rules! exact {
    (mut $slice:ident, $rows:literal by $length:literal $(, $otherwise:expr)?) => {
        let ($slice, _) = $slice.as_chunks_mut::<$length>();
        $crate::exact!(mut $slice, $rows $(, $otherwise)?);
    };
    (mut $slice:ident, $length:literal $(, $otherwise:expr)?) => {
        ::core::debug_assert!($slice.len() >= $length);
        let ::core::option::Option::Some($slice) = $slice.first_chunk_mut::<$length>() else {
            return $($otherwise)?;
        };
    };
    ($slice:ident, $length:literal $(, $otherwise:expr)?) => {
        ::core::debug_assert!($slice.len() >= $length);
        let ::core::option::Option::Some($slice) = $slice.first_chunk::<$length>() else {
            return $($otherwise)?;
        };
    };
}
