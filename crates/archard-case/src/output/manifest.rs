//! The list of what this program has written into a folder: nothing else in it is replaced or removed.
//!
//! The file `manifest.txt` has a line for each file that was written and for each that was removed again, as that
//! happens: `wrote NAME`, `removed NAME`, names within the folder. A name is on the disk before its file appears, so
//! that a run that is killed leaves no file without its name. The last line may be torn; its file never appeared. Of a run
//! that is done, `sum HASH NAME` is the BLAKE3 sum of a file, until that is written again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Component, Path, PathBuf};

use super::names::is_given;
use super::{CASE, Error, Place, file};
use crate::files::{self, Inputs};

/// The file.
const NAME: &str = "manifest.txt";
/// Its first line.
const FORMAT: &str =
    "# What archard has written here, and removes when it writes anew. Keep this file.\n";
const WROTE: &str = "wrote ";
const REMOVED: &str = "removed ";
const SUM: &str = "sum ";

/// The files of a folder that this program has written.
#[derive(Debug, Clone, Default)]
pub struct Manifest {
    dir: PathBuf,
    names: BTreeSet<String>,
    /// The sums of files that are whole, by name.
    sums: BTreeMap<String, String>,
    /// Whether the folder has a list.
    exists: bool,
    /// Files that are read and stay.
    inputs: Inputs,
}

impl Manifest {
    /// The list of a folder; empty where none exists.
    ///
    /// # Errors
    /// If it cannot be read, or another program wrote it.
    pub fn read(dir: &Path) -> Result<Self, Error> {
        let path = dir.join(NAME);
        let dir = dir.to_owned();
        match fs::symlink_metadata(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => {
                return Ok(Self { dir, ..Self::default() });
            }
            Ok(known) if known.is_symlink() => return Err(not_ours(path)),
            _ => {}
        }
        let text = match files::read_text(&path) {
            Ok(text) => text,
            Err(source) => return Err(Error::Read { path, source }),
        };
        let whole = &text[..text.rfind('\n').map_or(0, |end| end + 1)];
        let Some(lines) = whole.strip_prefix(FORMAT) else { return Err(not_ours(path)) };
        let (mut names, mut sums) = (BTreeSet::new(), BTreeMap::new());
        for line in lines.lines() {
            if let Some(name) = line.strip_prefix(WROTE) {
                names.insert(name.to_owned());
                sums.remove(name);
            } else if let Some(name) = line.strip_prefix(REMOVED) {
                names.remove(name);
                sums.remove(name);
            } else if let Some((sum, name)) =
                line.strip_prefix(SUM).and_then(|it| it.split_once(' '))
            {
                sums.insert(name.to_owned(), sum.to_owned());
            }
        }
        // Others have put there what this program never writes.
        names.retain(|name| is_within(name) && is_given(name));
        sums.retain(|name, _| names.contains(name));
        Ok(Self { dir, names, sums, exists: true, inputs: Inputs::default() })
    }

    /// The same for a command that reads these files: none of them is replaced or removed, listed or not.
    #[must_use]
    pub fn sparing(self, inputs: Inputs) -> Self {
        Self { inputs, ..self }
    }

    /// Holds the files of a run that is done, those that are still there, against the sums they were written with.
    ///
    /// # Errors
    /// If one cannot be read, or is not as it was written; it is named.
    pub fn verify(&self) -> Result<(), Error> {
        let mut there = self.sums.iter().filter(|(name, _)| self.dir.join(name).exists());
        there.try_for_each(|(name, sum)| {
            let path = self.dir.join(name);
            let found = self.find_no_links(name).and_then(|()| sum_of(&path))?;
            if found == *sum {
                return Ok(());
            }
            let why = "it is damaged or was changed: its sum is not the one in `manifest.txt`";
            Err(Error::Read { path, source: io::Error::new(ErrorKind::InvalidData, why) })
        })
    }

    /// Whether the folder has a list.
    pub(super) fn exists(&self) -> bool {
        self.exists
    }

    /// The names, in order.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// Whether a file was written by this program.
    pub(super) fn has(&self, name: &str) -> bool {
        self.names.contains(name)
    }

