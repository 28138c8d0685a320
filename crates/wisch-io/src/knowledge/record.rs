//! The records of knowledge files, and their conversion to a knowledge base.

use std::collections::BTreeMap;
use std::ops::Bound::{Excluded, Included};

use serde::Deserialize;
use toml::Spanned;

use super::KnowledgeFileError;
use super::grip::{GripRecord, SecondGripRecord};
use super::source::{Limits, Source, UNIT_NORM};
use wisch::geometry::Vector3;
use wisch::represent::{
    Action, AreaOfEffect, DirtFriction, GrainSize, Interaction, KnowledgeBase, KnowledgeError,
    Liquid, LogNormal, LogNormalSpread, MediumEntry, MediumKind, Redraw, SurfaceEntry,
    SurfaceScope, TiltFreedom, ToolEntry, ToolMesh,
};
use wisch::source_location::Place;

/// The schema number that this version supports.
pub(super) const SCHEMA: i64 = 1;
/// Maximum length of the name of a tool, medium or surface [bytes].
pub(super) const NAME_MAX_LEN: usize = 64;

/// Limits of thicknesses and grain sizes [m]: at most a tenth of a metre.
const LENGTH_M: Limits = (Excluded(0.0), Included(0.1));
/// Limits of a tool's compression depth [m]; 0 is rigid.
const DEPTH_M: Limits = (Included(0.0), Included(0.1));
/// Limits of an area of effect [m].
const EXTENT_M: Limits = (Excluded(0.0), Included(2.0));
/// Limits of a press force [N]; the maximum is above the ability of arms of this class.
const FORCE_N: Limits = (Excluded(0.0), Included(200.0));
/// Limits of a Cartesian stiffness [N/m]; the maximum is above what a compliance controller at 1 kHz keeps stable.
const STIFFNESS_N_PER_M: Limits = (Excluded(0.0), Included(1e5));
/// Limits of a damping ratio [1]: aperiodic at 1; far above, the arm no longer moves.
const DAMPING_RATIO: Limits = (Included(0.0), Included(10.0));
/// Limits of a weight relative to the Cartesian task [1].
const WEIGHT: Limits = (Included(0.0), Included(1e3));
/// Limits of a Coulomb coefficient [1]; rubber on glass is near 2.
const FRICTION: Limits = (Included(0.0), Included(5.0));
/// Limits of liquids: viscosity [Pa s], density [kg/m³] and adhering layer [m].
const VISCOSITY: Limits = (Included(1e-4), Included(1e3));
const DENSITY: Limits = (Included(100.0), Included(2e4));
const ADHERING: Limits = (Included(0.0), Included(0.01));
/// Limits of μ, so that the median of f′ is between e⁻¹⁰ and e¹⁰: beyond, every contact or no contact moves grains.
const MU: Limits = (Included(-10.0), Included(10.0));
/// Limits of σ [1]: a law wider than ten decades has no meaning.
const SIGMA: Limits = (Excluded(0.0), Included(10.0));
const SPREAD: Limits = (Included(0.0), Included(10.0));
const SHARE: Limits = (Included(0.0), Included(1.0));

