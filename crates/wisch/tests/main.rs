//! The tests of the method, one module for each of its parts.

mod adaptive;
mod cone;
mod curved;
mod effect;
mod follow;
mod given_strokes;
mod goal;
mod gravity;
mod house;
mod interpret;
mod learn;
mod limits;
mod plan;
mod preparation;
mod scenarios;
mod sequence;
mod session;
mod swept_mesh;
mod tour;
mod treatment;
mod tutorial;
