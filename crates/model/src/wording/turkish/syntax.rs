//! Translates the messages of the TOML parser.

/// Separators: between the error and the expected items, and between two expected items.
const EXPECTED: &str = ", expected ";
const OR: &str = ", ";

/// Translates a message. An unknown message is quoted unchanged, because a partial translation would mislead.
pub(super) fn translate_message(message: &str) -> String {
    let (fault, mut expected) = match message.split_once(EXPECTED) {
        Some((fault, expected)) => (fault, Some(expected)),
        None => (message, None),
    };
    // The parser reports an unclosed text as an error at the end of its line.
    match (fault, expected) {
        ("invalid basic string", Some("`\"`")) => return "kapanmamış metin: `\"` eksik".to_owned(),
        ("invalid literal string", Some("`'`")) => return "kapanmamış metin: `'` eksik".to_owned(),
        // Both kinds of quotes are allowed.
        ("string values must be quoted", _) => expected = None,
        (fault, _) if OF_DATES.iter().any(|of| fault.starts_with(of)) => {
            return "geçersiz tarih ya da saat".to_owned();
        }
        _ => {}
    }
    let Some(fault) = wrong(fault) else {
        return format!("TOML okuyucusunun iletisi: \"{message}\"");
    };
    match expected.map(wanted) {
        None => fault,
        Some(wanted) => format!("{fault}; beklenen: {wanted}"),
    }
}

fn wrong(fault: &str) -> Option<String> {
    if fault.starts_with("cannot extend value of type") {
        return Some("değeri olan bir anahtarın noktayla uzantısı olamaz".to_owned());
    }
    let (_, text) = FAULTS.iter().find(|(english, _)| *english == fault)?;
    Some((*text).to_owned())
}

/// Translates the expected items: symbols stay, names of text kinds are translated.
fn wanted(expected: &str) -> String {
    let items = expected.split(OR);
    let items = items.map(|item| {
        let known = WANTED.iter().find(|(english, _)| *english == item);
        known.map_or(item, |(_, text)| *text)
    });
    items.collect::<Vec<_>>().join(OR)
}

/// The starts of messages about dates, which share one translation: a scene has no dates.
const OF_DATES: [&str; 4] = [
    "invalid date",
    "invalid time",
    "invalid offset",
    "invalid local",
];

const FAULTS: [(&str, &str); 67] = [
    (
        "`_` may only go between digits",
        "`_` yalnız rakamların arasında bulunabilir",
    ),
    (
        "cannot recurse further; max recursion depth met",
        "listeler ve tablolar çok fazla iç içe",
    ),
    (
        "carriage return must be followed by newline",
        "satır başı (CR) tek başına satır sonu değildir",
    ),
    ("duplicate key", "anahtar iki kez verilmiş"),
    ("extra `=`", "fazladan `=`"),
    (
        "extra assignment between key-value pairs",
        "anahtar ile değer arasında fazladan `=`",
    ),
    ("extra comma in array", "listede fazladan virgül"),
    ("extra comma in inline table", "tabloda fazladan virgül"),
    (
        "integers with a radix cannot be signed",
        "0x, 0o ve 0b ile yazılan sayılar işaretsizdir",
    ),
    ("invalid array", "geçersiz liste"),
    ("invalid basic string", "geçersiz metin"),
    ("invalid binary number", "geçersiz ikilik sayı"),
    ("invalid boolean", "geçersiz true ya da false"),
    ("invalid comment character", "açıklamada geçersiz karakter"),
    ("invalid exponent", "sayının üssü geçersiz"),
    ("invalid float", "geçersiz sayı"),
    ("invalid fraction", "sayının kesri geçersiz"),
    ("invalid hexadecimal number", "geçersiz onaltılık sayı"),
    ("invalid inline table element", "tabloda geçersiz öge"),
    ("invalid integer number", "geçersiz tam sayı"),
    ("invalid key", "geçersiz anahtar"),
    ("invalid key-value pair", "geçersiz anahtar ve değer"),
    ("invalid literal string", "geçersiz tek tırnaklı metin"),
    ("invalid mantissa", "geçersiz sayı"),
    (
        "invalid multi-line basic string",
        "geçersiz çok satırlı metin",
    ),
    (
        "invalid multi-line literal string",
        "geçersiz çok satırlı tek tırnaklı metin",
    ),
    ("invalid newline", "geçersiz satır sonu"),
    ("invalid octal number", "geçersiz sekizlik sayı"),
    ("invalid string", "geçersiz metin"),
    ("invalid table", "geçersiz tablo"),
    ("invalid unquoted key", "geçersiz tırnaksız anahtar"),
    ("invalid value", "geçersiz değer"),
    ("key with no value", "değersiz anahtar"),
    (
        "keys cannot be multi-line basic strings",
        "anahtar çok satırlı bir metin olamaz",
    ),
    (
        "keys cannot be multi-line literal strings",
        "anahtar çok satırlı bir metin olamaz",
    ),
    ("missing array opening", "listenin başı eksik"),
    (
        "missing assignment between key-value pairs",
        "anahtar ile değer arasında `=` eksik",
    ),
    (
        "missing comma between array elements",
        "listenin ögeleri arasında virgül eksik",
    ),
    (
        "missing comma between key-value pairs",
        "anahtarlar arasında virgül eksik",
    ),
    ("missing comment start", "açıklamanın başı eksik"),
    ("missing escaped value", "`\\` ardında karakter eksik"),
    ("missing inline table opening", "tablonun başı eksik"),
    (
        "missing key for inline table element",
        "tablonun bir ögesinde anahtar eksik",
    ),
    ("missing opening quote", "açılış tırnağı eksik"),
    ("missing table open", "bölümün başı eksik"),
    ("missing value", "değer eksik"),
    ("missing value for key", "anahtarın değeri eksik"),
    ("number too large to fit in target type", "sayı çok büyük"),
    ("out of range unicode value", "Unicode'da olmayan karakter"),
    (
        "radix must be lowercase",
        "0x, 0o ve 0b küçük harfle yazılır",
    ),
    (
        "redundant integer number prefix",
        "tam sayının fazladan öneki",
    ),
    ("redundant numeric sign", "sayının fazladan işareti"),
    (
        "string values must be quoted",
        "metinler tırnak içinde yazılır",
    ),
    (
        "too few unicode value digits",
        "Unicode karakterinde eksik rakam",
    ),
    ("unclosed array", "kapanmamış liste"),
    ("unclosed array table", "kapanmamış [[bölüm]]"),
    ("unclosed inline table", "kapanmamış tablo"),
    ("unclosed table", "kapanmamış [bölüm]"),
    ("unexpected `=` in array", "listede beklenmeyen `=`"),
    ("unexpected content", "beklenmeyen metin"),
    (
        "unexpected content between comment and newline",
        "açıklamanın ardında beklenmeyen metin",
    ),
    ("unexpected key or value", "beklenmeyen anahtar ya da değer"),
    ("unexpected leading zero", "sayının başında fazladan sıfır"),
    ("unexpected sign", "beklenmeyen işaret"),
    (
        "unquoted keys cannot be empty",
        "tırnaksız anahtar boş olamaz",
    ),
    ("invalid unicode value", "geçersiz Unicode karakteri"),
    ("invalid escape sequence", "geçersiz `\\` dizisi"),
];

