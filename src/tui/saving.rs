//! Saving the assembly that is shown: `[start]` in the scene's file, or in a new one.

use super::Origin;
use super::stage::Stage;
use crate::replace::replace_file;
use crate::scene::Scene;
use std::fs;
use std::io;
use std::path::Path;

/// What some editors put in front of a text.
const BYTE_ORDER_MARK: &str = "\u{feff}";

/// Writes the scene with this assembly's start positions to a file, which is then the scene's own. What
/// was done, or why nothing was, in words.
pub(crate) fn save(stage: &mut Stage, to: &Path) -> Result<String, String> {
    let text = stage.saved_text();
    let text = text.ok_or("no start positions tell this assembly from the others here")?;
    let name = to.display().to_string();
    let own = matches!(stage.origin(), Origin::File(own) if own == to);
    let mark = if own {
        mark_kept(stage, to, &name)?
    } else {
        ""
    };
    let bytes = format!("{mark}{text}");
    replace_file(to, bytes.as_bytes()).map_err(|e| cannot("write", &name, &e))?;
    // It was read back before it was given.
    if let Ok(scene) = Scene::parse(&text, &name) {
        stage.rename(scene, to.to_owned());
    }
    Ok(format!("written to {name}"))
}

/// The byte order mark of the scene's own file, which must not have changed since it was opened: what
/// somebody wrote meanwhile would be lost.
fn mark_kept(stage: &Stage, file: &Path, name: &str) -> Result<&'static str, String> {
    let now = match fs::read_to_string(file) {
        Ok(now) => now,
        // It was taken away: there is nothing to lose.
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(""),
        Err(e) => return Err(cannot("read", name, &e)),
    };
    let (mark, text) = match now.strip_prefix(BYTE_ORDER_MARK) {
        Some(text) => (BYTE_ORDER_MARK, text),
        None => ("", now.as_str()),
    };
    if text == stage.scene().text() {
        Ok(mark)
    } else {
        Err(format!("not written: {name} has changed since"))
    }
}

fn cannot(what: &str, name: &str, error: &io::Error) -> String {
    format!("cannot {what} {name}: {error}")
}
