//! Task, surface, tool, medium and dirt particles, with the single model of the effect of wiping.

mod acting_part;
mod cone;
mod contact;
mod effect;
mod field;
mod film;
mod heap;
mod knowledge;
mod mesh_shape;
mod metrics;
mod motion;
mod observation;
mod occupied_area;
mod particles;
mod repeated;
mod scene;
mod shape;
mod sliding;
mod sources;
mod surface;
mod swept_rotation;
mod swept_translation;
mod task;
mod treatment;

pub use cone::{Cone, HALF_ANGLE_RANGE};
pub use contact::{
    ElasticFoundation, LocalPressure, MAX_PRESSURE, RIGID_COMPRESSION, effective_pressure,
    find_needed_compression,
};
pub use effect::{EffectModel, MotionEffect};
pub use field::ParticleField;
pub use film::{FilmFlow, MAX_REYNOLDS, mean_distance, run_off};
pub use heap::{HEAP_DEPTH, heap_depth, heap_slide};
pub use knowledge::{
    Action, AngleRange, AreaOfEffect, DirtFriction, DirtMobility, Effect, GrainSize, Grip,
    Interaction, KnowledgeBase, KnowledgeError, Liquid, LiquidFilm, LogNormal, LogNormalSpread,
    MediumEntry, MediumKind, Mount, Place, RankedTool, Redraw, SecondGrip, SurfaceEntry,
    SurfaceScope, TiltFreedom, ToolEntry, ToolMesh, ToolPace, UnknownName, describe_weak_reaction,
    dirt_friction,
};
pub use mesh_shape::{MeshShape, PatchOfMesh, principal_curvatures};
pub use metrics::{GoalState, Performance, THICKNESS_TOLERANCE};
pub use motion::ToolMotion;
pub use observation::{MAX_DETECTIONS, Observation, SensorModel, Sight};
pub use occupied_area::{OccupiedArea, SURFACE_SKIN};
pub use particles::{Fate, MAX_PARTICLES, ParticleDistribution, ParticleError, ParticleTally};
pub use scene::{SceneObject, ScenePart};
pub use shape::{ChartPoint, LeastRadii, MAX_ROLL, RADIUS_RANGE, SurfaceShape};
pub use sliding::{DirtSlide, SlideEnd, SteepSurface, slide_down};
pub use sources::{
    Cluster, DirtArea, SourceError, cluster_particles, particle_generator, uniform_particles,
};
pub use surface::{Ground, MoveSegment, ShapeFault, Surface};
pub use task::{Task, Tool};
pub use treatment::{Treatment, surface_cells};
