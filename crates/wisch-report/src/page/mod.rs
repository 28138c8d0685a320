//! Pages that need nothing but themselves.

pub(crate) mod document;
