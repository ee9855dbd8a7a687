//! A linkage.

use std::sync::Arc;

use assur_model::checked::{LinkageInfo, SceneModel};
use assur_solvers::closure::{Linkage, Range};
use assur_solvers::problem::{Refused, Span};
use assur_solvers::scalar::Scalar;
use assur_solvers::shape::Shape;

use super::closure::{Form, Function, Prepare, Trial, form};
use super::functions::Functions;
use super::values::{OfValues, too_large};

/// What all sets of values of a linkage have in common.
pub struct Loops {
    pub(super) shape: &'static Shape,
    pub(super) functions: Arc<Functions>,
    /// For each group the angles that the position has cosine and sine of: the angle, and the place of its cosine.
    pub(super) angles: Vec<Vec<(usize, usize)>>,
    /// What each group in closed form writes.
    pub(super) forms: Vec<Form>,
    /// Residuals and Jacobian of each group.
    pub(super) trials: Vec<Trial>,
    is_apart: bool,
    ranges: Vec<Range>,
    values: OfValues,
}

impl Loops {
    /// A linkage with its shape.
    pub fn new(scene: &SceneModel, linkage: &LinkageInfo, shape: &'static Shape) -> Self {
        let program = scene.program.clone();
        let count = Function::count(linkage.groups.len());
        let cosines = &scene.program.results.closing.cosines;
        let angles = linkage.groups.iter().map(|group| {
            let kept = group.unknowns.iter().filter_map(|one| Some((*one, cosines[*one]?)));
            kept.collect()
        });
        let groups = linkage.groups.iter().enumerate();
        let trials = groups
            .map(|(group, one)| Trial::of(&scene.program, group, &one.equations, &one.unknowns));
        let trials = trials.collect();
        let ranges = linkage.ranges.iter().map(|range| Range {
            from: range.from,
            to: range.to,
            start: range.start,
            period: range.period,
        });
        Self {
            shape,
            functions: Arc::new(Functions::new(program, scene.drivers.len(), count)),
            forms: (0..linkage.groups.len()).map(|group| form(&scene.program, group)).collect(),
            angles: angles.collect(),
            trials,
            is_apart: scene.program.is_apart(),
            ranges: ranges.collect(),
            values: OfValues::new(scene, shape),
        }
    }
}

/// A linkage with values of its constants.
#[derive(Clone)]
pub struct Moved {
    loops: Arc<Loops>,
    values: Vec<f64>,
}

impl Moved {
    /// The linkage with these values, of which there are as many as it has constants.
    pub fn new(loops: &Arc<Loops>, values: &[f64]) -> Self {
        Self { loops: loops.clone(), values: values.to_vec() }
    }
}

impl Linkage for Moved {
    type Closure<S: Scalar> = Prepare<S>;

    #[inline]
    fn shape(&self) -> &'static Shape {
        self.loops.shape
    }

    fn values(&self) -> Vec<f64> {
        self.values.clone()
    }

    fn with_values(&self, values: &[f64]) -> Self {
        Self::new(&self.loops, values)
    }

    fn prepare<S: Scalar>(&self, values: &[S]) -> Prepare<S> {
        Prepare::new(&self.loops, values)
    }

    fn renew<S: Scalar>(&self, closure: &mut Prepare<S>, values: &[S]) {
        closure.renew(values);
    }

    fn is_apart(&self) -> bool {
        self.loops.is_apart
    }

    fn check(&self) -> Result<(), Refused> {
        let groups = self.loops.forms.len();
        let checked = self.loops.functions.check(Function::all(groups));
        checked.map_err(|cannot| too_large(self.loops.shape, cannot))?;
        self.loops.values.check(&self.values)
    }

    fn span(&self) -> Span {
        self.loops.values.span(&self.values)
    }

    fn drive(&self, time: f64) -> Option<Vec<f64>> {
        self.loops.values.drive(&self.values, time)
    }

    fn ranges(&self) -> Vec<Range> {
        self.loops.ranges.clone()
    }

    fn start(&self) -> Vec<f64> {
        self.loops.values.start(&self.values)
    }
}
