//! The loop over instructions.

use assur_model::program::Function;
use assur_solvers::dense::BoundRows;
use assur_solvers::scalar::Scalar;

use super::memory::Image;
use crate::code::{Angle, Code, Instruction, Register};

/// Angles whose sines are taken together.
const PACK: usize = 4;

/// The registers of a call. There is a power of two of them, so that no index leads outside.
pub(super) struct Files<'a, S: Scalar, const N: usize> {
    pub numbers: &'a mut [S; N],
    pub conditions: &'a mut [S::Mask; N],
    pub bounds: &'a mut [BoundRows<S>],
}

impl<S: Scalar, const N: usize> Files<'_, S, N> {
    /// Copies what the caller gives.
    #[inline(always)]
    pub fn load(&mut self, code: &Code, given: &[&[S]]) {
        for load in &code.loads {
            let list = given.get(load.list).copied().unwrap_or_default();
            self.copy(load.at, load.count, list.get(load.from..).unwrap_or_default());
        }
    }

    /// Copies one of the lists anew.
    #[inline(always)]
    pub fn load_list(&mut self, code: &Code, list: usize, given: &[S]) {
        for load in code.loads.iter().filter(|load| load.list == list) {
            self.copy(load.at, load.count, given.get(load.from..).unwrap_or_default());
        }
    }

    /// Copies so many numbers; those that are not given are zero.
    #[inline(always)]
    fn copy(&mut self, at: usize, count: usize, list: &[S]) {
        let target = &mut self.numbers[at..][..count];
        let known = count.min(list.len());
        target[..known].copy_from_slice(&list[..known]);
        target[known..].fill(S::ZERO);
    }

    /// Copies registers into a list of the caller's.
    #[inline(always)]
    pub fn store(&self, registers: &[Register], list: &mut [S]) {
        for (value, register) in list.iter_mut().zip(registers) {
            *value = self.numbers[Self::place(*register)];
        }
    }

    #[inline(always)]
    const fn place(register: Register) -> usize {
        register as usize & (N - 1)
    }

    #[inline(always)]
    pub(super) fn at(&self, register: Register) -> S {
        self.numbers[Self::place(register)]
    }

    #[inline(always)]
    fn put(&mut self, register: Register, value: S) {
        self.numbers[Self::place(register)] = value;
    }

    #[inline(always)]
    fn holds(&self, register: Register) -> S::Mask {
        self.conditions[Self::place(register)]
    }

    #[inline(always)]
    fn decide(&mut self, register: Register, mask: S::Mask) {
        self.conditions[Self::place(register)] = mask;
    }

    /// Does some instructions, one after the other.
    #[inline(always)]
    pub fn run(&mut self, code: &Code, instructions: &[Instruction], lines: &[Image<S>]) {
        use Instruction as Do;
        for instruction in instructions {
            match instruction {
                Do::Add([d, a, b]) => self.put(*d, self.at(*a) + self.at(*b)),
                Do::Subtract([d, a, b]) => self.put(*d, self.at(*a) - self.at(*b)),
                Do::Multiply([d, a, b]) => self.put(*d, self.at(*a) * self.at(*b)),
                Do::Divide([d, a, b]) => self.put(*d, self.at(*a) / self.at(*b)),
                Do::Negate([d, a]) => self.put(*d, -self.at(*a)),
                Do::MultiplyAdd([d, a, b, c]) => {
                    self.put(*d, S::mul_add(self.at(*a), self.at(*b), self.at(*c)));
                }
                Do::MultiplySubtract([d, a, b, c]) => {
                    self.put(*d, S::mul_add(self.at(*a), self.at(*b), -self.at(*c)));
                }
                Do::SubtractProduct([d, a, b, c]) => {
                    self.put(*d, S::mul_add(-self.at(*a), self.at(*b), self.at(*c)));
                }
                Do::Root([d, a]) => self.put(*d, self.at(*a).sqrt()),
                Do::Less([d, a, b]) => self.decide(*d, S::less(self.at(*a), self.at(*b))),
                Do::LessEqual([d, a, b]) => {
                    self.decide(*d, S::less_equal(self.at(*a), self.at(*b)))
                }
                Do::Equal([d, a, b]) => self.decide(*d, S::equal(self.at(*a), self.at(*b))),
                Do::And([d, a, b]) => self.decide(*d, S::and(self.holds(*a), self.holds(*b))),
                Do::Or([d, a, b]) => self.decide(*d, S::or(self.holds(*a), self.holds(*b))),
                Do::Not([d, a]) => self.decide(*d, S::not(self.holds(*a))),
                Do::Select([d, condition, a, b]) => {
                    self.put(*d, S::select(self.holds(*condition), self.at(*a), self.at(*b)));
                }
                // Apart, so that the loop stays short enough for its values to stay where they are.
                rare => S::outline(
                    #[inline(always)]
                    || self.rare(code, rare, lines),
                ),
            }
        }
    }

    /// What takes so long that a call more does not count.
    #[inline(always)]
    fn rare(&mut self, code: &Code, instruction: &Instruction, lines: &[Image<S>]) {
        use Instruction as Do;
        match instruction {
            Do::Call(function, [d, a]) => self.put(*d, one(*function, self.at(*a))),
            Do::CallTwo(function, [d, a, b]) => {
                self.put(*d, two(*function, self.at(*a), self.at(*b)));
            }
            Do::Sines(begin, count) => {
                self.sines(&code.angles[usize::from(*begin)..][..usize::from(*count)]);
            }
            Do::Factor(index) => self.factor(&code.factors[usize::from(*index)]),
            Do::Solve(index) => self.solve(&code.solves[usize::from(*index)]),
            Do::Table(index) => self.table(&code.lookups[usize::from(*index)]),
            Do::Search(index) => self.search(code, &code.searches[usize::from(*index)], lines),
            _ => {}
        }
    }

    /// Sines and cosines, some angles at a time; what is left of these is filled up with the last one.
    #[inline(always)]
    fn sines(&mut self, angles: &[Angle]) {
        for pack in angles.chunks(PACK) {
            if let [one] = pack {
                let (sine, cosine) = self.at(one.angle).sin_cos();
                self.trigonometric(one, sine, cosine);
                continue;
            }
            let mut arguments = [S::ZERO; PACK];
            for (argument, angle) in arguments.iter_mut().zip(pack) {
                *argument = self.at(angle.angle);
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
            self.put(register, sine);
        }
        if let Some(register) = angle.cosine {
            self.put(register, cosine);
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