const WANTED: [(&str, &str); 17] = [
    ("basic string", "metin"),
    ("characters", "karakter"),
    ("digits", "rakam"),
    ("etc", "vb."),
    ("key", "anahtar"),
    ("letters", "harf"),
    ("literal string", "tek tırnaklı metin"),
    ("multi-line basic string", "çok satırlı metin"),
    ("newline", "satır sonu"),
    (
        "non-double-quote visible characters",
        "`\"` dışında görünür karakter",
    ),
    ("non-single-quote characters", "`'` dışında karakter"),
    (
        "non-single-quote visible characters",
        "`'` dışında görünür karakter",
    ),
    ("nothing", "hiçbir şey"),
    ("numbers", "rakam"),
    ("printable characters", "görünür karakter"),
    ("unicode hexadecimal value", "onaltılık Unicode değeri"),
    ("value", "değer"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use toml::de::DeTable;

    /// Returns the parser's message for a text, and its translation.
    fn parser_message(text: &str) -> (String, String) {
        let (_, errors) = DeTable::parse_recoverable(text);
        let message = errors[0].message().to_owned();
        let turkish = translate_message(&message);
        (message, turkish)
    }

    /// There is no list of all messages of the parser. These are common mistakes of users and
    /// editors.
    #[test]
    fn common_syntax_errors_are_translated() {
        for text in [
            "a = \"open",
            "a = 'open",
            "a = [1, 2",
            "a = { b = 1",
            "[a",
            "[[a",
            "a",
            "a =",
            "a = b",
            "a 1",
            "a = 1\na = 2",
            "a = 1 2",
            "a = [1 2]",
            "a = [1,,2]",
            "a = { b = 1 c = 2 }",
            "a = 01",
            "a = 1__0",
            "a = 0xg",
            "a = 1e",
            "a = 1.",
            "a = --1",
            "a = +-1",
            "= 1",
            "a = = 1",
            "a == 1",
            "'a = 1",
            "a = 0X1",
            "a = \"\\q\"",
            "a = \"\\u12\"",
            "a = \"\\uD800\"",
            "a = 2026-99-99",
            "a = tru",
            "a = 1\rb = 2",
            "# \u{1}",
            "a = \"\u{1}\"",
            "a = '\u{1}'",
            "a = \"\"\"x",
            "a = '''x",
            "a = [1 = 2]",
            "a.b = 1\na.b.c = 2",
            "a = { b = 1 }\na.c = 2",
            "a = [1]\na.c = 2",
            "// no",
            "\u{e9} = 1",
            "a = 1 b = 2",
            "a = [b]",
            "a = -0x1",
            "\"\"\"a\"\"\" = 1",
            "a = ,",
            "]",
            "}",
            "a = }",
            "a = ]",
            "[a]]",
            "[a] b",
            "[]",
            "[a.]",
            "a. = 1",
            "a = .5",
            "a = \u{b5}",
            "a = 1,5",
            "a = 10 mm",
            "a = \"x\" y",
        ] {
            let (message, turkish) = parser_message(text);
            assert!(!turkish.contains(&message), "{text:?}: {message}");
            assert!(!turkish.contains(" expected "), "{text:?}: {turkish}");
            let wanted = message.split_once(EXPECTED).map(|(_, wanted)| wanted);
            let wanted = wanted.filter(|_| turkish.contains("beklenen"));
            for item in wanted.into_iter().flat_map(|items| items.split(OR)) {
                let known = WANTED.iter().any(|(english, _)| *english == item);
                assert!(known || item.starts_with('`'), "{text:?}: {item}");
            }
        }
        assert_eq!(
            parser_message("a = [1,,2]").1,
            "listede fazladan virgül; beklenen: değer"
        );
        assert_eq!(
            parser_message("a = [1, 2").1,
            "kapanmamış liste; beklenen: `]`"
        );
    }

    #[test]
    fn unknown_parser_message_is_quoted() {
        assert_eq!(
            translate_message("a new rule"),
            "TOML okuyucusunun iletisi: \"a new rule\""
        );
    }
}
