//! The page that shows wiping, as a self-contained HTML text with its script and style.
//!
//! One bundle serves three pages: a report in one file with an embedded recording ([`report_page`]), the answers of a
//! query in one file with the recordings that they show ([`answers_page`]), and the page of `wisch studio`
//! ([`studio_page`]), which fetches recordings from its server.
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

/// Returns a self-contained page with the answers of a query.
///
/// # Parameters
/// - `query`: the query.
/// - `answers`: its answers as JSON, in the format of `Answers` in `web/src/studio/server.ts`.
/// - `recordings`: name and recording of each shown episode; the recordings are compressed by gzip.
#[must_use]
pub fn answers_page(query: &str, answers: &str, recordings: &[(String, Vec<u8>)]) -> String {
    // A "<" occurs only within texts, where "</script>" must not end the element.
    let answers = answers.replace('<', "\\u003c");
    let mut data = format!(
        "<pre id=\"query\" hidden>{}</pre>\n<script type=\"application/json\" id=\"answers\">{answers}</script>",
        escape(query)
    );
    for (episode, packed) in recordings {
        data.push_str("\n<script type=\"application/gzip\" data-episode=\"");
        data.push_str(&escape(episode));
        data.push_str("\">");
        data.push_str(&base64(packed));
        data.push_str("</script>");
    }
    page("Answers of the memory", "answers", &data)
}

/// Encodes bytes as text (RFC 4648, section 4).
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let three = [0, 1, 2].map(|k| u32::from(chunk.get(k).copied().unwrap_or(0)));
        let bits = three[0] << 16 | three[1] << 8 | three[2];
        for k in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * k) & 63) as usize];
            text.push(if k <= chunk.len() {
                char::from(letter)
            } else {
                '='
            });
        }
    }
    text
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
    fn nothing_in_answers_ends_its_element() {
        let recordings = [("\"><script>".to_owned(), b"foobar".to_vec())];
        let page = answers_page("</pre><script>", "[\"</script><script>\"]", &recordings);
        assert!(page.contains("<pre id=\"query\" hidden>&lt;/pre&gt;&lt;script&gt;</pre>"));
        assert!(page.contains("[\"\\u003c/script>\\u003cscript>\"]"));
        assert!(page.contains(" data-episode=\"&quot;&gt;&lt;script&gt;\">Zm9vYmFy</script>"));
    }

    #[test]
    fn base64_is_that_of_rfc_4648() {
        let vectors = ["", "f", "fo", "foo", "foob", "fooba", "foobar"];
        let texts = vectors.map(|text| base64(text.as_bytes()));
        let expected = [
            "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy",
        ];
        assert_eq!(texts, expected);
        assert_eq!(base64(&[0xfb, 0xff]), "+/8=");
    }

    #[test]
    fn the_bundle_ends_no_element_and_asks_for_nothing() {
        assert!(!SCRIPT.contains("</script"));
        assert!(!STYLE.contains("</style"));
        let answers = answers_page("true", "{}", &[]);
        for page in [report_page("t", ""), studio_page(), answers] {
            assert!(!page.contains("src=\"http") && !page.contains("href=\"http"));
        }
    }
}
