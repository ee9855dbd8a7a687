//! Motions with modes and events, against their closed forms.

mod bounce;
mod cycles;
mod hard;
mod lyapunov;
mod needle_impact;
mod presser_foot;
mod table_drive;
