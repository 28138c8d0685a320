//! Known words in names of columns, and names of forces in robot controllers.

use crate::options::{Axes, WrenchSign};

/// Force of a controller: three or six numbers with an index.
pub(super) struct KnownForce {
    pub base: &'static str,
    pub robot: &'static str,
    pub axes: Axes,
    pub sign: WrenchSign,
}

pub(super) const FORCES: [KnownForce; 3] = [
    KnownForce {
        base: "actual_tcp_force",
        robot: "UR's controller (actual_TCP_force)",
        axes: Axes::Log,
        sign: WrenchSign::OnTool,
    },
    KnownForce {
        base: "o_f_ext_hat_k",
        robot: "libfranka (O_F_ext_hat_K)",
        axes: Axes::Log,
        sign: WrenchSign::ByTool,
    },
    KnownForce {
        base: "k_f_ext_hat_k",
        robot: "libfranka (K_F_ext_hat_K)",
        axes: Axes::Tool,
        sign: WrenchSign::ByTool,
    },
];

/// Context words, which state whose quantity a column holds, not which quantity.
pub(super) const CONTEXT: [&str; 31] = [
    "tcp",
    "tool",
    "ee",
    "eef",
    "end",
    "effector",
    "endeffector",
    "tip",
    "flange",
    "arm",
    "actual",
    "act",
    "measured",
    "meas",
    "current",
    "curr",
    "pose",
    "field",
    "msg",
    "data",
    "state",
    "cartesian",
    "cart",
    "world",
    "rist",
    "kuka",
    "ur",
    "o",
    "t",
    "header",
    "transform",
];
/// Context words of force sensors.
pub(super) const SENSOR_CONTEXT: [&str; 5] = ["ft", "wrench", "sensor", "external", "ext"];

/// Whether the words of `prefix`, without context words, equal an entry of `of`.
pub(super) fn is_prefix(prefix: &str, of: &[&str], context: &[&[&str]]) -> bool {
    let words = prefix.split('_').filter(|word| !word.is_empty());
    let left: Vec<&str> = words
        .filter(|word| !context.iter().any(|list| list.contains(word)))
        .collect();
    of.contains(&left.join("_").as_str())
}

/// Whether a name is `base` with an index, with or without an underscore between them, after any context words.
pub(super) fn indexed_base(name: &str, base: &str, index: usize) -> bool {
    let with = |joint: &str| {
        let end = format!("{base}{joint}{index}");
        name.strip_suffix(&end).is_some_and(|prefix| {
            (prefix.is_empty() || prefix.ends_with('_')) && is_prefix(prefix, &[""], &[&CONTEXT])
        })
    };
    with("_") || with("")
}
