//! What is watched of a contact.

/// A number whose change of sign ends a step of the integration.
#[derive(Debug, Clone, Copy)]
pub struct Watched {
    /// Its value.
    pub value: f64,
    /// Smaller values are round-off.
    pub least: f64,
    /// Whether it is only watched for values below 0.
    pub one_sided: bool,
}

impl Watched {
    /// Of a change of sign in both directions.
    pub fn sign(value: f64) -> Watched {
        Watched {
            value,
            least: 0.0,
            one_sided: false,
        }
    }
}

/// The motion of a contact, and the sizes of the terms of which r and rdot are the sums.
#[derive(Debug, Clone, Copy)]
pub struct Motion {
    /// r and rdot.
    pub values: [f64; 2],
    /// The sums of the sizes of their terms.
    pub sizes: [f64; 2],
}

/// What a limit does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitAt {
    /// Its value.
    pub value: f64,
    /// Its rate.
    pub rate: f64,
}
