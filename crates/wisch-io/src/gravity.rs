//! What gravity does to the dirt of a task: dirt that slides before the first round, dirt that runs down, and dirt that is
//! assumed to stay.

use wisch::represent::{
    Action, DirtFriction, DirtMobility, DirtSlide, KnowledgeBase, LiquidFilm, MediumKind,
    SteepSurface, Task, dirt_friction, slide_down,
};

/// Slope up to which grains of an unknown friction rest on every usual surface, as a tangent [1].
const RESTING_GRAINS: f64 = 0.2;
/// Slope up to which a surface counts as level for a liquid, as a tangent [1]: 1°.
const LEVEL: f64 = 0.0175;

/// Moves the particles that cannot rest on the surface's slope down to where they come to rest: with the declared friction,
/// or on a plane with an assumed one.
pub(crate) fn let_slide(task: &mut Task, knowledge: &KnowledgeBase) -> Option<SteepSurface> {
    let slide = match task.dirt_slide() {
        Some(slide) => slide,
        None if matches!(task.mobility, DirtMobility::Runs(_)) => return None,
        // The planner refuses a curved surface on which dirt of an unknown friction may slide.
        None if task.action.treats() || !task.surface.shape.is_plane() => return None,
        None => {
            let friction = DirtFriction::constant(assume_friction(task, knowledge)?);
            DirtSlide::new(friction, task.occupied_area())
        }
    };
    let (slid, steep) = slide_down(&task.particles, &task.surface, &slide)?;
    task.particles = slid;
    Some(steep)
}

/// Returns the friction coefficient that is assumed of a task's dirt at rest [1].
fn assume_friction(task: &Task, knowledge: &KnowledgeBase) -> Option<f64> {
    let kind = knowledge.medium(&task.medium).ok()?.kind;
    let of_surface = knowledge.surface(&task.surface.name).ok()?.friction;
    Some(dirt_friction(kind, of_surface))
}

/// Returns a remark on dirt that is assumed to stay in place on a surface so steep that gravity may move it.
pub(crate) fn gravity_remark(task: &Task, knowledge: &KnowledgeBase) -> Option<String> {
    let kind = knowledge.medium(&task.medium).ok()?.kind;
    let slope = task.surface.steepest_slope();
    let level = match kind {
        MediumKind::Liquid => LEVEL,
        MediumKind::Solid | MediumKind::Powder => RESTING_GRAINS,
    };
    // A polished surface holds no dirt, and no law of a coat is known.
    let slides = matches!(task.mobility, DirtMobility::Slides(_));
    if slides || task.action == Action::Polish || slope <= level.atan() {
        return None;
    }
    if let (DirtMobility::Runs(film), true) = (task.mobility, task.has_running_film()) {
        return Some(describe_film(task, &film, slope));
    }
    let why = match kind {
        MediumKind::Liquid if !task.surface.shape.is_plane() || slope.cos() < -1e-3 => {
            "liquids run on planes that face up only".to_owned()
        }
        MediumKind::Liquid if task.action == Action::Dispense => {
            "wisch lets no coat run down".to_owned()
        }
        MediumKind::Liquid => {
            "declare medium.viscosity_pa_s and medium.volume_m3 to let it run down".to_owned()
        }
        MediumKind::Solid | MediumKind::Powder => {
            let friction = assume_friction(task, knowledge)?;
            format!(
                "its friction at rest is assumed to be {friction}; declare medium.static_friction and medium.kinetic_friction"
            )
        }
    };
    let up_to = if task.surface.shape.is_plane() {
        ""
    } else {
        "up to "
    };
    Some(format!(
        "gravity: {} is assumed to stay in place on a surface that leans by {up_to}{:.0}°; {why}",
        task.medium,
        slope.to_degrees()
    ))
}

/// Describes the film that runs down a plane.
fn describe_film(task: &Task, film: &LiquidFilm, slope: f64) -> String {
    let volume = film.particle_volume * task.particles.len() as f64;
    let thickness = volume / task.surface.outline.area();
    let adhering = film.liquid.adhering_thickness;
    if thickness <= adhering {
        return format!(
            "gravity: {} adheres to the surface, which leans by {:.0}°: a film of {:.3} mm is not thicker than the {:.3} mm of medium.adhering_thickness_m, so that it runs only where it gathers",
            task.medium,
            slope.to_degrees(),
            1e3 * thickness,
            1e3 * adhering
        );
    }
    let mut text = format!(
        "gravity: {} runs down the surface, which leans by {:.0}°: a film of {:.3} mm at {:.1} mm/s",
        task.medium,
        slope.to_degrees(),
        1e3 * thickness,
        1e3 * film.liquid.speed(thickness, slope),
    );
    let thickest = film.liquid.largest_thickness(slope);
    if thickness > thickest {
        text += &format!(
            "; waves carry part of a film thicker than {:.3} mm, whose speed is known only roughly",
            1e3 * thickest
        );
    }
    text
}
