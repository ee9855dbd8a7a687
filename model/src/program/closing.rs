//! What a linkage computes, as expressions or as values of a program.

/// Results of a linkage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Closing<T> {
    /// Closed forms of the groups that have one.
    pub groups: Vec<Option<ClosedForm<T>>>,
    /// Residuals of the scalar equations.
    pub residuals: Vec<T>,
    /// Nonzero entries of `∂F/∂z`: equation, dependent coordinate, value.
    pub slopes: Vec<(usize, usize, T)>,
    /// Nonzero kinematic coefficients: dependent coordinate, driver, value.
    pub coefficients: Vec<(usize, usize, T)>,
    /// Influence coefficients, outputs by variables, row by row.
    pub influence: Vec<T>,
    /// Second derivatives: for each output the lower triangle by the variables, row by row; empty where they are left to
    /// dual numbers.
    pub second: Vec<T>,
    /// Points, x and y of each.
    pub points: Vec<T>,
    /// Speeds of the drivers, then their accelerations, in time; empty where they are swept.
    pub rates: Vec<T>,
    /// For each dependent coordinate that is an angle the place of its cosine in a position; its sine follows.
    pub cosines: Vec<Option<usize>>,
}

/// How a group is closed without iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm<T> {
    /// Places in the position and what they become.
    pub values: Vec<(usize, T)>,
    /// Sine of the transmission angle, with the sign of the mode.
    pub sine: T,
    /// By how much the group assembles, in the unit of its equations.
    pub margin: T,
}

impl<T> Closing<T> {
    /// The closed form with everything in it replaced, always in the same order.
    pub fn map<U>(&self, mut new: impl FnMut(&T) -> U) -> Closing<U> {
        let groups = self.groups.iter().map(|group| {
            group.as_ref().map(|closed| ClosedForm {
                values: closed.values.iter().map(|(place, value)| (*place, new(value))).collect(),
                sine: new(&closed.sine),
                margin: new(&closed.margin),
            })
        });
        let groups = groups.collect();
        let residuals = self.residuals.iter().map(&mut new).collect();
        let mut entries = |list: &[(usize, usize, T)]| -> Vec<(usize, usize, U)> {
            list.iter().map(|(row, column, value)| (*row, *column, new(value))).collect()
        };
        let (slopes, coefficients) = (entries(&self.slopes), entries(&self.coefficients));
        Closing {
            groups,
            residuals,
            slopes,
            coefficients,
            influence: self.influence.iter().map(&mut new).collect(),
            second: self.second.iter().map(&mut new).collect(),
            points: self.points.iter().map(&mut new).collect(),
            rates: self.rates.iter().map(&mut new).collect(),
            cosines: self.cosines.clone(),
        }
    }

    /// Everything in it, in that order.
    pub fn all(&self) -> Vec<T>
    where
        T: Copy,
    {
        let mut list = Vec::new();
        self.map(|one| list.push(*one));
        list
    }

    /// For each of all values the function that computes it, numbered from the first on: the closed form of each group,
    /// its margin with the other margins, residuals and slopes, and each other list.
    pub fn functions(&self, first: usize) -> Vec<usize> {
        let lists = [
            self.residuals.len() + self.slopes.len(),
            self.coefficients.len(),
            self.influence.len(),
            self.second.len(),
            self.points.len(),
            self.rates.len(),
        ];
        let margins = first + lists.len();
        let mut functions = Vec::new();
        for (index, closed) in self.groups.iter().flatten().enumerate() {
            functions.extend(vec![margins + 1 + index; closed.values.len() + 1]);
            functions.push(margins);
        }
        for (index, count) in lists.into_iter().enumerate() {
            functions.extend(vec![first + index; count]);
        }
        functions
    }

    /// Length of a position: the dependent coordinates, then cosine and sine of each angle.
    pub fn position(&self) -> usize {
        self.cosines.len() + 2 * self.cosines.iter().flatten().count()
    }
}
