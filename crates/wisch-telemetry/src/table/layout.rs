//! Layout of a table: the columns that hold its times, poses and forces.

use super::known::{CONTEXT, FORCES, SENSOR_CONTEXT, indexed_base, is_prefix};
use super::names::{Name, Unit, UnitKind};
use crate::error::ReadFault;
use crate::options::{Axes, LogOptions, OrientationForm, WrenchSign};
use std::ops::Range;
use wisch::represent::UnknownName;

/// This crate's names of the columns of time, position and force.
const TIME: &str = "t";
const POSITION: [&str; 3] = ["x", "y", "z"];
const FORCE: [&str; 3] = ["fx", "fy", "fz"];

/// Names of columns of times, the likeliest first.
const TIMES: [&str; 14] = [
    TIME,
    "time",
    "timestamp",
    "time_stamp",
    "stamp",
    "header_stamp",
    "field_header_stamp",
    "ros_time",
    "unix_time",
    "robot_time",
    "elapsed_time",
    "elapsed",
    "datetime",
    "date_time",
];

/// Last words of the names of two columns that state a time together: its whole seconds, and the parts of a second beyond
/// them; and the size of a part [ns].
const SPLIT_TIMES: [([&str; 2], i64); 10] = [
    (["secs", "nsecs"], 1),
    (["sec", "nsec"], 1),
    (["sec", "nanosec"], 1),
    (["secs", "nanosecs"], 1),
    (["second", "nanosecond"], 1),
    (["seconds", "nanoseconds"], 1),
    (["seconds", "nanosecs"], 1),
    (["s", "ns"], 1),
    (["sec", "usec"], 1000),
    (["sec", "microsec"], 1000),
];
/// Words before these endings; with other words, two such columns are durations or another
/// quantity.
const STEMS: [&str; 7] = ["", "stamp", "time", "timestamp", "t", "tv", "clock"];

/// Columns of whole seconds and of the parts beyond them.
#[derive(Debug, Clone, Copy)]
struct SplitTime {
    columns: [usize; 2],
    /// Size of a part [ns].
    part: i64,
}

/// A column that is read.
#[derive(Debug, Clone)]
pub(super) struct Column {
    /// This crate's name.
    pub ours: &'static str,
    /// Its index in the table.
    pub index: usize,
    pub kind: UnitKind,
    /// Unit in its name.
    pub unit: Option<Unit>,
    /// Whether its unit is stated and known.
    pub is_unit_known: bool,
}

/// Columns that are read: time (unless a rate replaces it; its nanoseconds may follow in a column of their own), position,
/// orientation, force.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    pub columns: Vec<Column>,
    /// Size of the parts of a second in the second column of times [ns], if there is one.
    pub part_of_second: i64,
    pub form: OrientationForm,
    /// Axes and sign of the force, if the names of its columns imply them.
    pub axes: Option<Axes>,
    pub sign: Option<WrenchSign>,
    /// Remarks on how the columns were found.
    pub remarks: Vec<String>,
}

impl Layout {
    /// Finds the columns, given the names of all columns.
    pub fn find(texts: &[String], options: &LogOptions) -> Result<Self, ReadFault> {
        let mut finder = Finder {
            texts,
            names: texts.iter().map(|text| Name::parse(text)).collect(),
            renamed: &options.columns,
            remarks: Vec::new(),
        };
        finder.check_renamed()?;
        let mut columns = Vec::new();
        let mut part_of_second = 1;
        if options.rate.is_none() {
            let (times, part) = finder.time()?;
            columns.extend(times);
            part_of_second = part;
        }
        let force = finder.force()?;
        let (form, turn) = finder.orientation(options.orientation)?;
        columns.extend(finder.position(form, &turn)?);
        columns.extend(turn);
        // Column names of libfranka and UR imply axes and sign, as their logs show.
        let known = FORCES.iter().find(|known| {
            let name = &finder.names[force[0].index];
            name.bases().any(|base| indexed_base(base, known.base, 0))
        });
        let (axes, sign) = known.map_or((None, None), |known| (Some(known.axes), Some(known.sign)));
        columns.extend(force);
        if let Some(known) = known {
            let by = match known.sign {
                WrenchSign::OnTool => "on the tool",
                WrenchSign::ByTool => "of the tool on its surroundings",
            };
            finder.remarks.push(format!(
                "forces of {} are read as those {by}, in the axes of the {}",
                known.robot,
                known.axes.as_str()
            ));
        }
        Ok(Self {
            columns,
            part_of_second,
            form,
            axes,
            sign,
            remarks: finder.remarks,
        })
    }

