//! What a file is beside its text: owner, group, mode and extended attributes, among them access lists.

use rustix::fs::{
    Gid, Mode, RawMode, Uid, XattrFlags, fchmod, fchown, fgetxattr, flistxattr, fremovexattr,
    fsetxattr, fstat,
};
use rustix::io::Errno;
use std::ffi::{CStr, CString};
use std::fs::{File, Metadata};
use std::os::unix::fs::MetadataExt;

/// The longest list of names, and the longest attribute, that Linux has.
const LONGEST: usize = 1 << 16;
/// Bits of a mode: who may do what, and the three above.
const MODE: RawMode = 0o7777;

/// Gives a new file what another has.
///
/// # Errors
/// What the system does not let us give it. The new file is then not the other one in all but its text.
pub(super) fn carry_over(old: &File, has: &Metadata, new: &File) -> Result<(), Errno> {
    let now = new.metadata().map_err(|_| Errno::IO)?;
    if (now.uid(), now.gid()) != (has.uid(), has.gid()) {
        let (owner, group) = (Uid::from_raw(has.uid()), Gid::from_raw(has.gid()));
        fchown(new, Some(owner), Some(group))?;
    }
    carry_attributes(old, new)?;
    // Last, since another owner takes bits away.
    fchmod(new, Mode::from_raw_mode(fstat(old)?.st_mode & MODE))
}

fn carry_attributes(old: &File, new: &File) -> Result<(), Errno> {
    let (wanted, given) = (names(old)?, names(new)?);
    for name in &wanted {
        let value = attribute(old, name)?;
        if attribute(new, name).as_ref() != Ok(&value) {
            fsetxattr(new, name, &value, XattrFlags::empty())?;
        }
    }
    // A folder may give what is made in it an access list that the old file has not.
    for name in given.iter().filter(|name| !wanted.contains(name)) {
        match fremovexattr(new, name) {
            // What the system itself attaches stays where it likes.
            Err(_) if name.to_bytes().starts_with(b"security.") => {}
            done => done?,
        }
    }
    Ok(())
}

/// The names of a file's attributes; none where the disk knows no such thing.
fn names(file: &File) -> Result<Vec<CString>, Errno> {
    let mut list = vec![0; LONGEST];
    let length = match flistxattr(file, &mut list[..]) {
        Ok(length) => length,
        Err(Errno::NOTSUP | Errno::NOSYS) => 0,
        Err(error) => return Err(error),
    };
    let names = list[..length].split_inclusive(|byte| *byte == 0);
    let names = names.filter_map(|name| CStr::from_bytes_with_nul(name).ok());
    Ok(names.map(CStr::to_owned).collect())
}

fn attribute(file: &File, name: &CStr) -> Result<Vec<u8>, Errno> {
    let mut value = vec![0; LONGEST];
    let length = fgetxattr(file, name, &mut value[..])?;
    value.truncate(length);
    Ok(value)
}
