//! Repairs of XML that is not well-formed, although other readers of URDF and SRDF accept it.
//! TinyXML, which urdfdom and MoveIt use, knows no namespaces, and skips comments without examining
//! them.

use super::diagnostics::{Diagnostics, Words, words};
use super::xml::{MAX_URDF_BYTES, parsing_options};
use crate::geometry::{MAX_ATTRIBUTES, most_attributes};
use crate::{Diagnostic, DiagnosticKind, Severity, Subject};
use roxmltree::Document;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;

/// End of the root element of a URDF or an SRDF.
const END_OF_ROOT: &str = "</robot>";
/// Largest number of prefixes that a text may leave undeclared.
const MAX_PREFIXES: usize = 20;
/// Longest prefix of a name that is replaced [bytes].
const MAX_PREFIX: usize = 100;

/// A text in which passages that are no XML are overwritten. It is as long as the original, so that
/// places stay the same.
pub(crate) struct Repaired<'a> {
    pub text: Cow<'a, str>,
    /// Start of each repair [byte], and what is said about it.
    repairs: Vec<(usize, Words)>,
}

impl<'a> Repaired<'a> {
    /// Returns the text unchanged if it is XML, if it exceeds a limit, or if repairs do not suffice.
    pub fn new(text: &'a str) -> Self {
        let unchanged = Self {
            text: Cow::Borrowed(text),
            repairs: Vec::new(),
        };
        let is_too_large = text.len() > MAX_URDF_BYTES || most_attributes(text) > MAX_ATTRIBUTES;
        if is_too_large || is_xml(text) {
            return unchanged;
        }
        let mut repair = Repair {
            bytes: text.as_bytes().to_vec(),
            repairs: Vec::new(),
        };
        repair.comments();
        repair.declaration();
        repair.end();
        repair.prefixes();
        match String::from_utf8(repair.bytes) {
            Ok(repaired) if is_xml(&repaired) => Self {
                text: Cow::Owned(repaired),
                repairs: repair.repairs,
            },
            _ => unchanged,
        }
    }

    /// Returns a warning for each repair.
    pub fn findings(self, file: &str) -> Vec<Diagnostic> {
        let mut report = Diagnostics {
            file,
            text: &self.text,
            diagnostics: Vec::new(),
        };
        for (at, words) in self.repairs {
            let (severity, kind) = (Severity::Warning, DiagnosticKind::Syntax);
            report.add(severity, kind, Subject::Robot, at, words);
        }
        report.diagnostics
    }
}

fn is_xml(text: &str) -> bool {
    Document::parse_with_options(text, parsing_options()).is_ok()
}

/// A text that is being repaired.
struct Repair {
    bytes: Vec<u8>,
    repairs: Vec<(usize, Words)>,
}

impl Repair {
    fn find(&self, what: &str, from: usize) -> Option<usize> {
        let rest = self.bytes.get(from..)?;
        let at = rest
            .windows(what.len())
            .position(|window| window == what.as_bytes())?;
        Some(from + at)
    }

    /// Overwrites bytes with spaces, except line breaks.
    fn blank(&mut self, range: Range<usize>) {
        for byte in &mut self.bytes[range] {
            if !matches!(byte, b'\n' | b'\r') {
                *byte = b' ';
            }
        }
    }

    /// Removes the text of comments that contain two hyphens.
    fn comments(&mut self) {
        let (mut from, mut first) = (0, None);
        while let Some(start) = self.find("<!--", from) {
            let inside = start + "<!--".len();
            let Some(end) = self.find("-->", inside) else {
                break;
            };
            let is_valid = self.find("--", inside) == Some(end);
            if !is_valid || self.bytes[inside..end].ends_with(b"-") {
                self.blank(inside..end);
                first.get_or_insert(start);
            }
            from = end;
        }
        if let Some(start) = first {
            let w = words(
                "a comment contains two hyphens",
                "a comment without \"--\"",
                "the comment is skipped; remove the hyphens",
            );
            self.repairs.push((start, w));
        }
    }

    /// Removes an XML declaration that follows spaces, line breaks or comments.
    fn declaration(&mut self) {
        let Some(start) = self.find("<?xml ", 0).filter(|start| *start > 0) else {
            return;
        };
        if let Some(end) = self.find("?>", start)
            && self.is_blank(0..start)
        {
            self.blank(start..end + "?>".len());
            let w = words(
                "the declaration <?xml …?> is not at the start of the file",
                "nothing before it",
                "it is skipped; remove what comes before it",
            );
            self.repairs.push((start, w));
        }
    }

    /// Removes what follows the root element.
    fn end(&mut self) {
        let last = self
            .bytes
            .windows(END_OF_ROOT.len())
            .rposition(|window| window == END_OF_ROOT.as_bytes());
        let Some(end) = last.map(|start| start + END_OF_ROOT.len()) else {
            return;
        };
        if !self.is_blank(end..self.bytes.len()) {
            self.blank(end..self.bytes.len());
            let w = words(
                "text follows the end of <robot>",
                "nothing after </robot>",
                "it is skipped; remove it",
            );
            self.repairs.push((end, w));
        }
    }

