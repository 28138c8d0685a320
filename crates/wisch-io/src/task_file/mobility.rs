//! How the dirt of a task moves by its own weight: friction of solids, and films of liquids.

use super::deserialize::At;
use super::tables::MediumTable;
use super::values::Friction;
use super::{TaskError, TaskFile};
use wisch::represent::{
    DirtFriction, DirtMobility, KnowledgeBase, Liquid, LiquidFilm, MediumKind, ToolPace,
};

/// What a task file states about the motion of its medium.
#[derive(Debug, Clone)]
pub(super) struct MediumMotion {
    /// Name of the medium.
    name: String,
    /// Key that states most of it.
    at: At<()>,
    friction: Option<DirtFriction>,
    liquid: Option<Liquid>,
    /// Volume of all particles [m³].
    volume: Option<f64>,
}

/// Reads what the table of the medium states.
pub(super) fn read(table: &At<MediumTable>) -> Result<Option<MediumMotion>, TaskError> {
    let given = &table.value;
    let friction = friction(given)?;
    let viscosity = given.viscosity_pa_s.as_ref();
    for (key, is_given) in [
        ("density_kg_per_m3", given.density_kg_per_m3.is_some()),
        ("adhering_thickness_m", given.adhering_thickness_m.is_some()),
    ] {
        if is_given && viscosity.is_none() {
            return Err(table.inconsistent(format!("{key} needs viscosity_pa_s")));
        }
    }
    let liquid = viscosity.map(|viscosity| Liquid {
        viscosity: viscosity.value.0,
        density: (given.density_kg_per_m3).map_or(Liquid::WATER.density, |density| density.0),
        adhering_thickness: (given.adhering_thickness_m).map_or(0.0, |thickness| thickness.0),
    });
    let at = (friction.as_ref().map(|(at, _)| at.without_value()))
        .or_else(|| viscosity.map(At::without_value))
        .or_else(|| given.volume_m3.as_ref().map(At::without_value));
    let Some(at) = at else {
        return Ok(None);
    };
    let name = (given.name.as_ref()).ok_or_else(|| table.missing("name"))?;
    Ok(Some(MediumMotion {
        name: name.value.0.clone(),
        at,
        friction: friction.map(|(_, friction)| friction),
        liquid,
        volume: given.volume_m3.as_ref().map(|volume| volume.value.0),
    }))
}

/// Returns the friction that a table states, with its place.
fn friction(given: &MediumTable) -> Result<Option<(At<Friction>, DirtFriction)>, TaskError> {
    let (at_rest, sliding) = (&given.static_friction, &given.kinetic_friction);
    let Some(at_rest) = at_rest else {
        return match sliding {
            Some(sliding) => Err(sliding.inconsistent("this key needs static_friction")),
            None => Ok(None),
        };
    };
    let friction = DirtFriction {
        at_rest: at_rest.value.0,
        sliding: sliding.as_ref().map_or(at_rest, |sliding| sliding).value.0,
    };
    match sliding {
        Some(sliding) if friction.sliding > friction.at_rest => Err(sliding.inconsistent(format!(
            "{} exceeds static_friction, which is {}",
            friction.sliding, friction.at_rest
        ))),
        _ => Ok(Some((at_rest.clone(), friction))),
    }
}

impl TaskFile {
    /// Sets in the entry of the task's medium what the file states about its motion.
    pub(super) fn set_medium_motion(&self, knowledge: &mut KnowledgeBase) -> Result<(), TaskError> {
        let Some(motion) = &self.definitions.motion else {
            return Ok(());
        };
        let known = knowledge.medium(&motion.name);
        let known = known.map_err(|error| self.unknown(error, &motion.at.place))?;
        let mut entry = known.clone();
        let problem = match (entry.kind, motion.friction, motion.liquid, motion.volume) {
            (MediumKind::Liquid, Some(_), _, _) => Some("a liquid has no friction at rest"),
            (MediumKind::Liquid, ..) => None,
            (_, _, Some(_), _) => Some("only a liquid has a viscosity"),
            (_, _, _, Some(_)) => Some("only a liquid has a volume"),
            _ => None,
        };
        if let Some(problem) = problem {
            return Err(motion.at.inconsistent(problem));
        }
        entry.friction = motion.friction.or(entry.friction);
        entry.liquid = motion.liquid.or(entry.liquid);
        if motion.volume.is_some() && entry.liquid.is_none() {
            let problem = "volume_m3 needs the viscosity of the liquid (viscosity_pa_s)";
            return Err(motion.at.inconsistent(problem));
        }
        knowledge.insert_medium(entry);
        Ok(())
    }

    /// Returns how a medium of the knowledge base moves, if `count` particles stand for it.
    pub(super) fn mobility(
        &self,
        knowledge: &KnowledgeBase,
        medium: &str,
        count: usize,
    ) -> DirtMobility {
        let Ok(entry) = knowledge.medium(medium) else {
            return DirtMobility::Unknown;
        };
        let volume = self.definitions.motion.as_ref().and_then(|it| it.volume);
        let follow = &self.run.follow;
        match (entry.friction, entry.liquid, volume) {
            (Some(friction), ..) => DirtMobility::Slides(friction),
            (None, Some(liquid), Some(volume)) => DirtMobility::Runs(LiquidFilm {
                liquid,
                particle_volume: volume / count.max(1) as f64,
                pace: ToolPace {
                    contact: follow.contact_speed,
                    lifted: follow.free_speed.min(ToolPace::default().lifted),
                    ..ToolPace::default()
                },
            }),
            _ => DirtMobility::Unknown,
        }
    }
}
