//! Enumerations whose values have an identifier.

/// Declares enumerations in which each value stands beside the identifier that files and data exchange have for it; the list of
/// all values and the identifier of each follow from that.
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
            /// Every one, in order.
            pub const ALL: [Self; Self::IDS.len()] = [$(Self::$value),+];

            /// The identifiers, in the same order.
            pub const IDS: &'static [&'static str] = &[$($id),+];

            /// The identifier used in files and data exchange.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$value => $id,)+ }
            }
        }
    )+};
}
