//! Motions with modes and events, against their closed forms.

mod bounce;
mod hard;
mod table_drive;
