//! Splits internet addresses into their parameters.

/// The parameters that contain joints.
const JOINTS: [&str; 2] = ["mech", "j"];

/// Returns `true` for a text that begins with the scheme of an internet address.
pub(super) fn has_scheme(text: &str) -> bool {
    let starts = |scheme: &str| {
        let start = text.get(..scheme.len());
        start.is_some_and(|start| start.eq_ignore_ascii_case(scheme))
    };
    starts("http://") || starts("https://")
}

/// Returns the parameter with joints of an address that was copied without its scheme, or from its
/// `?` on.
pub(super) fn joints_without_scheme(line: &str) -> Option<(&'static str, String)> {
    let (head, _) = line.split_once('=')?;
    // A line of PMKS has blanks or commas between links, and a scene has blanks before its first
    // sign.
    let is_other = |c: char| c.is_whitespace() || matches!(c, ',' | '[' | '|' | '{' | '"');
    if head.contains(is_other) || !is_query(head, line) {
        return None;
    }
    let parameters = parameters(line);
    JOINTS
        .into_iter()
        .find_map(|name| Some((name, value(&parameters, name)?.to_owned())))
}

/// Returns `true` for a text that can only be an address or a part of one, although it may contain
/// no mechanism.
pub(super) fn is_part_of_address(text: &str) -> bool {
    let hosts = ["www.", "app.pmksplus.com", "designengrlab.github.io"];
    let parts = text.split(['?', '#', '&']);
    let mut names = parts.filter_map(|part| Some(part.split_once('=')?.0));
    has_scheme(text)
        || hosts.iter().any(|host| text.starts_with(host))
        || names.any(|name| JOINTS.contains(&name.trim_start_matches(['/', '!'])))
}

/// Returns `true` if a text before the first `=` ends with the name of a parameter of an address.
fn is_query(head: &str, line: &str) -> bool {
    // Files of PMKS have lines `mech=..` without further parameters.
    head.contains(['?', '#']) || head == "j" || line.contains('&')
}

/// Returns the parameters of an address, decoded, in their order: those after `?`, and those after
/// `#`.
pub(super) fn parameters(address: &str) -> Vec<(String, String)> {
    let queries = match address.split_once(['?', '#']) {
        Some((_, queries)) => queries,
        None if has_scheme(address) => return Vec::new(),
        // A query alone.
        None => address,
    };
    let parts = queries.split(['&', '?', '#']).map(|part| {
        // Some addresses have a path after `#`.
        part.trim_start_matches(['/', '!'])
    });
    parts
        .filter(|part| !part.is_empty())
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
        for address in [
            "a.b/#j=x",
            "a.b/#/?j=x&k",
            "?j=x#top",
            "j=x",
            "http://a.b/?q#!/j=x",
        ] {
            assert_eq!(value(&parameters(address), "j"), Some("x"), "{address}");
        }
    }

    #[test]
    fn joints_are_found_without_a_scheme() {
        let found = |text: &str| joints_without_scheme(text).map(|(name, _)| name);
        assert_eq!(found("app.pmksplus.com/?j=A,0,0&l="), Some("j"));
        assert_eq!(found("#j=A,0,0"), Some("j"));
        assert_eq!(found("j=A,0,0"), Some("j"));
        assert_eq!(found("?mech=a,b,R,0,0"), Some("mech"));
        assert_eq!(found("mech=a,b,R,0,0&name=x"), Some("mech"));
        // A line of a file of PMKS, a scene, and a comment.
        assert_eq!(found("mech=a,b,R,0,0|"), None);
        assert_eq!(found("name = \"x?j=1\""), None);
        assert_eq!(found("# see ?j=1"), None);
    }
}
