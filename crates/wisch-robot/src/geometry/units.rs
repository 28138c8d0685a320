//! Guess of the units of a length that is probably not in metres.

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
struct LikelyUnit {
    /// Name in the plural, such as "millimetres".
    name: &'static str,
    /// Metres per unit.
    metres: f64,
}

/// The units in which a number was probably meant, the most common first; at least one.
#[derive(Debug, Clone, PartialEq)]
pub struct LikelyUnits(Vec<LikelyUnit>);

/// Units of drawings, the most common first.
const DRAWN: [(&str, f64); 3] = [
    ("millimetres", 1e-3),
    ("centimetres", 1e-2),
    ("inches", 0.0254),
];

/// Other units; the last two result from a file that is scaled to metres once too often.
const OTHERS: [(&str, f64); 3] = [
    ("micrometres", 1e-6),
    ("kilometres, or millimetres that were scaled twice", 1e3),
    ("micrometres that were scaled twice", 1e6),
];

impl LikelyUnits {
    /// Returns the units of drawings in which `number` is a length within `usual` \[m\]. If it is in none of them, returns
    /// the most common unit in which it is within `possible` \[m\]. `None` if it is a possible length in metres, or one in
    /// no known unit.
    ///
    /// ```
    /// use wisch_robot::geometry::LikelyUnits;
    /// let guess = |number| LikelyUnits::guess(number, [0.03, 0.6], [0.01, 2.0]);
    /// let sponge = guess(110.0).unwrap();
    /// assert_eq!(sponge.to_string(), "it is probably in millimetres: multiply by 0.001");
    /// let pad = guess(4.3).unwrap();
    /// assert_eq!(pad.to_string(), "it is probably in centimetres or inches: multiply by 0.01 or 0.0254");
    /// assert_eq!(guess(0.11), None);
    /// ```
    pub fn guess(number: f64, usual: [f64; 2], possible: [f64; 2]) -> Option<Self> {
        let is_within =
            |[least, most]: [f64; 2], metres: f64| (least..=most).contains(&(number * metres));
        if is_within(possible, 1.0) {
            return None;
        }
        let unit = |(name, metres)| LikelyUnit { name, metres };
        let drawn = DRAWN.into_iter().map(unit);
        let likely: Vec<LikelyUnit> = drawn
            .clone()
            .filter(|unit| is_within(usual, unit.metres))
            .collect();
        if !likely.is_empty() {
            return Some(Self(likely));
        }
        let mut all = drawn.chain(OTHERS.into_iter().map(unit));
        let first = all.find(|unit| is_within(possible, unit.metres))?;
        Some(Self(vec![first]))
    }

    /// Returns the names of the units, such as "centimetres or inches".
    pub fn names(&self) -> String {
        let names: Vec<&str> = self.0.iter().map(|unit| unit.name).collect();
        names.join(" or ")
    }

    /// Returns the factors to metres, each as `text` writes it, joined by "or".
    pub fn factors(&self, text: impl Fn(f64) -> String) -> String {
        let factors: Vec<String> = self.0.iter().map(|unit| text(unit.metres)).collect();
        factors.join(" or ")
    }
}

impl std::fmt::Display for LikelyUnits {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let factors = self.factors(|metres| metres.to_string());
        write!(
            f,
            "it is probably in {}: multiply by {factors}",
            self.names()
        )
    }
}
