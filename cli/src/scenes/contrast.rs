//! What an effect or a choice does: by itself, and where all the rest is there.

use assur::registry::{Mechanism, SceneEntry};

use super::combination::{Combination, Reference};

/// What an effect or a choice does, as two pairs of combinations with and without it.
pub struct Contrast<'a> {
    /// `bending`, or an alternative that is taken instead, `crank.exact`.
    pub name: String,
    /// In the reference.
    pub together: [&'a Combination; 2],
    /// Where as little else as possible is there.
    pub alone: [&'a Combination; 2],
}

/// The effects of a reference, and the other alternatives of its choices.
pub fn contrasts<'a>(
    mechanism: &Mechanism,
    all: &'a [Combination],
    reference: &'a Reference,
) -> Vec<Contrast<'a>> {
    let whole = &reference.combination;
    let look = Look { all, whole };
    let effects = whole.scene.effects.iter().filter_map(|effect| {
        let fewest = look.least(&|scene| scene.effects.contains(effect), None)?;
        Some(Contrast {
            name: (*effect).to_owned(),
            together: [whole, look.most_without(effect, whole.scene)?],
            alone: [fewest, look.most_without(effect, fewest.scene)?],
        })
    });
    let choices = whole.scene.choices.iter().flat_map(|(choice, made)| {
        let known = mechanism.choices.iter().find(|one| one.name == *choice);
        let alternatives = known.map_or(&[][..], |one| one.alternatives);
        let others = alternatives.iter().filter(move |one| *one != made);
        others.filter_map(move |other| {
            let of = |other: &str, effects: &[&str]| {
                let is_it = |scene: &SceneEntry| {
                    scene.choices.contains(&(choice, other)) && same(scene.effects, effects)
                };
                look.least(&is_it, Some(choice))
            };
            let fewest = look.least(&|scene| scene.choices.contains(&(choice, made)), None)?;
            Some(Contrast {
                name: format!("{choice}.{other}"),
                together: [whole, of(other, whole.scene.effects)?],
                alone: [fewest, of(other, fewest.scene.effects)?],
            })
        })
    });
    effects.chain(choices).collect()
}

#[derive(Clone, Copy)]
struct Look<'a> {
    all: &'a [Combination],
    whole: &'a Combination,
}

impl<'a> Look<'a> {
    /// Of those with the choices of the reference, but for one perhaps, and with a property the one with fewest effects.
    fn least(
        self,
        has: &dyn Fn(&SceneEntry) -> bool,
        but: Option<&str>,
    ) -> Option<&'a Combination> {
        let all = self.all.iter().filter(|one| self.chooses_like(one.scene, but) && has(one.scene));
        all.min_by_key(|one| one.scene.effects.len())
    }

    /// Of those that lack an effect, and show nothing that a scene does not, the one with most effects.
    fn most_without(self, effect: &str, scene: &SceneEntry) -> Option<&'a Combination> {
        let is_part = |one: &SceneEntry| {
            let mut effects = one.effects.iter();
            effects.all(|own| *own != effect && scene.effects.contains(own))
        };
        let all = self.all.iter().filter(|one| self.chooses_like(one.scene, None));
        all.filter(|one| is_part(one.scene)).max_by_key(|one| one.scene.effects.len())
    }

    fn chooses_like(self, scene: &SceneEntry, but: Option<&str>) -> bool {
        let mut choices = self.whole.scene.choices.iter();
        choices.all(|(choice, made)| {
            let own = scene.choices.iter().find(|own| own.0 == *choice);
            but == Some(choice) || own.is_none_or(|own| own.1 == *made)
        })
    }
}

/// Whether two lists name the same, in whatever order.
pub fn same<T: PartialEq>(a: &[T], b: &[T]) -> bool {
    a.len() == b.len() && a.iter().all(|one| b.contains(one))
}