#[derive(Deserialize)]
struct SchemaRecord {
    schema: Spanned<i64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileRecord {
    #[serde(rename = "schema")]
    _schema: i64,
    #[serde(default, rename = "tool")]
    tools: Vec<ToolRecord>,
    #[serde(default, rename = "medium")]
    media: Vec<MediumRecord>,
    #[serde(default, rename = "surface")]
    surfaces: Vec<SurfaceRecord>,
    #[serde(default, rename = "interaction")]
    interactions: Vec<InteractionRecord>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ToolRecord {
    name: Spanned<String>,
    mesh_file: Spanned<String>,
    compression_depth_m: Spanned<f64>,
    area_of_effect: Option<AreaOfEffectRecord>,
    rotation_about_normal_rad: Spanned<[f64; 2]>,
    tilt: Option<TiltRecord>,
    grasp: String,
    grip: Option<GripRecord>,
    second_grip: Option<SecondGripRecord>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AreaOfEffectRecord {
    width_m: Spanned<f64>,
    depth_m: Spanned<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TiltRecord {
    axis_in_tool: Spanned<[f64; 3]>,
    range_rad: Spanned<[f64; 2]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MediumRecord {
    name: Spanned<String>,
    kind: KindRecord,
    grain_size_m: Option<Spanned<[f64; 2]>>,
    static_friction: Option<Spanned<f64>>,
    kinetic_friction: Option<Spanned<f64>>,
    viscosity_pa_s: Option<Spanned<f64>>,
    density_kg_per_m3: Option<Spanned<f64>>,
    adhering_thickness_m: Option<Spanned<f64>>,
}

#[derive(Deserialize, Clone, Copy)]
#[serde(rename_all = "lowercase")]
enum KindRecord {
    Solid,
    Liquid,
    Powder,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SurfaceRecord {
    name: Spanned<String>,
    friction: Spanned<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InteractionRecord {
    tool: Spanned<String>,
    medium: Spanned<String>,
    surface: Spanned<String>,
    actions: Spanned<Vec<Spanned<String>>>,
    press_force_n: Spanned<f64>,
    stiffness_n_per_m: Spanned<f64>,
    damping_ratio: Spanned<f64>,
    nullspace_posture_weight: Spanned<f64>,
    compression_depth_m: Option<Spanned<f64>>,
    gap_m: Option<Spanned<f64>>,
    mu: Spanned<f64>,
    sigma: Spanned<f64>,
    mu_spread: Option<Spanned<f64>>,
    ln_sigma_spread: Option<Spanned<f64>>,
    redraw_length_m: Option<Spanned<f64>>,
    ln_redraw_length_spread: Option<Spanned<f64>>,
    kept_share: Option<Spanned<f64>>,
}

/// Whether a text is a valid name: a PDDL name that is not reserved.
pub(crate) fn is_entry_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_lowercase())
        && (text.bytes())
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || b"_-".contains(&c))
        && text.len() <= NAME_MAX_LEN
        && text != SurfaceScope::ANY_NAME
}

impl Source<'_> {
    fn syntax_error(self, error: &toml::de::Error) -> KnowledgeFileError {
        let offset = error.span().map_or(0, |span| span.start);
        KnowledgeFileError::Syntax {
            at: Place::from_offset(self.name, self.text, offset),
            message: error.message().to_owned(),
        }
    }

    fn record(self) -> Result<FileRecord, KnowledgeFileError> {
        let SchemaRecord { schema } =
            toml::from_str(self.text).map_err(|error| self.syntax_error(&error))?;
        if *schema.get_ref() != SCHEMA {
            return Err(KnowledgeFileError::Schema {
                at: self.place(&schema),
                found: *schema.get_ref(),
            });
        }
        toml::from_str(self.text).map_err(|error| self.syntax_error(&error))
    }

    fn new_name(self, name: &Spanned<String>) -> Result<String, KnowledgeFileError> {
        let text = name.get_ref();
        if is_entry_name(text) {
            Ok(text.clone())
        } else {
            Err(KnowledgeFileError::BadName {
                at: self.place(name),
                name: text.clone(),
            })
        }
    }

    /// Adds the location of `name` to the result of a look-up.
    fn found<T>(
        self,
        name: &Spanned<String>,
        found: Result<T, KnowledgeError>,
    ) -> Result<T, KnowledgeFileError> {
        found.map_err(|error| KnowledgeFileError::UnknownReference {
            at: self.place(name),
            error: Box::new(error),
        })
    }

    fn tool(self, record: &ToolRecord) -> Result<ToolEntry, KnowledgeFileError> {
        if record.mesh_file.get_ref().is_empty() {
            return Err(KnowledgeFileError::Inconsistent {
                at: self.place(&record.mesh_file),
                problem: "mesh_file is empty".to_owned(),
            });
        }
        Ok(ToolEntry {
            name: self.new_name(&record.name)?,
            mesh: ToolMesh::InKnowledge(record.mesh_file.get_ref().clone()),
            compression_depth_m: self.number(
                "compression_depth_m",
                &record.compression_depth_m,
                DEPTH_M,
            )?,
            area_of_effect: (record.area_of_effect.as_ref())
                .map(|area| self.area_of_effect(area))
                .transpose()?,
            rotation_about_normal: self.angles(
                "rotation_about_normal_rad",
                &record.rotation_about_normal_rad,
            )?,
            tilt: (record.tilt.as_ref())
                .map(|tilt| self.tilt(tilt))
                .transpose()?,
            grasp: record.grasp.clone(),
            grip: (record.grip.as_ref())
                .map(|grip| self.grip(grip))
                .transpose()?,
            second_grip: (record.second_grip.as_ref())
                .map(|grip| self.second_grip(grip))
                .transpose()?,
        })
    }

    fn area_of_effect(
        self,
        record: &AreaOfEffectRecord,
    ) -> Result<AreaOfEffect, KnowledgeFileError> {
        Ok(AreaOfEffect {
            width_m: self.number("width_m", &record.width_m, EXTENT_M)?,
            depth_m: self.number("depth_m", &record.depth_m, EXTENT_M)?,
        })
    }

    fn tilt(self, record: &TiltRecord) -> Result<TiltFreedom, KnowledgeFileError> {
        let axis = Vector3::from(*record.axis_in_tool.get_ref());
        let at = self.place(&record.axis_in_tool);
        self.within("length of axis_in_tool", at, axis.norm(), UNIT_NORM)?;
        Ok(TiltFreedom {
            axis_in_tool: nalgebra::Unit::new_normalize(axis),
            range: self.angles("range_rad", &record.range_rad)?,
        })
    }

    fn medium(self, record: &MediumRecord) -> Result<MediumEntry, KnowledgeFileError> {
        let name = self.new_name(&record.name)?;
        let inconsistent = |problem: &str| KnowledgeFileError::Inconsistent {
            at: self.place(&record.name),
            problem: format!("medium {name}: {problem}"),
        };
        let kind = match (record.kind, &record.grain_size_m) {
            (KindRecord::Liquid, Some(_)) => {
                return Err(inconsistent("a liquid has no grain_size_m"));
            }
            (KindRecord::Solid | KindRecord::Powder, None) => {
                return Err(inconsistent("grain_size_m = [min, max] is missing"));
            }
            (KindRecord::Solid, Some(_)) => MediumKind::Solid,
            (KindRecord::Powder, Some(_)) => MediumKind::Powder,
            (KindRecord::Liquid, None) => MediumKind::Liquid,
        };
        let grain_size = match &record.grain_size_m {
            None => None,
            Some(sizes) => {
                let [min_m, max_m] = self.ascending("grain_size_m", sizes, LENGTH_M)?;
                Some(GrainSize { min_m, max_m })
            }
        };
        Ok(MediumEntry {
            name,
            kind,
            grain_size,
            friction: self.friction(record, kind)?,
            liquid: self.liquid(record, kind)?,
        })
    }

    /// Returns how a liquid runs, if that is known.
    fn liquid(
        self,
        record: &MediumRecord,
        kind: MediumKind,
    ) -> Result<Option<Liquid>, KnowledgeFileError> {
        let inconsistent = |problem: &str| KnowledgeFileError::Inconsistent {
            at: self.place(&record.name),
            problem: format!("medium {}: {problem}", record.name.get_ref()),
        };
        let others = [&record.density_kg_per_m3, &record.adhering_thickness_m];
        let Some(viscosity) = &record.viscosity_pa_s else {
            return match others.iter().any(|given| given.is_some()) {
                true => Err(inconsistent("viscosity_pa_s is missing")),
                false => Ok(None),
            };
        };
        if kind != MediumKind::Liquid {
            return Err(inconsistent("only a liquid has a viscosity"));
        }
        let number = |key, given: &Option<Spanned<f64>>, limits, usual| match given {
            Some(given) => self.number(key, given, limits),
            None => Ok(usual),
        };
        let [density, adhering] = others;
        Ok(Some(Liquid {
            viscosity: self.number("viscosity_pa_s", viscosity, VISCOSITY)?,
            density: number("density_kg_per_m3", density, DENSITY, Liquid::WATER.density)?,
            adhering_thickness: number("adhering_thickness_m", adhering, ADHERING, 0.0)?,
        }))
    }

    /// Returns the friction of a medium, if it is known.
    fn friction(
        self,
        record: &MediumRecord,
        kind: MediumKind,
    ) -> Result<Option<DirtFriction>, KnowledgeFileError> {
        let inconsistent = |problem: &str| KnowledgeFileError::Inconsistent {
            at: self.place(&record.name),
            problem: format!("medium {}: {problem}", record.name.get_ref()),
        };
        let (at_rest, sliding) = match (&record.static_friction, &record.kinetic_friction) {
            (None, None) => return Ok(None),
            (None, Some(_)) => {
                return Err(inconsistent("kinetic_friction needs static_friction"));
            }
            (Some(_), _) if kind == MediumKind::Liquid => {
                return Err(inconsistent("a liquid has no friction at rest"));
            }
            (Some(at_rest), None) => (at_rest, at_rest),
            (Some(at_rest), Some(sliding)) => (at_rest, sliding),
        };
        let friction = DirtFriction {
            at_rest: self.number("static_friction", at_rest, FRICTION)?,
            sliding: self.number("kinetic_friction", sliding, FRICTION)?,
        };
        if friction.sliding > friction.at_rest {
            return Err(inconsistent("kinetic_friction exceeds static_friction"));
        }
        Ok(Some(friction))
    }

    fn surface(self, record: &SurfaceRecord) -> Result<SurfaceEntry, KnowledgeFileError> {
        Ok(SurfaceEntry {
            name: self.new_name(&record.name)?,
            friction: self.number("friction", &record.friction, FRICTION)?,
        })
    }

    fn interaction(
        self,
        record: &InteractionRecord,
        knowledge: &KnowledgeBase,
    ) -> Result<Interaction, KnowledgeFileError> {
        let tool = self.found(&record.tool, knowledge.tool(record.tool.get_ref()))?;
        let surface = if record.surface.get_ref() == SurfaceScope::ANY_NAME {
            SurfaceScope::Any
        } else {
            let surface = knowledge.surface(record.surface.get_ref());
            SurfaceScope::Named(self.found(&record.surface, surface)?.name.clone())
        };
        let compression_depth_m = match &record.compression_depth_m {
            Some(depth) => self.number("compression_depth_m", depth, DEPTH_M)?,
            None => tool.compression_depth_m,
        };
        let gap_m = match &record.gap_m {
            Some(gap) => self.number("gap_m", gap, DEPTH_M)?,
            None => 0.0,
        };
        let actions = (record.actions.get_ref().iter())
            .map(|action| {
                let parsed = action.get_ref().parse::<Action>();
                self.found(action, parsed.map_err(KnowledgeError::from))
            })
            .collect::<Result<_, _>>()?;
        if record.actions.get_ref().is_empty() {
            return Err(KnowledgeFileError::Inconsistent {
                at: self.place(&record.actions),
                problem: "an interaction needs at least one action".to_owned(),
            });
        }
        let number = |field, value, limits| self.number(field, value, limits);
        let mut likelihood_spread = LogNormalSpread::default();
        if let Some(spread) = &record.mu_spread {
            likelihood_spread.mu = self.number("mu_spread", spread, SPREAD)?;
        }
        if let Some(spread) = &record.ln_sigma_spread {
            likelihood_spread.ln_sigma = self.number("ln_sigma_spread", spread, SPREAD)?;
        }
        let mut redraw = Redraw::default();
        if let Some(length) = &record.redraw_length_m {
            redraw.length_m = Some(self.number("redraw_length_m", length, EXTENT_M)?);
        }
        if let Some(spread) = &record.ln_redraw_length_spread {
            redraw.ln_length_spread = self.number("ln_redraw_length_spread", spread, SPREAD)?;
        }
        if let Some(share) = &record.kept_share {
            redraw.kept_share = self.number("kept_share", share, SHARE)?;
        }
        let medium = knowledge.medium(record.medium.get_ref());
        Ok(Interaction {
            medium: self.found(&record.medium, medium)?.name.clone(),
            tool: tool.name.clone(),
            surface,
            actions,
            press_force_n: number("press_force_n", &record.press_force_n, FORCE_N)?,
            stiffness_n_per_m: number(
                "stiffness_n_per_m",
                &record.stiffness_n_per_m,
                STIFFNESS_N_PER_M,
            )?,
            damping_ratio: number("damping_ratio", &record.damping_ratio, DAMPING_RATIO)?,
            nullspace_posture_weight: number(
                "nullspace_posture_weight",
                &record.nullspace_posture_weight,
                WEIGHT,
            )?,
            compression_depth_m,
            gap_m,
            likelihood: LogNormal {
                mu: number("mu", &record.mu, MU)?,
                sigma: number("sigma", &record.sigma, SIGMA)?,
            },
            likelihood_spread,
            redraw,
        })
    }
}

/// The locations of all definitions, to find duplicates.
#[derive(Default)]
struct Definitions(BTreeMap<String, Place>);

impl Definitions {
    fn define(&mut self, what: String, at: Place) -> Result<(), KnowledgeFileError> {
        match self.0.get(&what) {
            Some(first) => Err(KnowledgeFileError::Duplicate {
                at,
                first: first.clone(),
                what,
            }),
            None => {
                self.0.insert(what, at);
                Ok(())
            }
        }
    }
}

/// Reads all texts; interactions last, because they refer to the other entries.
pub(super) fn read(files: &[(&str, &str)]) -> Result<KnowledgeBase, KnowledgeFileError> {
    let mut knowledge = KnowledgeBase::default();
    let mut definitions = Definitions::default();
    let mut interactions = Vec::new();
    for &(name, text) in files {
        let source = Source { name, text };
        let file = source.record()?;
        for record in &file.tools {
            let tool = source.tool(record)?;
            definitions.define(format!("tool {}", tool.name), source.place(&record.name))?;
            knowledge.insert_tool(tool);
        }
        for record in &file.media {
            let medium = source.medium(record)?;
            let at = source.place(&record.name);
            definitions.define(format!("medium {}", medium.name), at)?;
            knowledge.insert_medium(medium);
        }
        for record in &file.surfaces {
            let surface = source.surface(record)?;
            let at = source.place(&record.name);
            definitions.define(format!("surface {}", surface.name), at)?;
            knowledge.insert_surface(surface);
        }
        interactions.extend(file.interactions.into_iter().map(|record| (source, record)));
    }
    for (source, record) in &interactions {
        let interaction = source.interaction(record, &knowledge)?;
        let what = format!(
            "interaction {}, {}, {}",
            interaction.tool, interaction.medium, interaction.surface
        );
        definitions.define(what, source.place(&record.tool))?;
        let inserted = knowledge.insert_interaction(interaction);
        source.found(&record.tool, inserted)?;
    }
    Ok(knowledge)
}
