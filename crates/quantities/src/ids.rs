//! Enumerations whose values have an identifier.

/// Declares enumerations in which each value is followed by its identifier in files and data exchange; the list of
/// values and the identifiers follow from that.
///
/// ```
/// quantities::identified! {
///     /// Where a load lies.
///     #[derive(Clone, Copy, Debug, PartialEq, Eq)]
///     pub enum Side {
///         /// On the flange.
///         Load = "load",
///         /// On the housing.
///         Housing = "housing",
///     }
/// }
/// assert_eq!(Side::ALL.map(Side::id), ["load", "housing"]);
/// ```
#[macro_export]
macro_rules! identified {
    ($($(#[$about:meta])* pub enum $name:ident { $($(#[$each:meta])* $value:ident = $id:literal,)+ })+) => {$(
        $(#[$about])*
        pub enum $name { $($(#[$each])* $value,)+ }

        impl $name {
            /// The values, in order.
            pub const ALL: [Self; Self::IDS.len()] = [$(Self::$value),+];

            /// Identifiers, in the same order.
            pub const IDS: &'static [&'static str] = &[$($id),+];

            /// Returns the identifier used in files and data exchange.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$value => $id,)+ }
            }
        }
    )+};
}
