//! Splits internet addresses into their parameters.

/// Returns the parameters of an address, decoded, in their order.
pub(super) fn parameters(address: &str) -> Vec<(String, String)> {
    let Some((_, query)) = address.split_once('?') else {
        return Vec::new();
    };
    let query = query.split_once('#').map_or(query, |(query, _)| query);
    let parts = query.split('&').filter(|part| !part.is_empty());
    parts
        .map(|part| {
            let (name, value) = part.split_once('=').unwrap_or(("", part));
            (decoded(name), decoded(value))
        })
        .collect()
}

/// Replaces `%7C` and other encoded characters. Bytes that are not UTF-8 become U+FFFD.
fn decoded(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut found = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while let Some(&byte) = bytes.get(i) {
        let digit = |at: usize| {
            bytes
                .get(at)
                .and_then(|&byte| char::from(byte).to_digit(16))
        };
        match (byte, digit(i + 1), digit(i + 2)) {
            (b'%', Some(high), Some(low)) => {
                found.push(u8::try_from(16 * high + low).unwrap_or(b'?'));
                i += 3;
            }
            _ => {
                found.push(byte);
                i += 1;
            }
        }
    }
    String::from_utf8_lossy(&found).into_owned()
}

/// Returns the value of a parameter.
pub(super) fn value<'p>(parameters: &'p [(String, String)], name: &str) -> Option<&'p str> {
    let mut named = parameters.iter().filter(|(key, _)| key == name);
    named.next().map(|(_, value)| value.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_decoded_and_broken_codes_kept() {
        let found = parameters("https://a.b/c?mech=x%7Cy%0Az&q=%zz%4&n");
        assert_eq!(value(&found, "mech"), Some("x|y\nz"));
        assert_eq!(value(&found, "q"), Some("%zz%4"));
        assert_eq!(value(&found, ""), Some("n"));
        assert_eq!(parameters("https://a.b/c"), []);
    }
}
