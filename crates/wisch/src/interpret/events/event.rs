//! An event and what shows it.

/// What happened during an interval of a log, as felt by pose and force alone; paper §4.2, Fig. 17 and 18.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EventKind {
    /// The tool was in contact.
    Contact,
    /// Between contacts of one stroke, the tool lost the surface.
    ContactLoss,
    /// Somebody pushed the tool off the plane or along it, or held it in free motion.
    Collision,
    /// Somebody led the tool by hand: for longer than a push lasts, or for most of the log.
    HandGuiding,
    /// The tool came down on the surface harder than it wipes.
    Landing,
    /// On the surface, the tool was pressed on much harder than asked for.
    Overload,
    /// The tool shook: a force that swings about nothing, as of a long tool that was just lifted.
    Vibration,
    /// The tool stuck and slipped.
    StickSlip,
    /// Phase: the tool came to the surface for the first time.
    Approach,
    /// Phase: the tool wiped, without being lifted.
    Stroke,
    /// Phase: the tool was lifted, and moved to the next stroke.
    Lift,
    /// Phase: the tool left the surface for the last time.
    Retreat,
}

impl EventKind {
    /// All of them, those of the contact first and the phases last.
    pub const ALL: [Self; 12] = [
        Self::Contact,
        Self::ContactLoss,
        Self::Collision,
        Self::HandGuiding,
        Self::Landing,
        Self::Overload,
        Self::Vibration,
        Self::StickSlip,
        Self::Approach,
        Self::Stroke,
        Self::Lift,
        Self::Retreat,
    ];

    /// Its name in records.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::ContactLoss => "contact_loss",
            Self::Collision => "collision",
            Self::HandGuiding => "hand_guiding",
            Self::Landing => "landing",
            Self::Overload => "overload",
            Self::Vibration => "vibration",
            Self::StickSlip => "stick_slip",
            Self::Approach => "approach",
            Self::Stroke => "stroke",
            Self::Lift => "lift",
            Self::Retreat => "retreat",
        }
    }

    /// Whether a person's hand is at the tool meanwhile, so that what is felt is the hand's as much as the surface's.
    pub const fn is_by_hand(self) -> bool {
        matches!(self, Self::Collision | Self::HandGuiding)
    }

    /// Whether it tells what the tool was about; such events follow one another over all of the log.
    ///
    /// ```
    /// use wisch::interpret::EventKind;
    ///
    /// assert!(EventKind::Stroke.is_phase());
    /// assert!(!EventKind::Contact.is_phase());
    /// ```
    pub const fn is_phase(self) -> bool {
        match self {
            Self::Approach | Self::Stroke | Self::Lift | Self::Retreat => true,
            Self::Contact
            | Self::ContactLoss
            | Self::Collision
            | Self::HandGuiding
            | Self::Landing
            | Self::Overload
            | Self::Vibration
            | Self::StickSlip => false,
        }
    }
}

/// Something that happened, with its evidence. Times are the log's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// From [s].
    pub start: f64,
    /// To [s].
    pub end: f64,
    /// How many samples show it.
    pub samples: usize,
    /// Mean normal force [N], negative where the tool presses.
    pub mean_normal_force: f64,
    /// Largest size of the force [N].
    pub peak_force: f64,
    /// Largest distance from the fitted plane [m].
    pub peak_height: f64,
}
