//! Writes the trait of all messages, and its implementation for each language, from the messages in
//! `src/wording/*.txt`, and the tables of translations.

#[path = "src/wording/catalogue.rs"]
mod catalogue;

use catalogue::{Message, messages, translations};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Every language: its type, its name in options, its file, and the module of its messages that need
/// grammar. The first language is the default.
const LANGUAGES: &[(&str, &str, &str, &str)] = &[
    ("English", "en", "english.txt", "english"),
    ("Turkish", "tr", "turkish.txt", "turkish::grammar"),
];

#[allow(clippy::print_stdout, reason = "cargo reads it")]
fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new("src/wording");
    println!("cargo::rerun-if-changed=src/wording");
    println!("cargo::rerun-if-changed=build.rs");
    let mut all = Vec::new();
    for (_, _, file, _) in LANGUAGES {
        let text = fs::read_to_string(folder.join(file))?;
        all.push(messages(&text).map_err(|fault| format!("{file}: {fault}"))?);
    }
    let mut code = languages() + "/// All messages in one language.\npub trait Words {\n";
    for message in &all[0] {
        let text = message.text.as_deref().unwrap_or("Depends on grammar.");
        let doc = format!("```text\n{text}\n```");
        code += &format!("#[doc = {doc:?}]\n{};\n", head(message));
    }
    code += "}\n";
    for ((language, _, file, grammar), own) in LANGUAGES.iter().zip(&all) {
        let is_known = |own: &&Message| all[0].iter().any(|message| message.name == own.name);
        if let Some(extra) = own.iter().find(|own| !is_known(own)) {
            return Err(format!("{file}: `{}` is not in english.txt", extra.name).into());
        }
        code += &format!(
            "#[allow(unused_variables, clippy::useless_format)]\nimpl Words for {language} {{\n"
        );
        for message in &all[0] {
            let own = own.iter().find(|own| own.name == message.name);
            let own = own.ok_or_else(|| format!("{file}: `{}` is missing", message.name))?;
            let body = match (&own.text, &message.arguments) {
                (Some(text), None) => format!("{text:?}"),
                (Some(text), Some(_)) => format!("format!({text:?})"),
                (None, arguments) => {
                    let names = arguments.iter().flatten().map(|(name, _)| name.as_str());
                    format!(
                        "super::{grammar}::{}({})",
                        own.name,
                        names.collect::<Vec<_>>().join(", ")
                    )
                }
            };
            code += &format!("{} {{ {body} }}\n", head(message));
        }
        code += "}\n";
    }
    let text = fs::read_to_string(folder.join("turkish/translations.txt"))?;
    let mut tables = String::new();
    for (name, pairs) in translations(&text)? {
        tables += &format!(
            "pub(super) const {name}: [(&str, &str); {}] = {pairs:?};\n",
            pairs.len()
        );
    }
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("no OUT_DIR")?);
    fs::write(out.join("words.rs"), code)?;
    Ok(fs::write(out.join("translations.rs"), tables)?)
}

/// Returns the types of the languages.
fn languages() -> String {
    let [mut variants, mut all, mut names, mut words] = [const { String::new() }; 4];
    for (language, name, ..) in LANGUAGES {
        variants += &format!("/// The language `{name}`.\n{language},\n");
        all += &format!("Language::{language}, ");
        names += &format!("Language::{language} => {name:?},\n");
        words += &format!("Language::{language} => &{language},\n");
    }
    let types = LANGUAGES.iter();
    let types = types.map(|(language, ..)| format!("#[derive(Debug)]\nstruct {language};\n"));
    let types: String = types.collect();
    format!(
        "/// A language of krank's messages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {{ #[default]\n{variants} }}
impl Language {{
    /// All languages, in the order of the variants. The workbench cycles through them.
    pub const ALL: [Language; {}] = [{all}];
    /// Returns the language's name in options and in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {{ match self {{ {names} }} }}
    /// Returns the messages in this language.
    #[must_use]
    pub fn words(self) -> &'static dyn Words {{ match self {{ {words} }} }}
}}
{types}",
        LANGUAGES.len()
    )
}

/// Returns the head of a message's function.
fn head(message: &Message) -> String {
    let Message {
        name, arguments, ..
    } = message;
    let kind = match arguments {
        Some(_) => "String",
        None => "&'static str",
    };
    let arguments = arguments.iter().flatten();
    let arguments: String = arguments
        .map(|(name, kind)| format!(", {name}: {kind}"))
        .collect();
    format!("fn {name}(&self{arguments}) -> {kind}")
}
