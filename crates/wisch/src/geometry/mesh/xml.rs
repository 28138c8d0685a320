//! A small XML scanner, enough for COLLADA: elements, attributes and text, in one pass without
//! recursion. Entities are left as written; a document type is skipped, its subset refused.

use super::MeshError;
use std::borrow::Cow;

/// Most elements in one document; bounds the memory that a small file can ask for.
const MAX_ELEMENTS: usize = 1_000_000;

/// One element; children are indices into the document.
pub(super) struct Element<'a> {
    /// Name without its namespace prefix.
    pub name: &'a str,
    /// The text directly inside.
    pub text: Cow<'a, str>,
    pub children: Vec<usize>,
    pub line: usize,
    attributes: Vec<(&'a str, &'a str)>,
}

impl<'a> Element<'a> {
    pub fn attribute(&self, name: &str) -> Option<&'a str> {
        self.attributes
            .iter()
            .find(|(key, _)| *key == name)
            .map(|&(_, value)| value)
    }

    /// An error at this element.
    pub fn fault(&self, reason: impl std::fmt::Display) -> MeshError {
        let reason = format!("<{}>: {reason}", self.name);
        MeshError::SyntaxAt {
            line: self.line,
            reason,
        }
    }
}

/// The elements in document order; the first is the root.
pub(super) struct Document<'a> {
    elements: Vec<Element<'a>>,
}

impl<'a> Document<'a> {
    pub fn root(&self) -> &Element<'a> {
        &self.elements[0]
    }

    /// All elements of a name, in document order.
    pub fn named(&self, name: &str) -> impl Iterator<Item = &Element<'a>> {
        self.elements.iter().filter(move |e| e.name == name)
    }

    pub fn children<'s>(
        &'s self,
        parent: &'s Element<'a>,
    ) -> impl Iterator<Item = &'s Element<'a>> {
        parent.children.iter().map(|&i| &self.elements[i])
    }

    pub fn child<'s>(&'s self, parent: &'s Element<'a>, name: &str) -> Option<&'s Element<'a>> {
        self.children(parent).find(|e| e.name == name)
    }

    /// Scans a document.
    pub fn scan(text: &'a str) -> Result<Self, MeshError> {
        let mut elements: Vec<Element<'a>> = Vec::new();
        let mut open: Vec<usize> = Vec::new();
        let mut line = 1;
        let mut rest = text;
        while let Some(start) = rest.find('<') {
            let (before, markup) = rest.split_at(start);
            line += before.matches('\n').count();
            let here = line;
            let fault = |reason: &str| MeshError::SyntaxAt {
                line: here,
                reason: reason.to_owned(),
            };
            if let Some(&i) = open.last() {
                add_text(&mut elements[i].text, before);
            }
            let length =
                markup_length(markup).ok_or_else(|| fault("a tag or comment is never closed"))?;
            let (tag, after) = markup.split_at(length);
            if let Some(data) = tag.strip_prefix("<![CDATA[") {
                if let Some(&i) = open.last() {
                    add_text(&mut elements[i].text, data.trim_end_matches("]]>"));
                }
            } else if let Some(name) = tag.strip_prefix("</") {
                let name = local(name.trim_end_matches('>').trim());
                match open.pop() {
                    Some(i) if elements[i].name == name => {}
                    _ => return Err(fault(&format!("</{name}> closes no open element"))),
                }
            } else if tag.starts_with("<!DOCTYPE") && tag.contains('[') {
                return Err(fault("a document type with declarations is not read"));
            } else if !tag.starts_with("<!") && !tag.starts_with("<?") {
                let index = elements.len();
                if index == MAX_ELEMENTS {
                    let (what, count, limit) = ("XML elements", index + 1, MAX_ELEMENTS);
                    return Err(MeshError::TooManyParts { what, count, limit });
                }
                match open.last() {
                    Some(&i) => elements[i].children.push(index),
                    None if index > 0 => return Err(fault("there is a second root element")),
                    None => {}
                }
                let inner = &tag[1..tag.len() - 1];
                let (inner, closed) = inner
                    .strip_suffix('/')
                    .map_or((inner, false), |s| (s, true));
                elements.push(
                    element(inner, line)
                        .ok_or_else(|| fault("an attribute is not name=\"value\""))?,
                );
                if !closed {
                    open.push(index);
                }
            }
            line += tag.matches('\n').count();
            rest = after;
        }
        match open.last() {
            Some(&i) => Err(elements[i].fault("it is never closed")),
            None if elements.is_empty() => Err(MeshError::SyntaxAt {
                line,
                reason: "there is no XML element".to_owned(),
            }),
            None => Ok(Self { elements }),
        }
    }
}

/// Length of the markup at the start of the text, which begins with '<'.
fn markup_length(text: &str) -> Option<usize> {
    for (opening, closing) in [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")] {
        if let Some(inner) = text.strip_prefix(opening) {
            return Some(opening.len() + inner.find(closing)? + closing.len());
        }
    }
    let mut quote = None;
    for (i, byte) in text.bytes().enumerate() {
        match (quote, byte) {
            (None, b'"' | b'\'') => quote = Some(byte),
            (Some(q), _) if q == byte => quote = None,
            (None, b'>') => return Some(i + 1),
            _ => {}
        }
    }
    None
}

/// The element of a start tag without its brackets; `None` if its attributes are malformed.
fn element(tag: &str, line: usize) -> Option<Element<'_>> {
    let (name, mut rest) = tag
        .split_once(|c: char| c.is_ascii_whitespace())
        .unwrap_or((tag, ""));
    let mut attributes = Vec::new();
    while !rest.trim_ascii_start().is_empty() {
        let (key, quoted) = rest.split_once('=')?;
        let quoted = quoted.trim_ascii_start();
        let quote = quoted.chars().next().filter(|c| matches!(c, '"' | '\''))?;
        let (value, after) = quoted[1..].split_once(quote)?;
        attributes.push((local(key.trim()), value));
        rest = after;
    }
    let (text, children) = (Cow::Borrowed(""), Vec::new());
    Some(Element {
        name: local(name),
        text,
        children,
        line,
        attributes,
    })
}

fn local(name: &str) -> &str {
    name.rsplit_once(':').map_or(name, |(_, local)| local)
}

fn add_text<'a>(text: &mut Cow<'a, str>, more: &'a str) {
    if text.trim_ascii().is_empty() {
        *text = Cow::Borrowed(more);
    } else if !more.trim_ascii().is_empty() {
        text.to_mut().push_str(more);
    }
}
