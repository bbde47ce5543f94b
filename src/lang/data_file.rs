//! `data("file")`: a table of wavelengths and values from a text file.
//!
//! Rows of a wavelength, a value, and for a complex index a second value k, parted by commas,
//! semicolons, tabs or blanks. `#` begins a comment, which ends with its line; the first row may name
//! the columns. Whatever else a file holds is told with its line.

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::errors::spectrum as errors;
use super::report::Reports;
use super::{Library, limits};
use crate::diag::{FileId, Sources, Span};
use crate::math::Table;

/// The files that scenes took data from.
#[derive(Default)]
pub struct DataFiles<'l> {
    library: Option<&'l dyn Library>,
    /// The number of the next source.
    next: u32,
    read: RefCell<Vec<Rc<DataFile>>>,
}

/// A file that was read.
pub struct DataFile {
    identity: PathBuf,
    /// Its number among the sources; none if it could not be read.
    source: Option<FileId>,
    /// As shown to people.
    path: String,
    /// Its text, or why there is none.
    text: Result<String, String>,
    /// What was made of it, by the unit of its wavelengths.
    parsed: RefCell<Vec<(f64, Result<Columns, Fault>)>>,
}

/// The columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Values by wavelength.
    pub value: Table,
    /// The second value, where there are three columns.
    pub k: Option<Table>,
}

impl<'l> DataFiles<'l> {
    /// Files are read through `library`, and numbered from the sources there are.
    pub fn new(library: &'l dyn Library, sources: &Sources) -> Self {
        Self {
            library: Some(library),
            next: sources.iter().count() as u32,
            read: RefCell::default(),
        }
    }

    /// A file, read once; None: why not was told. `name`: as written at `span`.
    pub fn get(
        &self,
        reports: &Reports,
        path: &Path,
        name: &str,
        span: Span,
    ) -> Option<Rc<DataFile>> {
        let library = self.library?;
        let identity = library.identity(path);
        let mut read = self.read.borrow_mut();
        let known = read.iter().find(|file| file.identity == identity).cloned();
        if known.is_none() && read.len() == limits::FILES {
            reports.tell(errors::too_many_files(span));
            return None;
        }
        let file = known.unwrap_or_else(|| {
            let count = read.iter().filter(|file| file.source.is_some()).count() as u32;
            let text = library.read(path);
            let source = text.is_ok().then_some(FileId(self.next + count));
            let path = path.to_string_lossy().into_owned();
            let parsed = RefCell::default();
            let file = Rc::new(DataFile { identity, source, path, text, parsed });
            read.push(file.clone());
            file
        });
        match &file.text {
            Ok(_) => Some(file),
            Err(cause) => {
                let place = file.identity.to_string_lossy();
                reports.tell(errors::unread(name, &place, cause, span));
                None
            }
        }
    }

    /// Gives the texts to the sources, in the order of their numbers.
    pub fn hand_over(self, sources: &mut Sources) {
        for file in self.read.into_inner() {
            if let Ok(text) = &file.text {
                let id = sources.add(file.path.as_str(), text.as_str());
                debug_assert_eq!(Some(id), file.source);
            }
        }
    }
}

impl DataFile {
    /// Its columns; None: what is wrong was told. `unit`: nanometres of a wavelength's unit.
    /// `asked`: the place of the file's name.
    pub fn columns(
        &self,
        reports: &Reports,
        name: &str,
        unit: f64,
        asked: Span,
    ) -> Option<Columns> {
        let (text, source) = (self.text.as_ref().ok()?, self.source?);
        let mut parsed = self.parsed.borrow_mut();
        let known = parsed.iter().position(|(known, _)| *known == unit);
        let at = known.unwrap_or_else(|| {
            parsed.push((unit, parse(text, unit)));
            parsed.len() - 1
        });
        match &parsed[at].1 {
            Ok(columns) => Some(columns.clone()),
            Err(fault) => {
                let place = fault.at.map(|(start, end)| Span::new(source, start, end));
                reports.tell(errors::bad_data(name, &fault.what, fault.help, place, asked));
                None
            }
        }
    }

    /// What it costs to read its columns, in values; nothing, if they have been read.
    pub fn cost(&self, unit: f64) -> usize {
        let known = self.parsed.borrow().iter().any(|(known, _)| *known == unit);
        let bytes = self.text.as_ref().map_or(0, String::len);
        if known { 0 } else { bytes / BYTES_A_VALUE }
    }
}

/// Bytes of a file that cost as much as computing a value.
const BYTES_A_VALUE: usize = 256;

/// What is wrong with a file.
#[derive(Clone, Debug, PartialEq)]
struct Fault {
    /// In words, after the file's name.
    what: String,
    /// Where, in bytes.
    at: Option<(usize, usize)>,
    help: &'static str,
}

const FORM: &str = "write rows of a wavelength and a value, such as `400, 0.1`";