    /// Indices of all columns that are read.
    pub fn indices(&self) -> Vec<usize> {
        self.columns.iter().map(|column| column.index).collect()
    }

    /// Range of the columns with a kind of unit, which are adjacent.
    pub fn columns_of_kind(&self, kind: UnitKind) -> Range<usize> {
        let is_one = |column: &Column| column.kind == kind;
        let start = self.columns.iter().position(is_one).unwrap_or(0);
        start..start + self.columns.iter().filter(|column| is_one(column)).count()
    }

    /// Range of the columns of angles.
    pub fn angles(&self) -> Range<usize> {
        self.columns_of_kind(UnitKind::Angle)
    }
}

/// Finder of columns by their names.
struct Finder<'a> {
    texts: &'a [String],
    names: Vec<Name>,
    renamed: &'a [(String, String)],
    remarks: Vec<String>,
}

impl Finder<'_> {
    /// Checks that every renamed column is one that this crate reads.
    fn check_renamed(&self) -> Result<(), ReadFault> {
        let turns = OrientationForm::ALL.iter().flat_map(|form| form.names());
        let ours: Vec<&str> = std::iter::once(TIME)
            .chain(POSITION)
            .chain(turns.copied())
            .chain(FORCE)
            .collect();
        match (self.renamed.iter()).find(|(name, _)| !ours.contains(&name.as_str())) {
            Some((name, _)) => Err(unknown(name, ours.into_iter())),
            None => Ok(()),
        }
    }

    fn column(&self, ours: &'static str, index: usize, kind: UnitKind) -> Column {
        let unit = self.names[index].without_unit.as_ref();
        // "qx_m" does not end with a unit of a quaternion; "x [furlong]" ends with a unit, though an unknown one.
        let unit = unit.map(|(_, unit)| unit.clone());
        let unit = unit.filter(|unit| unit.is_apart || kind.size_of(&unit.text).is_some());
        Column {
            ours,
            index,
            kind,
            unit,
            is_unit_known: false,
        }
    }

    /// Returns the table's name of a column, if the options state it.
    fn renaming(&self, ours: &str) -> Option<&str> {
        let found = self.renamed.iter().find(|(name, _)| name == ours);
        found.map(|(_, theirs)| theirs.as_str())
    }

    /// Finds the only column of a name: exactly, or else ignoring case and unit.
    fn sole(&self, name: &str) -> Result<Option<usize>, ReadFault> {
        let sought = Name::parse(name);
        let is_close = |index: &usize| {
            let candidate = &self.names[*index];
            candidate.whole == sought.whole || candidate.is(&sought.whole).is_some()
        };
        let indices = 0..self.texts.len();
        let exact: Vec<usize> = indices
            .clone()
            .filter(|&k| self.texts[k] == name.trim())
            .collect();
        let found = if exact.is_empty() {
            indices.filter(is_close).collect()
        } else {
            exact
        };
        match found[..] {
            [] => Ok(None),
            [one] => Ok(Some(one)),
            [first, second, ..] => Err(ReadFault::DuplicateColumn {
                name: name.to_owned(),
                columns: [first, second].map(|index| (index + 1, self.texts[index].clone())),
            }),
        }
    }

    /// Finds columns by this crate's names, or by their names in the options.
    fn by_our_names<const N: usize>(
        &self,
        ours: [&'static str; N],
        kind: UnitKind,
    ) -> Result<[Option<Column>; N], ReadFault> {
        let mut columns = [const { None }; N];
        for (column, ours) in columns.iter_mut().zip(ours) {
            let renamed = self.renaming(ours);
            let name = renamed.unwrap_or(ours);
            let index = self.sole(name)?;
            if index.is_none() && renamed.is_some() {
                return Err(unknown(name, self.texts.iter().map(String::as_str)));
            }
            *column = index.map(|index| self.column(ours, index, kind));
        }
        Ok(columns)
    }

    /// Finds the column of times, or those of its seconds and of the parts beyond them, whose size [ns] is returned.
    fn time(&mut self) -> Result<(Vec<Column>, i64), ReadFault> {
        let split = self.split_times();
        if self.renaming(TIME).is_some() {
            let [time] = self.by_our_names([TIME], UnitKind::Time)?;
            let time = time.ok_or_else(|| self.missing(TIME))?;
            let named = split.into_iter().find(|pair| pair.columns[0] == time.index);
            return Ok(match named {
                Some(pair) => (self.split_columns(pair), pair.part),
                None => (vec![time], 1),
            });
        }
        let is_part = |index: usize| split.iter().any(|pair| pair.columns.contains(&index));
        let mut found = Vec::new();
        for name in TIMES {
            match self.sole(name) {
                // Seconds whose parts stand in another column are no times by themselves.
                Ok(index) => found.extend(index.filter(|&index| !is_part(index))),
                Err(ReadFault::DuplicateColumn { columns, .. })
                    if columns.iter().all(|(number, _)| is_part(number - 1)) => {}
                Err(fault) => return Err(fault),
            }
        }
        let named = |indices: &[usize]| {
            let texts = (indices.iter()).map(|&index| format!("{:?}", self.texts[index]));
            texts.collect::<Vec<_>>().join(" and ")
        };
        let all: Vec<Vec<usize>> = (found.iter().map(|&index| vec![index]))
            .chain(split.iter().map(|pair| pair.columns.to_vec()))
            .collect();
        let Some(first) = all.first() else {
            return Err(ReadFault::NoTime {
                columns: self.texts.to_vec(),
            });
        };
        let ignored = all.get(1).map(|second| {
            format!(
                "times from {}; {} could be times, too, and are ignored: --csv-columns t=NAME chooses",
                named(first),
                named(second)
            )
        });
        let together = (first.len() > 1)
            .then(|| format!("times are the sums of the columns {}", named(first)));
        self.remarks.extend(together.into_iter().chain(ignored));
        Ok(match (found.first(), split.first()) {
            (None, Some(pair)) => (self.split_columns(*pair), pair.part),
            _ => (vec![self.column(TIME, first[0], UnitKind::Time)], 1),
        })
    }

    fn split_columns(&self, pair: SplitTime) -> Vec<Column> {
        let columns = pair.columns.into_iter();
        let columns = columns.map(|index| Column {
            // The units of both columns follow from their names.
            unit: None,
            ..self.column(TIME, index, UnitKind::Time)
        });
        columns.collect()
    }

    /// Finds the pairs of columns of seconds and of the parts beyond them, those of poses first, and of forces last.
    fn split_times(&self) -> Vec<SplitTime> {
        let stem = |index: usize, word: &str| -> Option<&str> {
            let rest = self.names[index].whole.strip_suffix(word)?;
            let stem = rest.strip_suffix('_').or(rest.is_empty().then_some(rest))?;
            let last = stem.rsplit_once('_').map_or(stem, |(_, last)| last);
            STEMS.contains(&last).then_some(stem)
        };
        let indices = || 0..self.texts.len();
        let mut pairs = Vec::new();
        for ([seconds, parts], part) in SPLIT_TIMES {
            for first in indices() {
                let Some(whole) = stem(first, seconds) else {
                    continue;
                };
                let second = indices().find(|&k| stem(k, parts) == Some(whole));
                pairs.extend(second.map(|second| SplitTime {
                    columns: [first, second],
                    part,
                }));
            }
        }
        let rank = |pair: &SplitTime| {
            let name = &self.names[pair.columns[0]].whole;
            let has = |words: &[&str]| words.iter().any(|word| name.contains(word));
            (
                !has(&["pose"]),
                has(&["wrench", "force", "ft_"]),
                pair.columns[0],
            )
        };
        pairs.sort_by_key(rank);
        pairs
    }

    fn force(&mut self) -> Result<Vec<Column>, ReadFault> {
        let plain = self.by_our_names(FORCE, UnitKind::Force)?;
        if let Some(columns) = self.complete(plain, FORCE)? {
            return Ok(columns);
        }
        let kinds = ["f", "force", "forces"];
        let mut families = self.families(FORCE, POSITION, UnitKind::Force, |prefix| {
            is_prefix(prefix, &kinds, &[&CONTEXT, &SENSOR_CONTEXT])
        });
        if let Some(known) = FORCES
            .iter()
            .find_map(|known| self.find_indexed(known.base, &[0, 1, 2], &FORCE, UnitKind::Force))
        {
            families.push(known);
        }
        self.one_of("force", families, &FORCE)
    }

    fn orientation(
        &mut self,
        chosen: Option<OrientationForm>,
    ) -> Result<(OrientationForm, Vec<Column>), ReadFault> {
        let forms = OrientationForm::ALL.into_iter();
        for form in forms.filter(|form| chosen.is_none_or(|chosen| chosen == *form)) {
            let ours = form.names();
            let is_renamed = ours.iter().any(|name| self.renaming(name).is_some());
            // Single letters are ambiguous; beside a position and with the same prefix they are
            // KUKA's angles.
            let may_be_plain = form != OrientationForm::Abc || chosen.is_some();
            if is_renamed || may_be_plain {
                let plain: Vec<Option<Column>> = (ours.iter())
                    .map(|ours| {
                        Ok(self
                            .by_our_names([*ours], form.kind())?
                            .into_iter()
                            .flatten()
                            .next())
                    })
                    .collect::<Result<_, ReadFault>>()?;
                if plain.iter().all(Option::is_some) {
                    self.remark_assumed(form, chosen);
                    return Ok((form, plain.into_iter().flatten().collect()));
                }
                if is_renamed {
                    let missing = ours.iter().zip(&plain).find(|(_, column)| column.is_none());
                    return Err(self.missing(missing.map_or(ours[0], |(name, _)| name)));
                }
            }
        }
        let mut found: Vec<(OrientationForm, Vec<Vec<Column>>)> = Vec::new();
        for form in OrientationForm::ALL {
            if chosen.is_none_or(|chosen| chosen == form) {
                let families = self.turns(form, chosen);
                if !families.is_empty() {
                    found.push((form, families));
                }
            }
        }
        match found.pop() {
            None => {
                let form = chosen.unwrap_or(OrientationForm::Quaternion);
                self.one_of("orientation", Vec::new(), form.names())
                    .map(|columns| (form, columns))
            }
            Some((form, families)) if found.is_empty() => {
                let columns = self.one_of("orientation", families, form.names())?;
                self.remark_assumed(form, chosen);
                Ok((form, columns))
            }
            Some(last) => {
                found.push(last);
                let families = found.into_iter().flat_map(|(_, families)| families);
                self.one_of("orientation", families.collect(), &["qx"])
                    .map(|columns| (OrientationForm::Quaternion, columns))
            }
        }
    }

    /// Finds the columns that may state an orientation in some form, by the names of other programs.
    fn turns(&self, form: OrientationForm, chosen: Option<OrientationForm>) -> Vec<Vec<Column>> {
        let (ours, kind) = (form.names(), form.kind());
        match form {
            OrientationForm::Quaternion => {
                let kinds = [
                    "q",
                    "quat",
                    "quaternion",
                    "orientation",
                    "ori",
                    "rot",
                    "rotation",
                ];
                let leaves = ["x", "y", "z", "w"];
                let ours = [ours[0], ours[1], ours[2], ours[3]];
                self.families(ours, leaves, kind, |prefix| {
                    is_prefix(prefix, &kinds, &[&CONTEXT])
                })
            }
            OrientationForm::RotationVector => {
                let kinds = ["r", "rv", "rotvec", "rot_vec", "rotation_vector"];
                let names = [ours[0], ours[1], ours[2]];
                let mut families = self.families(names, POSITION, kind, |prefix| {
                    is_prefix(prefix, &kinds, &[&CONTEXT])
                });
                families.extend(self.find_indexed("actual_tcp_pose", &[3, 4, 5], ours, kind));
                families
            }
            OrientationForm::RollPitchYaw => {
                let kinds = ["", "rpy", "euler", "orientation", "ori", "rot", "rotation"];
                let names = [ours[0], ours[1], ours[2]];
                let mut families = self.families(names, names, kind, |prefix| {
                    is_prefix(prefix, &kinds, &[&CONTEXT])
                });
                if chosen == Some(form) && families.is_empty() {
                    // If an option states that the columns are angles, they may be named after their axes.
                    families = self.families(names, POSITION, kind, |prefix| {
                        is_prefix(prefix, &["r", "rot", "rpy", "euler"], &[&CONTEXT])
                    });
                }
                families
            }
            OrientationForm::Abc => {
                let names = [ours[0], ours[1], ours[2]];
                self.families(names, names, kind, |prefix| {
                    let is_ours = is_prefix(prefix, &["", "pos", "position"], &[&CONTEXT]);
                    is_ours
                        && POSITION
                            .iter()
                            .all(|leaf| self.has(&format!("{prefix}{leaf}")))
                })
            }
            OrientationForm::Matrix => {
                let indices: Vec<usize> = (0..16).collect();
                self.find_indexed("o_t_ee", &indices, ours, kind)
                    .into_iter()
                    .collect()
            }
        }
    }

    fn position(
        &mut self,
        form: OrientationForm,
        turn: &[Column],
    ) -> Result<Vec<Column>, ReadFault> {
        let plain = self.by_our_names(POSITION, UnitKind::Length)?;
        if let Some(columns) = self.complete(plain, POSITION)? {
            return Ok(columns);
        }
        if form == OrientationForm::Matrix {
            // The position is the last column of the matrix.
            let columns = POSITION.into_iter().zip(&turn[12..]);
            let columns =
                columns.map(|(ours, column)| self.column(ours, column.index, UnitKind::Length));
            return Ok(columns.collect());
        }
        let kinds = ["", "p", "pos", "position", "translation"];
        let mut families = self.families(POSITION, POSITION, UnitKind::Length, |prefix| {
            is_prefix(prefix, &kinds, &[&CONTEXT])
        });
        families.extend(self.find_indexed(
            "actual_tcp_pose",
            &[0, 1, 2],
            &POSITION,
            UnitKind::Length,
        ));
        self.one_of("position", families, &POSITION)
    }

    /// Returns the columns with this crate's names, if all exist; fails if some are renamed and others are missing.
    fn complete<const N: usize>(
        &self,
        columns: [Option<Column>; N],
        ours: [&'static str; N],
    ) -> Result<Option<Vec<Column>>, ReadFault> {
        if columns.iter().all(Option::is_some) {
            return Ok(Some(columns.into_iter().flatten().collect()));
        }
        if ours.iter().any(|name| self.renaming(name).is_some()) {
            let missing = ours
                .iter()
                .zip(&columns)
                .find(|(_, column)| column.is_none());
            return Err(self.missing(missing.map_or(ours[0], |(name, _)| name)));
        }
        Ok(None)
    }

    /// Whether a column of this name exists, ignoring its unit.
    fn has(&self, base: &str) -> bool {
        self.names.iter().any(|name| name.is(base).is_some())
    }

    /// Finds every set of columns whose names consist of a common prefix and the given leaves.
    fn families<const N: usize>(
        &self,
        ours: [&'static str; N],
        leaves: [&str; N],
        kind: UnitKind,
        is_meant: impl Fn(&str) -> bool,
    ) -> Vec<Vec<Column>> {
        let mut prefixes: Vec<&str> = Vec::new();
        for base in self.names.iter().flat_map(Name::bases) {
            if let Some(prefix) = base.strip_suffix(leaves[0])
                && !prefixes.contains(&prefix)
                && is_meant(prefix)
            {
                prefixes.push(prefix);
            }
        }
        let family = |prefix: &&str| {
            let columns = ours.iter().zip(leaves).map(|(ours, leaf)| {
                let base = format!("{prefix}{leaf}");
                let mut found =
                    (0..self.names.len()).filter(|&k| self.names[k].is(&base).is_some());
                let index = found.next()?;
                found
                    .next()
                    .is_none()
                    .then(|| self.column(ours, index, kind))
            });
            columns.collect::<Option<Vec<Column>>>()
        };
        prefixes.iter().filter_map(family).collect()
    }

    /// Finds the columns of an array with the given indices.
    fn find_indexed(
        &self,
        base: &str,
        indices: &[usize],
        ours: &[&'static str],
        kind: UnitKind,
    ) -> Option<Vec<Column>> {
        let columns = indices.iter().zip(ours).map(|(&index, ours)| {
            let is_it = |name: &Name| name.bases().any(|name| indexed_base(name, base, index));
            let mut found = (0..self.names.len()).filter(|&k| is_it(&self.names[k]));
            let first = found.next()?;
            found
                .next()
                .is_none()
                .then(|| self.column(ours, first, kind))
        });
        columns.collect()
    }

    /// Returns the only set of columns that was found. Without any, the error names the first missing column.
    fn one_of(
        &mut self,
        what: &'static str,
        families: Vec<Vec<Column>>,
        ours: &[&'static str],
    ) -> Result<Vec<Column>, ReadFault> {
        let listed = |columns: &[Column]| {
            let names = columns
                .iter()
                .map(|column| self.texts[column.index].as_str());
            names.collect::<Vec<_>>().join(", ")
        };
        match &families[..] {
            [] => {
                let is_missing = |name: &&&str| matches!(self.sole(name), Ok(None));
                Err(self.missing(ours.iter().find(is_missing).unwrap_or(&ours[0])))
            }
            [one] => {
                let remark = format!("{what} from columns {}", listed(one));
                self.remarks.push(remark);
                Ok(families.into_iter().flatten().collect())
            }
            many => Err(ReadFault::SeveralColumns {
                what,
                columns: many.iter().map(|family| listed(family)).collect(),
            }),
        }
    }

    /// Adds the remark that the form of an orientation is assumed, if the names leave it open.
    fn remark_assumed(&mut self, form: OrientationForm, chosen: Option<OrientationForm>) {
        let is_known = self
            .names
            .iter()
            .any(|name| indexed_base(&name.whole, "actual_tcp_pose", 3));
        if form == OrientationForm::RotationVector && chosen.is_none() && !is_known {
            self.remarks.push(
                "the orientation is read as a rotation vector; --orientation states another form"
                    .to_owned(),
            );
        }
    }

    fn missing(&self, ours: &str) -> ReadFault {
        unknown(
            self.renaming(ours).unwrap_or(ours),
            self.texts.iter().map(String::as_str),
        )
    }
}

impl OrientationForm {
    /// Kind of unit of its numbers.
    const fn kind(self) -> UnitKind {
        match self {
            Self::Quaternion | Self::Matrix => UnitKind::None,
            Self::RotationVector | Self::RollPitchYaw | Self::Abc => UnitKind::Angle,
        }
    }
}

fn unknown<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> ReadFault {
    ReadFault::Unknown(UnknownName::new("column", name, known))
}
