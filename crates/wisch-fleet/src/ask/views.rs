//! Built-in views: SQL in a file, with the meaning of each view before it.

const TEXT: &str = include_str!("../views.sql");

/// A view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SqlView {
    /// Its name.
    pub name: &'static str,
    /// Its meaning, line by line.
    pub about: &'static str,
    /// Its SQL statement.
    pub statement: &'static str,
}

/// All views, in order: later views may use earlier ones.
pub fn all() -> impl Iterator<Item = SqlView> {
    TEXT.split_inclusive(";\n").filter_map(|part| {
        let begin = part.find("CREATE VIEW ")?;
        let statement = part[begin..].trim_end().trim_end_matches(';');
        let name = statement.split_whitespace().nth(2)?;
        let about = part[..begin].trim();
        Some(SqlView {
            name,
            // Text before an empty line is about the whole file.
            about: about.rsplit("\n\n").next().unwrap_or(about),
            statement,
        })
    })
}

impl SqlView {
    /// Its meaning, as one text.
    pub fn meaning(&self) -> String {
        let lines = self.about.lines();
        let lines = lines.map(|line| line.trim_start_matches("--").trim());
        lines.collect::<Vec<_>>().join(" ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_view_says_what_it_means() {
        let views: Vec<SqlView> = all().collect();
        assert_eq!(views.len(), TEXT.matches("CREATE VIEW ").count());
        for view in views {
            assert!(!view.meaning().is_empty(), "{}", view.name);
            assert!(
                view.about.lines().all(|line| line.starts_with("--")),
                "{}",
                view.name
            );
        }
    }
}
