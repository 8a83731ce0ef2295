// The macro for catalogues of messages. The parent module explains their purpose.

/// Defines a part of the catalogue: a trait with a function for each message, and one language's
/// implementation.
///
/// ```text
/// catalogue! {
///     /// What the part is about.
///     trait Motion for English {
///         paused = "paused";                                          // fn paused(&self) -> &'static str
///         ends_at(at: &str, unit: &str) = "ends at {at} {unit}";      // fn ends_at(&self, ..) -> String
///         links(count: usize) = { counted(count, "link", "links") };  // the same, where grammar decides
///     }
/// }
/// ```
///
/// A second language implements the same messages in
/// `catalogue! { impl Motion for Turkish { .. } }`:
///
/// ```
/// include!(concat!(env!("CARGO_MANIFEST_DIR"), "/src/wording/catalogue.rs"));
/// catalogue! {
///     trait Motion for English {
///         paused = "paused";
///         ends_at(at: &str) = "ends at {at}";
///     }
/// }
/// catalogue! {
///     impl Motion for Turkish {
///         paused = "durdu";
///         ends_at(at: &str) = "{at} konumunda biter";
///     }
/// }
/// struct English;
/// struct Turkish;
/// fn main() {
///     let spoken: [&dyn Motion; 2] = [&English, &Turkish];
///     assert_eq!(spoken.map(|words| words.paused()), ["paused", "durdu"]);
///     assert_eq!(spoken[1].ends_at("60"), "60 konumunda biter");
/// }
/// ```
///
/// A missing message is a compile error:
///
/// ```compile_fail
/// include!(concat!(env!("CARGO_MANIFEST_DIR"), "/src/wording/catalogue.rs"));
/// catalogue! {
///     trait Motion for English {
///         paused = "paused";
///         ends_at(at: &str) = "ends at {at}";
///     }
/// }
/// catalogue! {
///     impl Motion for Turkish {
///         paused = "durdu";
///     }
/// }
/// struct English;
/// struct Turkish;
/// fn main() {}
/// ```
macro_rules! catalogue {
    ($(#[$about:meta])* trait $part:ident for $language:ident { $($sentences:tt)* }) => {
        $(#[$about])*
        pub trait $part {
            catalogue! { @declared $($sentences)* }
        }
        catalogue! { impl $part for $language { $($sentences)* } }
    };
    (impl $part:ident for $language:ident { $($sentences:tt)* }) => {
        impl $part for $language {
            catalogue! { @message $($sentences)* }
        }
    };
    (@declared $($(#[$only:meta])* $name:ident $(($($given:ident: $kind:ty),*))? = $text:tt;)*) => {
        $($(#[$only])* catalogue! { @one $name $(($($given: $kind),*))? })*
    };
    (@one $name:ident) => {
        fn $name(&self) -> &'static str;
    };
    (@one $name:ident ($($given:ident: $kind:ty),*)) => {
        fn $name(&self, $($given: $kind),*) -> String;
    };
    (@message $($(#[$only:meta])* $name:ident $(($($given:ident: $kind:ty),*))? = $text:tt;)*) => {
        $($(#[$only])* catalogue! { @one $name $(($($given: $kind),*))? = $text })*
    };
    (@one $name:ident = $text:tt) => {
        fn $name(&self) -> &'static str {
            $text
        }
    };
    (@one $name:ident ($($given:ident: $kind:ty),*) = $text:literal) => {
        #[allow(unused_variables, reason = "a language need not say all that it is given")]
        fn $name(&self, $($given: $kind),*) -> String {
            format!($text)
        }
    };
    (@one $name:ident ($($given:ident: $kind:ty),*) = $text:block) => {
        #[allow(unused_variables, reason = "a language need not say all that it is given")]
        fn $name(&self, $($given: $kind),*) -> String $text
    };
}
