//! Names of columns, and the units in them.

/// Kind of a column's unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitKind {
    Time,
    Length,
    Force,
    Angle,
    /// Dimensionless, as the numbers of a quaternion.
    None,
}

/// A unit, as a name states it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Unit {
    pub text: String,
    /// Whether brackets or a slash separate it from the name; the last word of a name may also not be a unit.
    pub is_apart: bool,
}

/// Units of time [s], length [m], force [N] and angle [rad] in names and lines of units.
const TIME_UNITS: [(&str, f64); 13] = [
    ("s", 1.0),
    ("sec", 1.0),
    ("seconds", 1.0),
    ("ms", 1e-3),
    ("msec", 1e-3),
    ("milliseconds", 1e-3),
    ("us", 1e-6),
    ("µs", 1e-6),
    ("usec", 1e-6),
    ("ns", 1e-9),
    ("nsec", 1e-9),
    ("min", 60.0),
    ("h", 3600.0),
];
const LENGTH_UNITS: [(&str, f64); 20] = [
    ("m", 1.0),
    ("metre", 1.0),
    ("metres", 1.0),
    ("meter", 1.0),
    ("meters", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("millimetre", 1e-3),
    ("millimetres", 1e-3),
    ("millimeter", 1e-3),
    ("millimeters", 1e-3),
    ("um", 1e-6),
    ("µm", 1e-6),
    ("in", INCH),
    ("inch", INCH),
    ("inches", INCH),
    ("ft", 12.0 * INCH),
    ("foot", 12.0 * INCH),
    ("feet", 12.0 * INCH),
    ("yd", 36.0 * INCH),
];
const INCH: f64 = 0.0254;
/// A mass as a unit of force is its weight, as scales and load cells state it.
const FORCE_UNITS: [(&str, f64); 17] = [
    ("N", 1.0),
    ("newton", 1.0),
    ("newtons", 1.0),
    ("kN", 1e3),
    ("daN", 10.0),
    ("cN", 1e-2),
    ("mN", 1e-3),
    ("kp", GRAVITY),
    ("kgf", GRAVITY),
    ("kg", GRAVITY),
    ("gf", 1e-3 * GRAVITY),
    ("g", 1e-3 * GRAVITY),
    ("lbf", POUND),
    ("lb", POUND),
    ("lbs", POUND),
    ("pounds", POUND),
    ("ozf", POUND / 16.0),
];
/// Standard gravity [m/s²], and a pound-force [N].
const GRAVITY: f64 = 9.80665;
const POUND: f64 = 4.448_221_615_260_5;
const ANGLE_UNITS: [(&str, f64); 5] = [
    ("rad", 1.0),
    ("deg", DEGREE),
    ("degree", DEGREE),
    ("degrees", DEGREE),
    ("°", DEGREE),
];
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Units that may end a name after an underscore; shorter or rarer words there are ambiguous.
const SUFFIXES: [&str; 14] = [
    "s", "sec", "ms", "us", "ns", "m", "cm", "mm", "um", "n", "kn", "mn", "rad", "deg",
];

impl UnitKind {
    /// Returns the size of a unit of this kind in SI units, if it is known.
    pub fn size_of(self, text: &str) -> Option<f64> {
        let known: &[(&str, f64)] = match self {
            Self::Time => &TIME_UNITS,
            Self::Length => &LENGTH_UNITS,
            Self::Force => &FORCE_UNITS,
            Self::Angle => &ANGLE_UNITS,
            Self::None => &[],
        };
        // Unicode has two micro signs.
        let text = text.replace('μ', "µ");
        let exact = known.iter().find(|(name, _)| *name == text);
        let found = exact.or_else(|| {
            known
                .iter()
                .find(|(name, _)| name.eq_ignore_ascii_case(&text))
        });
        found.map(|(_, size)| *size)
    }
}

/// A name of a column in a form for comparison: lower case, words joined by single underscores.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Name {
    /// The whole name.
    pub whole: String,
    /// The name without a final unit, and the unit.
    pub without_unit: Option<(String, Unit)>,
}

