//! The numerical solvers of Assur.
//!
//! A mechanism is to them a set of equations `y' = f(t, y)` with outputs, given by the traits of [`problem`]. They
//! know no symbol, name or unit; where a name stands in a [`shape`], it is carried for whoever prints it.
//!
//! | module | what it finds |
//! |---|---|
//! | [`answer`] | the front door: what is asked of a scene, and its motion |
//! | [`model`] | a scene with its values behind a pointer, so that what follows is compiled once |
//! | [`smooth`] | the motion from a start in one phase, by any of the methods below or its Taylor series |
//! | [`ode`] | explicit methods: Tsitouras 5(4), Dormand–Prince 8(5,3); continuous output |
//! | [`series`] | what emitted code computes those series with |
//! | [`stiff`] | the same for stiff motions: Radau IIA 5, Rodas5P, and the choice on the way |
//! | [`closure`] | the positions of a linkage: its loops closed |
//! | [`periodic`] | the steady state: method of initial parameters, shooting, Floquet multipliers |
//! | [`hybrid`] | the motion from event to event |
//! | [`mod@measure`] | numbers of a whole run |
//! | [`tolerance`](mod@tolerance) | errors of a linkage from tolerances, and tolerances of least cost |
//! | [`synthesis`] | dimensions from a wanted motion: designs sought everywhere, then polished |
//! | [`dense`] | small linear systems |
//! | [`shape`] | what a scene is made of |
//! | [`scalar`], [`dispatch`] | the numbers that all of it runs on, and the choice of the instruction set |
//! | [`threads`] | how many share a work |

pub mod answer;
pub mod closure;
#[cfg(any(feature = "allocation", feature = "synthesis"))]
mod conic;
pub mod dense;
pub mod dispatch;
mod floquet;
pub mod hybrid;
pub mod measure;
pub mod model;
pub mod ode;
pub mod periodic;
pub mod problem;
pub mod rest;
pub mod scalar;
pub mod series;
mod settings;
pub mod shape;
pub mod smooth;
pub mod stiff;
pub mod synthesis;
mod taylor;
pub mod threads;
pub mod tolerance;
