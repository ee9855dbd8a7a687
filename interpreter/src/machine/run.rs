//! The loop over instructions.

use std::ops::Range;

use assur_model::program::Function;
use assur_solvers::scalar::Scalar;

use super::files::Files;
use super::memory::Image;
use crate::code::{Angle, Instruction};

/// Angles whose sines are taken together.
const PACK: usize = 4;

impl<S: Scalar> Files<'_, S> {
    /// Does some instructions, one after the other.
    #[inline(always)]
    pub fn run(&mut self, instructions: Range<usize>, lines: &[Image<S>]) {
        use Instruction as Do;
        let (code, all) = (self.code, self.registers);
        for instruction in &code.instructions[instructions] {
            match instruction {
                Do::Add([d, a, b]) => all.put(*d, all.at(*a) + all.at(*b)),
                Do::Subtract([d, a, b]) => all.put(*d, all.at(*a) - all.at(*b)),
                Do::Multiply([d, a, b]) => all.put(*d, all.at(*a) * all.at(*b)),
                Do::Divide([d, a, b]) => all.put(*d, all.at(*a) / all.at(*b)),
                Do::Negate([d, a]) => all.put(*d, -all.at(*a)),
                Do::MultiplyAdd([d, a, b, c]) => {
                    all.put(*d, S::mul_add(all.at(*a), all.at(*b), all.at(*c)));
                }
                Do::MultiplySubtract([d, a, b, c]) => {
                    all.put(*d, S::mul_add(all.at(*a), all.at(*b), -all.at(*c)));
                }
                Do::SubtractProduct([d, a, b, c]) => {
                    all.put(*d, S::mul_add(-all.at(*a), all.at(*b), all.at(*c)));
                }
                Do::Root([d, a]) => all.put(*d, all.at(*a).sqrt()),
                Do::Less([d, a, b]) => all.decide(*d, S::less(all.at(*a), all.at(*b))),
                Do::LessEqual([d, a, b]) => all.decide(*d, S::less_equal(all.at(*a), all.at(*b))),
                Do::Equal([d, a, b]) => all.decide(*d, S::equal(all.at(*a), all.at(*b))),
                Do::And([d, a, b]) => all.decide(*d, S::and(all.holds(*a), all.holds(*b))),
                Do::Or([d, a, b]) => all.decide(*d, S::or(all.holds(*a), all.holds(*b))),
                Do::Not([d, a]) => all.decide(*d, S::not(all.holds(*a))),
                Do::Select([d, condition, a, b]) => {
                    all.put(*d, S::select(all.holds(*condition), all.at(*a), all.at(*b)));
                }
                // Apart, so that the loop stays short enough for its values to stay where they are.
                rare => S::outline(
                    #[inline(always)]
                    || self.rare(rare, lines),
                ),
            }
        }
    }

    /// What takes so long that a call more does not count.
    #[inline(always)]
    fn rare(&mut self, instruction: &Instruction, lines: &[Image<S>]) {
        use Instruction as Do;
        let (code, all) = (self.code, self.registers);
        match instruction {
            Do::Call(function, [d, a]) => all.put(*d, one(*function, all.at(*a))),
            Do::CallTwo(function, [d, a, b]) => {
                all.put(*d, two(*function, all.at(*a), all.at(*b)));
            }
            Do::Sines(begin, count) => {
                self.sines(&code.angles[usize::from(*begin)..][..usize::from(*count)]);
            }
            Do::Factor(index) => self.factor(&code.factors[usize::from(*index)]),
            Do::Solve(index) => self.solve(&code.solves[usize::from(*index)]),
            Do::Table(index) => self.table(&code.lookups[usize::from(*index)]),
            Do::Search(index) => self.search(&code.searches[usize::from(*index)], lines),
            _ => {}
        }
    }

    /// Sines and cosines, some angles at a time; what is left of these is filled up with the last one.
    #[inline(always)]
    fn sines(&mut self, angles: &[Angle]) {
        for pack in angles.chunks(PACK) {
            if let [one] = pack {
                let (sine, cosine) = self.registers.at(one.angle).sin_cos();
                self.trigonometric(one, sine, cosine);
                continue;
            }
            let mut arguments = [S::ZERO; PACK];
            for (argument, angle) in arguments.iter_mut().zip(pack) {
                *argument = self.registers.at(angle.angle);
            }
            let (sines, cosines) = S::sin_cos_all(arguments);
            for (angle, (sine, cosine)) in pack.iter().zip(sines.into_iter().zip(cosines)) {
                self.trigonometric(angle, sine, cosine);
            }
        }
    }

    #[inline(always)]
    fn trigonometric(&mut self, angle: &Angle, sine: S, cosine: S) {
        if let Some(register) = angle.sine {
            self.registers.put(register, sine);
        }
        if let Some(register) = angle.cosine {
            self.registers.put(register, cosine);
        }
    }
}

/// A function of one number.
#[inline(always)]
pub(super) fn one<S: Scalar>(function: Function, a: S) -> S {
    match function {
        Function::Sin => a.sin_cos().0,
        Function::Cos => a.sin_cos().1,
        Function::Tan => a.tan(),
        Function::Asin => a.asin(),
        Function::Acos => a.acos(),
        Function::Atan => a.atan(),
        Function::Sinh => a.sinh(),
        Function::Cosh => a.cosh(),
        Function::Tanh => a.tanh(),
        Function::Exp => a.exp(),
        Function::Ln => a.ln(),
        Function::Log10 => a.log10(),
        Function::Sqrt => a.sqrt(),
        Function::Erf => a.erf(),
        Function::NormalCdf => a.normal_cdf(),
        Function::Floor => a.floor(),
        Function::Abs => a.abs(),
        Function::Sign => a.sign(),
        Function::ExpM1 => a.exp_m1(),
        Function::Ln1p => a.ln_1p(),
        Function::Atan2 | Function::Hypot | Function::Max | Function::Min | Function::Power => a,
    }
}

/// A function of two numbers.
#[inline(always)]
pub(super) fn two<S: Scalar>(function: Function, a: S, b: S) -> S {
    match function {
        Function::Atan2 => S::atan2(a, b),
        Function::Hypot => a.hypot(b),
        Function::Max => a.max(b),
        Function::Min => a.min(b),
        Function::Power => a.powf(b),
        _ => a,
    }
}
