//! The views that are shipped: SQL in a file, with what each means before it.

const TEXT: &str = include_str!("../views.sql");

/// A view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SqlView {
    /// Its name.
    pub name: &'static str,
    /// What it means, line by line.
    pub about: &'static str,
    /// What makes it.
    pub statement: &'static str,
}

/// All of them, in their order: later ones may build on earlier ones.
pub fn all() -> impl Iterator<Item = SqlView> {
    TEXT.split_inclusive(";\n").filter_map(|part| {
        let begin = part.find("CREATE VIEW ")?;
        let statement = part[begin..].trim_end().trim_end_matches(';');
        let name = statement.split_whitespace().nth(2)?;
        let about = part[..begin].trim();
        Some(SqlView {
            name,
            // What stands before an empty line is about the file.
            about: about.rsplit("\n\n").next().unwrap_or(about),
            statement,
        })
    })
}

impl SqlView {
    /// What it means, as one text.
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
