//! Which kind of group some loop equations are: the Assur groups of two links, and what is simpler, are recognised from
//! the equations alone.
//!
//! A planar loop is a sum of turning links: with the complex numbers `w` of the links, `Σ wₖ·e^{±iφₖ} = V`. Two scalar
//! equations are such a loop if the coefficients of `(cos φ, sin φ)` are those of a rotation in one sense or the other,
//! `[[a, ∓b], [b, ±a]]`. Equations in the other order, or with another sign, turn in the other sense.

use super::dyad;
use super::relative::Relative;
use super::{Closed, angles};
use crate::checked::GroupKind;
use crate::expression::{Expression, Graph, Map, Symbol};

/// Loop equations that are closed together.
#[derive(Clone, Debug)]
pub struct Group {
    /// How they are solved.
    pub kind: GroupKind,
    /// The scalar equations.
    pub equations: Vec<usize>,
    /// The dependent coordinates that they determine.
    pub unknowns: Vec<usize>,
    /// Their solution, if it has a closed form.
    pub closed: Option<Closed>,
}

/// A complex number.
pub type Complex = [Expression; 2];

/// Coefficients of one unknown in one or two equations.
#[derive(Clone, Debug)]
pub enum Share {
    /// Of the cosine and the sine of an angle, for each equation.
    Turn(Vec<[Expression; 2]>),
    /// Of a displacement, for each equation.
    Slide(Vec<Expression>),
}

/// What a group says when its equations are affine in cosines, sines and displacements.
pub struct Affine {
    /// Coefficients of each unknown.
    pub shares: Vec<Share>,
    /// What is left, for each equation.
    pub rest: Vec<Expression>,
}

impl Group {
    /// Recognises the group from the equations as they are written. `angle` says which dependent coordinates occur as
    /// angles; `mode` is the number of the group, and `alike` are the positions of the kind of its first unknown.
    pub fn of(
        graph: &mut Graph,
        residuals: &[Expression],
        equations: Vec<usize>,
        unknowns: Vec<usize>,
        angle: &[bool],
        (mode, alike): (u32, &[Symbol]),
    ) -> Self {
        let own: Vec<Expression> = equations.iter().map(|row| residuals[*row]).collect();
        let found = match own.len() {
            1 | 2 => recognise(graph, &own, &unknowns, angle, mode),
            _ => None,
        };
        let found = match (found, own.as_slice(), unknowns.as_slice()) {
            (None, &[residual], &[unknown]) => {
                dyad::distance(graph, residual, unknown, mode, alike)
            }
            (found, ..) => found,
        };
        let (kind, closed) = match found {
            Some((kind, closed)) => (kind, Some(closed)),
            None => (GroupKind::General, None),
        };
        Self { kind, equations, unknowns, closed }
    }
}

fn recognise(
    graph: &mut Graph,
    residuals: &[Expression],
    unknowns: &[usize],
    angle: &[bool],
    mode: u32,
) -> Option<(GroupKind, Closed)> {
    if let Some((relative, absolute)) = Relative::of(graph, residuals, unknowns, angle) {
        let (kind, closed) = recognise(graph, &absolute, unknowns, angle, mode)?;
        return Some((kind, relative.back(graph, &closed, mode)?));
    }
    let residuals = &angles::expand(graph, residuals);
    let basics = Basics::of(graph, residuals, unknowns, angle);
    if let Some(affine) = basics.affine(graph) {
        return dyad::affine(graph, &affine, unknowns, mode);
    }
    let (slide, turn) = basics.slide_and_turn()?;
    let parts = basics.turning_slide(graph, slide, turn)?;
    dyad::rpr(graph, &parts, unknowns[turn], unknowns[slide], mode)
}

/// Equations in the cosines, sines and displacements of their unknowns.
struct Basics {
    /// The equations, with `Argument` symbols for cosines and sines.
    residuals: Vec<Expression>,
    /// For each unknown its cosine and sine, or itself.
    symbols: Vec<Vec<Symbol>>,
}

/// `(m·s + n)·e^{±iφ} + rest = 0`, a turning slide.
pub struct TurningSlide {
    /// Direction of the slide.
    pub direction: Complex,
    /// Its offset.
    pub offset: Complex,
    /// What is left.
    pub rest: Complex,
    /// Sense in which it turns.
    pub sense: f64,
}

impl Basics {
    fn of(graph: &mut Graph, residuals: &[Expression], unknowns: &[usize], angle: &[bool]) -> Self {
        let symbol = |unknown: &usize| Symbol::Dependent(*unknown as u32);
        // Of what stands elsewhere than in sines and cosines these are not free.
        let turning: Vec<usize> = unknowns.iter().copied().filter(|one| angle[*one]).collect();
        let turning_symbols: Vec<Symbol> = turning.iter().map(symbol).collect();
        let residuals = angles::free_of(graph, residuals, &turning_symbols);
        let symbols =
            unknowns.iter().map(|unknown| match turning.iter().position(|one| one == unknown) {
                Some(k) => [0, 1].map(|part| Symbol::Argument(2 * k as u32 + part)).to_vec(),
                None => vec![symbol(unknown)],
            });
        let symbols = symbols.collect();
        Self { residuals, symbols }
    }

    fn all(&self) -> Vec<Symbol> {
        self.symbols.concat()
    }

    fn is_free(&self, graph: &Graph, expression: Expression) -> bool {
        let all = self.all();
        !graph.depends_on(expression, |symbol| all.contains(&symbol))
    }

