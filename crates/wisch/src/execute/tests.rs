//! Laws of the controller, the observer and the world.
