//! Reads expressions of Pyslvs: `M[J[R, P[x, y], L[ground, link_0]], ..]`.

use super::ImportError;
use super::drawing::{Drawing, DrawnLaw, number};
use super::joints::{JointKind, Joints, ReadJoint};
use crate::wording::words;

/// Maximum depth of brackets.
const MAX_DEPTH: usize = 16;

/// Returns `true` for an expression, which may follow lines of comments.
pub(super) fn is_pyslvs(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
    first.is_some_and(|line| {
        let rest = line.strip_prefix('M').map(str::trim_start);
        rest.is_some_and(|rest| rest.starts_with('['))
    })
}

/// A part of an expression: a word, or a name with a list in brackets.
#[derive(Clone, Debug)]
struct ExpressionTerm {
    word: String,
    list: Option<Vec<ExpressionTerm>>,
    line: usize,
}

impl ExpressionTerm {
    /// Returns the list with this name in a joint.
    fn named<'t>(terms: &'t [ExpressionTerm], name: &str) -> Option<&'t [ExpressionTerm]> {
        let mut named = terms.iter().filter(|term| term.word == name);
        named.find_map(|term| term.list.as_deref())
    }

    /// Returns the text of a word, including a number with its sign.
    fn text(&self) -> &str {
        self.word.trim()
    }
}

/// Reads an expression.
pub(super) fn read_pyslvs(text: &str) -> Result<Drawing, ImportError> {
    let mut scanner = Scanner {
        rest: text.chars().peekable(),
        line: 1,
    };
    let terms = scanner.terms(0)?;
    let list = ExpressionTerm::named(&terms, "M");
    let mut joints = Joints::default();
    for (number_of_joint, term) in list.unwrap_or_default().iter().enumerate() {
        let place = words().import_line_joint(term.line, number_of_joint + 1);
        let read = (term.word == "J").then_some(term.list.as_deref()).flatten();
        match read.and_then(|terms| joint(terms, &place)) {
            Some((joint, has_other_place)) => {
                if has_other_place {
                    let text = words().import_second_place();
                    joints.drawing.remark(&place, text);
                }
                joints.add(&joint);
            }
            None => joints.drawing.remark(&place, words().import_not_a_joint()),
        }
    }
    if joints.drawing.points.is_empty() {
        return Err(ImportError::new(words().import_no_joints()));
    }
    joints
        .finish(&DrawnLaw::Unknown, true)
        .ok_or_else(ImportError::too_large)
}

/// Reads a joint, and whether it has a second place.
fn joint(terms: &[ExpressionTerm], place: &str) -> Option<(ReadJoint, bool)> {
    let kind = terms.iter().find(|term| term.list.is_none());
    let kind = JointKind::parse(kind?.text())?;
    let numbers = |name: &str| -> Option<Vec<f64>> {
        ExpressionTerm::named(terms, name)?
            .iter()
            .map(|term| number(term.text()))
            .collect()
    };
    // A slider may have two places where its slot was drawn; the first one counts. Decimals with a
    // comma give too many numbers.
    let (x, y, has_other_place) = match (numbers("P")?.as_slice(), kind) {
        (&[x, y], _) => (x, y, false),
        (&[x, y, _, _], JointKind::Slider | JointKind::PinInSlot) => (x, y, true),
        _ => return None,
    };
    let angle = match ExpressionTerm::named(terms, "A") {
        None => 0.0,
        Some(_) => match numbers("A")?.as_slice() {
            [angle] => *angle,
            _ => return None,
        },
    };
    let links = ExpressionTerm::named(terms, "L")?.iter();
    let joint = ReadJoint {
        name: None,
        links: links.map(|term| term.text().to_owned()).collect(),
        kind,
        at: [x, y],
        angle,
        is_input: false,
        place: place.to_owned(),
    };
    Some((joint, has_other_place))
}

/// The characters of an expression.
struct Scanner<'t> {
    rest: std::iter::Peekable<std::str::Chars<'t>>,
    line: usize,
}

impl Scanner<'_> {
    fn next(&mut self) -> Option<char> {
        let c = self.rest.next()?;
        self.line += usize::from(c == '\n');
        Some(c)
    }

    /// Reads terms up to a closing bracket or the end.
    fn terms(&mut self, depth: usize) -> Result<Vec<ExpressionTerm>, ImportError> {
        let mut terms = Vec::new();
        let mut word = String::new();
        let mut finished: Option<ExpressionTerm> = None;
        let fault = |line: usize| Err(ImportError::new(&words().import_brackets(line)));
        loop {
            let c = self.next();
            match c {
                Some('#') => while self.next().is_some_and(|c| c != '\n') {},
                Some('[') => {
                    if depth == MAX_DEPTH || finished.is_some() {
                        return fault(self.line);
                    }
                    let line = self.line;
                    let list = self.terms(depth + 1)?;
                    let word = std::mem::take(&mut word).trim().to_owned();
                    finished = Some(ExpressionTerm {
                        word,
                        list: Some(list),
                        line,
                    });
                }
                Some(',' | ']') | None => {
                    let text = std::mem::take(&mut word);
                    let line = self.line;
                    if finished.is_some() && !text.trim().is_empty() {
                        return fault(line);
                    }
                    let typed = (!text.trim().is_empty()).then(|| ExpressionTerm {
                        word: text.trim().to_owned(),
                        list: None,
                        line,
                    });
                    terms.extend(finished.take().or(typed));
                    match c {
                        Some(',') => {}
                        Some(_) if depth == 0 => return fault(self.line),
                        None if depth > 0 => return fault(self.line),
                        _ => return Ok(terms),
                    }
                }
                Some(c) => word.push(c),
            }
        }
    }
}
