//! Guess of the unit of a length that is probably not in metres.

/// A unit of length in which a number was probably meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LikelyUnit {
    /// Name in the plural, such as "millimetres".
    pub name: &'static str,
    /// Metres per unit.
    pub metres: f64,
}

/// Units of drawings, the most common first; the last two result from a file that is scaled to metres once too often.
const UNITS: [(&str, f64); 6] = [
    ("millimetres", 1e-3),
    ("centimetres", 1e-2),
    ("micrometres", 1e-6),
    ("inches", 0.0254),
    ("kilometres, or millimetres that were scaled twice", 1e3),
    ("micrometres that were scaled twice", 1e6),
];

impl LikelyUnit {
    /// Returns the most common unit in which `number` is a length between `least` and `most` \[m\]; `None` if it is one
    /// in metres, or in no known unit.
    ///
    /// ```
    /// use wisch_robot::geometry::LikelyUnit;
    /// let sponge = LikelyUnit::guess(110.0, 0.01, 2.0).unwrap();
    /// assert_eq!((sponge.name, sponge.metres), ("millimetres", 0.001));
    /// assert_eq!(LikelyUnit::guess(0.11, 0.01, 2.0), None);
    /// ```
    pub fn guess(number: f64, least: f64, most: f64) -> Option<Self> {
        let is_usual = |length: f64| (least..=most).contains(&length);
        if is_usual(number) {
            return None;
        }
        let (name, metres) = UNITS
            .into_iter()
            .find(|(_, metres)| is_usual(number * metres))?;
        Some(Self { name, metres })
    }
}

impl std::fmt::Display for LikelyUnit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { name, metres } = self;
        write!(f, "it is probably in {name}: multiply by {metres}")
    }
}