    /// Says whether a file of that name may be written: it was written before, or nothing stands there.
    ///
    /// # Errors
    /// If something stands there that is not listed or is read, the name leads out of the folder, or none of the program's files
    /// has it.
    pub fn admit(&self, name: &str) -> Result<Place, Error> {
        let path = self.dir.join(name);
        if !is_within(name) || !is_given(name) {
            let why = "it is no name of a file of results";
            return Err(Error::Write {
                path,
                source: io::Error::new(ErrorKind::InvalidInput, why),
            });
        }
        self.find_no_links(name)?;
        self.spare(name)?;
        match fs::symlink_metadata(&path) {
            Err(_) => Ok(Place::known(path)),
            Ok(known) if self.has(name) && !known.is_dir() => Ok(Place::known(path)),
            Ok(_) => Err(not_ours(path)),
        }
    }

    /// Says whether folders of results may be written below a folder: none of those that are there has a file that is read.
    ///
    /// # Errors
    /// If one has, which is named.
    pub fn spare_below(dir: &Path, inputs: &Inputs) -> Result<(), Error> {
        let Ok(dir) = dir.canonicalize() else { return Ok(()) };
        let found = inputs.paths().find(|path| {
            let Ok(path) = path.canonicalize() else { return false };
            let mut folders = path.ancestors().skip(1).take_while(|folder| **folder != dir);
            path.starts_with(&dir) && folders.any(|folder| folder.join(NAME).is_file())
        });
        found.map_or(Ok(()), |path| Err(Error::Input { path: path.to_owned() }))
    }

    /// Refuses to touch a file that is read.
    fn spare(&self, name: &str) -> Result<(), Error> {
        let path = self.dir.join(name);
        if self.inputs.has(&path) { Err(Error::Input { path }) } else { Ok(()) }
    }

    /// Takes a name for a file that is about to be written, and makes the folder it lies in.
    ///
    /// # Errors
    /// As [`Manifest::admit`], and if the list cannot be written.
    pub fn claim(&mut self, name: &str) -> Result<Place, Error> {
        let place = self.admit(name)?;
        if let Some((folder, _)) = name.rsplit_once('/') {
            let folder = self.dir.join(folder);
            match fs::create_dir(&folder) {
                Err(source) if !folder.is_dir() => {
                    return Err(Error::Write { path: folder, source });
                }
                _ => {}
            }
        }
        // What is written again has another sum.
        if !self.has(name) || self.sums.contains_key(name) {
            self.note(WROTE, name)?;
            self.names.insert(name.to_owned());
            self.sums.remove(name);
        }
        Ok(place)
    }

    /// Writes a file of that name; returns its path.
    ///
    /// # Errors
    /// As [`Manifest::claim`], and if it cannot be written.
    pub fn write(&mut self, name: &str, content: &[u8]) -> Result<PathBuf, Error> {
        let place = self.claim(name)?;
        place.write(content)?;
        Ok(place.into_path())
    }

    /// Removes a file, if it is listed.
    ///
    /// # Errors
    /// If it cannot be removed or the list cannot be written.
    pub(super) fn remove(&mut self, name: &str) -> Result<(), Error> {
        if !self.has(name) {
            return Ok(());
        }
        self.find_no_links(name)?;
        self.spare(name)?;
        file::remove(&self.dir.join(name))?;
        self.note(REMOVED, name)?;
        self.names.remove(name);
        self.sums.remove(name);
        Ok(())
    }

