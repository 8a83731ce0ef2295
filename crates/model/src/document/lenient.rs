//! Deserializes values without stopping at the first one of a wrong type.
//!
//! A derived `Deserialize` ends at the first value that does not fit. Here such a value is stored
//! with its place and the kind of value found instead, so that one fault does not hide others.

use super::reader::{ByteSpan, Name, meant};
use crate::wording::words;
use serde::de::value::{BoolDeserializer, F64Deserializer, StrDeserializer};
use serde::de::{DeserializeSeed, Error, IgnoredAny, IntoDeserializer, MapAccess, SeqAccess};
use serde::{Deserialize, Deserializer, de};
use std::fmt;
use std::marker::PhantomData;
use toml::Spanned;

/// A key as written in the file.
pub type WrittenKey = Spanned<String>;

/// A value that should be a `T`.
#[derive(Clone, Debug)]
pub struct Lenient<T> {
    /// The place in the text.
    pub span: ByteSpan,
    /// The value, or the kind of value found instead.
    pub read: Result<T, Misplaced>,
    /// Every key of a table, known or not, in the order of the file.
    pub keys: Vec<WrittenKey>,
    /// The permitted keys: the fields of `T`.
    pub known: &'static [&'static str],
}

/// The kind of a value with the wrong type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Misplaced {
    Text(String),
    Number,
    /// A number valid in TOML that the parser cannot represent.
    Unheld,
    Boolean,
    Date,
    List,
    Table,
}

impl Misplaced {
    /// Returns the text, if it is one.
    pub(crate) fn text(&self) -> Option<&str> {
        match self {
            Misplaced::Text(text) => Some(text),
            Misplaced::Number
            | Misplaced::Unheld
            | Misplaced::Boolean
            | Misplaced::Date
            | Misplaced::List
            | Misplaced::Table => None,
        }
    }

    /// Returns the kind as a phrase for messages.
    pub(super) fn said(&self) -> &'static str {
        match self {
            Misplaced::Text(_) => words().a_text(),
            Misplaced::Number | Misplaced::Unheld => words().a_number(),
            Misplaced::Boolean => words().a_truth(),
            Misplaced::Date => words().a_date(),
            Misplaced::List => words().a_list(),
            Misplaced::Table => words().a_table(),
        }
    }
}

impl<T> Lenient<T> {
    /// Returns the value, if it has the right type.
    pub fn get(&self) -> Option<&T> {
        self.read.as_ref().ok()
    }

    /// Returns a key of the table.
    pub fn key(&self, name: &str) -> Option<&WrittenKey> {
        self.keys.iter().find(|key| key.get_ref() == name)
    }

    /// Returns `true` if an unknown key of the table is probably a misspelling of this one.
    pub fn meant(&self, key: &str) -> bool {
        meant(&self.keys, self.known, key)
    }
}

/// The values of a table whose keys are names.
#[derive(Clone, Debug)]
pub struct Entries<T>(Vec<T>);

impl<T> Lenient<Entries<T>> {
    /// Returns name and value of each entry, in the order of the file; empty for anything but a
    /// table.
    pub fn entries(&self) -> impl Iterator<Item = (Name<'_>, &T)> {
        let values = self.get().into_iter().flat_map(|entries| &entries.0);
        self.keys.iter().map(Name::of_key).zip(values)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Lenient<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let whole = Spanned::<Attempt<T>>::deserialize(deserializer)?;
        let span = whole.span();
        let Attempt(value) = whole.into_inner();
        Ok(Lenient { span, ..value })
    }
}

/// The result of reading a value, before its place is known; reading never fails.
struct Attempt<T>(Lenient<T>);

impl<T> From<Result<T, Misplaced>> for Attempt<T> {
    fn from(read: Result<T, Misplaced>) -> Self {
        Attempt(Lenient {
            span: ByteSpan::default(),
            read,
            keys: Vec::new(),
            known: &[],
        })
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Attempt<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let read = deserializer.deserialize_any(Trial(PhantomData));
        // The visitor accepts every value, so only numbers that the parser cannot represent fail.
        Ok(read.unwrap_or_else(|_| Err(Misplaced::Unheld).into()))
    }
}

