//! Defines the appearance of a picture's classes by one style sheet, which is written to SVG and
//! HTML unchanged and interpreted here for other formats.

/// Rules in addition to those for paper, lines (`path`) and `text`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct StyleSheet {
    /// The rules for all grounds.
    pub(crate) light: &'static str,
    /// The additional rules for a dark ground.
    pub(crate) dark: &'static str,
}

/// The colours for viewers that know no preference; `currentColor` would be black there.
pub(super) const LIGHT: &str = "\
.paper{fill:#fff}
path{fill:none;stroke:#222;stroke-width:2;stroke-linecap:round;stroke-linejoin:round}
text{font:13px sans-serif;fill:#222}
";
pub(super) const DARK: &str = "\
.paper{fill:#181818}
path{stroke:#ddd}
text{fill:#ddd}
";

/// The appearance of an element on light paper. Colours are strings such as `0000ff`, `None` if not
/// drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SvgStyle {
    pub(super) stroke: Option<String>,
    pub(super) fill: Option<String>,
    pub(super) width: f64,
    pub(super) dashes: Vec<f64>,
    pub(super) stroke_opacity: f64,
    pub(super) fill_opacity: f64,
}

impl StyleSheet {
    /// Returns the appearance of an element of a kind (`path`, `circle`, `text`) with these classes
    /// on light paper.
    pub(super) fn svg_style(&self, kind: &str, classes: &str) -> SvgStyle {
        let mut style = SvgStyle {
            stroke: None,
            fill: Some("000000".into()),
            width: 1.0,
            dashes: Vec::new(),
            stroke_opacity: 1.0,
            fill_opacity: 1.0,
        };
        let mut found: Vec<(usize, &str)> = Vec::new();
        for (selectors, declarations) in rules(LIGHT).chain(rules(self.light)) {
            let ranks = selectors
                .split(',')
                .filter_map(|selector| rank(selector, kind, classes));
            found.extend(ranks.max().map(|rank| (rank, declarations)));
        }
        // A rule with more classes takes precedence, then the later one.
        found.sort_by_key(|(rank, _)| *rank);
        for (_, declarations) in found {
            for declaration in declarations.split(';') {
                if let Some((name, value)) = declaration.split_once(':') {
                    style.declare(name.trim(), value.trim());
                }
            }
        }
        style
    }
}

impl SvgStyle {
    fn declare(&mut self, name: &str, value: &str) {
        let number = |before: f64| value.parse().unwrap_or(before);
        match name {
            "stroke" => self.stroke = colour(value),
            "fill" => self.fill = colour(value),
            "stroke-width" => self.width = number(self.width),
            "stroke-opacity" => self.stroke_opacity = number(self.stroke_opacity),
            "fill-opacity" => self.fill_opacity = number(self.fill_opacity),
            "stroke-dasharray" => {
                let dashes = value.split_whitespace().map(str::parse);
                self.dashes = dashes.collect::<Result<_, _>>().unwrap_or_default();
            }
            _ => {}
        }
    }
}

/// Returns the rules of a sheet: selectors and declarations.
pub(super) fn rules(sheet: &str) -> impl Iterator<Item = (&str, &str)> {
    let rules = sheet.split('}').filter_map(|rule| rule.split_once('{'));
    rules.map(|(selectors, declarations)| (selectors.trim(), declarations))
}

/// Returns the specificity of a selector, that is, the number of its classes; `None` if it does not
/// match the element.
fn rank(selector: &str, kind: &str, classes: &str) -> Option<usize> {
    let mut parts = selector.trim().split('.');
    let of_kind = parts.next().unwrap_or("");
    let mut named = 0;
    for class in parts {
        named += 1;
        if !classes.split(' ').any(|own| own == class) {
            return None;
        }
    }
    (of_kind.is_empty() || of_kind == kind).then_some(named)
}

/// Parses `#05d` or `#0055dd` to `0055dd`; returns `None` for `none`.
fn colour(value: &str) -> Option<String> {
    let digits = value.strip_prefix('#')?;
    match digits.len() {
        3 => Some(digits.chars().flat_map(|c| [c, c]).collect()),
        _ => Some(digits.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEET: StyleSheet = StyleSheet {
        light: ".a,.b{stroke:#123}\n.a.b{stroke:#010203}\n.b{stroke-width:3;stroke-dasharray:7 4}\ncircle{stroke:#222}\n",
        dark: "",
    };

    #[test]
    fn more_specific_or_later_rule_wins() {
        let both = SHEET.svg_style("path", "a b");
        assert_eq!(both.stroke.as_deref(), Some("010203"));
        assert_eq!((both.width, both.dashes), (3.0, vec![7.0, 4.0]));
        assert_eq!(
            SHEET.svg_style("path", "a").stroke.as_deref(),
            Some("112233")
        );
        assert_eq!(
            SHEET.svg_style("path", "c").stroke.as_deref(),
            Some("222222")
        );
        assert_eq!(SHEET.svg_style("path", "c").fill, None);
        // A class is more specific than an element type, in any order.
        assert_eq!(
            SHEET.svg_style("circle", "a").stroke.as_deref(),
            Some("112233")
        );
        assert_eq!(
            SHEET.svg_style("circle", "").fill.as_deref(),
            Some("000000")
        );
    }
}
