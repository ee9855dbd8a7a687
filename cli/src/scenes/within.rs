//! `assur scenes --within`: the cheapest combination of effects and choices that is accurate enough.

use assur::registry::{Mechanism, SceneEntry};
use assur::shape::Quantity;
use assur::study;
use assur_model::asked::Asked;

use super::combination::{Combination, Reference, give};
use super::contrast::{Contrast, contrasts, same};
use super::{constants, fullest};
use crate::arguments::ScenesArguments;
use crate::ask::constants::Constants;
use crate::ask::file;
use crate::ask::lookup::suggestion;
use crate::ask::range::{self, Range};
use crate::ask::wanted::Wanted;
use crate::error::Failure;
use crate::show::progress::Progress;
use crate::source::{Source, Wanted as Compiled};

/// Values of a range unless it says how many.
const VALUES: usize = 5;
/// Seconds that measuring times may take.
const SECONDS: f64 = 3.0;
/// Fewest and most times of each.
const ROUNDS: (usize, usize) = (3, 20);

/// What is found.
pub struct Advice {
    /// The mechanism with all of its scenes.
    pub mechanism: &'static Mechanism,
    /// The scene that the others are compared with.
    pub base: &'static SceneEntry,
    /// It as a combination.
    pub reference: Reference,
    /// The accuracies that are asked for.
    pub wanted: Vec<Wanted>,
    /// What a parameter goes through, if anything.
    pub over: Option<(Quantity, Range)>,
    /// All combinations that balance and report what the scene does, the cheapest first.
    pub all: Vec<Combination>,
}

impl Advice {
    /// Tries all combinations.
    ///
    /// # Errors
    /// A wrong request; a scene of which nothing comes out.
    pub fn find(options: &ScenesArguments, mechanism: &'static Mechanism) -> Result<Self, Failure> {
        let base = fullest(mechanism, options.against.as_deref())?;
        let source = Source::of(mechanism)?.call(mechanism.name);
        let among = among(options, mechanism)?;
        let asked = Compiled::Scenes(Asked::Combinations(Some(base.name), &among));
        let combined = file::mechanism(&source, asked)?;
        let shown: Vec<Quantity> = base.outputs.iter().chain(base.measures).copied().collect();
        let read = |text: &String| Wanted::read("--within", text, &shown);
        let wanted = options.within.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let over = options.over.as_deref();
        let over = over.map(|text| range::read(base, text, Some(VALUES))).transpose()?;
        let over = over.map(|range| (base.constants[range.constant].quantity, range));
        if let Some((quantity, _)) = &over
            && constants(mechanism, base, options)?.given_names().contains(&quantity.name)
        {
            let what = format!("`{}` is given twice, with --over and --set", quantity.name);
            return Err(Failure::request(what).remedy("leave one of them out"));
        }
        let is_base = |scene: &SceneEntry| {
            same(scene.effects, base.effects) && same(scene.choices, base.choices)
        };
        let Some(own) = combined.scenes.iter().position(is_base) else {
            return Err(Failure::request(format!("scene `{}` cannot be compared", base.name))
                .place(format!("--against {}", base.name)));
        };
        let values = |scene| all_values(combined, scene, options, over.as_ref());
        let all = combined.scenes.iter().map(values).collect::<Result<Vec<_>, _>>()?;
        let count = all[own].len();
        let bar = Progress::start(
            format!("{}, combinations", mechanism.name),
            (all.len() * count) as u64,
        );
        let mut given = study::each(all.len() * count, 0, &|done| bar.advance_by(done), &|index| {
            give(all[index / count][index % count].clone())
        })
        .into_iter();
        let combinations = combined
            .scenes
            .iter()
            .map(|scene| Combination { scene, given: given.by_ref().take(count).collect() });
        let mut tried: Vec<Combination> = combinations.collect();
        drop(bar);
        let first = tried.remove(own);
        let reference = Reference::new(first, &all[own])?;
        let mut advice = Self { mechanism, base, reference, wanted, over, all: tried };
        let mut left = all;
        let owns = left.remove(own);
        advice.measure(&left, &owns);
        advice.all.sort_by(|a, b| a.seconds().total_cmp(&b.seconds()));
        Ok(advice)
    }

    /// Measures the times of all that is accurate enough, and of the reference, in turns.
    fn measure(&mut self, all: &[Vec<Constants>], own: &[Constants]) {
        let enough: Vec<usize> =
            (0..self.all.len()).filter(|index| self.share(&self.all[*index]) <= 1.0).collect();
        let of = |one: &Combination| one.seconds();
        let pass: f64 = enough.iter().map(|index| of(&self.all[*index])).sum::<f64>()
            + of(&self.reference.combination);
        let rounds = ((SECONDS / pass) as usize).clamp(ROUNDS.0, ROUNDS.1);
        let bar = Progress::start(format!("{}, times", self.mechanism.name), rounds as u64);
        for _ in 0..rounds {
            let ours = (&mut self.reference.combination, own);
            let others = self.all.iter_mut().zip(all.iter().map(Vec::as_slice)).enumerate();
            let others = others.filter(|(index, _)| enough.contains(index));
            for (combination, constants) in others.map(|one| one.1).chain([ours]) {
                for (given, constants) in combination.given.iter_mut().zip(constants) {
                    if let (Ok(given), Ok(again)) = (given, give(constants.clone())) {
                        given.seconds = given.seconds.min(again.seconds);
                    }
                }
            }
            bar.advance();
        }
    }

