//! A linkage with its values behind a pointer: what asks about it is compiled once for all linkages.
//!
//! What is compiled for each are its loops on the numbers that are asked for, a step of an [`Assembly`], and the drawing
//! of linkages made at random.

use super::loops::{Answers, Apart, Loops, Trials};
use super::problem::{Closure, Linkage, Range};
use crate::closure::extent::survey::{Looking, Sides};
use crate::closure::position::assembly::Assembly;
use crate::closure::position::guide::Moves;
use crate::dispatch::{dispatch, dispatch_packs};
use crate::problem::Span;
use crate::scalar::{Dual, Interval};
use crate::shape::Shape;
use crate::tolerance::{Block, Blocks, Counts, Drawing, Run};

/// Between which bounds measures lie, from bounds of what has been found of a way.
pub type Bounds<'a> = Box<dyn Fn(&[Interval]) -> Vec<Interval> + 'a>;

/// A linkage with its values.
pub trait AnyLinkage: Send + Sync {
    /// What it is made of.
    fn shape(&self) -> &'static Shape;

    /// See [`Linkage::values`].
    fn values(&self) -> Vec<f64>;

    /// See [`Linkage::with_values`].
    fn with_values(&self, values: &[f64]) -> Box<dyn AnyLinkage>;

    /// See [`Linkage::span`].
    fn span(&self) -> Span;

    /// See [`Linkage::drive`].
    fn drive(&self, time: f64) -> Option<Vec<f64>>;

    /// See [`Linkage::ranges`].
    fn ranges(&self) -> Vec<Range>;

    /// See [`Linkage::start`].
    fn start(&self) -> Vec<f64>;

    /// An assembly that is not yet put together.
    #[doc(hidden)]
    fn assemble(&self) -> Box<dyn Moves>;

    /// Its loops, from constants.
    #[doc(hidden)]
    fn prepare(&self, values: &[f64]) -> Box<dyn Loops<f64>>;

    /// The loops with these values over numbers that carry derivatives.
    #[doc(hidden)]
    fn differentiate(&self, values: &[Dual]) -> Box<dyn Answers<Dual>>;

    /// The loops with these values over intervals.
    #[doc(hidden)]
    fn enclose(&self, values: &[Interval]) -> Box<dyn Trials<Interval>>;

    /// Its measures, from bounds of what has been found of a way.
    #[doc(hidden)]
    fn bounds(&self) -> Bounds<'_>;

    /// Looks at linkages of its kind side by side.
    #[doc(hidden)]
    fn survey(&self, sides: Sides<'_, '_>);

    /// Makes linkages at random, block after block until none waits, and counts the classes of their errors.
    #[doc(hidden)]
    fn draw(&self, run: &Run<'_>, blocks: &Blocks<'_>, counts: &mut [Counts]) -> Vec<(u64, Block)>;
}

impl<L: Linkage> AnyLinkage for L {
    fn shape(&self) -> &'static Shape {
        Linkage::shape(self)
    }

    fn values(&self) -> Vec<f64> {
        Linkage::values(self)
    }

    fn with_values(&self, values: &[f64]) -> Box<dyn AnyLinkage> {
        Box::new(Linkage::with_values(self, values))
    }

    fn span(&self) -> Span {
        Linkage::span(self)
    }

    fn drive(&self, time: f64) -> Option<Vec<f64>> {
        Linkage::drive(self, time)
    }

    fn ranges(&self) -> Vec<Range> {
        Linkage::ranges(self)
    }

    fn start(&self) -> Vec<f64> {
        Linkage::start(self)
    }

    fn assemble(&self) -> Box<dyn Moves> {
        Box::new(Assembly::<L, f64>::new(self))
    }

    fn prepare(&self, values: &[f64]) -> Box<dyn Loops<f64>> {
        Box::new(Apart(Linkage::prepare(self, values)))
    }

    fn differentiate(&self, values: &[Dual]) -> Box<dyn Answers<Dual>> {
        Box::new(Apart(Linkage::prepare(self, values)))
    }

    fn enclose(&self, values: &[Interval]) -> Box<dyn Trials<Interval>> {
        Box::new(Apart(Linkage::prepare(self, values)))
    }

    fn bounds(&self) -> Bounds<'_> {
        let values: Vec<Interval> = self.values().into_iter().map(Interval::point).collect();
        let loops = Linkage::prepare(self, &values);
        let count = Linkage::shape(self).measures.len();
        Box::new(move |found| {
            let mut measures = vec![Interval::ENTIRE; count];
            loops.measures(found, &mut measures);
            measures
        })
    }

    fn survey(&self, sides: Sides<'_, '_>) {
        if L::IS_SOUGHT {
            let looking = Looking { linkage: self, sides };
            if self.is_apart() { dispatch(looking) } else { dispatch_packs(looking) }
        }
    }

    fn draw(&self, run: &Run<'_>, blocks: &Blocks<'_>, counts: &mut [Counts]) -> Vec<(u64, Block)> {
        let drawing = Drawing { run, blocks, counts, linkage: self };
        if L::PACKED && !self.is_apart() { dispatch_packs(drawing) } else { dispatch(drawing) }
    }
}
