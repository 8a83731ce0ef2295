//! Makes text of files safe for a terminal, and reduces krank's own text to ASCII where needed.

use crate::wording::Language;

/// Returns `true` if a character could act on a terminal or hide: controls, bidirectional marks,
/// and zero-width characters other than combining accents. Tab and line feed count as harmful here.
#[must_use]
pub fn is_harmful(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{00AD}'
            | '\u{034F}'
            | '\u{061C}'
            | '\u{115F}'..='\u{1160}'
            | '\u{17B4}'..='\u{17B5}'
            | '\u{180B}'..='\u{180F}'
            | '\u{200B}'..='\u{200F}'
            | '\u{2028}'..='\u{202E}'
            | '\u{2060}'..='\u{206F}'
            | '\u{3164}'
            | '\u{FE00}'..='\u{FE0F}'
            | '\u{FEFF}'
            | '\u{FFA0}'
            | '\u{FFF0}'..='\u{FFFB}'
            | '\u{1D173}'..='\u{1D17A}'
            | '\u{E0000}'..='\u{E0FFF}')
}

/// Returns the ASCII letter most similar to a Turkish one; `None` for other characters.
pub fn ascii_letter(c: char) -> Option<char> {
    Some(match c {
        'â' => 'a',
        'ç' => 'c',
        'ğ' => 'g',
        'ı' | 'î' => 'i',
        'ö' => 'o',
        'ş' => 's',
        'ü' | 'û' => 'u',
        'Â' => 'A',
        'Ç' => 'C',
        'Ğ' => 'G',
        'İ' | 'Î' => 'I',
        'Ö' => 'O',
        'Ş' => 'S',
        'Ü' | 'Û' => 'U',
        _ => return None,
    })
}

/// Replaces Turkish letters by similar ASCII letters, one for one; other characters stay.
pub fn with_ascii_letters(text: &str) -> String {
    text.chars().map(|c| ascii_letter(c).unwrap_or(c)).collect()
}

/// Replaces harmful characters one for one. With `ascii`, Turkish letters become similar ASCII
/// letters, and all other characters beyond ASCII become `?`.
///
/// Line feeds and tabs become spaces: this is for text of one line.
#[must_use]
pub fn sanitized(text: &str, ascii: bool) -> String {
    text.chars().map(|c| replacement(c, ascii)).collect()
}

/// Writes harmful characters as escapes (`\u{1b}`), for messages that should identify the
/// character. With `ascii`, all other characters beyond ASCII are escaped too.
///
/// Line feeds and tabs become spaces. If the current language is Turkish, `ascii` reduces its
/// letters to similar ASCII letters instead, because messages contain them; but not between
/// backticks, which quote the file.
pub(crate) fn escaped(text: &str, ascii: bool) -> String {
    let mut out = String::with_capacity(text.len());
    let is_turkish = Language::current_language() == Language::Turkish;
    let mut is_quoted = false;
    for c in text.chars() {
        is_quoted ^= c == '`';
        let plain = replacement(c, ascii);
        let is_own_letter = is_turkish && !is_quoted && ascii_letter(c).is_some();
        if plain == c || c == '\t' || c == '\n' || is_own_letter {
            out.push(plain);
        } else {
            out.extend(c.escape_unicode());
        }
    }
    out
}

/// Returns the replacement of a character; a harmless one stays unchanged.
pub(crate) fn replacement(c: char, ascii: bool) -> char {
    match c {
        '\t' | '\n' => ' ',
        _ if c.is_ascii() && !c.is_ascii_control() => c,
        _ if ascii => ascii_letter(c).unwrap_or('?'),
        _ if is_harmful(c) => char::REPLACEMENT_CHARACTER,
        _ => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sanitized_replaces_each_harmful_character() {
        let hostile = "a\u{1b}[2J\u{202e}b\u{200b}\r\u{9b}\u{e0041}c";
        let shown = sanitized(hostile, false);
        assert_eq!(shown.chars().count(), hostile.chars().count());
        assert!(!shown.chars().any(is_harmful), "{shown:?}");
        assert_eq!(sanitized(hostile, true), "a?[2J?b????c");
    }

    #[test]
    fn escaped_shows_code_points_or_ascii_letters() {
        assert_eq!(escaped("a\u{1b}[2J\n\u{d6}", false), "a\\u{1b}[2J \u{d6}");
        assert_eq!(escaped("\u{d6}", true), "\\u{d6}");
        Language::Turkish.speak();
        assert_eq!(escaped("`\u{d6}` ad\u{131}", true), "`\\u{d6}` adi");
        assert_eq!(
            escaped("\u{d6}l\u{e7}\u{fc} \u{3b8}", true),
            "Olcu \\u{3b8}"
        );
    }

    #[test]
    fn turkish_letters_become_similar_ascii_letters() {
        let all = "ç ğ ı i ö ş ü Ç Ğ I İ Ö Ş Ü â î û";
        assert_eq!(sanitized(all, true), "c g i i o s u C G I I O S U a i u");
        assert_eq!(with_ascii_letters(all), sanitized(all, true));
        assert_eq!(with_ascii_letters("θ → ─"), "θ → ─");
    }

    #[test]
    fn sanitized_keeps_ordinary_unicode_text() {
        let turkish = "Krank-biyel mekanizması, θ3 = 29°";
        assert_eq!(sanitized(turkish, false), turkish);
        assert_eq!(
            sanitized(turkish, true),
            "Krank-biyel mekanizmasi, ?3 = 29?"
        );
    }
}