fn parse(text: &str, unit: f64) -> Result<Columns, Fault> {
    let mut nodes: [Vec<(f64, f64)>; 2] = [Vec::new(), Vec::new()];
    let mut columns = None;
    let mut named = false;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let start = at;
        at += line.len();
        let line = line.split('#').next().unwrap_or(line).trim_end();
        let blank = line.len() - line.trim_start().len();
        let line = line.trim_start();
        if line.is_empty() {
            continue;
        }
        let place = (start + blank, start + blank + line.len());
        let fault = |what: String, help| Fault { what, at: Some(place), help };
        let cells = cells(line);
        if columns.is_none() && !named && cells.iter().all(|cell| number(cell).is_none()) {
            named = true;
            continue;
        }
        let wanted = *columns.get_or_insert(cells.len());
        if cells.len() != wanted || !(2..=3).contains(&wanted) {
            let found = cells.len();
            let what = match (2..=3).contains(&wanted) {
                false => format!("has a row of {found} columns"),
                true => format!("has a row of {found} columns, after rows of {wanted}"),
            };
            return Err(fault(what, "a row is a wavelength and a value, or a wavelength, n and k"));
        }
        let mut row = [0.0; 3];
        for (slot, cell) in row.iter_mut().zip(&cells) {
            *slot = number(cell).ok_or_else(|| {
                let shown: String = cell.chars().take(20).collect();
                fault(format!("has `{shown}` where a number belongs"), FORM)
            })?;
        }
        let nm = super::value::neat(row[0] * unit);
        if !(nm > 0.0 && nm.is_finite()) {
            let help = "wavelengths are lengths above 0";
            return Err(fault(format!("has the wavelength `{}`", cells[0]), help));
        }
        if nodes[0].last().is_some_and(|(last, _)| *last >= nm) {
            let help = "sort the rows by their wavelengths, each once";
            return Err(fault("has wavelengths that do not rise".into(), help));
        }
        if nodes[0].len() == limits::ELEMENTS {
            let what = format!("has more than {} rows", limits::ELEMENTS);
            return Err(fault(what, "leave out rows: straight lines join those that stay"));
        }
        nodes[0].push((nm, row[1]));
        nodes[1].push((nm, row[2]));
    }
    let [value, k] = nodes.map(Table::new);
    let nothing = || Fault { what: "has no row of numbers".into(), at: None, help: FORM };
    let value = value.ok_or_else(nothing)?;
    Ok(Columns { value, k: k.filter(|_| columns == Some(3)) })
}

/// The cells of a row, without blanks and quotes.
fn cells(line: &str) -> Vec<&str> {
    let tidy = |cell: &'_ str| -> bool { !cell.is_empty() };
    let bare = |cell| -> &str { str::trim(cell).trim_matches('"') };
    match [';', ',', '\t'].into_iter().find(|part| line.contains(*part)) {
        Some(part) => line.split(part).map(bare).collect(),
        None => line.split_whitespace().map(bare).filter(|cell| tidy(cell)).collect(),
    }
}

/// A finite number.
fn number(cell: &str) -> Option<f64> {
    let digits = cell.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    cell.parse().ok().filter(|x: &f64| digits && x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(text: &str) -> Vec<(f64, f64)> {
        parse(text, 1.0).unwrap().value.nodes().to_vec()
    }

    #[test]
    fn rows_are_parted_by_whatever_tables_are_parted_by() {
        let expected = [(400.0, 0.5), (500.0, 1e-3)];
        for text in [
            "400,0.5\n500,1e-3\n",
            "# nm\nwavelength, value\r\n400, 0.5\r\n\r\n500, 0.001",
            "400;0.5\n500;0.001",
            "  400\t0.5\n500\t0.001\n",
            "wl,n # of 2020\n400,0.5 # measured, twice\n  # a gap\n500,1e-3# last\n",
            "400   0.5\n 500 +1e-3 \n",
            "\"400\",\"0.5\"\n\"500\",\".001\"\n",
        ] {
            assert_eq!(nodes(text), expected, "{text:?}");
        }
        assert_eq!(parse("0.4 1\n0.5 2", 1000.0).unwrap().value.nodes()[1], (500.0, 2.0));
        let columns = parse("wl,n,k\n400,1.5,0.25\n500,1.4,0.5", 1.0).unwrap();
        assert_eq!(columns.k.unwrap().nodes(), [(400.0, 0.25), (500.0, 0.5)]);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        for (text, what, at) in [
            ("", "has no row of numbers", None),
            ("# nothing\nwl,n\n", "has no row of numbers", None),
            ("400,1\n390,2", "has wavelengths that do not rise", Some((6, 11))),
            ("400,1\n400,2", "has wavelengths that do not rise", Some((6, 11))),
            ("wl,n\n400,x\n", "has `x` where a number belongs", Some((5, 10))),
            ("400,nan", "has `nan` where a number belongs", Some((0, 7))),
            ("400,inf", "has `inf` where a number belongs", Some((0, 7))),
            ("400,1e999", "has `1e999` where a number belongs", Some((0, 9))),
            ("400;0,5", "has `0,5` where a number belongs", Some((0, 7))),
            ("-400,1", "has the wavelength `-400`", Some((0, 6))),
            ("0,1", "has the wavelength `0`", Some((0, 3))),
            ("400", "has a row of 1 columns", Some((0, 3))),
            ("400 # 1", "has a row of 1 columns", Some((0, 3))),
            ("1,2,3,4", "has a row of 4 columns", Some((0, 7))),
            ("400,1\n500,1,2", "has a row of 3 columns, after rows of 2", Some((6, 13))),
            ("wl,n\nwl,k\n400,1", "has `wl` where a number belongs", Some((5, 9))),
        ] {
            let fault = parse(text, 1.0).unwrap_err();
            assert_eq!((fault.what.as_str(), fault.at), (what, at), "{text:?}");
        }
        let many = (1..=limits::ELEMENTS + 1).map(|i| format!("{i} 1\n")).collect::<String>();
        assert_eq!(parse(&many, 1.0).unwrap_err().what, "has more than 100000 rows");
    }
}
