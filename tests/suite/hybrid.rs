//! Motions with modes and events, against their closed forms.

mod bounce;
mod branches;
mod clocks;
mod cycles;
mod hard;
mod kinks;
mod lyapunov;
mod needle_impact;
mod presser_foot;
mod starts;
mod table_drive;