impl Name {
    /// Parses a name: `x [mm]`, `fx (N)`, `x / mm` and `tcp_x_mm` end with units, `O_T_EE[12]` with an index.
    pub fn parse(text: &str) -> Self {
        let text = text.trim().trim_start_matches('%');
        let (head, bracketed) = split_unit(text);
        if let Some(unit) = bracketed {
            return Self {
                whole: words(text),
                without_unit: Some((
                    words(head),
                    Unit {
                        text: unit.to_owned(),
                        is_apart: true,
                    },
                )),
            };
        }
        let whole = words(text);
        let suffixed = whole.rsplit_once('_');
        let without_unit =
            suffixed
                .filter(|(_, last)| SUFFIXES.contains(last))
                .map(|(head, last)| {
                    (
                        head.to_owned(),
                        Unit {
                            text: last.to_owned(),
                            is_apart: false,
                        },
                    )
                });
        Self {
            whole,
            without_unit,
        }
    }

    /// Returns the unit, if the name without it is `base`.
    pub fn is(&self, base: &str) -> Option<Option<&Unit>> {
        if self.whole == base {
            return Some(None);
        }
        let (without, unit) = self.without_unit.as_ref()?;
        (without == base).then_some(Some(unit))
    }

    /// The name, and the name without its unit.
    pub fn bases(&self) -> impl Iterator<Item = &str> {
        let without = self.without_unit.as_ref().map(|(name, _)| name.as_str());
        std::iter::once(self.whole.as_str()).chain(without)
    }
}

/// Splits off a final unit in brackets or after a slash; an index in brackets is not a unit.
fn split_unit(text: &str) -> (&str, Option<&str>) {
    for [open, close] in [['[', ']'], ['(', ')']] {
        if let Some((head, unit)) =
            (text.strip_suffix(close)).and_then(|rest| rest.rsplit_once(open))
        {
            let unit = unit.trim();
            let is_unit = !unit.is_empty() && unit.parse::<usize>().is_err();
            return if is_unit && !head.trim().is_empty() {
                (head, Some(unit))
            } else {
                (text, None)
            };
        }
    }
    let Some((head, unit)) = text.rsplit_once('/') else {
        return (text, None);
    };
    let kinds = [
        UnitKind::Time,
        UnitKind::Length,
        UnitKind::Force,
        UnitKind::Angle,
    ];
    let is_unit = kinds.iter().any(|kind| kind.size_of(unit.trim()).is_some());
    // A path such as /tool/pose/position/x has more slashes.
    if is_unit && !head.trim().is_empty() && !head.contains('/') {
        (head, Some(unit.trim()))
    } else {
        (text, None)
    }
}

/// Returns the words of a name in lower case, joined by underscores.
fn words(text: &str) -> String {
    let lower = text.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric());
    words
        .filter(|word| !word.is_empty())
        .collect::<Vec<_>>()
        .join("_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_and_indices_end_names() {
        let cases = [
            ("x [mm]", "x", Some("mm")),
            ("fx (N)", "fx", Some("N")),
            ("x/mm", "x", Some("mm")),
            ("x / µm", "x", Some("µm")),
            ("TCP_x_mm", "tcp_x", Some("mm")),
            ("Time [s]", "time", Some("s")),
            ("timestamp_ns", "timestamp", Some("ns")),
            ("O_T_EE[12]", "o_t_ee_12", None),
            ("/tool/pose/position/x", "tool_pose_position_x", None),
            ("%time", "time", None),
            ("field.header.stamp", "field_header_stamp", None),
        ];
        for (text, base, unit) in cases {
            let name = Name::parse(text);
            let stated = name
                .is(base)
                .map(|unit| unit.map(|unit| unit.text.as_str()));
            assert_eq!(stated, Some(unit), "{text}: {name:?}");
        }
        assert_eq!(UnitKind::Force.size_of("kN"), Some(1e3));
        assert_eq!(UnitKind::Force.size_of("n"), Some(1.0));
        assert_eq!(UnitKind::Force.size_of("gf"), Some(0.00980665));
        assert_eq!(
            UnitKind::Force.size_of("lb"),
            UnitKind::Force.size_of("lbf")
        );
        assert_eq!(UnitKind::Force.size_of("Newton"), Some(1.0));
        assert_eq!(UnitKind::Length.size_of("meters"), Some(1.0));
        assert_eq!(UnitKind::Length.size_of("μm"), Some(1e-6));
        assert!((UnitKind::Length.size_of("ft").unwrap() - 0.3048).abs() < 1e-12);
        assert!((UnitKind::Length.size_of("yd").unwrap() - 0.9144).abs() < 1e-12);
        assert_eq!(UnitKind::Length.size_of("s"), None);
    }
}
