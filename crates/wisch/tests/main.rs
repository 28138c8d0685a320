//! The tests of the method, one module for each of its parts.

mod adaptive;
mod articulation;
mod capability;
mod clearance;
mod effect;
mod follow;
mod given_strokes;
mod goal;
mod house;
mod ik;
mod interpret;
mod learn;
mod limits;
mod plan;
mod robot;
mod scenarios;
mod session;
mod srdf;
mod timing;
mod tool_meshes;
mod tour;
mod treatment;
mod tutorial;
