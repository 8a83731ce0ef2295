//! Translates the messages of the command-line parser and of the system, part by part.

use std::fmt::Display;

/// Translates a message of the command-line parser.
pub(super) fn translate_message(text: &str) -> String {
    OF_PARSER
        .iter()
        .fold(text.to_owned(), |text, (english, turkish)| {
            replaced(&text, english, turkish)
        })
}

/// Replaces every occurrence of a part in the text. If the parser has broken a line inside a part, the line break
/// moves before the part.
fn replaced(text: &str, part: &str, by: &str) -> String {
    let mut message = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((at, length)) = found(rest, part) {
        let there = &rest[at..at + length];
        message.push_str(&rest[..at]);
        match there.trim_end().find('\n') {
            None => message.push_str(by),
            Some(end) => {
                let after = &there[end..];
                let blanks = after.len() - after.trim_start().len();
                message.truncate(message.trim_end_matches(' ').len());
                message.push_str(&after[..blanks]);
                message.push_str(by);
            }
        }
        rest = &rest[at + length..];
    }
    message + rest
}

/// Returns the position of a part and its length there: a blank in it may match a line break and an indent.
fn found(text: &str, part: &str) -> Option<(usize, usize)> {
    let mut places = text.char_indices();
    places.find_map(|(at, _)| Some((at, length_of(&text[at..], part)?)))
}

/// Returns the length of the part at the start of the text, or `None` if the text starts differently.
fn length_of(text: &str, part: &str) -> Option<usize> {
    let mut rest = text;
    for (at, c) in part.char_indices() {
        rest = match rest.strip_prefix(c) {
            Some(after) => after,
            None if c == ' ' && !part[..at].trim().is_empty() => {
                rest.strip_prefix('\n')?.trim_start_matches(' ')
            }
            None => return None,
        };
    }
    Some(text.len() - rest.len())
}

/// Translates an error message of the system.
pub(super) fn of_system(why: &dyn Display) -> String {
    let why = why.to_string();
    let known = OF_SYSTEM
        .iter()
        .find(|(english, _)| why.starts_with(english));
    let Some((english, turkish)) = known else {
        return why;
    };
    let rest = &why[english.len()..];
    format!("{turkish}{}", rest.replace("(os error ", "(hata "))
}

const OF_PARSER: [(&str, &str); 49] = [
    ("Usage: ", "Kullanım: "),
    ("Commands:\n", "Komutlar:\n"),
    ("Arguments:\n", "Argümanlar:\n"),
    ("Options:\n", "Seçenekler:\n"),
    ("Possible values:", "Değerler:"),
    ("[possible values: ", "[değerler: "),
    ("[default: ", "[yoksa: "),
    ("[aliases: ", "[öteki adı: "),
    ("[subcommands: ", "[komutlar: "),
    (
        "Print help (see a summary with '-h')",
        "Yardımı yazın (özeti: '-h')",
    ),
    (
        "Print help (see more with '--help')",
        "Yardımı yazın (ayrıntısı: '--help')",
    ),
    ("Print help", "Yardımı yazın"),
    ("Print version", "Sürümü yazın"),
    ("error: ", "hata: "),
    ("  tip: ", "  ipucu: "),
    (
        "For more information, try '--help'.",
        "Ayrıntılı bilgi için: '--help'.",
    ),
    (
        "the following required arguments were not provided:",
        "şu zorunlu argümanlar verilmemiş:",
    ),
    ("unexpected argument '", "beklenmeyen argüman '"),
    ("unexpected value '", "beklenmeyen değer '"),
    ("' found; no more were expected", "', fazla argüman"),
    ("' found\n", "'\n"),
    ("invalid value '", "geçersiz değer '"),
    ("unrecognized subcommand '", "bilinmeyen komut '"),
    ("a value is required for '", "değer eksik: '"),
    ("' but none was supplied", "'"),
    (
        "equal sign is needed when assigning values to '",
        "değerden önce = gerekir: '",
    ),
    (
        "invalid UTF-8 was detected in one or more arguments",
        "bir argüman UTF-8 değil",
    ),
    ("' for '", "', yeri '"),
    (
        "' cannot be used multiple times",
        "' bir kereden çok verilemez",
    ),
    (
        "' cannot be used with one or more of the other specified arguments",
        "' verilen öteki argümanlarla birlikte kullanılamaz",
    ),
    (
        "' cannot be used with:\n",
        "' şunlarla birlikte kullanılamaz:\n",
    ),
    (
        "' cannot be used with '",
        "' şununla birlikte kullanılamaz: '",
    ),
    (
        "' requires a subcommand but one was not provided",
        "' için bir komut gerekir",
    ),
    ("the argument '", "argüman '"),
    ("the subcommand '", "komut '"),
    ("a similar argument exists: ", "benzer bir argüman var: "),
    ("a similar subcommand exists: ", "benzer bir komut var: "),
    ("a similar value exists: ", "benzer bir değer var: "),
    ("some similar arguments exist: ", "benzer argümanlar var: "),
    ("some similar subcommands exist: ", "benzer komutlar var: "),
    ("some similar values exist: ", "benzer değerler var: "),
    (
        "' exists; to use it, remove the '--' before it",
        "' var; önündeki '--' olmadan yazın",
    ),
    (" is not in ", " şu aralıkta değil: "),
    (": invalid digit found in string", ": tam sayı değil"),
    (": cannot parse integer from empty string", ": sayı yok"),
    (
        ": number too large to fit in target type",
        ": sayı çok büyük",
    ),
    (
        ": number too small to fit in target type",
        ": sayı çok küçük",
    ),
    (": invalid float literal", ": sayı değil"),
    (
        "a value is required but none was supplied",
        "bir değer gerekir",
    ),
];

