//! What a linkage is asked for, and what it says of itself.

use super::{Geometry, Linkage, Ranges, Slot, angles, expand};
use crate::checked::{ConstantInfo, DependentInfo, GroupInfo, LinkageInfo, LoopInfo, VariableInfo};
use crate::declare::{Drive, quantity};
use crate::expression::{Expression, Graph, Map, Symbol};
use crate::lower::{Lowering, Moved};
use crate::program::{ClosedForm, Closing, Input, Request};
use crate::resolve::Names;
use crate::slopes::Slopes;
use crate::unit::Unit;

/// Most second derivatives that are written out. Beyond, and for outputs that are derivatives themselves, dual numbers
/// find them.
const MOST_SECOND: usize = 200;
/// Most nodes of the first derivatives of which second ones are written out, and most of these: they are asked for where made
/// dimensions err to second order, and what is longer would take more time to compile than it ever saves.
const LONGEST: (usize, usize) = (1000, 5000);

impl Linkage {
    /// Everything but the influence coefficients. Outputs of `request` are put in terms of single angles.
    pub fn closing(
        &self,
        low: &mut Lowering<'_>,
        request: &mut Request,
        geometry: &Geometry,
        drives: &[Drive],
    ) -> Closing<Expression> {
        let graph = &mut low.graph;
        request.results.outputs = expand(graph, &request.results.outputs);
        request.results.measured = expand(graph, &request.results.measured);
        let cosines = self.cosines();
        let place = |slot: Slot| match slot {
            Slot::Value(index) => index,
            Slot::Cosine(index) => cosines[index].unwrap_or(index),
            Slot::Sine(index) => cosines[index].unwrap_or(index) + 1,
        };
        let groups = self.groups.iter().map(|group| {
            group.closed.as_ref().map(|closed| ClosedForm {
                values: closed.values.iter().map(|(slot, value)| (place(*slot), *value)).collect(),
                sine: closed.sine,
                margin: closed.margin,
            })
        });
        let groups = groups.collect();
        let residuals: Vec<_> = self.equations.iter().map(|one| one.residual).collect();
        let (slopes, coefficients) = slopes(low, (residuals.len(), cosines.len()), drives.len());
        for index in 0..cosines.len() as u32 {
            request.inputs.insert(Symbol::Dependent(index), Input::Position(index));
        }
        for group in 0..self.groups.len() as u32 {
            request.inputs.insert(Symbol::Mode(group), Input::Mode(group));
        }
        let rates = match low.moved {
            Moved::Given => {
                let speeds = drives.iter().filter_map(|drive| drive.rate);
                speeds.chain(drives.iter().filter_map(|drive| drive.acceleration)).collect()
            }
            _ => Vec::new(),
        };
        Closing {
            groups,
            residuals,
            slopes,
            coefficients,
            influence: Vec::new(),
            second: Vec::new(),
            points: expand(&mut low.graph, &geometry.points),
            rates,
            cosines,
        }
    }

    /// Where the dependent coordinates are declared to start, by the constants; no number where nothing says so. The drivers are
    /// where they start, or, where nothing says that, at the begin of the task.
    pub fn starts(
        &self,
        low: &mut Lowering<'_>,
        (ranges, drives): (&Ranges, &[Drive]),
        span: &[Expression],
    ) -> Vec<Expression> {
        let names = low.names;
        let begin = span.first().filter(|_| span.len() == 2).copied();
        let begin = begin.unwrap_or_else(|| low.graph.zero());
        let begin = Map::from_iter([(Symbol::Time, begin)]);
        let mut places = Map::default();
        for (index, (range, drive)) in ranges.list.iter().zip(drives).enumerate() {
            let place = match drive.position.filter(|_| range.start.is_nan()) {
                Some(position) => low.graph.substitute(&[position], &begin)[0],
                None => low.graph.number(range.start),
            };
            places.insert(Symbol::Driver(index as u32), place);
        }
        let starts = names.dependents.iter().enumerate().map(|(index, declared)| {
            let kind = low.kind_of(Symbol::Dependent(index as u32));
            let what = format!("`{}`", declared.name.text);
            let start = declared.what.start.as_ref();
            match start.and_then(|term| low.start_of(term, kind, &what)) {
                Some(start) => low.graph.substitute(&[start], &places)[0],
                None => low.graph.number(f64::NAN),
            }
        });
        starts.collect()
    }

