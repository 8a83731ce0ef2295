//! Copies the metadata of files: owner, group, mode and extended attributes, including access
//! control lists.

use rustix::fs::{
    Gid, Mode, RawMode, Uid, XattrFlags, fchmod, fchown, fgetxattr, flistxattr, fremovexattr,
    fsetxattr, fstat,
};
use rustix::io::Errno;
use std::ffi::{CStr, CString};
use std::fs::{File, Metadata};
use std::os::unix::fs::MetadataExt;

/// Maximum size in bytes of the list of names, and of an attribute, in Linux.
const MAX_LEN: usize = 1 << 16;
/// The permission bits of a mode, and the three above them.
const MODE: RawMode = 0o7777;

/// Copies the metadata of a file to a new one.
///
/// # Errors
/// Returns an error if the system does not permit it. The new file then differs from the other in
/// more than its text.
pub(super) fn carry_over(old: &File, has: &Metadata, new: &File) -> Result<(), Errno> {
    let now = new.metadata().map_err(|_| Errno::IO)?;
    if (now.uid(), now.gid()) != (has.uid(), has.gid()) {
        let (owner, group) = (Uid::from_raw(has.uid()), Gid::from_raw(has.gid()));
        fchown(new, Some(owner), Some(group))?;
    }
    carry_attributes(old, new)?;
    // The mode is set last, because a change of owner clears bits.
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
    // A folder may give its new files an access control list that the old file does not have.
    for name in given.iter().filter(|name| !wanted.contains(name)) {
        match fremovexattr(new, name) {
            // Attributes attached by the system itself stay.
            Err(_) if name.to_bytes().starts_with(b"security.") => {}
            done => done?,
        }
    }
    Ok(())
}

/// Returns the names of a file's attributes; empty if the file system does not support any.
fn names(file: &File) -> Result<Vec<CString>, Errno> {
    let mut list = vec![0; MAX_LEN];
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
    let mut value = vec![0; MAX_LEN];
    let length = fgetxattr(file, name, &mut value[..])?;
    value.truncate(length);
    Ok(value)
}
