//! Splits a formula into lexemes.

use super::{DASHES, FormulaError, is_of_name};
use crate::wording::words;
use std::ops::Range;

/// A word or a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lexeme {
    Number(f64),
    /// A name, or any other word made of the same characters.
    Name,
    /// One of `+ - * / ^ ( ) ,`.
    Mark(char),
    End,
}

/// Reads one lexeme after another. The context decides about a `-`, because it can be part of a
/// name.
#[derive(Clone, Debug)]
pub(super) struct Lexer<'t> {
    pub(super) text: &'t str,
    at: usize,
}

impl<'t> Lexer<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Lexer { text, at: 0 }
    }

    /// Returns the next lexeme and its position. With `is_operand`, an operand must follow, so that
    /// a `-` is a sign.
    pub(super) fn next(
        &mut self,
        is_operand: bool,
    ) -> Result<(Lexeme, Range<usize>), FormulaError> {
        let rest = self.text[self.at..].trim_start();
        let from = self.text.len() - rest.len();
        let Some(first) = rest.chars().next() else {
            return Ok((Lexeme::End, from..from));
        };
        let mark = match first {
            '-' => is_operand || !rest[1..].starts_with(is_of_name),
            _ => "+*/^(),".contains(first),
        };
        if mark {
            self.at = from + 1;
            return Ok((Lexeme::Mark(first), from..from + 1));
        }
        if !is_of_name(first) {
            let shown: String = first.escape_debug().collect();
            let span = from..from + first.len_utf8();
            let fault = FormulaError::new(span, words().no_part_of_a_formula(&shown));
            return Err(match DASHES.contains(&first) {
                true => fault.help(words().minus_sign()),
                false => fault,
            });
        }
        let end = from + self.word_length(rest);
        let span = from..end;
        self.at = end;
        let word = &self.text[span.clone()];
        if first == '-' {
            let fault = FormulaError::new(span, words().minus_without_blank(word));
            return Err(fault.help(words().minus_between_blanks()));
        }
        let is_beyond = is_digital(word) && word.parse().is_ok_and(f64::is_infinite);
        if is_beyond {
            return Err(FormulaError::new(span, words().number_too_large(word)));
        }
        let is_lost = number(word) == Some(0.0) && has_digits(word);
        if is_lost {
            return Err(FormulaError::new(span, words().number_too_small(word)));
        }
        Ok((number(word).map_or(Lexeme::Name, Lexeme::Number), span))
    }

    /// Returns the length of the word at the beginning of a text, including the sign in `1e+3`.
    fn word_length(&self, rest: &str) -> usize {
        let length = |text: &str| text.find(|c| !is_of_name(c)).unwrap_or(text.len());
        let word = length(rest);
        let (head, tail) = rest.split_at(word);
        let is_open = head.ends_with(['e', 'E']) && number(&head[..word - 1]).is_some();
        match tail.strip_prefix('+') {
            Some(digits) if is_open && digits.starts_with(|c: char| c.is_ascii_digit()) => {
                word + 1 + length(digits)
            }
            _ => word,
        }
    }

    /// Returns the position where the next lexeme may begin.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    pub(super) fn skip_to(&mut self, at: usize) {
        self.at = at;
    }
}

/// Returns the number that a word represents, if it is finite and written in digits.
pub(super) fn number(word: &str) -> Option<f64> {
    let value: f64 = word.parse().ok()?;
    (is_digital(word) && value.is_finite()).then_some(value)
}

/// Returns `true` if a number has a digit other than 0 in front of its power of ten.
fn has_digits(number: &str) -> bool {
    let digits = number.split(['e', 'E']).next().unwrap_or(number);
    digits.contains(|c: char| matches!(c, '1'..='9'))
}

/// Returns `true` if a word begins like a number; `inf` and `nan` are names.
fn is_digital(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit() || c == '.')
}