const OF_SYSTEM: [(&str, &str); 20] = [
    (
        "No such file or directory",
        "böyle bir dosya ya da klasör yok",
    ),
    ("Permission denied", "izin yok"),
    ("Operation not permitted", "işleme izin yok"),
    ("Is a directory", "bu bir klasör"),
    ("Not a directory", "klasör değil"),
    ("Directory not empty", "klasör boş değil"),
    ("File exists", "dosya zaten var"),
    ("File too large", "dosya çok büyük"),
    ("File name too long", "dosyanın adı çok uzun"),
    ("No space left on device", "diskte yer yok"),
    ("Disk quota exceeded", "disk kotası dolu"),
    ("Read-only file system", "dosya sistemi salt okunur"),
    ("Input/output error", "giriş/çıkış hatası"),
    (
        "Too many levels of symbolic links",
        "çok fazla iç içe sembolik bağ",
    ),
    ("Too many open files", "çok fazla açık dosya var"),
    ("Device or resource busy", "aygıt meşgul"),
    ("Text file busy", "dosya çalışan bir program"),
    ("No such device", "böyle bir aygıt yok"),
    ("Broken pipe", "kopuk boru hattı"),
    ("stream did not contain valid UTF-8", "metin UTF-8 değil"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_is_translated_and_wrapped_parts_are_rejoined() {
        assert_eq!(
            translate_message(
                "  --language  Dil [default: auto] [possible\n      values: tr, en]\n"
            ),
            "  --language  Dil [yoksa: auto]\n      [değerler: tr, en]\n"
        );
        assert_eq!(
            translate_message("x\n\n  tip: ş is not in 1"),
            "x\n\n  ipucu: ş şu aralıkta değil: 1"
        );
        assert_eq!(translate_message("Print help\n"), "Yardımı yazın\n");
        assert_eq!(
            translate_message("Usage: x\n\nOptions:\n  -h"),
            "Kullanım: x\n\nSeçenekler:\n  -h"
        );
    }

    #[test]
    fn system_errors_are_translated_with_their_number() {
        let missing = std::io::Error::from_raw_os_error(2);
        assert_eq!(
            of_system(&missing),
            "böyle bir dosya ya da klasör yok (hata 2)"
        );
        assert_eq!(of_system(&"no matter"), "no matter");
    }
}