    /// Whether a range contains only white space and comments.
    fn is_blank(&self, range: Range<usize>) -> bool {
        let mut at = range.start;
        while at < range.end {
            if self.bytes[at..range.end].starts_with(b"<!--") {
                match self.find("-->", at) {
                    Some(end) => at = end + "-->".len(),
                    None => return false,
                }
            } else if self.bytes[at].is_ascii_whitespace() {
                at += 1;
            } else {
                return false;
            }
        }
        true
    }

    /// Replaces the colon of names whose prefix the text does not declare by an underscore.
    fn prefixes(&mut self) {
        let mut prefixes = Prefixes::new(self);
        let mut at = 0;
        while let Some(start) = self.find("<", at) {
            let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
            let skip = skipped
                .iter()
                .find(|(open, _)| self.bytes[start..].starts_with(open.as_bytes()));
            if let Some((open, close)) = skip {
                match self.find(close, start + open.len()) {
                    Some(end) => at = end,
                    None => return,
                }
                continue;
            }
            at = self.tag(start, &mut prefixes);
        }
    }

    /// Replaces colons in the tag that starts at a byte, and returns its end.
    fn tag(&mut self, start: usize, prefixes: &mut Prefixes) -> usize {
        let mut quote = None;
        let mut name = start + 1;
        let mut at = start + 1;
        while at < self.bytes.len() {
            let byte = self.bytes[at];
            match quote {
                Some(open) if byte == open => quote = None,
                Some(_) => {}
                None if matches!(byte, b'"' | b'\'') => quote = Some(byte),
                None if byte == b'>' => break,
                None if byte == b':'
                    && at - name <= MAX_PREFIX
                    && prefixes.undeclared.len() < MAX_PREFIXES =>
                {
                    let prefix = self.bytes[name..at].to_vec();
                    if !prefixes.declared.contains(&prefix) {
                        self.bytes[at] = b'_';
                        self.report(prefix, start, prefixes);
                    }
                }
                None if byte.is_ascii_whitespace() || matches!(byte, b'/' | b'=') => name = at + 1,
                None => {}
            }
            at += 1;
        }
        at
    }

    fn report(&mut self, prefix: Vec<u8>, at: usize, prefixes: &mut Prefixes) {
        let name = String::from_utf8_lossy(&prefix).into_owned();
        let w = words(
            format!("the prefix {name:?} of a name is not declared"),
            format!("xmlns:{name}=\"…\" in <robot>"),
            "names with it are read as if it were; declare it, or remove these elements",
        );
        if prefixes.undeclared.insert(prefix) {
            self.repairs.push((at, w));
        }
    }
}

/// Prefixes of the names in a text.
struct Prefixes {
    /// Those that the text declares, and those of XML.
    declared: BTreeSet<Vec<u8>>,
    /// Those with a warning.
    undeclared: BTreeSet<Vec<u8>>,
}

impl Prefixes {
    fn new(repair: &Repair) -> Self {
        let mut declared = BTreeSet::from([b"xml".to_vec(), b"xmlns".to_vec()]);
        let mut at = 0;
        while let Some(found) = repair.find("xmlns:", at) {
            at = found + "xmlns:".len();
            let name = repair.bytes[at..].iter().take(MAX_PREFIX + 1);
            let ends = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'=';
            if let Some(length) = name.clone().position(ends) {
                declared.insert(name.take(length).copied().collect());
            }
        }
        Self {
            declared,
            undeclared: BTreeSet::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The warnings about a text, and whether it is XML after its repair.
    fn repaired(text: &str) -> (Vec<String>, bool) {
        let repaired = Repaired::new(text);
        assert_eq!(repaired.text.len(), text.len());
        let is_valid = is_xml(&repaired.text);
        let findings = repaired.findings("r").into_iter();
        let shown =
            findings.map(|found| format!("{}:{}: {}", found.at.line, found.at.column, found.value));
        (shown.collect(), is_valid)
    }

    #[test]
    fn xml_stays_as_it_is() {
        for text in [
            "<?xml version=\"1.0\"?><robot xmlns:a=\"a\"><!-- a:b - c --><a:b a:c=\"d:e\"/></robot> <!-- end -->",
            "no <XML",
            "<robot><link></robot>",
        ] {
            assert_eq!(Repaired::new(text).text, text);
            assert_eq!(repaired(text).0, [""; 0]);
        }
    }

    #[test]
    fn what_other_readers_accept_is_repaired_in_place() {
        for (text, expected) in [
            (
                "\n<!-- a -->\n<?xml version=\"1.0\"?>\n<robot/>",
                "3:1: the declaration <?xml …?> is not at the start of the file",
            ),
            (
                "<robot>\n <!-- ä -- b --->\n</robot>",
                "2:2: a comment contains two hyphens",
            ),
            (
                "<robot></robot>\n\u{1}",
                "1:16: text follows the end of <robot>",
            ),
            (
                "<robot>\n<s:a t:b='x:y>' c='z'><s:d/></s:a></robot>",
                "2:1: the prefix \"s\" of a name is not declared",
            ),
        ] {
            let (findings, is_valid) = repaired(text);
            assert!(is_valid, "{text}");
            assert_eq!(findings[0], expected);
        }
        let kept = Repaired::new("<robot><s:a t:b='x:y>'/></robot>").text;
        assert_eq!(kept, "<robot><s_a t_b='x:y>'/></robot>");
    }
}
