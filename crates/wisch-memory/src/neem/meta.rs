//! Metadata of a NEEM.

use crate::id::in_utc;
use bson::oid::ObjectId;
use serde_json::json;

/// Version of the triples' data model.
const MODEL_VERSION: &str = "0.1";

/// The metadata of a NEEM: its title, author and contents.
#[derive(Debug, Clone, PartialEq)]
pub struct NeemMeta {
    /// Title.
    pub name: String,
    /// Description of its contents.
    pub description: String,
    /// Name of its author.
    pub created_by: String,
    /// Time of its creation [s since 1970].
    pub created_at: f64,
    /// Keywords.
    pub keywords: Vec<String>,
    /// Address at which it is published; empty before publication.
    pub url: String,
    /// Description of the activity, and the IRI of its class.
    pub activity: [String; 2],
    /// Environment of the activity.
    pub environment: String,
    /// Agent of the activity.
    pub agent: String,
    /// Address of a picture; may be empty.
    pub image: String,
}

impl NeemMeta {
    /// Returns the text of the file, in JSON.
    pub(super) fn json(&self, id: ObjectId) -> String {
        let [name, url] = &self.activity;
        let document = json!({
            "_id": {"$oid": id.to_hex()},
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

/// Formats a time [s since 1970] as `2026-01-31T12:00:00+00:00`, cut to whole seconds.
///
/// ```
/// use wisch_memory::neem::utc;
///
/// assert_eq!(utc(951_782_400.5), "2000-02-29T00:00:00+00:00");
/// ```
pub fn utc(time: f64) -> String {
    in_utc(time, "%Y-%m-%dT%H:%M:%S+00:00")
}

#[cfg(test)]
mod tests {
    use super::utc;

    #[test]
    fn times_are_those_of_the_calendar() {
        // Expected values from GNU `date -u -d @…`.
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
