//! Macros that declare the units and their conversions from one table.

macro_rules! units {
    ($(
        $dimension:ident $uom:tt {
            $(
                $(#[$note:meta])*
                $name:ident: $ascii:literal, $symbol:literal, $json:literal, [$($other:literal),*],
                $how:tt;
            )*
        }
    )*) => {
        $($(
            #[doc = concat!("`", $symbol, "`, in project files `", $ascii, "`.")]
            $(#[$note])*
            pub static $name: Unit = Unit {
                dimension: Dimension::$dimension,
                ascii: $ascii,
                symbol: $symbol,
                json: $json,
                others: &[$($other),*],
                forth: forth!($uom $how),
                back: back!($uom $how),
            };
        )*)*

        /// The units, the usual one of each dimension first.
        pub static ALL: &[&Unit] = &[$($(&$name),*),*];

        /// Returns the units of a dimension, the usual one first.
        pub(crate) fn of_dimension(dimension: Dimension) -> &'static [Unit] {
            match dimension {
                $(Dimension::$dimension => {
                    static UNITS: &[Unit] = &[$($name),*];
                    UNITS
                })*
            }
        }
    };
}

/// Converts a value in a unit to SI.
macro_rules! forth {
    ([$quantity:ident $module:ident] (is $unit:ident)) => {
        |value| uom::si::f64::$quantity::new::<uom::si::$module::$unit>(value).value
    };
    ([$($uom:ident)*] (times $factor:expr)) => {
        |value| value * $factor
    };
    ([$($uom:ident)*] (over $divisor:expr)) => {
        |value| value / $divisor
    };
    ([$($uom:ident)*] (si)) => {
        |value| value
    };
}

/// Converts a value in SI to a unit.
macro_rules! back {
    ([$quantity:ident $module:ident] (is $unit:ident)) => {
        |si| {
            let (dimension, units) = (std::marker::PhantomData, std::marker::PhantomData);
            uom::si::f64::$quantity { dimension, units, value: si }.get::<uom::si::$module::$unit>()
        }
    };
    ([$($uom:ident)*] (times $factor:expr)) => {
        |si| si / $factor
    };
    ([$($uom:ident)*] (over $divisor:expr)) => {
        |si| si * $divisor
    };
    ([$($uom:ident)*] (si)) => {
        |si| si
    };
}

/// Adds the stiffnesses to the list of units: torsion and tilting have the same units, each with a name of its own, but not the
/// same usual one.
macro_rules! with_stiffnesses {
    (
        {$($before:tt)*}
        {$($torsional:ident $tilting:ident: $ascii:literal, $symbol:literal, $json:literal, $others:tt, $how:tt;)*}
        {$($of_shaft:ident $of_bearing:ident: $ascii_2:literal, $symbol_2:literal, $json_2:literal, $others_2:tt, $how_2:tt;)*}
        {$($torsional_3:ident $tilting_3:ident: $ascii_3:literal, $symbol_3:literal, $json_3:literal, $others_3:tt, $how_3:tt;)*}
        {$($after:tt)*}
    ) => {
        units! {
            $($before)*
            TorsionalStiffness [] {
                $(#[doc = of_bearing!($tilting)] $torsional: $ascii, $symbol, $json, $others, $how;)*
                $(#[doc = of_bearing!($of_bearing)] $of_shaft: $ascii_2, $symbol_2, $json_2, $others_2, $how_2;)*
                $(#[doc = of_bearing!($tilting_3)] $torsional_3: $ascii_3, $symbol_3, $json_3, $others_3, $how_3;)*
            }
            TiltingStiffness [] {
                $(#[doc = of_shaft!($of_shaft)] $of_bearing: $ascii_2, $symbol_2, $json_2, $others_2, $how_2;)*
                $(#[doc = of_shaft!($torsional)] $tilting: $ascii, $symbol, $json, $others, $how;)*
                $(#[doc = of_shaft!($torsional_3)] $tilting_3: $ascii_3, $symbol_3, $json_3, $others_3, $how_3;)*
            }
            $($after)*
        }
    };
}

macro_rules! of_bearing {
    ($tilting:ident) => {
        concat!("\n\nOf a shaft; of a bearing it is [`", stringify!($tilting), "`].")
    };
}

macro_rules! of_shaft {
    ($torsional:ident) => {
        concat!("\n\nOf a bearing; of a shaft it is [`", stringify!($torsional), "`].")
    };
}
