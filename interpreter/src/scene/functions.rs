//! The functions of a program.

use std::sync::{Arc, OnceLock};

use assur_model::program::{Program, Value};
use assur_solvers::scalar::{Lanes, Scalar, WIDTH};

use super::products::Terms;
use super::room::room;
use crate::code::series::Plan;
use crate::code::{CannotRun, Checked, Code, Scope, Storage, Wanted};
use crate::machine::{Calls, Columns, Image, Kept, series};

/// A function of a program, by its number.
pub trait Name: Copy {
    /// Its number.
    fn number(self, program: &Program) -> usize;

    /// What it is given, and what it gives.
    fn wanted(self, program: &Program) -> (Scope, Wanted);
}

/// A function as instructions, or why there is none.
type Built = Result<Checked, CannotRun>;

/// Operations of a program from which on a function may need more numbers than there are registers: of most operations each
/// needs one, of a system of equations more.
const LARGE: usize = 5000;

/// A program with its functions.
pub struct Functions {
    /// The program.
    pub program: Program,
    /// What is kept between its stages.
    pub storage: Storage,
    prepare: OnceLock<Built>,
    /// How the entries of the Jacobian go into its products with columns.
    pub terms: Terms,
    codes: Vec<OnceLock<Built>>,
    /// What stands for a function that cannot be run: it has no results.
    none: Checked,
    /// The series of the rates; none where there is none.
    series: OnceLock<Option<Plan>>,
}

impl Functions {
    /// Of a program with so many drivers that has so many functions at most.
    pub fn new(program: Program, drivers: usize, count: usize) -> Self {
        let storage = Storage::of(&program, drivers);
        let codes = (0..count).map(|_| OnceLock::new()).collect();
        let terms = Terms::of(&program);
        let (prepare, series, none) = (OnceLock::new(), OnceLock::new(), Checked::default());
        Self { program, storage, prepare, terms, codes, none, series }
    }

    /// The function that prepares values.
    fn prepare(&self) -> &Checked {
        let built = self.prepare.get_or_init(|| {
            let prepared: Vec<Value> = self.storage.staging.prepared.iter().copied().collect();
            let wanted = Wanted { keeps: true, ..Wanted::of(prepared) };
            Code::build(&self.program, &self.storage, Scope::Values, &wanted, &Default::default())
        });
        built.as_ref().unwrap_or(&self.none)
    }

    /// A function, or why it cannot be run.
    fn built(&self, name: impl Name) -> &Built {
        let built = self.codes[name.number(&self.program)].get_or_init(|| {
            let (scope, wanted) = name.wanted(&self.program);
            Code::build(&self.program, &self.storage, scope, &wanted, &self.prepare().kept)
        });
        debug_assert_ne!(built.as_ref().err(), Some(&CannotRun::Missing));
        built
    }

    /// A function.
    pub fn code(&self, name: impl Name) -> &Checked {
        self.built(name).as_ref().unwrap_or(&self.none)
    }

    /// Checks that functions can be run. Where the program is not large all can, and none is built for it.
    ///
    /// # Errors
    /// Why the first that cannot be run cannot.
    pub fn check(&self, names: impl IntoIterator<Item = impl Name>) -> Result<(), CannotRun> {
        if self.program.operations.len() < LARGE {
            return Ok(());
        }
        self.prepare();
        if let Some(Err(cannot)) = self.prepare.get() {
            return Err(*cannot);
        }
        names
            .into_iter()
            .try_for_each(|name| self.built(name).as_ref().map(|_| ()).map_err(|one| *one))
    }

    /// Calls a function that needs nothing prepared.
    pub fn bare<S: Scalar>(&self, name: impl Name, given: &[&[S]], results: &mut [S]) {
        let code = self.code(name);
        Image::bare(code).call(code, given, results);
    }
}

/// The functions of a program with its prepared values, on numbers of one kind.
pub struct Prepared<S: Scalar> {
    /// The functions.
    pub functions: Arc<Functions>,
    kept: Kept<S>,
    images: Vec<OnceLock<Image<S>>>,
    /// The same for several numbers side by side; none where these would have to go separate ways.
    wide: Vec<OnceLock<Option<Image<Lanes<S>>>>>,
}