    /// Closures that are not solved for, their time derivatives, and their slopes by the coordinates.
    pub fn closures(&self, low: &mut Lowering<'_>) -> Closing<Expression> {
        let residuals: Vec<_> = self.equations.iter().map(|one| one.residual).collect();
        let coordinates = 0..low.names.coordinates.len() as u32;
        let symbols: Vec<_> = coordinates.map(Symbol::Coordinate).collect();
        let direction = low.direction().unwrap_or_default();
        let rates = low.graph.tangent(&residuals, &direction);
        let slopes = low.graph.jacobian(&residuals, &symbols);
        Closing { residuals, slopes, rates, ..Closing::default() }
    }

    /// Places of the cosines in a position.
    fn cosines(&self) -> Vec<Option<usize>> {
        let mut next = self.angles.len();
        let mut place = |is_angle: &bool| {
            is_angle.then(|| {
                next += 2;
                next - 2
            })
        };
        self.angles.iter().map(&mut place).collect()
    }

    /// What influence coefficients are taken by: the dimensions that are kept, parameters with a tolerance, the drivers.
    pub fn variables(
        &self,
        names: &Names,
        constants: &[Option<ConstantInfo>],
        kept: &[usize],
    ) -> Vec<VariableInfo> {
        let counts = |old: &usize| {
            let made = |info: &ConstantInfo| info.is_dimension || info.tolerance > 0.0;
            constants[*old].as_ref().is_some_and(made)
        };
        let constants = kept.iter().enumerate().filter(|(_, old)| counts(old));
        constants
            .map(|(new, _)| VariableInfo::Constant(new))
            .chain((0..names.drivers.len()).map(VariableInfo::Driver))
            .collect()
    }

    /// Adds the influence coefficients.
    pub fn influence(
        &self,
        low: &mut Lowering<'_>,
        request: &mut Request,
        variables: &[VariableInfo],
        kept: &[usize],
    ) {
        let Some(slopes) = &mut low.slopes else {
            return;
        };
        let graph = &mut low.graph;
        let symbols = symbols(variables, kept);
        // The multipliers of an output serve all variables, the derivatives of the coordinates by a variable all outputs.
        if request.results.outputs.len() <= symbols.len() {
            for output in &request.results.outputs {
                let row = slopes.influence(graph, *output, &symbols);
                request.results.closing.influence.extend(row);
            }
        } else {
            let directions = directions(graph, slopes, &symbols);
            let columns = columns(graph, &request.results.outputs, &directions);
            for output in 0..request.results.outputs.len() {
                let row = columns.iter().map(|column| column[output]);
                request.results.closing.influence.extend(row);
            }
        }
    }

    /// Adds the second derivatives, unless they are many or those of what is a derivative itself.
    pub fn curve(
        &self,
        low: &mut Lowering<'_>,
        request: &mut Request,
        variables: &[VariableInfo],
        kept: &[usize],
    ) {
        let Some(slopes) = &mut low.slopes else {
            return;
        };
        let graph = &mut low.graph;
        let symbols = symbols(variables, kept);
        let derived = |output: &Expression| {
            graph.reachable(&[*output]).iter().any(|one| low.derived.contains(one))
        };
        let triangle = variables.len() * (variables.len() + 1) / 2;
        if triangle * request.results.outputs.len() > MOST_SECOND
            || request.results.outputs.iter().any(derived)
            || graph.reachable(&request.results.closing.influence).len() > LONGEST.0
        {
            return;
        }
        let directions = directions(graph, slopes, &symbols);
        let columns = columns(graph, &request.results.outputs, &directions);
        let mut second = Vec::new();
        for output in 0..request.results.outputs.len() {
            for (row, column) in columns.iter().enumerate() {
                for direction in &directions[..=row] {
                    second.extend(graph.tangent(&[column[output]], direction));
                }
            }
        }
        if graph.reachable(&second).len() <= LONGEST.1 {
            request.results.closing.second = second;
        }
    }

