//! Parameters that are one of several names: an enum, its names and their meanings, all in one place.

/// An enum for a parameter with names, each with its meaning for the table of parameters.
macro_rules! choice {
    (
        $(#[$doc:meta])*
        $visibility:vis enum $choice:ident {
            $($variant:ident = $name:literal: $meaning:literal),+ $(,)?
        }
    ) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        $visibility enum $choice {
            $(#[doc = $meaning] $variant),+
        }

        impl $choice {
            /// The names, each with its meaning.
            pub const NAMES: &'static [(&'static str, &'static str)] = &[$(($name, $meaning)),+];

            /// The kind of the parameter.
            pub const KIND: $crate::problem::numbers::parameter::Kind =
                $crate::problem::numbers::parameter::Kind::Choice($choice::NAMES);

            /// The choice with this name; `None` if there is none, as for a parameter that does not apply.
            pub fn parse(name: &str) -> Option<$choice> {
                match name {
                    $($name => Some($choice::$variant),)+
                    _ => None,
                }
            }
        }
    };
}

pub(crate) use choice;

#[cfg(test)]
mod tests {
    use crate::problem::numbers::parameter::Kind;

    choice! {
        /// What a bar meets.
        enum Opposite {
            Bar = "bar": "another bar",
            Wall = "wall": "a rigid wall",
        }
    }

    #[test]
    fn every_name_of_the_table_is_a_variant() {
        let Kind::Choice(names) = Opposite::KIND else {
            panic!("{:?}", Opposite::KIND)
        };
        assert_eq!(names, [("bar", "another bar"), ("wall", "a rigid wall")]);
        let parsed = names.iter().map(|(name, _)| Opposite::parse(name));
        let expected = [Some(Opposite::Bar), Some(Opposite::Wall)];
        assert!(parsed.eq(expected));
        assert_eq!([Opposite::parse("floor"), Opposite::parse("")], [None; 2]);
    }
}
