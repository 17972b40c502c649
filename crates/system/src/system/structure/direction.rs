//! Directions of degrees of freedom.

/// The direction of a degree of freedom.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Direction {
    /// Along x.
    #[default]
    X,
    /// Along y.
    Y,
    /// Along z.
    Z,
    /// A rotation about x.
    Rx,
    /// A rotation about y.
    Ry,
    /// A rotation about z.
    Rz,
    /// None: the coordinate of a mode. No row of matrices has it.
    Modal,
}

impl Direction {
    /// All directions of rows; the translations come first.
    pub const ALL: [Direction; 6] = [
        Direction::X,
        Direction::Y,
        Direction::Z,
        Direction::Rx,
        Direction::Ry,
        Direction::Rz,
    ];

    /// The translations.
    pub const TRANSLATIONS: [Direction; 3] = [Direction::X, Direction::Y, Direction::Z];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Direction::X => "x",
            Direction::Y => "y",
            Direction::Z => "z",
            Direction::Rx => "rx",
            Direction::Ry => "ry",
            Direction::Rz => "rz",
            Direction::Modal => "",
        }
    }

    /// The direction with this name.
    pub fn named(name: &str) -> Option<Direction> {
        Direction::ALL
            .into_iter()
            .find(|direction| direction.name() == name)
    }
}
