//! The page that shows wiping, as text: a script and a style that need nothing but themselves.
//!
//! The same bundle is a report in one file, with a recording in it ([`report_page`]), and the page of `wisch studio`
//! ([`studio_page`]), which asks its server for recordings.
//!
//! ```
//! let page = wisch_web::report_page("Chopping board", "{\"piece\":\"head\"}\n");
//! assert!(page.starts_with("<!DOCTYPE html>"));
//! ```

/// The bundle, built by `npm run build` in `web/` and committed beside its source.
const SCRIPT: &str = include_str!("../web/dist/wisch.js");
/// Its style.
const STYLE: &str = include_str!("../web/dist/wisch.css");

/// A page that needs nothing but itself, with one recording: JSON lines as `web/src/recording.ts` has them.
#[must_use]
pub fn report_page(title: &str, recording: &str) -> String {
    // A "<" occurs only within texts, where "</script>" must not end the element.
    let recording = recording.replace('<', "\\u003c");
    page(
        title,
        "report",
        &format!("<script type=\"application/x-ndjson\" id=\"recording\">{recording}</script>"),
    )
}

/// The page of the studio.
#[must_use]
pub fn studio_page() -> String {
    page("wisch studio", "studio", "")
}

fn page(title: &str, kind: &str, data: &str) -> String {
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\" data-page=\"{kind}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<noscript><p>This page draws by script; the figures and tables \
         beside it show the same.</p></noscript>\n<main id=\"app\"></main>\n{data}\n<script>{SCRIPT}</script>\n\
         </body>\n</html>\n"
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_recording_ends_its_element() {
        let page = report_page(
            "a < b",
            "{\"title\":\"</script><script>alert(1)</script>\"}",
        );
        assert!(page.contains("<title>a &lt; b</title>"));
        assert!(!page.contains("</script><script>alert(1)"));
    }

    #[test]
    fn the_bundle_ends_no_element_and_asks_for_nothing() {
        assert!(!SCRIPT.contains("</script"));
        assert!(!STYLE.contains("</style"));
        for page in [report_page("t", ""), studio_page()] {
            assert!(!page.contains("src=\"http") && !page.contains("href=\"http"));
        }
    }
}
