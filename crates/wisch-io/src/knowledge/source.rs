//! The text of a knowledge file: locations in it, and checks of limits.

use super::KnowledgeFileError;
use std::f64::consts::PI;
use std::ops::Bound::{Excluded, Included};
use std::ops::{Bound, RangeBounds};
use toml::Spanned;
use wisch::represent::AngleRange;
use wisch::source_location::Place;

pub(super) type Limits = (Bound<f64>, Bound<f64>);

/// Limits of a coordinate in the tool frame [m].
pub(super) const POINT_M: Limits = (Included(-3.0), Included(3.0));
/// Limits of the ends of a range of angles [rad].
pub(super) const ANGLE_RAD: Limits = (Included(-PI), Included(PI));
/// Limits of the norm of a direction, before it is normalised.
pub(super) const UNIT_NORM: Limits = (Included(0.99), Included(1.01));

/// A text with its name, which converts offsets to locations.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub(super) name: &'a str,
    pub(super) text: &'a str,
}

impl Source<'_> {
    pub(super) fn place<T>(self, spanned: &Spanned<T>) -> Place {
        Place::from_offset(self.name, self.text, spanned.span().start)
    }

    pub(super) fn number(
        self,
        field: &'static str,
        value: &Spanned<f64>,
        limits: Limits,
    ) -> Result<f64, KnowledgeFileError> {
        self.within(field, self.place(value), *value.get_ref(), limits)
    }

    pub(super) fn within(
        self,
        field: &'static str,
        at: Place,
        value: f64,
        limits: Limits,
    ) -> Result<f64, KnowledgeFileError> {
        if limits.contains(&value) {
            return Ok(value);
        }
        let side = |bound, included: &str, excluded: &str| match bound {
            Included(limit) => format!("{included} {limit}"),
            Excluded(limit) => format!("{excluded} {limit}"),
            Bound::Unbounded => "any".to_owned(),
        };
        Err(KnowledgeFileError::OutOfRange {
            at,
            field,
            value,
            limits: format!(
                "{} and {}",
                side(limits.0, "at least", "above"),
                side(limits.1, "at most", "below")
            ),
        })
    }

    /// Checks that two numbers are in ascending order.
    pub(super) fn ascending(
        self,
        field: &'static str,
        pair: &Spanned<[f64; 2]>,
        limits: Limits,
    ) -> Result<[f64; 2], KnowledgeFileError> {
        let [min, max] = *pair.get_ref();
        self.within(field, self.place(pair), min, limits)?;
        self.within(field, self.place(pair), max, limits)?;
        if min > max {
            return Err(KnowledgeFileError::Inconsistent {
                at: self.place(pair),
                problem: format!("{field}: the minimum {min} exceeds the maximum {max}"),
            });
        }
        Ok([min, max])
    }

    pub(super) fn angles(
        self,
        field: &'static str,
        pair: &Spanned<[f64; 2]>,
    ) -> Result<AngleRange, KnowledgeFileError> {
        let [min_rad, max_rad] = self.ascending(field, pair, ANGLE_RAD)?;
        Ok(AngleRange { min_rad, max_rad })
    }
}