/// Tries to deserialize any value as `T`; integers are passed as the nearest double.
struct Trial<T>(PhantomData<T>);

#[expect(clippy::cast_precision_loss, reason = "the nearest double is meant")]
impl<'de, T: Deserialize<'de>> de::Visitor<'de> for Trial<T> {
    type Value = Attempt<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Attempt<T>, E> {
        let read = T::deserialize::<BoolDeserializer<E>>(value.into_deserializer());
        Ok(read.map_err(|_| Misplaced::Boolean).into())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Attempt<T>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Attempt<T>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_i128<E: Error>(self, value: i128) -> Result<Attempt<T>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u128<E: Error>(self, value: u128) -> Result<Attempt<T>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Attempt<T>, E> {
        let read = T::deserialize::<F64Deserializer<E>>(value.into_deserializer());
        Ok(read.map_err(|_| Misplaced::Number).into())
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Attempt<T>, E> {
        let read = T::deserialize::<StrDeserializer<'_, E>>(text.into_deserializer());
        Ok(read.map_err(|_| Misplaced::Text(text.to_owned())).into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Attempt<T>, A::Error> {
        Ok(T::deserialize(LenientList(list))
            .map_err(|_| Misplaced::List)
            .into())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Attempt<T>, A::Error> {
        // Dates also arrive as a table, but without places.
        let Ok(first) = map.next_key() else {
            return Ok(Err(Misplaced::Date).into());
        };
        let Attempt(mut value) = Err(Misplaced::Table).into();
        let table = LenientTable {
            map,
            first,
            keys: &mut value.keys,
            known: &mut value.known,
            names: true,
        };
        value.read = T::deserialize(table).map_err(|_| Misplaced::Table);
        Ok(Attempt(value))
    }
}

/// A list passed to a type. Rejects structs, because derived types would fill their fields from it.
struct LenientList<A>(A);

impl<'de, A: SeqAccess<'de>> Deserializer<'de> for LenientList<A> {
    type Error = A::Error;

    fn deserialize_any<V: de::Visitor<'de>>(self, visitor: V) -> Result<V::Value, A::Error> {
        visitor.visit_seq(self.0)
    }

    fn deserialize_struct<V: de::Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        _visitor: V,
    ) -> Result<V::Value, A::Error> {
        Err(Error::custom("a table is meant"))
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

/// A table passed to a type; records its keys. Derived types lose the places of keys, and stop at
/// an unrepresentable number even under an unknown key.
struct LenientTable<'k, A> {
    map: A,
    /// The first key, which was read to recognize a table.
    first: Option<WrittenKey>,
    keys: &'k mut Vec<WrittenKey>,
    known: &'k mut &'static [&'static str],
    /// Whether every key is accepted as the name of an entry.
    names: bool,
}

impl<'de, A: MapAccess<'de>> Deserializer<'de> for LenientTable<'_, A> {
    type Error = A::Error;

    fn deserialize_any<V: de::Visitor<'de>>(self, visitor: V) -> Result<V::Value, A::Error> {
        visitor.visit_map(self)
    }

    fn deserialize_struct<V: de::Visitor<'de>>(
        mut self,
        _name: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, A::Error> {
        *self.known = fields;
        self.names = false;
        visitor.visit_map(self)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for LenientTable<'_, A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, A::Error> {
        loop {
            let key = match self.first.take() {
                Some(key) => Some(key),
                None => self.map.next_key::<WrittenKey>()?,
            };
            let Some(key) = key else { return Ok(None) };
            let text = key.get_ref().as_str();
            if self.names || self.known.contains(&text) {
                let field = seed.deserialize(text.into_deserializer())?;
                self.keys.push(key);
                return Ok(Some(field));
            }
            self.map.next_value::<Attempt<IgnoredAny>>()?;
            self.keys.push(key);
        }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(seed)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Entries<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(TableNames(PhantomData))
    }
}

/// Collects the values of a table; the names are in [`Lenient::keys`].
struct TableNames<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> de::Visitor<'de> for TableNames<T> {
    type Value = Entries<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries<T>, A::Error> {
        let mut values = Vec::new();
        while let Some((IgnoredAny, value)) = map.next_entry()? {
            values.push(value);
        }
        Ok(Entries(values))
    }
}