    /// Removes all files that are listed, and their folders where nothing else is in them; the list begins anew with
    /// the names of files that are about to be written.
    ///
    /// # Errors
    /// If one of these names is taken by what is not listed, which removes nothing, or a file cannot be removed or
    /// written.
    pub fn begin<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) -> Result<(), Error> {
        let next: BTreeSet<String> = names.into_iter().map(str::to_owned).collect();
        next.iter().try_for_each(|name| self.admit(name).map(|_| ()))?;
        self.names.iter().try_for_each(|name| self.find_no_links(name).and(self.spare(name)))?;
        self.remove_parts(|_| true);
        // The case goes last: a run that is killed on the way leaves no results whose case is not told.
        let (case, results): (Vec<_>, Vec<_>) = self.names.iter().partition(|name| *name == CASE);
        let mut all = results.into_iter().chain(case);
        all.try_for_each(|name| file::remove(&self.dir.join(name)))?;
        for folder in self.folders() {
            // One that holds anything else stays.
            let _ = fs::remove_dir(self.dir.join(folder));
        }
        self.names = next;
        self.sums.clear();
        fs::create_dir_all(&self.dir)
            .map_err(|source| Error::Write { path: self.dir.clone(), source })?;
        file::write_whole(&self.dir.join(NAME), self.text().as_bytes())?;
        self.exists = true;
        Ok(())
    }

    /// Writes the list of a run that is done in order, so that it does not tell how often that was interrupted, with the
    /// sum of each file.
    ///
    /// # Errors
    /// If it or a file cannot be read, or it cannot be written.
    pub(super) fn settle(&mut self) -> Result<(), Error> {
        // Others may have added to it.
        *self = Self::read(&self.dir)?.sparing(std::mem::take(&mut self.inputs));
        let there = self.names.iter().filter(|name| self.dir.join(name).is_file());
        let sums = there.map(|name| Ok((name.clone(), sum_of(&self.dir.join(name))?)));
        self.sums = sums.collect::<Result<_, Error>>()?;
        let path = self.dir.join(NAME);
        match files::read_text(&path).is_ok_and(|known| known == self.text()) {
            true => Ok(()),
            false => file::write_whole(&path, self.text().as_bytes()),
        }
    }

    /// Removes parts of files that are listed, if whoever wrote them is gone.
    pub(super) fn remove_parts(&self, gone: impl Fn(u32) -> bool) {
        for folder in self.folders().into_iter().chain([""]) {
            let own = |whole: &str| match folder {
                "" => whole == NAME || self.has(whole),
                folder => self.has(&format!("{folder}/{whole}")),
            };
            file::remove_parts(&self.dir.join(folder), &gone, own);
        }
    }

    /// The folders within the folder that listed files lie in.
    fn folders(&self) -> BTreeSet<&str> {
        self.names.iter().filter_map(|name| Some(name.rsplit_once('/')?.0)).collect()
    }

    /// Takes over files of a folder that has no list, which are known to be this program's in another way.
    pub fn adopt(&mut self, names: impl IntoIterator<Item = String>) {
        let known = names.into_iter().filter(|name| is_within(name) && is_given(name));
        self.names.extend(known.filter(|_| !self.exists));
    }

    /// Refuses a name that leads elsewhere through the link of a folder.
    fn find_no_links(&self, name: &str) -> Result<(), Error> {
        let within = Path::new(name).ancestors().skip(1).map(|folder| self.dir.join(folder));
        let link =
            within.take_while(|folder| *folder != self.dir).find(|folder| folder.is_symlink());
        link.map_or(Ok(()), |path| Err(not_ours(path)))
    }

    /// Adds a line to the list, and brings it to the disk.
    fn note(&self, what: &str, name: &str) -> Result<(), Error> {
        let path = self.dir.join(NAME);
        let mut options = OpenOptions::new();
        let list = options.read(true).append(true).create(true).open(&path);
        let added = list.and_then(|mut list| {
            if cut_to_lines(&mut list)? == 0 {
                list.write_all(self.text().as_bytes())?;
            }
            list.write_all(format!("{what}{name}\n").as_bytes())?;
            list.sync_data()
        });
        added.map_err(|source| Error::Write { path, source })
    }

    /// The list anew.
    fn text(&self) -> String {
        let lines: String = self.names.iter().map(|name| format!("{WROTE}{name}\n")).collect();
        let sum = |(name, sum): (&String, &String)| format!("{SUM}{sum} {name}\n");
        format!("{FORMAT}{lines}{}", self.sums.iter().map(sum).collect::<String>())
    }
}

/// The BLAKE3 sum of a file, in hexadecimal digits.
fn sum_of(path: &Path) -> Result<String, Error> {
    let mut hash = blake3::Hasher::new();
    let read = files::open(path).and_then(|mut file| io::copy(&mut file, &mut hash));
    read.map_err(|source| Error::Read { path: path.to_owned(), source })?;
    Ok(hash.finalize().to_hex().to_string())
}

/// Cuts off what stands behind the last whole line of a list; what is left of it (bytes).
fn cut_to_lines(list: &mut File) -> io::Result<u64> {
    let length = list.metadata()?.len();
    let mut last = [b'\n'];
    if length > 0 {
        list.seek(SeekFrom::Start(length - 1))?;
        list.read_exact(&mut last)?;
    }
    if last == [b'\n'] {
        return Ok(length);
    }
    let mut bytes = vec![];
    list.rewind()?;
    list.read_to_end(&mut bytes)?;
    let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end as u64 + 1);
    list.set_len(whole)?;
    Ok(whole)
}

fn not_ours(path: PathBuf) -> Error {
    Error::NotOurs { path, help: "" }
}

/// Whether a name is one of a file within the folder, on one line.
pub(super) fn is_within(name: &str) -> bool {
    let plain = |part: Component<'_>| matches!(part, Component::Normal(_));
    !name.is_empty() && !name.contains(char::is_control) && Path::new(name).components().all(plain)
}

#[cfg(test)]
mod tests;
