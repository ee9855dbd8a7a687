//! Expressions as text, for messages and tests.

use std::cell::Cell;

use super::graph::{Expression, Graph, Node, Symbol};

/// Most nodes that are written out. What is shared is written wherever it occurs: a text without an end can belong to a
/// few nodes.
const LONGEST: usize = 200;

impl Graph {
    /// An expression as text; what has a name is written by its name unless it is the whole, and the inner parts of a
    /// long one are left out: `…`.
    pub fn display(&self, expression: Expression) -> String {
        let writer = Writer { graph: self, left: Cell::new(LONGEST) };
        writer.write(expression, 0, true)
    }
}

/// Writes a graph as if it were a tree.
struct Writer<'a> {
    graph: &'a Graph,
    /// Nodes that may still be written.
    left: Cell<usize>,
}

impl Writer<'_> {
    fn write(&self, expression: Expression, least: u8, whole: bool) -> String {
        let graph = self.graph;
        if let (Some(name), false) = (graph.name_of(expression), whole) {
            return name.to_string();
        }
        let Some(left) = self.left.get().checked_sub(1) else {
            return "…".into();
        };
        self.left.set(left);
        let list = |items: &[Expression]| {
            items.iter().map(|one| self.write(*one, 0, false)).collect::<Vec<_>>().join(", ")
        };
        let (text, power) = match graph.node(expression) {
            Node::Symbol(symbol) => {
                (graph.name_of(expression).map_or_else(|| plain(*symbol), str::to_string), 9)
            }
            Node::Number(value) => {
                (format!("{}", value.get()), if value.get() < 0.0 { 1 } else { 9 })
            }
            Node::Sum(terms) => (self.write_sum(terms), 1),
            Node::Product(factors) => (self.write_product(factors), 2),
            Node::Power(base, exponent) => match graph.as_number(*exponent) {
                Some(0.5) => (format!("sqrt({})", self.write(*base, 0, false)), 9),
                Some(number) if number < 0.0 => (self.write_product(&[expression]), 2),
                _ => (
                    format!("{}^{}", self.write(*base, 4, false), self.write(*exponent, 4, false)),
                    3,
                ),
            },
            Node::Call(function, arguments) => {
                (format!("{}({})", format!("{function:?}").to_lowercase(), list(arguments)), 9)
            }
            Node::Compare(relation, a, b) => (
                format!("{relation:?}({}, {})", self.write(*a, 0, false), self.write(*b, 0, false)),
                9,
            ),
            Node::And(a, b) => (format!("and({})", list(&[*a, *b])), 9),
            Node::Or(a, b) => (format!("or({})", list(&[*a, *b])), 9),
            Node::Whole(a) => (format!("({})", list(&[*a])), 9),
            Node::Not(a) => (format!("not({})", list(&[*a])), 9),
            Node::Select(c, a, b) => (format!("select({})", list(&[*c, *a, *b])), 9),
            Node::Factor(_, size, entries) => (format!("factor{size}({})", list(entries)), 9),
            Node::Solve(factor, right) => {
                (format!("solve({}, {})", self.write(*factor, 0, false), list(right)), 9)
            }
            Node::Table(_, order, at) => {
                (format!("table{}({})", "'".repeat(*order as usize), list(&[*at])), 9)
            }
            Node::Search(search, _, bodies) => {
                (format!("{}({})", format!("{search:?}").to_lowercase(), list(bodies)), 9)
            }
            Node::Element(solution, index) => {
                (format!("{}[{index}]", self.write(*solution, 9, false)), 9)
            }
        };
        if power < least { format!("({text})") } else { text }
    }

    fn write_sum(&self, terms: &[Expression]) -> String {
        let mut text = String::new();
        for term in terms {
            let one = match self.graph.as_number(*term) {
                Some(number) => format!("{number}"),
                None => self.write(*term, 2, false),
            };
            match (text.is_empty(), one.strip_prefix('-')) {
                (true, _) => text = one,
                (false, Some(positive)) => text += &format!(" - {positive}"),
                (false, None) => text += &format!(" + {one}"),
            }
        }
        text
    }

    fn write_product(&self, factors: &[Expression]) -> String {
        let (mut sign, mut above, mut below) = ("", Vec::new(), Vec::new());
        for factor in factors {
            match self.graph.node(*factor) {
                Node::Number(value) if value.get() == -1.0 && factors.len() > 1 => sign = "-",
                Node::Power(base, exponent) => match self.graph.as_number(*exponent) {
                    Some(-1.0) => below.push(self.write(*base, 3, false)),
                    Some(number) if number < 0.0 => {
                        below.push(format!("{}^{}", self.write(*base, 4, false), -number))
                    }
                    _ => above.push(self.write(*factor, 3, false)),
                },
                _ => above.push(self.write(*factor, 2, false)),
            }
        }
        let above = if above.is_empty() { "1".to_string() } else { above.join("*") };
        match below.as_slice() {
            [] => format!("{sign}{above}"),
            [one] => format!("{sign}{above}/{one}"),
            _ => format!("{sign}{above}/({})", below.join("*")),
        }
    }
}

fn plain(symbol: Symbol) -> String {
    match symbol {
        Symbol::Parameter(index) => format!("p{index}"),
        Symbol::Time => "time".into(),
        Symbol::Driver(index) => format!("driver{index}"),
        Symbol::DriverRate(index) => format!("dot(driver{index})"),
        Symbol::DriverAcceleration(index) => format!("ddot(driver{index})"),
        Symbol::Dependent(index) => format!("dependent{index}"),
        Symbol::DependentRate(index) => format!("dot(dependent{index})"),
        Symbol::DependentAcceleration(index) => format!("ddot(dependent{index})"),
        Symbol::Reaction(index) => format!("reaction{index}"),
        Symbol::Felt(index) => format!("felt{index}"),
        Symbol::Effort(index) => format!("effort{index}"),
        Symbol::Energy(index) => format!("energy{index}"),
        Symbol::Mode(index) => format!("mode{index}"),
        Symbol::Measured(index) => format!("measured{index}"),
        Symbol::Side(index) => format!("side{index}"),
        Symbol::Change(index) => format!("change{index}"),
        Symbol::Coordinate(index) => format!("q{index}"),
        Symbol::Speed(index) => format!("u{index}"),
        Symbol::State(index) => format!("z{index}"),
        Symbol::Acceleration(index) => format!("a{index}"),
        Symbol::Argument(index) => format!("argument{index}"),
        Symbol::Bound(level) => format!("bound{level}"),
    }
}
