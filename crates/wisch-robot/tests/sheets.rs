//! Charts of meshes: closed forms, refusals, and repairs.

mod charts;
mod repairs;
mod shapes;
