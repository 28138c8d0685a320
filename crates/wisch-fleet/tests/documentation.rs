//! docs/fleet.md lists every column and view.

use wisch_fleet::ask::views;
use wisch_fleet::tables::all_tables;

#[test]
fn the_page_lists_every_column_and_view() {
    let page = include_str!("../../../docs/fleet.md");
    let (_, listed) = page.split_once("\n## Tables\n").unwrap();
    let mut expected = String::new();
    for table in all_tables() {
        let (name, about) = (table.name, table.about);
        expected += &format!(
            "\n### `{name}`: {about}\n\n| column | type | unit | what |\n|---|---|---|---|\n"
        );
        for column in table.columns {
            let kind = column.kind.name();
            expected += &format!(
                "| `{}` | {kind} | {} | {} |\n",
                column.name, column.unit, column.about
            );
        }
    }
    assert_eq!(listed, expected);
    for view in views::all() {
        let row = format!("| `{}` | {} |\n", view.name, view.meaning());
        assert!(page.contains(&row), "{row}");
    }
}