    /// The derivative of an equation, by one symbol.
    fn slope(graph: &mut Graph, residual: Expression, symbol: Symbol) -> Expression {
        let direction = Map::from_iter([(symbol, graph.one())]);
        graph.tangent(&[residual], &direction)[0]
    }

    /// The equations where all unknowns are zero.
    fn rest(&self, graph: &mut Graph, residuals: &[Expression]) -> Vec<Expression> {
        let zero = graph.zero();
        let map: Map<_, _> = self.all().into_iter().map(|symbol| (symbol, zero)).collect();
        graph.substitute(residuals, &map)
    }

    /// The coefficients, if none holds an unknown.
    fn affine(&self, graph: &mut Graph) -> Option<Affine> {
        let mut shares = Vec::new();
        for symbols in &self.symbols {
            let mut columns = Vec::new();
            for symbol in symbols {
                let column: Vec<_> = self
                    .residuals
                    .iter()
                    .map(|residual| Self::slope(graph, *residual, *symbol))
                    .collect();
                if !column.iter().all(|one| self.is_free(graph, *one)) {
                    return None;
                }
                columns.push(column);
            }
            shares.push(match columns.as_slice() {
                [cosines, sines] => {
                    Share::Turn(cosines.iter().zip(sines).map(|(c, s)| [*c, *s]).collect())
                }
                _ => Share::Slide(columns.concat()),
            });
        }
        let rest = self.rest(graph, &self.residuals);
        Some(Affine { shares, rest })
    }

    /// Which of two unknowns is a displacement and which an angle.
    fn slide_and_turn(&self) -> Option<(usize, usize)> {
        match self.symbols.as_slice() {
            [a, b] if a.len() == 1 && b.len() == 2 => Some((0, 1)),
            [a, b] if a.len() == 2 && b.len() == 1 => Some((1, 0)),
            _ => None,
        }
    }

    fn turning_slide(&self, graph: &mut Graph, slide: usize, turn: usize) -> Option<TurningSlide> {
        let ([s], [cosine, sine]) = (self.symbols[slide].as_slice(), self.symbols[turn].as_slice())
        else {
            return None;
        };
        let (mut directions, mut offsets) = (Vec::new(), Vec::new());
        for residual in &self.residuals {
            let mut direction = Vec::new();
            let mut offset = Vec::new();
            for symbol in [cosine, sine] {
                let slope = Self::slope(graph, *residual, *symbol);
                let by_s = Self::slope(graph, slope, *s);
                let at_zero = self.rest(graph, &[slope])[0];
                let rebuilt = {
                    let value = graph.symbol(*s);
                    let product = graph.mul(by_s, value);
                    graph.add(product, at_zero)
                };
                if !self.is_free(graph, by_s) || !graph.is_same(rebuilt, slope) {
                    return None;
                }
                direction.push(by_s);
                offset.push(at_zero);
            }
            // Without the angle the displacement must not occur.
            let alone = Self::slope(graph, *residual, *s);
            let alone = self.rest(graph, &[alone])[0];
            if graph.as_number(alone) != Some(0.0) {
                return None;
            }
            directions.push([direction[0], direction[1]]);
            offsets.push([offset[0], offset[1]]);
        }
        let rest = self.rest(graph, &self.residuals);
        [1.0, -1.0].into_iter().find_map(|sense| {
            Some(TurningSlide {
                direction: rotation(graph, &directions, sense)?,
                offset: rotation(graph, &offsets, sense)?,
                rest: [rest[0], rest[1]],
                sense,
            })
        })
    }
}

/// The complex number that turns in a sense, `w·e^{±iφ}`, if two rows of coefficients of cosine and sine are one.
pub fn rotation(graph: &mut Graph, rows: &[[Expression; 2]], sense: f64) -> Option<Complex> {
    let [[a, by_sine], [b, other_by_sine]] = [rows[0], rows[1]];
    let (minus_b, other_a) = (graph.scale(sense, by_sine), graph.scale(sense, other_by_sine));
    let turned = graph.neg(minus_b);
    (graph.is_same(a, other_a) && graph.is_same(turned, b)).then_some([a, b])
}

/// A link that turns in either sense.
pub fn link(graph: &mut Graph, rows: &[[Expression; 2]]) -> Option<(Complex, f64)> {
    [1.0, -1.0].into_iter().find_map(|sense| Some((rotation(graph, rows, sense)?, sense)))
}

impl Graph {
    /// A value for each symbol that no formula singles out, another one at each place.
    pub fn somewhere(symbol: Symbol, place: u32) -> f64 {
        let text = format!("{symbol:?} {place}");
        let mixed = text
            .bytes()
            .fold(7_u32, |sum, byte| sum.wrapping_mul(31).wrapping_add(u32::from(byte)));
        0.3 + f64::from(mixed % 1009) / 613.0
    }

    /// Whether two expressions have the same value everywhere, tried at a few places.
    pub fn is_same(&mut self, a: Expression, b: Expression) -> bool {
        if a == b {
            return true;
        }
        (1..=3).all(|place| {
            let given = |symbol: Symbol| Self::somewhere(symbol, place);
            let values = self.evaluate(&[a, b], &given);
            (values[0] - values[1]).abs() <= 1e-9 * values[0].abs().max(values[1].abs()).max(1e-9)
        })
    }
}
