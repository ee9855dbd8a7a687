//! Where an expression jumps or bends: what stands in the way of its derivatives.
//!
//! `sign`, `floor` and a branch between two constants jump; `abs`, `max` and `min` bend, so that their slope jumps. Three
//! things take a jump away, or are taken to: an even power of a sign, a factor that vanishes where the jump is, as in
//! `x*sign(x)`, and a branch, because whoever writes one says what holds on each side.

use super::function::Function;
use super::graph::{Expression, Graph, Node, Symbol};
use super::hash::Set;

/// What an expression is differentiated along.
pub struct Course<'a> {
    /// Whether something given changes.
    pub moves: &'a dyn Fn(Symbol) -> bool,
    /// The expression that something given stands for, if it is differentiated with it.
    pub behind: &'a dyn Fn(Symbol) -> Option<Expression>,
    /// Whether a branch is meant as a step, where both of its values are constant.
    pub is_step: &'a dyn Fn(Expression) -> bool,
}

/// The places where some expressions are not smooth, in the order in which they were built.
#[derive(Debug, Default)]
pub struct Breaks {
    /// Functions that jump.
    pub jumps: Vec<Expression>,
    /// Functions whose slope jumps.
    pub bends: Vec<Expression>,
}

impl Graph {
    /// Where some expressions jump or bend along a course.
    pub fn breaks(&mut self, roots: &[Expression], course: &Course<'_>) -> Breaks {
        let mut breaks = Breaks::default();
        let mut seen = Set::default();
        let mut stack = roots.to_vec();
        while let Some(one) = stack.pop() {
            if !self.depends_on(one, course.moves) || !seen.insert(one) {
                continue;
            }
            match self.node(one).clone() {
                Node::Symbol(symbol) => stack.extend((course.behind)(symbol)),
                Node::Call(Function::Sign | Function::Floor, _) => breaks.jumps.push(one),
                Node::Select(..) if self.steps(one, course) => breaks.jumps.push(one),
                Node::Select(..) => {}
                Node::Power(base, exponent) if self.is_sign(base) && self.is_even(exponent) => {}
                Node::Product(factors) => {
                    for factor in &factors {
                        if !self.jump_vanishes(*factor, &factors, course) {
                            stack.push(*factor);
                        }
                    }
                }
                node => {
                    if let Node::Call(Function::Abs | Function::Max | Function::Min, _) = node {
                        breaks.bends.push(one);
                    }
                    stack.extend(node.operands());
                }
            }
        }
        breaks.jumps.sort_unstable();
        breaks.bends.sort_unstable();
        breaks
    }

    /// The slopes of a bend, each of which jumps, without a sign before it.
    pub fn slopes_of_bend(&mut self, bend: Expression) -> Vec<Expression> {
        let slopes = self.slopes(bend);
        slopes.into_iter().map(|(_, slope)| self.split_coefficient(slope).1).collect()
    }

    fn is_sign(&self, one: Expression) -> bool {
        matches!(self.node(one), Node::Call(Function::Sign, _))
    }

    fn is_even(&self, exponent: Expression) -> bool {
        self.as_number(exponent).is_some_and(|number| number % 2.0 == 0.0)
    }

    /// Whether a branch goes from constant to constant where its condition changes.
    fn steps(&self, select: Expression, course: &Course<'_>) -> bool {
        let moves = |one: Expression| self.depends_on(one, course.moves);
        let Node::Select(condition, ..) = self.node(select) else {
            return false;
        };
        if !moves(*condition) {
            return false;
        }
        let mut seen = Set::default();
        let mut stack = vec![select];
        while let Some(one) = stack.pop() {
            match self.node(one) {
                _ if !moves(one) || !seen.insert(one) => {}
                Node::Select(_, then, otherwise) if (course.is_step)(one) => {
                    stack.extend([*then, *otherwise]);
                }
                _ => return false,
            }
        }
        true
    }

    /// Whether a factor jumps where the others of its product vanish.
    fn jump_vanishes(
        &mut self,
        factor: Expression,
        factors: &[Expression],
        course: &Course<'_>,
    ) -> bool {
        let Some(surface) = self.surface(factor) else {
            return false;
        };
        let others = factors.iter().copied().filter(|other| *other != factor);
        let zeros = self.zeros(others.collect(), false);
        let needed = self.zeros(vec![surface], true);
        let mut moving =
            needed.iter().filter(|one| self.depends_on(**one, course.moves)).peekable();
        moving.peek().is_some() && moving.all(|one| zeros.contains(one))
    }

    /// What vanishes where a sign or a simple branch jumps.
    fn surface(&mut self, factor: Expression) -> Option<Expression> {
        match self.node(factor).clone() {
            Node::Call(Function::Sign, arguments) => Some(arguments[0]),
            Node::Select(condition, ..) => {
                let compared = match self.node(condition) {
                    Node::Not(inner) => *inner,
                    _ => condition,
                };
                match self.node(compared) {
                    Node::Compare(_, a, b) => {
                        let (a, b) = (*a, *b);
                        Some(self.sub(a, b))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Expressions with whose zeros the product of some factors vanishes; with `poles`, or becomes infinite.
    fn zeros(&mut self, mut factors: Vec<Expression>, poles: bool) -> Set<Expression> {
        let (mut zeros, mut seen) = (Set::default(), Set::default());
        while let Some(one) = factors.pop() {
            if !seen.insert(one) {
                continue;
            }
            match self.node(one).clone() {
                Node::Product(inner) => factors.extend(inner.iter()),
                Node::Power(base, exponent) => match self.as_number(exponent) {
                    Some(number) if number > 0.0 || poles => factors.push(base),
                    _ => {}
                },
                Node::Call(Function::Abs, arguments) => factors.push(arguments[0]),
                Node::Call(Function::Max | Function::Min, arguments)
                    if self.is_zero(arguments[0]) || self.is_zero(arguments[1]) =>
                {
                    factors.extend(arguments.iter());
                }
                Node::Sum(terms) => {
                    // `a - b` and `b - a` vanish together.
                    let turned: Vec<_> = terms.iter().map(|term| self.neg(*term)).collect();
                    zeros.insert(one.min(self.sum(&turned)));
                }
                Node::Number(_) => {}
                _ => {
                    zeros.insert(one);
                }
            }
        }
        zeros
    }

    fn is_zero(&self, one: Expression) -> bool {
        self.as_number(one) == Some(0.0)
    }
}
