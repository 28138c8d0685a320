//! Colours by their names in queries.

use super::{ViewError, text_of};
use crate::ask::Term;
use wisch::source_location::UnknownName;

/// Names of colours in queries.
const NAMED: [(&str, [u8; 3]); 14] = [
    ("red", [213, 52, 43]),
    ("orange", [230, 126, 34]),
    ("yellow", [241, 196, 15]),
    ("green", [47, 158, 68]),
    ("cyan", [23, 162, 184]),
    ("blue", [43, 108, 213]),
    ("purple", [116, 64, 184]),
    ("violet", [116, 64, 184]),
    ("magenta", [200, 50, 150]),
    ("pink", [232, 121, 172]),
    ("brown", [139, 90, 43]),
    ("black", [20, 24, 29]),
    ("gray", [128, 136, 144]),
    ("white", [250, 250, 250]),
];

/// A colour: red, green and blue from 0 to 255.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(pub [u8; 3]);

impl Colour {
    /// Parses a name, `'#rrggbb'`, or `[R, G, B]` with parts from 0 to 1, also as `color: …`.
    ///
    /// # Errors
    /// If the term is not a colour.
    pub fn from_term(term: &Term) -> Result<Self, ViewError> {
        match term {
            Term::Compound(name, parts) => match (name.as_str(), parts.as_slice()) {
                ("color" | "colour", [colour]) => Self::from_term(colour),
                (":" | "=", [key, colour]) if matches!(key.as_atom(), Some("color" | "colour")) => {
                    Self::from_term(colour)
                }
                _ => Err(Self::none(term, "")),
            },
            Term::List(items) => match items.as_slice() {
                [one] => Self::from_term(one),
                [red, green, blue] => Self::from_shares(term, [red, green, blue]),
                _ => Err(Self::none(term, "")),
            },
            _ => Self::named(term),
        }
    }

    fn from_shares(term: &Term, parts: [&Term; 3]) -> Result<Self, ViewError> {
        let mut mixed = [0; 3];
        for (mixed, part) in mixed.iter_mut().zip(parts) {
            let share = part.as_number().filter(|share| (0.0..=1.0).contains(share));
            let share = share.ok_or_else(|| Self::none(term, "; its parts go from 0 to 1"))?;
            *mixed = (share * 255.0).round() as u8;
        }
        Ok(Self(mixed))
    }

    fn named(term: &Term) -> Result<Self, ViewError> {
        let name = text_of(term).to_lowercase().replace("grey", "gray");
        if let Some((_, colour)) = NAMED.iter().find(|(known, _)| *known == name) {
            return Ok(Self(*colour));
        }
        let digits = name.strip_prefix('#').filter(|digits| digits.len() == 6);
        let number = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        if let Some(number) = number {
            let [_, red, green, blue] = number.to_be_bytes();
            return Ok(Self([red, green, blue]));
        }
        let nearest = UnknownName::new("color", &name, NAMED.iter().map(|(known, _)| *known));
        let hint = match nearest.nearest() {
            Some(nearest) => format!("; did you mean {nearest}?"),
            None => "; expected a name such as red, or a code such as '#ff0000'".to_owned(),
        };
        Err(Self::none(term, &hint))
    }

    fn none(term: &Term, hint: &str) -> ViewError {
        ViewError::Colour {
            found: term.to_string(),
            hint: hint.to_owned(),
        }
    }
}
