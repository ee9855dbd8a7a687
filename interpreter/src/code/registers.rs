//! Which registers are free.

use super::CannotRun;

/// A file of registers, of which the first that is free is taken.
#[derive(Debug, Default)]
pub struct Registers {
    free: Vec<usize>,
    /// How many have been taken at one time.
    pub count: usize,
}

impl Registers {
    /// A block of registers that stay taken.
    pub fn block(&mut self, length: usize) -> Result<usize, CannotRun> {
        let at = self.count;
        self.count += length;
        match self.count <= usize::from(u16::MAX) {
            true => Ok(at),
            false => Err(CannotRun::TooLarge),
        }
    }

    /// One register.
    pub fn one(&mut self) -> Result<usize, CannotRun> {
        match self.free.pop() {
            Some(free) => Ok(free),
            None => self.block(1),
        }
    }

    /// Gives a register back.
    pub fn release(&mut self, register: usize) {
        self.free.push(register);
    }
}
