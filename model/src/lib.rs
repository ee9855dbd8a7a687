//! The language of Assur: from the text of an equation file to a checked model with one program for each scene.
//!
//! ```text
//! lex -> parse -> put parts in their places -> survey effects and scenes -> for each scene:
//!     specialise -> resolve names -> lower terms, checking units -> derive (Lagrange)
//!     -> balance and order -> solve for the highest derivatives -> simplify and share -> program
//! ```
//!
//! A file is specialised to a scene *before* its names are resolved, because a name may mean one thing with an effect
//! and another without it. A mistake that shows in several scenes is reported once. Branches that no scene shows are
//! compiled as well, for their mistakes alone.
//!
//! The crate knows nothing of rustc: the macro and the command hand it [`token::Token`]s and get
//! [`checked::Compiled`], plain data.
#![doc = include_str!("../GRAMMAR.md")]

pub mod asked;
pub mod checked;
pub mod combinations;
mod compile;
mod declare;
pub mod diagnostic;
pub mod expression;
mod facts;
mod file;
pub mod flatten;
mod homogeneity;
mod joined;
mod lagrange;
pub mod lexer;
mod linkage;
mod lower;
mod measures;
mod modes;
mod motion;
pub mod nearest;
mod presets;
pub mod program;
mod published;
mod resolve;
mod scene;
pub mod sheet;
mod slopes;
mod statements;
pub mod structure;
pub mod syntax;
mod synthesis;
pub mod texts;
pub mod token;
pub mod unit;
mod unroll;

use std::sync::mpsc;

use asked::Asked;
use checked::Compiled;
use flatten::{Loader, Wanted};
use lexer::Unreadable;
use token::Token;

/// Stack of the thread that compiles: nesting is limited, and this holds the deepest that is allowed.
const STACK: usize = 256 << 20;

/// Compiles the tokens of a mechanism without parts, those inside `mechanism! { … }`.
///
/// Never panics and never loops: nesting, repetition and size are limited, and a limit that is met is an error.
pub fn compile(tokens: &[Token]) -> Compiled {
    compile_with(tokens, &mut no_file)
}

/// The loader that has no files.
fn no_file(wanted: &Wanted) -> Result<Vec<Token>, Unreadable> {
    Err(Unreadable {
        range: 0..0,
        message: format!("there is no file `{}` here", wanted.path),
        hint: None,
    })
}

/// Compiles the tokens of a mechanism. Files of its parts and tables come from `loader`, which is called on this thread.
pub fn compile_with(tokens: &[Token], loader: &mut Loader<'_>) -> Compiled {
    compile_asked(tokens, Asked::All, loader)
}

/// Compiles some scenes of a mechanism, or one that is made of another. What is wrong elsewhere is not seen.
pub fn compile_asked(tokens: &[Token], asked: Asked<'_>, loader: &mut Loader<'_>) -> Compiled {
    let (ask, questions) = mpsc::channel::<Wanted>();
    let (give, given) = mpsc::channel();
    let work = move || {
        file::compile(tokens, asked, &mut |wanted| {
            let answer = ask.send(wanted.clone()).ok().and_then(|()| given.recv().ok());
            answer.unwrap_or_else(|| no_file(wanted))
        })
    };
    // `give` goes with this closure, so that the thread that asks ends even if `loader` panics.
    std::thread::scope(move |scope| {
        let worker = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        let Ok(worker) = worker else {
            return file::compile(tokens, asked, loader);
        };
        for wanted in questions {
            let _ = give.send(loader(&wanted));
        }
        match worker.join() {
            Ok(compiled) => compiled,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}
