//! What is to be wiped, with what, and what the robot knows about both.

mod knowledge;

pub use knowledge::{
    Action, AngleRange, AreaOfEffect, Effect, GrainSize, Interaction, KnowledgeBase,
    KnowledgeError, LogNormal, MediumEntry, MediumKind, Place, RankedTool, SurfaceEntry,
    SurfaceScope, TiltFreedom, ToolEntry, UnknownName,
};
