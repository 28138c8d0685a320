//! What the names in an episode mean: classes, properties and shared things of wiping, under SOMA and DUL.
//!
//! The ontology is `ontology/semco.owl`. `ontology/upper.owl` states those axioms of SOMA and DUL on which it
//! rests, so that closures can be computed without the ontologies themselves.

mod read;
#[cfg(test)]
mod tests;

pub use read::OntologyError;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use wisch::source_location::UnknownName;

/// Prefixes and the namespaces that they stand for. A bare name is looked for in this order.
const PREFIXES: [(&str, &str); 8] = [
    ("semco", "https://wisch-project.org/ont/semco.owl#"),
    ("soma", "http://www.ease-crc.org/ont/SOMA.owl#"),
    (
        "dul",
        "http://www.ontologydesignpatterns.org/ont/dul/DUL.owl#",
    ),
    ("justin", "https://wisch-project.org/ont/justin.owl#"),
    ("rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"),
    ("rdfs", "http://www.w3.org/2000/01/rdf-schema#"),
    ("owl", "http://www.w3.org/2002/07/owl#"),
    ("xsd", "http://www.w3.org/2001/XMLSchema#"),
];

/// The text of `ontology/semco.owl`, in RDF/XML.
pub const SEMCO_OWL: &str = include_str!("../../ontology/semco.owl");
const UPPER_OWL: &str = include_str!("../../ontology/upper.owl");

/// What a name stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TermKind {
    /// A class of things or events.
    Class,
    /// A relation to other things.
    ObjectProperty,
    /// A relation to numbers or texts.
    DataProperty,
    /// A thing that episodes share, such as `semco:sponge`.
    Individual,
}

impl TermKind {
    /// How messages call it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Class => "class",
            Self::ObjectProperty | Self::DataProperty => "property",
            Self::Individual => "individual",
        }
    }

    /// Whether it is a relation.
    pub fn is_property(self) -> bool {
        matches!(self, Self::ObjectProperty | Self::DataProperty)
    }
}

/// What the ontology says of one name.
#[derive(Debug, Clone, PartialEq)]
pub struct OntologyTerm {
    /// What it stands for.
    pub kind: TermKind,
    /// Directly above it: classes of a class or individual, properties of a property.
    pub parents: Vec<String>,
    /// Of which class the subjects of a property are.
    pub domain: Option<String>,
    /// Of which class or datatype the objects of a property are.
    pub range: Option<String>,
    /// The individual that it is another name of.
    pub same_as: Option<String>,
    /// Its name in words; empty for a term of SOMA or DUL.
    pub label: String,
    /// What it means, with unit if it has one; empty for a term of SOMA or DUL.
    pub comment: String,
}

/// Classes, properties and shared individuals by their names with prefix, such as `semco:Collision`.
///
/// ```
/// use wisch_memory::Ontology;
///
/// let ontology = Ontology::shipped();
/// assert!(ontology.superclasses("semco:HumanCollision")?.contains(&"dul:Process"));
/// assert_eq!(ontology.types_of("semco:sponge")?[..2], ["semco:Sponge", "semco:WipingTool"]);
/// assert_eq!(ontology.resolve("justin", "justin_robot1")?, "semco:humanoid");
/// assert_eq!(
///     ontology.resolve("semco", "Colision").unwrap_err().nearest(),
///     Some("semco:Collision")
/// );
/// # Ok::<(), wisch::source_location::UnknownName>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Ontology {
    terms: BTreeMap<String, OntologyTerm>,
    children: BTreeMap<String, Vec<String>>,
}

