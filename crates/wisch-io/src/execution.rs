//! What a simulated execution takes for real: the table `[execution]` over what the knowledge base says.

use crate::ExecutionRecord;
use wisch::represent::{
    GrainSize, KnowledgeBase, KnowledgeError, LogNormal, MediumKind, Reality, Task,
};

/// Drops of a liquid on a surface that they wet [m].
const DROPS: GrainSize = GrainSize {
    min_m: 0.002,
    max_m: 0.004,
};
/// Smaller grains are simulated as ones of this diameter [m]: a contact of two smaller bodies is not
/// resolved at 1 kHz.
const LEAST_GRAIN: f64 = 0.0008;

/// The world as a simulated execution of a task takes it for real: what the file says of it, over what
/// the knowledge base says of surface and medium.
///
/// # Errors
/// If surface or medium of the task are unknown.
pub fn reality(
    record: &ExecutionRecord,
    task: &Task,
    knowledge: &KnowledgeBase,
) -> Result<Reality, KnowledgeError> {
    let medium = knowledge.medium(&task.medium)?;
    let likelihood = task.interaction.likelihood;
    let grain_size = medium.grain_size.unwrap_or(DROPS);
    Ok(Reality {
        believed_from_real: record.believed_from_real,
        friction: match record.friction {
            Some(friction) => friction,
            None => knowledge.surface(&task.surface.name)?.friction,
        },
        friction_changes: record.friction_changes.clone(),
        pushes: record.pushes.clone(),
        force_noise: record.force_noise,
        force_bias: record.force_bias,
        likelihood: LogNormal {
            mu: record.mu.unwrap_or(likelihood.mu),
            sigma: record.sigma.unwrap_or(likelihood.sigma),
        },
        grain_size: GrainSize {
            min_m: grain_size.min_m.max(LEAST_GRAIN),
            max_m: grain_size.max_m.max(LEAST_GRAIN),
        },
        kind: if medium.grain_size.is_none() {
            MediumKind::Liquid
        } else {
            medium.kind
        },
        max_bodies: record.max_bodies,
    })
}
