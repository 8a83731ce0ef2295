//! What the parser of the command line and the system say by themselves, part by part.

use std::fmt::Display;

/// What the parser says, in Turkish.
pub(super) fn said(text: &str) -> String {
    OF_PARSER
        .iter()
        .fold(text.to_owned(), |text, (english, turkish)| {
            replaced(&text, english, turkish)
        })
}

/// The text with every part of it replaced; where the parser has broken a line in the midst of one, the line is
/// broken before it.
fn replaced(text: &str, part: &str, by: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((at, length)) = found(rest, part) {
        let there = &rest[at..at + length];
        said.push_str(&rest[..at]);
        match there.trim_end().find('\n') {
            None => said.push_str(by),
            Some(end) => {
                let behind = &there[end..];
                let blanks = behind.len() - behind.trim_start().len();
                said.truncate(said.trim_end_matches(' ').len());
                said.push_str(&behind[..blanks]);
                said.push_str(by);
            }
        }
        rest = &rest[at + length..];
    }
    said + rest
}

/// Where a part stands, and how long it is there: a blank of it may be the end of a line, and what indents the next.
fn found(text: &str, part: &str) -> Option<(usize, usize)> {
    let mut places = text.char_indices();
    places.find_map(|(at, _)| Some((at, length_of(&text[at..], part)?)))
}

/// How much of the text the part takes with which it begins.
fn length_of(text: &str, part: &str) -> Option<usize> {
    let mut rest = text;
    for (at, c) in part.char_indices() {
        rest = match rest.strip_prefix(c) {
            Some(behind) => behind,
            None if c == ' ' && !part[..at].trim().is_empty() => {
                rest.strip_prefix('\n')?.trim_start_matches(' ')
            }
            None => return None,
        };
    }
    Some(text.len() - rest.len())
}

/// Why the system did not do what it was asked for.
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
        "Yardımı yaz (özeti: '-h')",
    ),
    (
        "Print help (see more with '--help')",
        "Yardımı yaz (fazlası: '--help')",
    ),
    ("Print help", "Yardımı yaz"),
    ("Print version", "Sürümü yaz"),
    ("error: ", "hata: "),
    ("  tip: ", "  ipucu: "),
    ("For more information, try '--help'.", "Fazlası: '--help'."),
    (
        "the following required arguments were not provided:",
        "şu zorunlu argümanlar verilmemiş:",
    ),
    ("unexpected argument '", "beklenmeyen argüman '"),
    ("unexpected value '", "beklenmeyen değer '"),
    ("' found; no more were expected", "', fazlası olmaz"),
    ("' found\n", "'\n"),
    ("invalid value '", "geçersiz değer '"),
    ("unrecognized subcommand '", "bilinmeyen komut '"),
    ("a value is required for '", "değeri verilmemiş: '"),
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
        "' verilen öteki argümanlarla birlikte olmaz",
    ),
    ("' cannot be used with:\n", "' şunlarla birlikte olmaz:\n"),
    ("' cannot be used with '", "' şununla birlikte olmaz: '"),
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
        "' var; önündeki '--' olmadan yaz",
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
    ("Operation not permitted", "buna izin yok"),
    ("Is a directory", "bu bir klasör"),
    ("Not a directory", "klasör olması gereken bir dosya"),
    ("Directory not empty", "klasör boş değil"),
    ("File exists", "dosya var"),
    ("File too large", "dosya çok büyük"),
    ("File name too long", "dosyanın adı çok uzun"),
    ("No space left on device", "diskte yer yok"),
    ("Disk quota exceeded", "diskteki pay dolu"),
    ("Read-only file system", "disk yalnız okunabilir"),
    ("Input/output error", "aygıt okuma ya da yazma hatası verdi"),
    (
        "Too many levels of symbolic links",
        "sembolik bağlar bir döngü",
    ),
    ("Too many open files", "çok fazla açık dosya var"),
    ("Device or resource busy", "aygıt meşgul"),
    ("Text file busy", "program olarak çalışan bir dosya"),
    ("No such device", "böyle bir aygıt yok"),
    ("Broken pipe", "okuyan kalmadı"),
    ("stream did not contain valid UTF-8", "metin UTF-8 değil"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_broken_within_a_part_is_broken_before_it() {
        assert_eq!(
            said("  --language  Dil [default: auto] [possible\n      values: tr, en]\n"),
            "  --language  Dil [yoksa: auto]\n      [değerler: tr, en]\n"
        );
        assert_eq!(
            said("x\n\n  tip: ş is not in 1"),
            "x\n\n  ipucu: ş şu aralıkta değil: 1"
        );
        assert_eq!(said("Print help\n"), "Yardımı yaz\n");
        assert_eq!(
            said("Usage: x\n\nOptions:\n  -h"),
            "Kullanım: x\n\nSeçenekler:\n  -h"
        );
    }

    #[test]
    fn what_the_system_says_keeps_its_number() {
        let missing = std::io::Error::from_raw_os_error(2);
        assert_eq!(
            of_system(&missing),
            "böyle bir dosya ya da klasör yok (hata 2)"
        );
        assert_eq!(of_system(&"no matter"), "no matter");
    }
}