impl Ontology {
    /// The ontology that comes with this program.
    ///
    /// # Panics
    /// If the files that were compiled in are no ontology, which a test excludes.
    pub fn shipped() -> &'static Self {
        static SHIPPED: LazyLock<Ontology> = LazyLock::new(|| {
            Ontology::read(&[
                ("ontology/upper.owl", UPPER_OWL),
                ("ontology/semco.owl", SEMCO_OWL),
            ])
            .expect("the shipped ontology is whole")
        });
        &SHIPPED
    }

    /// Reads files in RDF/XML, given as name and text; parents may stand in any of them.
    ///
    /// # Errors
    /// [`OntologyError`], at the first fault.
    pub fn read(files: &[(&str, &str)]) -> Result<Self, OntologyError> {
        let mut terms = BTreeMap::new();
        for (file, text) in files {
            read::read_file(file, text, &mut terms)?;
        }
        let mut children = BTreeMap::<String, Vec<String>>::new();
        for (name, term) in &terms {
            for parent in &term.parents {
                children
                    .entry(parent.clone())
                    .or_default()
                    .push(name.clone());
            }
        }
        let ontology = Self { terms, children };
        ontology.check()?;
        Ok(ontology)
    }

    /// Parents are known and of the right kind, and nothing is above itself.
    fn check(&self) -> Result<(), OntologyError> {
        for (name, term) in &self.terms {
            let kind = match term.kind {
                TermKind::Individual => TermKind::Class,
                kind => kind,
            };
            for parent in &term.parents {
                if self.kind(parent) != Some(kind) {
                    return Err(OntologyError::Parent {
                        name: name.clone(),
                        parent: parent.clone(),
                        kind: kind.word(),
                    });
                }
                if term.kind != TermKind::Individual && self.above(parent).contains(&name.as_str())
                {
                    return Err(OntologyError::Circle { name: name.clone() });
                }
            }
        }
        Ok(())
    }

    /// The prefixes and the namespaces that they stand for; a bare name is looked for in this order.
    pub fn prefixes() -> &'static [(&'static str, &'static str)] {
        &PREFIXES
    }

    /// Everything it names, by alphabet, with prefix.
    pub fn terms(&self) -> impl Iterator<Item = (&str, &OntologyTerm)> {
        self.terms.iter().map(|(name, term)| (name.as_str(), term))
    }

    /// All classes, by alphabet, with prefix.
    pub fn classes(&self) -> impl Iterator<Item = &str> {
        self.of_kind(|kind| kind == TermKind::Class)
    }

    /// All properties, by alphabet, with prefix.
    pub fn properties(&self) -> impl Iterator<Item = &str> {
        self.of_kind(TermKind::is_property)
    }

    /// All shared individuals, by alphabet, with prefix.
    pub fn individuals(&self) -> impl Iterator<Item = &str> {
        self.of_kind(|kind| kind == TermKind::Individual)
    }

    fn of_kind(&self, wanted: impl Fn(TermKind) -> bool) -> impl Iterator<Item = &str> {
        self.terms()
            .filter(move |(_, term)| wanted(term.kind))
            .map(|(name, _)| name)
    }

    /// What is said of a name, if anything.
    pub fn term(&self, name: &str) -> Option<&OntologyTerm> {
        self.terms.get(name)
    }

    /// What a name stands for, if it is known.
    pub fn kind(&self, name: &str) -> Option<TermKind> {
        self.term(name).map(|term| term.kind)
    }

    /// The class and all classes above it; itself first, then level by level.
    ///
    /// # Errors
    /// It is no class.
    pub fn superclasses(&self, class: &str) -> Result<Vec<&str>, UnknownName> {
        let class = self.expect(class, "class", |kind| kind == TermKind::Class)?;
        Ok(self.above(class))
    }

    /// The class and all classes below it; itself first, then level by level.
    ///
    /// # Errors
    /// It is no class.
    pub fn subclasses(&self, class: &str) -> Result<Vec<&str>, UnknownName> {
        let class = self.expect(class, "class", |kind| kind == TermKind::Class)?;
        let below = self.below(class).into_iter();
        Ok(below
            .filter(|name| self.kind(name) == Some(TermKind::Class))
            .collect())
    }

    /// The property and all properties above it; itself first, then level by level.
    ///
    /// # Errors
    /// It is no property.
    pub fn superproperties(&self, property: &str) -> Result<Vec<&str>, UnknownName> {
        let property = self.expect(property, "property", TermKind::is_property)?;
        Ok(self.above(property))
    }

    /// The property and all properties below it; itself first, then level by level.
    ///
    /// # Errors
    /// It is no property.
    pub fn subproperties(&self, property: &str) -> Result<Vec<&str>, UnknownName> {
        let property = self.expect(property, "property", TermKind::is_property)?;
        Ok(self.below(property))
    }

    /// All classes of a shared individual, nearest first.
    ///
    /// # Errors
    /// It is no shared individual.
    pub fn types_of(&self, individual: &str) -> Result<Vec<&str>, UnknownName> {
        let individual = self.expect(individual, "individual", |kind| {
            kind == TermKind::Individual
        })?;
        let mut types = self.above(individual);
        types.remove(0);
        Ok(types)
    }

    /// The name in words, if the ontology gives one.
    pub fn label(&self, name: &str) -> Option<&str> {
        self.term(name)
            .map(|term| term.label.as_str())
            .filter(|label| !label.is_empty())
    }

    /// What a name means, with its unit if it has one, if the ontology says so.
    pub fn comment(&self, name: &str) -> Option<&str> {
        self.term(name)
            .map(|term| term.comment.as_str())
            .filter(|comment| !comment.is_empty())
    }

    /// The IRI of a name with prefix, be it known or not.
    ///
    /// # Errors
    /// It has no prefix, or an unknown one.
    pub fn expand(&self, name: &str) -> Result<String, UnknownName> {
        let (prefix, local) = name.split_once(':').unwrap_or(("", name));
        Ok(format!("{}{local}", namespace(prefix)?))
    }

    /// The name with prefix of an IRI, if it lies in one of the namespaces.
    pub fn compact(&self, iri: &str) -> Option<String> {
        compact(iri)
    }

    /// The known class, property or individual of this prefix and local name; another name of a thing leads to
    /// the thing.
    ///
    /// # Errors
    /// The prefix is unknown, or nothing is called so; then the nearest names are given.
    pub fn resolve(&self, prefix: &str, local: &str) -> Result<&str, UnknownName> {
        namespace(prefix)?;
        self.expect(
            &format!("{prefix}:{local}"),
            "class, property or individual",
            |_| true,
        )
        .map(|name| self.proper(name))
    }

    /// The known class, property or individual of this local name, looked for in the order of
    /// [`Self::prefixes`].
    ///
    /// # Errors
    /// Nothing is called so; then the nearest names are given.
    pub fn resolve_bare(&self, local: &str) -> Result<&str, UnknownName> {
        let found = PREFIXES
            .iter()
            .find_map(|(prefix, _)| self.terms.get_key_value(&format!("{prefix}:{local}")));
        match found {
            Some((name, _)) => Ok(self.proper(name)),
            None => Err(UnknownName::new(
                "class, property or individual",
                local,
                self.terms
                    .keys()
                    .filter_map(|name| name.split_once(':').map(|(_, local)| local)),
            )),
        }
    }

    fn proper<'a>(&'a self, name: &'a str) -> &'a str {
        self.term(name)
            .and_then(|term| term.same_as.as_deref())
            .unwrap_or(name)
    }

    fn expect(
        &self,
        name: &str,
        kind: &'static str,
        wanted: impl Fn(TermKind) -> bool,
    ) -> Result<&str, UnknownName> {
        match self.terms.get_key_value(name) {
            Some((name, term)) if wanted(term.kind) => Ok(name),
            _ => Err(UnknownName::new(kind, name, self.of_kind(wanted))),
        }
    }

    fn above<'a>(&'a self, name: &'a str) -> Vec<&'a str> {
        closure(name, |name| {
            self.terms
                .get(name)
                .map_or(&[], |term| term.parents.as_slice())
        })
    }

    fn below<'a>(&'a self, name: &'a str) -> Vec<&'a str> {
        closure(name, |name| {
            self.children.get(name).map_or(&[], Vec::as_slice)
        })
    }
}

/// A name and all that can be reached from it, level by level, each once.
fn closure<'a>(name: &'a str, next: impl Fn(&str) -> &'a [String]) -> Vec<&'a str> {
    let mut reached = vec![name];
    let mut done = 0;
    while let Some(&name) = reached.get(done) {
        for name in next(name) {
            if !reached.contains(&name.as_str()) {
                reached.push(name);
            }
        }
        done += 1;
    }
    reached
}

fn namespace(prefix: &str) -> Result<&'static str, UnknownName> {
    PREFIXES
        .iter()
        .find(|(known, _)| *known == prefix)
        .map(|(_, namespace)| *namespace)
        .ok_or_else(|| UnknownName::new("prefix", prefix, PREFIXES.map(|(prefix, _)| prefix)))
}

fn compact(iri: &str) -> Option<String> {
    PREFIXES.iter().find_map(|(prefix, namespace)| {
        let local = iri.strip_prefix(namespace)?;
        (!local.is_empty()).then(|| format!("{prefix}:{local}"))
    })
}
