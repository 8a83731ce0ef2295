//! Copies text to the clipboard of the user's terminal, also over a network, with OSC 52.

use super::base64::base64;
use crate::wording::words;
use thiserror::Error;

/// Maximum length in base64. Many terminals drop sequences above 100,000 bytes, and some above this
/// length.
const MAX_BASE64: usize = 74_994;
/// Maximum length of a text: three bytes are four characters of base64.
const MAX_BYTES: usize = MAX_BASE64 / 4 * 3;

/// The error for a text longer than terminals accept.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{}", words().too_much_to_copy(*bytes))]
pub(crate) struct TooLarge {
    bytes: usize,
}

/// Returns the sequence that copies a text to the clipboard. The terminal does not confirm it.
pub(crate) fn sequence(text: &str) -> Result<Vec<u8>, TooLarge> {
    if text.len() > MAX_BYTES {
        return Err(TooLarge { bytes: text.len() });
    }
    Ok(format!("\x1b]52;c;{}\x1b\\", base64(text.as_bytes())).into_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clipboard_text_is_one_sequence_of_limited_size() {
        assert_eq!(sequence("60").unwrap(), b"\x1b]52;c;NjA=\x1b\\");
        let maximum = sequence(&"x".repeat(MAX_BYTES)).unwrap();
        assert!(maximum.len() - b"\x1b]52;c;\x1b\\".len() <= MAX_BASE64);
        let bytes = MAX_BYTES + 1;
        let refused = sequence(&"x".repeat(bytes)).unwrap_err();
        assert_eq!(refused, TooLarge { bytes });
        assert_eq!(refused.to_string(), "too much to copy, 56245 B");
    }
}
