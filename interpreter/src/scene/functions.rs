//! The functions of a program.

use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use assur_model::program::{OperationKind, Program, Value};
use assur_solvers::scalar::Scalar;

use super::room::room;
use crate::code::series::Plan;
use crate::code::{CannotRun, Code, Scope, Storage, Wanted};
use crate::machine::{Image, Kept, Lanes, WIDTH, series};

/// A function of a program, by its number.
pub trait Name: Copy {
    /// Its number.
    fn number(self, program: &Program) -> usize;

    /// What it is given, and what it gives.
    fn wanted(self, program: &Program) -> (Scope, Wanted);
}

/// A function as instructions, or why there is none.
type Built = Result<Code, CannotRun>;

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
    terms: Vec<Term>,
    codes: Vec<OnceLock<Built>>,
    /// What stands for a function that cannot be run: it has no results.
    none: Code,
    /// The series of the rates; none where there is none.
    series: OnceLock<Option<Plan>>,
}

impl Functions {
    /// Of a program with so many drivers that has so many functions at most.
    pub fn new(program: Program, drivers: usize, count: usize) -> Self {
        let storage = Storage::of(&program, drivers);
        let codes = (0..count).map(|_| OnceLock::new()).collect();
        let terms = terms(&program);
        let (prepare, series, none) = (OnceLock::new(), OnceLock::new(), Code::default());
        Self { program, storage, prepare, terms, codes, none, series }
    }

    /// The function that prepares values.
    fn prepare(&self) -> &Code {
        let built = self.prepare.get_or_init(|| {
            let prepared: Vec<Value> = self.storage.staging.prepared.iter().copied().collect();
            let wanted = Wanted { keeps: true, ..Wanted::of(prepared) };
            Code::new(&self.program, &self.storage, Scope::Values, &wanted, &Default::default())
        });
        built.as_ref().unwrap_or(&self.none)
    }

    /// A function, or why it cannot be run.
    fn built(&self, name: impl Name) -> &Built {
        let built = self.codes[name.number(&self.program)].get_or_init(|| {
            let (scope, wanted) = name.wanted(&self.program);
            Code::new(&self.program, &self.storage, scope, &wanted, &self.prepare().kept)
        });
        debug_assert_ne!(built.as_ref().err(), Some(&CannotRun::Missing));
        built
    }

    /// A function.
    pub fn code(&self, name: impl Name) -> &Code {
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
        lose(code, results);
    }
}

/// How an entry of the Jacobian goes into a row of a product.
struct Term {
    row: usize,
    column: usize,
    kind: Kind,
}

/// What an entry is: the first of its row or not, a number or not.
enum Kind {
    Nothing,
    First,
    FirstOne,
    FirstMinus,
    One,
    Minus,
    Other,
}

fn terms(program: &Program) -> Vec<Term> {
    let mut begun = BTreeSet::new();
    let entries = program.results.jacobian.iter();
    let term = entries.map(|(row, column, value)| {
        let number = match program.kind(*value) {
            OperationKind::Number(number) => *number,
            _ => f64::NAN,
        };
        let is_first = number != 0.0 && begun.insert(*row);
        let kind = match (is_first, number) {
            (_, 0.0) => Kind::Nothing,
            (true, 1.0) => Kind::FirstOne,
            (true, -1.0) => Kind::FirstMinus,
            (true, _) => Kind::First,
            (false, 1.0) => Kind::One,
            (false, -1.0) => Kind::Minus,
            (false, _) => Kind::Other,
        };
        Term { row: *row as usize, column: *column as usize, kind }
    });
    term.collect()
}

/// Results of a function that cannot be run are no numbers.
#[inline]
fn lose<S: Scalar>(code: &Code, results: &mut [S]) {
    if code.results.len() < results.len() {
        results.fill(S::from_f64(f64::NAN));
    }
}

/// The functions of a program with its prepared values, on numbers of one kind.
pub struct Prepared<S: Scalar> {
    /// The functions.
    pub functions: Arc<Functions>,
    kept: Kept<S>,
    images: Vec<OnceLock<Image<S>>>,
    /// The same for several numbers side by side, of the function of instants.
    wide: OnceLock<Option<Image<Lanes<S>>>>,
}

impl<S: Scalar> Prepared<S> {
    /// From the values of the constants.
    pub fn new(functions: &Arc<Functions>, values: &[S]) -> Self {
        let code = functions.prepare();
        Self {
            functions: functions.clone(),
            kept: Image::bare(code).keep(code, &[values]),
            images: functions.codes.iter().map(|_| OnceLock::new()).collect(),
            wide: OnceLock::new(),
        }
    }

    /// The program.
    #[inline]
    pub fn program(&self) -> &Program {
        &self.functions.program
    }

    #[inline]
    fn of(&self, name: impl Name) -> (&Code, &Image<S>) {
        let code = self.functions.code(name);
        let image = &self.images[name.number(&self.functions.program)];
        (code, image.get_or_init(|| Image::of(code, &self.kept)))
    }

    /// Calls a function.
    #[inline]
    pub fn call(&self, name: impl Name, given: &[&[S]], results: &mut [S]) {
        let (code, image) = self.of(name);
        image.call(code, given, results);
        lose(code, results);
    }

    /// Writes rows of a function of one number, the time, for several of them; `stride` is the length of a row.
    pub fn call_rows(&self, name: impl Name, times: &[S], stride: usize, rows: &mut [S]) {
        let (code, image) = self.of(name);
        let (length, mut done) = (code.results.len(), 0);
        if length < self.functions.storage.length {
            return rows.fill(S::from_f64(f64::NAN));
        }
        let wide = (times.len() > 1).then(|| self.wide.get_or_init(|| image.widen(code)).as_ref());
        if let Some(wide) = wide.flatten() {
            room(length, |row| {
                for (times, rows) in times.chunks(WIDTH).zip(rows.chunks_mut(WIDTH * stride)) {
                    let mut pack = Lanes::splat(times[0]);
                    pack.0[..times.len()].copy_from_slice(times);
                    wide.call(code, &[&[pack]], row);
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

    /// Writes the products of the Jacobian, from its entries, with columns, which they take the places of: in the order in
    /// which emitted code adds them up.
    pub fn multiply(&self, entries: &[S], products: &mut [S]) {
        let (terms, states) = (&self.functions.terms, self.program().states.max(1));
        S::outline(
            #[inline(always)]
            || {
                room(states, |sums: &mut [S]| {
                    for product in products.chunks_exact_mut(states) {
                        sums.fill(S::ZERO);
                        for (term, entry) in terms.iter().zip(entries) {
                            let (sum, other) = (&mut sums[term.row], product[term.column]);
                            *sum = match term.kind {
                                Kind::Nothing => *sum,
                                Kind::First => *entry * other,
                                Kind::FirstOne => other,
                                Kind::FirstMinus => -other,
                                Kind::One => *sum + other,
                                Kind::Minus => *sum - other,
                                Kind::Other => entry.mul_add(other, *sum),
                            };
                        }
                        product.copy_from_slice(sums);
                    }
                });
            },
        );
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

    /// Calls a function for several columns, which its products take the places of.
    pub fn call_columns(
        &self,
        name: impl Name,
        given: &[&[S]],
        results: &mut [S],
        products: &mut [S],
    ) {
        let (code, image) = self.of(name);
        image.call_columns(code, given, results, products);
        lose(code, results);
    }
}

impl<S: Scalar> std::fmt::Debug for Prepared<S> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Prepared").finish_non_exhaustive()
    }
}
