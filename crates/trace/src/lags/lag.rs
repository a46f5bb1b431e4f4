//! A first-order lag of a form.

use crate::Form;

/// One first-order lag y' = (u − y)/τ of a form, in the steady periodic state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag {
    /// τ \[s\], greater than zero.
    pub tau_s: f64,
    /// u
    pub form: Form,
}
