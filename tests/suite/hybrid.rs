//! Motions with modes and events, against their closed forms.

mod bounce;
mod cycles;
mod hard;
mod table_drive;
