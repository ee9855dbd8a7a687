//! What an event computes, as expressions or as values of a program.

/// What an event computes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Event<T> {
    /// The quantity that passes zero.
    pub guard: T,
    /// Its time derivative.
    pub rate: T,
    /// What else has to hold.
    pub condition: Option<T>,
    /// The state after it.
    pub after: Vec<T>,
    /// How all that depends on the state, for the variations of a cycle.
    pub slopes: Slopes<T>,
}

/// How an event depends on the state; empty unless the scene asks for a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slopes<T> {
    /// Of the guard, by each component of the state.
    pub guard: Vec<T>,
    /// Of the state after the event, column by column; empty where nothing is set.
    pub after: Vec<T>,
    /// Total time derivative of the state after the event, along the motion before it; empty where nothing is set.
    pub rate: Vec<T>,
}

impl<T: Copy> Event<T> {
    /// All values, in the order of [`Self::map`].
    pub fn all(&self) -> Vec<T> {
        let mut list = Vec::new();
        self.map(|one| list.push(one));
        list
    }

    /// The event with other values in the places of these.
    pub fn map<U>(&self, mut value: impl FnMut(T) -> U) -> Event<U> {
        let (guard, rate) = (value(self.guard), value(self.rate));
        let condition = self.condition.map(&mut value);
        let mut each = |list: &[T]| list.iter().map(|one| value(*one)).collect();
        Event {
            guard,
            rate,
            condition,
            after: each(&self.after),
            slopes: Slopes {
                guard: each(&self.slopes.guard),
                after: each(&self.slopes.after),
                rate: each(&self.slopes.rate),
            },
        }
    }
}