impl<S: Scalar> Prepared<S> {
    /// From the values of the constants.
    pub fn new(functions: &Arc<Functions>, values: &[S]) -> Self {
        let code = functions.prepare();
        Self {
            functions: functions.clone(),
            kept: Image::bare(code).keep(code, &[values]),
            images: functions.codes.iter().map(|_| OnceLock::new()).collect(),
            wide: functions.codes.iter().map(|_| OnceLock::new()).collect(),
        }
    }

    /// The same from other values of the constants, in the same memory.
    pub fn renew(&mut self, values: &[S]) {
        let functions = &self.functions;
        self.kept.renew(functions.prepare(), &[values]);
        for (image, code) in self.images.iter_mut().zip(&functions.codes) {
            if let (Some(image), Some(Ok(code))) = (image.get_mut(), code.get()) {
                image.renew(code, &self.kept);
            }
        }
        self.wide.iter_mut().for_each(|wide| *wide = OnceLock::new());
    }

    /// The program.
    #[inline]
    pub fn program(&self) -> &Program {
        &self.functions.program
    }

    #[inline]
    fn of(&self, name: impl Name) -> (&Checked, &Image<S>) {
        let code = self.functions.code(name);
        let image = &self.images[name.number(&self.functions.program)];
        (code, image.get_or_init(|| Image::of(code, &self.kept)))
    }

    /// Calls a function.
    #[inline]
    pub fn call(&self, name: impl Name, given: &[&[S]], results: &mut [S]) {
        let (code, image) = self.of(name);
        image.call(code, given, results);
    }

    /// A function that is called again and again.
    #[inline]
    pub fn calls(&self, name: impl Name) -> Calls<'_, S> {
        let (code, image) = self.of(name);
        Calls::new(code, image)
    }

    /// A function that is called for several columns.
    pub fn columns(&self, name: impl Name) -> Columns<'_, S> {
        let (code, image) = self.of(name);
        Columns::new(code, image, self.wide(name).map(|(_, wide)| wide))
    }

    /// A function on several numbers side by side; none where these would have to go separate ways.
    fn wide(&self, name: impl Name) -> Option<(&Checked, &Image<Lanes<S>>)> {
        let (code, image) = self.of(name);
        let wide = &self.wide[name.number(&self.functions.program)];
        Some((code, wide.get_or_init(|| image.widen(code)).as_ref()?))
    }

    /// Writes rows of a function of one number, the time, for several of them; `stride` is the length of a row.
    pub fn call_rows(&self, name: impl Name, times: &[S], stride: usize, rows: &mut [S]) {
        let (code, image) = self.of(name);
        let (length, mut done) = (code.results.len(), 0);
        if length < self.functions.storage.length {
            return rows.fill(S::from_f64(f64::NAN));
        }
        let wide = if times.len() > 1 { self.wide(name) } else { None };
        if let Some((code, wide)) = wide {
            let mut calls = Calls::new(code, wide);
            room(length, |row| {
                for (times, rows) in times.chunks(WIDTH).zip(rows.chunks_mut(WIDTH * stride)) {
                    let mut pack = Lanes::splat(times[0]);
                    pack.0[..times.len()].copy_from_slice(times);
                    calls.call(&[&[pack]], row);
                    for (lane, own) in rows.chunks_exact_mut(stride).enumerate() {
                        own.iter_mut().zip(&*row).for_each(|(own, all)| *own = all.0[lane]);
                    }
                }
            });
            done = times.len();
        }
        for (time, row) in times.iter().zip(rows.chunks_exact_mut(stride)).skip(done) {
            image.call(code, &[std::slice::from_ref(time)], &mut row[..length]);
        }
    }

    /// Writes the Taylor series of a motion. False where there is none.
    pub fn series(&self, sides: &[S], along: (S, S), rows: &mut [S]) -> bool {
        let functions = &self.functions;
        let rates = &functions.program.results.derivative;
        let plan = functions.series.get_or_init(|| Plan::new(&functions.program, rates));
        let Some(plan) = plan else { return false };
        let slot = |value: Value| functions.prepare().kept.get(&value).copied();
        series::run(plan, (&self.kept, &slot), sides, along, rows);
        true
    }
}

impl<S: Scalar> std::fmt::Debug for Prepared<S> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Prepared").finish_non_exhaustive()
    }
}
