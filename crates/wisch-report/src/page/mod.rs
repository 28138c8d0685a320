//! Self-contained HTML pages.

pub(crate) mod document;