    /// What one of the equations says of itself.
    pub fn loop_info(&self, index: usize) -> LoopInfo {
        let (equation, kind) = (&self.equations[index], &self.kinds[index]);
        let unit = Unit::for_dimension(&kind.dimension());
        LoopInfo {
            name: equation.name.clone(),
            factor: unit.scale(),
            unit: unit.symbol,
            span: equation.span,
        }
    }

    /// What the linkage says of itself.
    pub fn info(
        &self,
        low: &mut Lowering<'_>,
        names: &Names,
        units: &[Option<Unit>],
        ranges: &Ranges,
        variables: Vec<VariableInfo>,
    ) -> LinkageInfo {
        let residuals: Vec<_> = self.equations.iter().map(|one| one.residual).collect();
        let mut ranges = ranges.list.clone();
        for (index, range) in ranges.iter_mut().enumerate() {
            if angles::is_turn(&mut low.graph, &residuals, Symbol::Driver(index as u32)) {
                range.period = std::f64::consts::TAU;
            }
        }
        let dependents = names.dependents.iter().zip(units).enumerate().filter_map(
            |(index, (declared, unit))| {
                let unit = unit.as_ref()?;
                Some(DependentInfo {
                    quantity: quantity(
                        &declared.name.text,
                        &declared.summary,
                        &unit.dimension,
                        unit,
                    ),
                    is_angle: self.angles[index],
                })
            },
        );
        let loops = (0..self.equations.len()).map(|index| self.loop_info(index));
        let groups = self.groups.iter().map(|group| GroupInfo {
            kind: group.kind,
            equations: group.equations.clone(),
            unknowns: group.unknowns.clone(),
        });
        LinkageInfo {
            ranges,
            dependents: dependents.collect(),
            loops: loops.collect(),
            groups: groups.collect(),
            variables,
        }
    }
}

/// What influence coefficients are taken by, as symbols.
fn symbols(variables: &[VariableInfo], kept: &[usize]) -> Vec<Symbol> {
    let symbols = variables.iter().map(|variable| match variable {
        VariableInfo::Constant(new) => Symbol::Parameter(kept[*new] as u32),
        VariableInfo::Driver(index) => Symbol::Driver(*index as u32),
    });
    symbols.collect()
}

/// What happens when one of some things given changes by one.
type Direction = Map<Symbol, Expression>;

fn directions(graph: &mut Graph, slopes: &mut Slopes, symbols: &[Symbol]) -> Vec<Direction> {
    let direction = |symbol: &Symbol| slopes.direction(graph, *symbol);
    symbols.iter().map(direction).collect()
}

/// Derivatives of the outputs in each direction.
fn columns(
    graph: &mut Graph,
    outputs: &[Expression],
    directions: &[Direction],
) -> Vec<Vec<Expression>> {
    let column = |direction: &Direction| graph.tangent(outputs, direction);
    directions.iter().map(column).collect()
}

/// The entries that are not zero of the loops' Jacobian, of so many rows and columns, and of the rates of the dependent
/// coordinates by each driver: row, column, value.
fn slopes(
    low: &mut Lowering<'_>,
    (rows, columns): (usize, usize),
    drivers: usize,
) -> (Entries, Entries) {
    let (mut slopes, mut coefficients) = (Vec::new(), Vec::new());
    let zero = low.graph.zero();
    let Some(known) = &mut low.slopes else {
        return (slopes, coefficients);
    };
    for row in 0..rows {
        let entry = |column| Some((row, column, known.entry(row, column)?));
        slopes.extend((0..columns).filter_map(entry));
    }
    for driver in 0..drivers {
        let by = known.by(&mut low.graph, Symbol::Driver(driver as u32));
        let nonzero = by.into_iter().enumerate().filter(|(_, value)| *value != zero);
        coefficients.extend(nonzero.map(|(index, value)| (index, driver, value)));
    }
    (slopes, coefficients)
}

/// Entries of a matrix.
type Entries = Vec<(usize, usize, Expression)>;
