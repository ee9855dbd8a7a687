//! Motions with modes and events, against their closed forms.

mod bounce;
mod cycles;
mod hard;
mod needle_impact;
mod presser_foot;
mod table_drive;
