//! The page that shows wiping, as a self-contained HTML text with its script and style.
//!
//! One bundle serves two pages: a report in one file with an embedded recording ([`report_page`]), and the page of
//! `wisch studio` ([`studio_page`]), which fetches recordings from its server.
//!
//! ```
//! let page = wisch_web::report_page("Chopping board", "{\"piece\":\"head\"}\n");
//! assert!(page.starts_with("<!DOCTYPE html>"));
//! ```

/// The bundle, built by `npm run build` in `web/` and committed beside its source.
const SCRIPT: &str = include_str!("../web/dist/wisch.js");
/// The style of the bundle.
const STYLE: &str = include_str!("../web/dist/wisch.css");

/// Returns a self-contained page with one recording. `recording`: JSON lines in the format of `web/src/recording.ts`.
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

/// Returns the page of the studio.
#[must_use]
pub fn studio_page() -> String {
    page("wisch studio", "studio", "")
}

fn page(title: &str, kind: &str, data: &str) -> String {
    let title = escape(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\" data-page=\"{kind}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<noscript><p>This page needs JavaScript. The figures and \
         tables beside it show the same results.</p></noscript>\n<main id=\"app\"></main>\n{data}\n<script>{SCRIPT}</script>\n\
         </body>\n</html>\n"
    )
}

fn escape(text: &str) -> String {
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
