//! Sections of the project file as plain structs: one declaration of a key defines its field, its reader and its
//! description.

use crate::key::{Key, Variants};
use crate::stated::{SectionHead, StatedField};
use std::any::Any;

/// Fields of a section.
pub trait Fields {
    /// Returns its place and path.
    fn head(&self) -> &SectionHead;
    /// Returns its place and path for a change.
    fn head_mut(&mut self) -> &mut SectionHead;
    /// Returns the fields in their order.
    fn fields(&self) -> Vec<&dyn StatedField>;
    /// Returns the field of a key for a change.
    fn field_mut(&mut self, name: &str) -> Option<&mut dyn StatedField>;
    /// Returns the sections whose keys it includes.
    fn groups(&self) -> Vec<&dyn Any>;

    /// Returns the field of a key.
    fn field(&self, name: &str) -> Option<&dyn StatedField> {
        self.fields().into_iter().find(|field| field.name() == name)
    }
}

/// Returns the included section of a type.
#[must_use]
pub fn group<T: Any>(of: &(impl Fields + ?Sized)) -> Option<&T> {
    of.groups().into_iter().find_map(<dyn Any>::downcast_ref)
}

/// A section of the file.
pub trait Section: Fields + Sized {
    /// Descriptions of its keys.
    const KEYS: &'static [Key];

    /// Creates an empty section.
    fn absent(head: &SectionHead) -> Self;

    /// Returns `true` if no value was refused.
    fn is_whole(&self) -> bool {
        self.fields().iter().all(|field| field.is_given() || !field.is_written())
    }
}

/// A section that has several kinds.
pub trait OfKinds: Section {
    /// Description of its kinds.
    const VARIANTS: &'static Variants;
}

/// Replaces the value of a quantity, in SI: `load.inertia`, `motion[2].speed`, `points[1][3]` (row and column),
/// `bodies[1].mass`. `None` if there is no quantity at the path.
pub(crate) fn set(section: &mut dyn Fields, path: &str, si: f64) -> Option<()> {
    let (head, rest) = path.split_once('.').unwrap_or((path, ""));
    let mut parts = head.split('[').map(|part| part.trim_end_matches(']'));
    let name = parts.next()?;
    let index: Option<Vec<usize>> = parts.map(|part| part.parse::<usize>().ok()?.checked_sub(1)).collect();
    section.field_mut(name)?.set(&index?, rest, si)
}

/// Returns `false` if a path leads to a key that is not stated: `load.inertia`, `motion[2].speed`. A path that leads to a section
/// or to no key of it counts as stated.
pub(crate) fn states(section: &dyn Fields, path: &str) -> bool {
    let (head, rest) = path.split_once('.').unwrap_or((path, ""));
    let mut parts = head.split('[').map(|part| part.trim_end_matches(']'));
    let field = parts.next().and_then(|name| section.field(name));
    let index: Vec<usize> = parts.filter_map(|part| part.parse::<usize>().ok()?.checked_sub(1)).collect();
    field.is_none_or(|field| field.states(&index, rest))
}

