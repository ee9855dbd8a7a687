//! What no crate can test alone: equation file to emitted Rust to solver to number.
//!
//! | module | what it holds |
//! |---|---|
//! | [`boundaries`] | which package may know which |
//! | [`answers`] | the front door: what a scene is asked |
//! | [`batten`] | a mechanism against an independent computation, closed forms, limits, energy |
//! | [`linkages`] | loops against an independent computation, and the misprints of a paper |
//! | [`closures`] | linkages that have mass and are not reduced: dead points, change points, space, pins that come and go |
//! | [`cost`] | what accuracy costs, against closed forms |
//! | [`dynamics`] | linkages that have mass: two ways to write one, forces against work, drift |
//! | [`pumping_jack`] | a linkage with masses and its gear against closed forms, and naive ways beside them |
//! | [`hybrid`] | modes and events against closed forms |
//! | [`series`] | Taylor series against the other method |
//! | [`sought`] | what a compiled scene seeks |
//! | [`sheets`] | formulas without motion: integrals, roots and extremes in them |
//! | [`tables`] | sampled curves in motions |
//! | [`stability`] | the page of hard cases, which their tests write |
//! | [`hard`] | cases in which the naive way fails, beside ours |

mod answers;
mod batten;
mod boundaries;
mod closures;
mod cost;
mod dynamics;
mod friction;
mod hard;
mod hybrid;
mod linkages;
mod measures;
mod pumping_jack;
mod rest;
mod series;
mod sheets;
mod solved;
mod sought;
mod stability;
mod tables;
mod trust;