    /// How many values of the range there are.
    pub fn values(&self) -> usize {
        self.reference.combination.given.len()
    }

    /// The largest difference over what is permitted, over the range.
    pub fn share(&self, of: &Combination) -> f64 {
        (0..self.values()).map(|value| self.share_at(of, value)).fold(0.0, f64::max)
    }

    /// The same with one value of the range.
    pub fn share_at(&self, of: &Combination, value: usize) -> f64 {
        let differs = |index| self.reference.differs(of, index, value);
        let shares = self.wanted.iter().map(|wanted| wanted.share(differs));
        shares.filter(|share| !share.is_nan()).fold(0.0, f64::max)
    }

    /// What differs most of what is asked for, by its place, and by how much of its size.
    pub fn worst(&self, of: &Combination) -> Option<(usize, f64)> {
        let all = (0..self.values()).flat_map(|value| {
            self.looked_at().into_iter().map(move |index| {
                let differs = self.reference.differs(of, index, value);
                (index, differs.error / differs.size)
            })
        });
        all.filter(|one| !one.1.is_nan()).max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// By how much a quantity differs at most over the range, SI units.
    pub fn apart(&self, of: &Combination, index: usize) -> f64 {
        let errors = (0..self.values()).map(|value| self.reference.differs(of, index, value).error);
        errors.fold(0.0, f64::max)
    }

    /// What any of the accuracies is about.
    pub fn looked_at(&self) -> Vec<usize> {
        let of: Vec<usize> = self.wanted.iter().flat_map(|wanted| wanted.of.clone()).collect();
        (0..self.reference.shown.len()).filter(|index| of.contains(index)).collect()
    }

    /// What effects and choices do.
    pub fn contrasts(&self) -> Vec<Contrast<'_>> {
        contrasts(self.mechanism, &self.all, &self.reference)
    }

    /// The named scene that is a combination, if there is one with the same task.
    pub fn named(&self, scene: &SceneEntry) -> Option<&'static SceneEntry> {
        let is_it = |one: &&SceneEntry| {
            same(one.effects, scene.effects)
                && same(one.choices, scene.choices)
                && one.preset == scene.preset
                && same_names(one.outputs, scene.outputs)
        };
        self.mechanism.scenes.iter().find(is_it)
    }

    /// The command that runs a combination.
    pub fn command(&self, scene: &SceneEntry) -> String {
        let mut text = format!("assur run {} --scene ", self.mechanism.name);
        if let Some(named) = self.named(scene) {
            return text + named.name;
        }
        text += self.base.name;
        for effect in self.left_out(scene) {
            text += &format!(" --without {effect}");
        }
        for (choice, made) in self.chosen(scene) {
            text += &format!(" --choose {choice}={made}");
        }
        text
    }

    /// By what a combination differs from the scene that it is compared with.
    pub fn changes(&self, scene: &SceneEntry) -> Vec<String> {
        let left_out = self.left_out(scene).map(|effect| format!("no {effect}"));
        let chosen = self.chosen(scene).map(|(choice, made)| format!("{choice}.{made}"));
        left_out.chain(chosen).collect()
    }

    fn left_out(&self, scene: &SceneEntry) -> impl Iterator<Item = &'static str> {
        let shown = scene.effects;
        self.base.effects.iter().copied().filter(move |one| !shown.contains(one))
    }

    fn chosen(&self, scene: &SceneEntry) -> impl Iterator<Item = (&'static str, &'static str)> {
        let own = self.base.choices;
        scene.choices.iter().copied().filter(move |one| !own.contains(one))
    }
}

/// The effects and choices that may differ.
fn among<'a>(
    options: &'a ScenesArguments,
    mechanism: &'static Mechanism,
) -> Result<Vec<&'a str>, Failure> {
    let effects = mechanism.effects.iter().map(|effect| effect.name);
    let known: Vec<&str> =
        effects.chain(mechanism.choices.iter().map(|choice| choice.name)).collect();
    let names = options.among.iter().map(|name| name.trim());
    let names = names.map(|name| match known.contains(&name) {
        true => Ok(name),
        false => {
            let what = format!("`{}` has no effect or choice `{name}`", mechanism.name);
            let failure = Failure::request(what).place(format!("--among {name}"));
            Err(failure.remedy(suggestion(name, &known)))
        }
    });
    names.collect()
}

fn same_names(a: &[Quantity], b: &[Quantity]) -> bool {
    a.iter().map(|one| one.name).eq(b.iter().map(|one| one.name))
}

/// The values of a combination, for each value of the range; what it does not have cannot change it.
fn all_values(
    mechanism: &'static Mechanism,
    scene: &'static SceneEntry,
    options: &ScenesArguments,
    over: Option<&(Quantity, Range)>,
) -> Result<Vec<Constants>, Failure> {
    let one = constants(mechanism, scene, options)?;
    let Some((quantity, range)) = over else { return Ok(vec![one]) };
    let place = scene.constants.iter().position(|own| own.quantity.name == quantity.name);
    let with = |value: &f64| {
        let mut values = one.values.clone();
        if let Some(place) = place {
            values[place] = *value;
        }
        one.with_values(&values)
    };
    Ok(range.values.iter().map(with).collect())
}
