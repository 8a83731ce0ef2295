//! Decodes text files written by spreadsheets.

use std::borrow::Cow;

/// The encoding of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TextEncoding {
    /// UTF-8, with or without byte order mark.
    #[default]
    Utf8,
    /// UTF-16 with byte order mark.
    Utf16,
    /// The Turkish code page of Windows, a superset of ISO 8859-9.
    Windows1254,
}

impl TextEncoding {
    /// Returns the registered name of the encoding.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            TextEncoding::Utf8 => "utf-8",
            TextEncoding::Utf16 => "utf-16",
            TextEncoding::Windows1254 => "windows-1254",
        }
    }
}

/// Decodes a text: UTF-16 if it has a byte order mark, UTF-8 if it is valid, or else windows-1254.
pub(in crate::report) fn decoded(bytes: &[u8]) -> (Cow<'_, str>, TextEncoding) {
    let unit: fn([u8; 2]) -> u16 = match bytes {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        _ => {
            return match str::from_utf8(bytes) {
                Ok(text) => (text.into(), TextEncoding::Utf8),
                Err(_) => {
                    let text: String = bytes.iter().map(|&byte| of_windows_1254(byte)).collect();
                    (text.into(), TextEncoding::Windows1254)
                }
            };
        }
    };
    let (pairs, _) = bytes.as_chunks();
    let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
    (String::from_utf16_lossy(&units).into(), TextEncoding::Utf16)
}

/// Bytes 0x80 to 0x9f of windows-1254. ISO 8859-9 has control characters there, which spreadsheets
/// do not write.
const FROM_80: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', '\u{8e}',
    '\u{8f}', '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}',
    '\u{9e}', 'Ÿ',
];

/// Decodes a byte: Latin-1 with six Turkish letters and the block above.
fn of_windows_1254(byte: u8) -> char {
    match byte {
        0x80..=0x9f => FROM_80[usize::from(byte - 0x80)],
        0xd0 => 'Ğ',
        0xdd => 'İ',
        0xde => 'Ş',
        0xf0 => 'ğ',
        0xfd => 'ı',
        0xfe => 'ş',
        other => char::from(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_1254_letters_are_decoded() {
        let bytes =
            b"\xd6\xf0renci: Ay\xfee \xdd\xfe\xe7i, 38\xb0, \x93\xd0\xdeI\xfd\x94 \x96 5 m/s\xb2";
        let (text, encoding) = decoded(bytes);
        assert_eq!(text, "Öğrenci: Ayşe İşçi, 38°, “ĞŞIı” – 5 m/s²");
        assert_eq!(encoding.name(), "windows-1254");
    }

    #[test]
    fn valid_utf8_and_utf16_are_recognized() {
        let text = "Ayşe \u{b0}";
        assert_eq!(decoded(text.as_bytes()), (text.into(), TextEncoding::Utf8));
        assert_eq!(decoded(b""), ("".into(), TextEncoding::Utf8));
        let marked = format!("\u{feff}{text}");
        let bytes: Vec<u8> = marked.encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(decoded(&bytes), (marked.into(), TextEncoding::Utf16));
    }
}
