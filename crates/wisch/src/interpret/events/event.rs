//! Events with their evidence.

/// Kind of event or phase during an interval of a log, as detected from pose and force alone; paper §4.2, Fig. 17 and
/// 18.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EventKind {
    /// The tool was in contact.
    Contact,
    /// The tool lost contact between two contacts of one stroke.
    ContactLoss,
    /// A person pushed the tool off the plane or along it, or held it in free motion.
    Push,
    /// A person guided the tool by hand, for longer than a push lasts or for most of the log.
    HandGuiding,
    /// The tool came down on the surface with more force than it wipes with.
    Landing,
    /// The tool was pressed onto the surface far harder than the task demands.
    Overload,
    /// The tool vibrated: an inertial force that oscillates about 0, for example after a long tool
    /// was lifted.
    Vibration,
    /// The tool alternately stuck and slipped.
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
    /// All kinds: events of contact first, phases last.
    pub const ALL: [Self; 12] = [
        Self::Contact,
        Self::ContactLoss,
        Self::Push,
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

    /// Name of the kind in files and queries.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::ContactLoss => "contact_loss",
            Self::Push => "collision",
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

    /// Whether a person's hand is on the tool, so that the measured force includes the force of the
    /// hand.
    pub const fn is_by_hand(self) -> bool {
        matches!(self, Self::Push | Self::HandGuiding)
    }

    /// Whether the event is a phase of the task. Phases follow one another and cover the whole log.
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
            | Self::Push
            | Self::HandGuiding
            | Self::Landing
            | Self::Overload
            | Self::Vibration
            | Self::StickSlip => false,
        }
    }
}

/// An event with its evidence. Times are those of the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Kind of the event.
    pub kind: EventKind,
    /// Start \[s\].
    pub start: f64,
    /// End \[s\].
    pub end: f64,
    /// Number of samples during the event.
    pub samples: usize,
    /// Mean normal force \[N\]; negative where the tool presses.
    pub mean_normal_force: f64,
    /// Largest size of the force \[N\].
    pub peak_force: f64,
    /// Largest distance from the fitted plane \[m\].
    pub peak_height: f64,
}
