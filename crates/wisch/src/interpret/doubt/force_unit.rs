//! Units in which a force may be logged, by the factor between the measured and the declared press force.

/// Factors by which a force must be multiplied to be in newtons, and the log that needs them.
const UNITS: [(f64, &str); 10] = [
    (1000.0, "a log in kN"),
    (10.0, "a log in daN"),
    (9.80665, "a log in kgf"),
    (4.44822, "a log in lbf"),
    (0.224809, "a log converted from lbf twice"),
    (0.101972, "a log multiplied by 9.81 once too often"),
    (0.1, "a log in dN"),
    (0.01, "a log in cN"),
    (0.00980665, "a log in gf"),
    (0.001, "a log in mN"),
];
/// Largest ratio of the declared force to the force in another unit that still fits it [1]; controllers press with 10 % more or
/// less.
const FITS: f64 = 1.12;

/// Returns the units in which the measured force would be the declared one, with their factors, the nearest first; `None` if
/// no unit fits.
pub(super) fn describe_units(measured: f64, declared: f64) -> Option<String> {
    let off = |factor: f64| libm::log(factor * measured / declared).abs();
    let mut fitting: Vec<(f64, &str)> = (UNITS.into_iter())
        .filter(|(factor, _)| off(*factor) <= libm::log(FITS))
        .collect();
    fitting.sort_by(|a, b| off(a.0).total_cmp(&off(b.0)));
    let units: Vec<String> = (fitting.iter())
        .map(|(factor, log)| format!("{log} needs a factor of {factor}"))
        .collect();
    (!units.is_empty()).then(|| format!("{} (--force-unit-n, --force-scale)", units.join(", ")))
}

/// Whether the measured force would be the declared one in another unit.
pub(in crate::interpret) fn fits_other_unit(measured: f64, declared: f64) -> bool {
    describe_units(measured, declared).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_names_the_units_that_explain_it() {
        for (measured, units) in [
            (
                1.02,
                "a log in kgf needs a factor of 9.80665, a log in daN needs a factor of 10",
            ),
            (
                98.0,
                "a log multiplied by 9.81 once too often needs a factor of 0.101972",
            ),
            (9_950.0, "a log in mN needs a factor of 0.001"),
            (2.25, "a log in lbf needs a factor of 4.44822"),
            (0.0098, "a log in kN needs a factor of 1000"),
        ] {
            let found = describe_units(measured, 10.0).unwrap();
            assert!(found.starts_with(units), "{measured}: {found}");
        }
        for measured in [0.0, 5.0, 9.0, 15.0, 20.0, 30.0] {
            assert_eq!(describe_units(measured, 10.0), None, "{measured}");
        }
    }
}
