//! Derivatives: forward along a direction, backward from weighted values. Each costs a small multiple of the nodes.

use super::function::{Function, Relation};
use super::graph::{Expression, Graph, Node, Symbol};
use super::hash::{Map, Set};

impl Graph {
    /// Derivatives of some expressions along a direction: what each symbol changes by.
    pub fn tangent(
        &mut self,
        roots: &[Expression],
        direction: &Map<Symbol, Expression>,
    ) -> Vec<Expression> {
        let zero = self.zero();
        let mut rates: Map<Expression, Expression> = Map::default();
        for one in self.reachable(roots) {
            if !self.depends_on(one, |symbol| direction.contains_key(&symbol)) {
                continue;
            }
            let rate = self.rate(one, direction, &rates);
            if rate != zero {
                rates.insert(one, rate);
            }
        }
        roots.iter().map(|root| rates.get(root).copied().unwrap_or(zero)).collect()
    }

    fn rate(
        &mut self,
        one: Expression,
        direction: &Map<Symbol, Expression>,
        rates: &Map<Expression, Expression>,
    ) -> Expression {
        let zero = self.zero();
        let of = |operand: &Expression| rates.get(operand).copied().unwrap_or(zero);
        match self.node(one).clone() {
            Node::Symbol(symbol) => direction.get(&symbol).copied().unwrap_or(zero),
            Node::Sum(terms) => {
                let list: Vec<_> = terms.iter().map(of).collect();
                self.sum(&list)
            }
            Node::Select(condition, a, b) => self.select(condition, of(&a), of(&b)),
            Node::Element(solution, index) => match self.node(solution).clone() {
                Node::Solve(factor, right) => {
                    self.rate_of_solution(factor, solution, &right, rates)[index as usize]
                }
                _ => zero,
            },
            Node::Search(..) => self.rate_of_search(one, rates),
            // The rate of a distance from an end of a range vanishes there as well.
            Node::Whole(inner) if self.is_tried(inner) && of(&inner) != zero => {
                let rate = of(&inner);
                self.intern(Node::Whole(rate))
            }
            // Conditions, factors and solutions have no derivative of their own.
            Node::Number(_) | Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) => {
                zero
            }
            Node::Factor(..) | Node::Solve(..) => zero,
            _ => {
                let mut list = Vec::new();
                for (operand, slope) in self.slopes(one) {
                    let rate = of(&operand);
                    if rate != zero {
                        list.push(self.mul(slope, rate));
                    }
                }
                self.sum(&list)
            }
        }
    }

    /// `A·x = b` gives `A·ẋ = ḃ − Ȧ·x`.
    fn rate_of_solution(
        &mut self,
        factor: Expression,
        solution: Expression,
        right: &[Expression],
        rates: &Map<Expression, Expression>,
    ) -> Vec<Expression> {
        let zero = self.zero();
        let Node::Factor(form, size, entries) = self.node(factor).clone() else {
            return vec![zero; right.len()];
        };
        let size = size as usize;
        let of = |operand: &Expression| rates.get(operand).copied().unwrap_or(zero);
        let elements: Vec<_> =
            (0..size as u32).map(|index| self.intern(Node::Element(solution, index))).collect();
        let mut new_right = Vec::new();
        for (row, right) in right.iter().enumerate() {
            let mut list = vec![of(right)];
            for (column, element) in elements.iter().enumerate() {
                let entry = entries[form.place(size, row, column)];
                if entry == zero {
                    continue;
                }
                let rate = of(&entry);
                let share = self.mul(rate, *element);
                list.push(self.neg(share));
            }
            new_right.push(self.sum(&list));
        }
        self.solve_factored(factor, &new_right)
    }

    /// Gradient of `Σ weight·value` with respect to some symbols, by one sweep from the values to the symbols.
    pub fn gradient(
        &mut self,
        weighted: &[(Expression, Expression)],
        symbols: &[Symbol],
    ) -> Vec<Expression> {
        let roots: Vec<_> = weighted.iter().map(|(value, _)| *value).collect();
        let reachable = self.reachable(&roots);
        let forward_only = |one: &Expression| match self.node(*one) {
            Node::Solve(..) | Node::Search(..) => true,
            // A weight of zero takes nothing away from a slope that is none where the branch does not hold.
            Node::Select(_, a, b) => self.has_a_domain(&[*a, *b], symbols),
            _ => false,
        };
        if reachable.iter().any(forward_only) {
            return self.gradient_by_columns(weighted, symbols);
        }
        let wanted: Set<Symbol> = symbols.iter().copied().collect();
        let mut shares: Map<Expression, Vec<Expression>> = Map::default();
        for (value, weight) in weighted {
            shares.entry(*value).or_default().push(*weight);
        }
        let mut found: Map<Symbol, Expression> = Map::default();
        for one in reachable.into_iter().rev() {
            let Some(list) = shares.remove(&one) else {
                continue;
            };
            if !self.depends_on(one, |symbol| wanted.contains(&symbol)) {
                continue;
            }
            let weight = self.sum(&list);
            if self.as_number(weight) == Some(0.0) {
                continue;
            }
            match self.node(one).clone() {
                Node::Symbol(symbol) => {
                    found.insert(symbol, weight);
                }
                Node::Sum(terms) => {
                    terms.iter().for_each(|term| shares.entry(*term).or_default().push(weight))
                }
                Node::Select(condition, a, b) => {
                    let zero = self.zero();
                    let (then, otherwise) = (
                        self.select(condition, weight, zero),
                        self.select(condition, zero, weight),
                    );
                    shares.entry(a).or_default().push(then);
                    shares.entry(b).or_default().push(otherwise);
                }
                _ => {
                    for (operand, slope) in self.slopes(one) {
                        let share = self.mul(weight, slope);
                        shares.entry(operand).or_default().push(share);
                    }
                }
            }
        }
        let zero = self.zero();
        symbols.iter().map(|symbol| found.get(symbol).copied().unwrap_or(zero)).collect()
    }

    /// Whether some expressions have no slope by one of the symbols somewhere: beyond a domain, or at its end.
    fn has_a_domain(&self, roots: &[Expression], symbols: &[Symbol]) -> bool {
        self.reachable(roots).into_iter().any(|one| {
            let is_limited = match self.node(one) {
                Node::Power(_, exponent) => {
                    let whole = self.as_number(*exponent).filter(|number| number.fract() == 0.0);
                    whole.is_none_or(|number| number < 0.0)
                }
                Node::Call(function, _) => matches!(
                    function,
                    Function::Asin
                        | Function::Acos
                        | Function::Ln
                        | Function::Ln1p
                        | Function::Log10
                        | Function::Hypot
                        | Function::Atan2
                ),
                _ => false,
            };
            is_limited && self.depends_on(one, |symbol| symbols.contains(&symbol))
        })
    }

    fn gradient_by_columns(
        &mut self,
        weighted: &[(Expression, Expression)],
        symbols: &[Symbol],
    ) -> Vec<Expression> {
        let roots: Vec<_> = weighted.iter().map(|(value, _)| *value).collect();
        let one = self.one();
        let mut gradient = Vec::new();
        for symbol in symbols {
            let slopes = self.tangent(&roots, &Map::from_iter([(*symbol, one)]));
            let list: Vec<_> = weighted
                .iter()
                .zip(&slopes)
                .map(|((_, weight), slope)| self.mul(*weight, *slope))
                .collect();
            gradient.push(self.sum(&list));
        }
        gradient
    }

    /// Nonzero partial derivatives of some expressions with respect to some symbols: row, column, value.
    pub fn jacobian(
        &mut self,
        rows: &[Expression],
        symbols: &[Symbol],
    ) -> Vec<(usize, usize, Expression)> {
        let one = self.one();
        let zero = self.zero();
        let mut entries = Vec::new();
        let mut rows_of: Map<Symbol, Vec<usize>> = Map::default();
        for (row, value) in rows.iter().enumerate() {
            for symbol in self.occurring(*value) {
                rows_of.entry(symbol).or_default().push(row);
            }
        }
        for (column, symbol) in symbols.iter().enumerate() {
            let Some(concerned) = rows_of.remove(symbol) else {
                continue;
            };
            let values: Vec<_> = concerned.iter().map(|row| rows[*row]).collect();
            let slopes = self.tangent(&values, &Map::from_iter([(*symbol, one)]));
            entries.extend(
                concerned
                    .into_iter()
                    .zip(slopes)
                    .filter(|(_, slope)| *slope != zero)
                    .map(|(row, slope)| (row, column, slope)),
            );
        }
        entries.sort_by_key(|(row, column, _)| (*row, *column));
        entries
    }

    /// Partial derivatives of a product, power or function with respect to its operands.
    pub(super) fn slopes(&mut self, one: Expression) -> Vec<(Expression, Expression)> {
        match self.node(one).clone() {
            Node::Product(factors) => (0..factors.len())
                .map(|index| {
                    let others: Vec<_> = factors
                        .iter()
                        .enumerate()
                        .filter(|(other, _)| *other != index)
                        .map(|(_, factor)| *factor)
                        .collect();
                    (factors[index], self.product(&others))
                })
                .collect(),
            Node::Power(base, exponent) => {
                let one_less = match self.as_number(exponent) {
                    Some(number) => self.number(number - 1.0),
                    None => {
                        let minus = self.number(-1.0);
                        self.sum(&[exponent, minus])
                    }
                };
                let lower = self.pow(base, one_less);
                let mut list = vec![(base, self.mul(exponent, lower))];
                if self.as_number(exponent).is_none() {
                    let logarithm = self.call(Function::Ln, &[base]);
                    list.push((exponent, self.mul(one, logarithm)));
                }
                list
            }
            Node::Call(function, arguments) => self.slopes_of_call(one, function, &arguments),
            Node::Table(spline, order, at) => vec![(at, self.sampled(spline, order + 1, at))],
            Node::Whole(inner) => match *self.node(inner) {
                // The slope of an inverse is made of it, and divides nothing once more.
                Node::Power(base, exponent) if self.as_number(exponent) == Some(-1.0) => {
                    let square = self.powi(one, 2);
                    vec![(base, self.neg(square))]
                }
                _ => vec![(inner, self.one())],
            },
            _ => Vec::new(),
        }
    }

    fn slopes_of_call(
        &mut self,
        value: Expression,
        function: Function,
        arguments: &[Expression],
    ) -> Vec<(Expression, Expression)> {
        let x = arguments[0];
        let one = self.one();
        let call = |graph: &mut Self, function: Function| graph.call(function, &[x]);
        // `(1 ± x²)^exponent`
        let root = |graph: &mut Self, sign: f64, exponent: f64| {
            let square = graph.powi(x, 2);
            let signed = graph.scale(sign, square);
            let sum = graph.sum(&[one, signed]);
            let exponent = graph.number(exponent);
            graph.pow(sum, exponent)
        };
        let slope = match function {
            Function::Sin => call(self, Function::Cos),
            Function::Cos => {
                let sine = call(self, Function::Sin);
                self.neg(sine)
            }
            Function::Tan => {
                let square = self.powi(value, 2);
                self.sum(&[one, square])
            }
            Function::Asin => root(self, -1.0, -0.5),
            Function::Acos => {
                let slope = root(self, -1.0, -0.5);
                self.neg(slope)
            }
            Function::Atan => root(self, 1.0, -1.0),
            Function::Sinh => call(self, Function::Cosh),
            Function::Cosh => call(self, Function::Sinh),
            Function::Tanh => {
                let square = self.powi(value, 2);
                let negated = self.neg(square);
                self.sum(&[one, negated])
            }
            Function::Exp => value,
            Function::ExpM1 => self.sum(&[value, one]),
            Function::Ln => self.powi(x, -1),
            Function::Ln1p => {
                let sum = self.sum(&[one, x]);
                self.powi(sum, -1)
            }
            Function::Log10 => {
                let inverse = self.powi(x, -1);
                self.scale(std::f64::consts::LOG10_E, inverse)
            }
            Function::Erf => self.bell(x, 1.0, std::f64::consts::FRAC_2_SQRT_PI),
            Function::NormalCdf => self.bell(
                x,
                0.5,
                std::f64::consts::FRAC_2_SQRT_PI * std::f64::consts::FRAC_1_SQRT_2 / 2.0,
            ),
            Function::Abs => {
                let sign = call(self, Function::Sign);
                let bare = self.split_coefficient(sign).1;
                self.carry_switch(value, bare);
                sign
            }
            Function::Sign | Function::Floor => self.zero(),
            Function::Atan2 | Function::Hypot | Function::Max | Function::Min => {
                return self.slopes_of_two(value, function, x, arguments[1]);
            }
            // Built as powers, never as calls.
            Function::Sqrt | Function::Power => return Vec::new(),
        };
        vec![(x, slope)]
    }

    /// `height·exp(−rate·x²)`
    fn bell(&mut self, x: Expression, rate: f64, height: f64) -> Expression {
        let square = self.powi(x, 2);
        let argument = self.scale(-rate, square);
        let value = self.call(Function::Exp, &[argument]);
        self.scale(height, value)
    }

    fn slopes_of_two(
        &mut self,
        value: Expression,
        function: Function,
        a: Expression,
        b: Expression,
    ) -> Vec<(Expression, Expression)> {
        let (zero, one) = (self.zero(), self.one());
        match function {
            // The angle of the point with ordinate a and abscissa b.
            Function::Atan2 => {
                let squares = [self.powi(a, 2), self.powi(b, 2)];
                let sum = self.sum(&squares);
                let (by_a, by_b) = (self.div(b, sum), self.div(a, sum));
                vec![(a, by_a), (b, self.neg(by_b))]
            }
            Function::Hypot => vec![(a, self.div(a, value)), (b, self.div(b, value))],
            _ => {
                let first = if function == Function::Max {
                    self.compare(Relation::Less, b, a)
                } else {
                    self.compare(Relation::Less, a, b)
                };
                self.carry_switch(value, first);
                vec![(a, self.select(first, one, zero)), (b, self.select(first, zero, one))]
            }
        }
    }
}
