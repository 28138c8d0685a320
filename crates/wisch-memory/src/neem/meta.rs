//! What a NEEM says of itself.

use serde_json::json;

/// Version of the form of the triples.
const MODEL_VERSION: &str = "0.1";

/// What a NEEM says of itself.
#[derive(Debug, Clone, PartialEq)]
pub struct NeemMeta {
    /// Its title.
    pub name: String,
    /// What it holds.
    pub description: String,
    /// Who made it.
    pub created_by: String,
    /// When it was made [s since 1970].
    pub created_at: f64,
    /// Words to find it by.
    pub keywords: Vec<String>,
    /// Where it can be found; empty if nowhere yet.
    pub url: String,
    /// What was done, in words, and the IRI of its class.
    pub activity: [String; 2],
    /// Where it was done.
    pub environment: String,
    /// Who did it.
    pub agent: String,
    /// Address of a picture; empty without.
    pub image: String,
}

impl NeemMeta {
    /// Its text, in JSON.
    pub(super) fn json(&self, id: [u8; 12]) -> String {
        let id: String = id.iter().map(|byte| format!("{byte:02x}")).collect();
        let [name, url] = &self.activity;
        let document = json!({
            "_id": {"$oid": id},
            "name": self.name,
            "description": self.description,
            "created_by": self.created_by,
            "created_at": utc(self.created_at),
            "url": self.url,
            "model_version": MODEL_VERSION,
            "keywords": self.keywords,
            "activity": {"name": name, "url": url},
            "environment": self.environment,
            "agent": self.agent,
            "image": self.image,
            "visibility": false,
        });
        format!("{document:#}\n")
    }
}

/// A time [s since 1970] as `2026-01-31T12:00:00+00:00`, cut to whole seconds.
///
/// ```
/// use wisch_memory::neem::utc;
///
/// assert_eq!(utc(951_782_400.5), "2000-02-29T00:00:00+00:00");
/// ```
pub fn utc(time: f64) -> String {
    let seconds = time.floor() as i64;
    let (days, of_day) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
    // Years that begin in March, in eras of 400 years (Howard Hinnant, "chrono-compatible low-level date
    // algorithms").
    let days = days + 719_468;
    let (era, of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year_of_era = (of_era - of_era / 1_460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = (month_from_march + 2) % 12 + 1;
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    let (hour, minute, second) = (of_day / 3_600, of_day / 60 % 60, of_day % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}+00:00")
}

#[cfg(test)]
mod tests {
    use super::utc;

    #[test]
    fn times_are_those_of_the_calendar() {
        // Of GNU date -u -d @….
        for (time, text) in [
            (0.0, "1970-01-01T00:00:00+00:00"),
            (-1.0, "1969-12-31T23:59:59+00:00"),
            (68_169_599.0, "1972-02-28T23:59:59+00:00"),
            (68_169_600.0, "1972-02-29T00:00:00+00:00"),
            (946_684_799.0, "1999-12-31T23:59:59+00:00"),
            (1_709_251_199.0, "2024-02-29T23:59:59+00:00"),
            (4_107_542_400.0, "2100-03-01T00:00:00+00:00"),
        ] {
            assert_eq!(utc(time), text);
        }
    }
}