/// Declares a section: its struct, the names of its keys, and their description.
///
/// ```text
/// section! {
///     /// A screw that moves a slide.
///     Screw, ScrewKey of About::Mechanism, MechanismKey::Screw {
///         lead: Length => positive, needed, example("10 mm");
///         ..slide: Slide;
///     }
/// }
/// ```
///
/// A key is a line: its name in the file, the type of its value ([`Value`](crate::value::Value)), after `=` its
/// default, and the settings by the methods of [`Key`]. A key with a default has a method of its name, which returns
/// the stated value or the default. A line that begins with `..` includes the keys of another section.
macro_rules! section {
    (
        $(#[$doc:meta])*
        $Section:ident, $Name:ident of $about:path $(, $inner:path)? {
            $($field:ident: $Type:ty $(= $default:expr)? $(=> $($has:ident $(($($of:tt)*))?),+)?;)*
            $(
                ..$group:ident: $Group:ty;
                $($more:ident: $More:ty $(=> $($has_more:ident $(($($of_more:tt)*))?),+)?;)*
            )*
        }
    ) => {
        $(#[$doc])*
        #[allow(
            missing_docs,
            unreachable_pub,
            reason = "each field is named as its key, or as the section that it includes; not every section is used outside"
        )]
        #[derive(Clone, Debug)]
        pub struct $Section {
            head: $crate::stated::SectionHead,
            $(pub $field: $crate::stated::Stated<$Type>,)*
            $(pub $group: $Group, $(pub $more: $crate::stated::Stated<$More>,)*)*
        }

        $(#[$doc])*
        #[allow(missing_docs, non_camel_case_types, reason = "each is named as its key is written")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $Name {
            $($field,)*
            $($($more,)*)*
        }

        impl $Name {
            const fn about(self) -> About {
                $crate::section::nested!(self, $about $(, $inner)?)
            }
        }

        impl $Section {
            $($(
                /// Returns the stated value, or the default.
                #[must_use]
                pub fn $field(&self) -> $Type {
                    self.$field.value().unwrap_or($default)
                }
            )?)*
        }

        impl $crate::section::Fields for $Section {
            fn head(&self) -> &$crate::stated::SectionHead {
                &self.head
            }

            fn head_mut(&mut self) -> &mut $crate::stated::SectionHead {
                &mut self.head
            }

            fn fields(&self) -> Vec<&dyn $crate::stated::StatedField> {
                #[allow(unused_mut, reason = "a section without groups")]
                let mut all: Vec<&dyn $crate::stated::StatedField> = vec![$(&self.$field,)*];
                $(
                    all.extend($crate::section::Fields::fields(&self.$group));
                    $(all.push(&self.$more);)*
                )*
                all
            }

            fn groups(&self) -> Vec<&dyn std::any::Any> {
                vec![$(&self.$group),*]
            }

            fn field_mut(&mut self, name: &str) -> Option<&mut dyn $crate::stated::StatedField> {
                match name {
                    $(stringify!($field) => return Some(&mut self.$field),)*
                    $($(stringify!($more) => return Some(&mut self.$more),)*)*
                    _ => {}
                }
                $(
                    if let Some(field) = $crate::section::Fields::field_mut(&mut self.$group, name) {
                        return Some(field);
                    }
                )*
                None
            }
        }

        impl $crate::section::Section for $Section {
            /// Descriptions of its keys.
    const KEYS: &'static [$crate::key::Key] = {
                const PARTS: &[&[$crate::key::Key]] = &[
                    $(&[$crate::section::key! {
                        $Name::$field: $field: $Type $(= $default)? $(=> $($has $(($($of)*))?),+)?
                    }],)*
                    $(
                        <$Group as $crate::section::Section>::KEYS,
                        $(&[$crate::section::key! {
                            $Name::$more: $more: $More $(=> $($has_more $(($($of_more)*))?),+)?
                        }],)*
                    )*
                ];
                #[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
                const ALL: [$crate::key::Key; $crate::key::count(PARTS)] = $crate::key::concat(PARTS, PARTS[0][0]);
                &ALL
            };

            fn absent(head: &$crate::stated::SectionHead) -> Self {
                Self {
                    $($field: $crate::stated::Stated::absent(head, &const { $crate::section::key! {
                        $Name::$field: $field: $Type $(= $default)? $(=> $($has $(($($of)*))?),+)?
                    } }),)*
                    $(
                        $group: $crate::section::Section::absent(head),
                        $($more: $crate::stated::Stated::absent(head, &const { $crate::section::key! {
                            $Name::$more: $more: $More $(=> $($has_more $(($($of_more)*))?),+)?
                        } }),)*
                    )*
                    head: head.clone(),
                }
            }
        }

        impl $crate::value::KeyValue for $Section {
            const KIND: $crate::key::Kind = $crate::key::Kind::Table(<Self as $crate::section::Section>::KEYS);

            fn read(found: &$crate::read::FoundValue<'_, '_>, reader: &mut $crate::read::Reader<'_>) -> Option<Self> {
                reader.table(found)
            }

            fn set(&mut self, _: &[usize], rest: &str, si: f64) -> Option<()> {
                $crate::section::set(self, rest, si)
            }

            fn states(&self, _: &[usize], rest: &str) -> bool {
                $crate::section::states(self, rest)
            }
        }
    };
}

/// Describes one key of a section.
macro_rules! key {
    (
        $Name:ident::$variant:ident: $field:ident: $Type:ty
        $(= $default:expr)? $(=> $($has:ident $(($($of:tt)*))?),+)?
    ) => {
        $crate::key::Key::new(stringify!($field), <$Type as $crate::value::KeyValue>::KIND, $Name::$variant.about())
            $(.or(|| $crate::value::Written::written(&$default)))?
            $($(.$has($($($of)*)?))+)?
    };
}

/// Lists names of keys of a section, checked against its fields.
macro_rules! names {
    ($Section:ty: $($field:ident)*) => {{
        const _: fn(&$Section) = |_section| { $(let _ = &_section.$field;)* };
        &[$(stringify!($field)),*]
    }};
}

/// Wraps a value in one enum, or in two.
macro_rules! nested {
    ($value:expr, $outer:path) => {
        $outer($value)
    };
    ($value:expr, $outer:path, $inner:path) => {
        $outer($inner($value))
    };
}

pub(crate) use {key, names, nested, section};
