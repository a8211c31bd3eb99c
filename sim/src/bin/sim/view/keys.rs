/// Action of a key in `sim view`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Key {
    Left,
    Right,
    Up,
    Down,
    Closer,
    Farther,
    NextScene,
    PreviousScene,
    Display,
    Format,
    Dither,
    Transfer,
    Antialiasing,
    Order,
    Chip,
    Pause,
    Save,
    Reset,
    Help,
    Quit,
}

/// SDL's names of keys, and the actions of the keys.
const NAMES: [(&str, Key); 25] = [
    ("Left", Key::Left),
    ("Right", Key::Right),
    ("Up", Key::Up),
    ("Down", Key::Down),
    ("+", Key::Closer),
    // On US keyboards, the key of `+` without Shift is `=`.
    ("=", Key::Closer),
    ("Keypad +", Key::Closer),
    ("-", Key::Farther),
    ("Keypad -", Key::Farther),
    ("N", Key::NextScene),
    ("Tab", Key::NextScene),
    ("P", Key::PreviousScene),
    ("D", Key::Display),
    ("F", Key::Format),
    ("T", Key::Dither),
    ("G", Key::Transfer),
    ("A", Key::Antialiasing),
    ("O", Key::Order),
    ("C", Key::Chip),
    ("Space", Key::Pause),
    ("S", Key::Save),
    ("R", Key::Reset),
    ("H", Key::Help),
    ("Q", Key::Quit),
    ("Escape", Key::Quit),
];

/// Help text: the keys and their actions.
pub(super) const HELP: [&str; 6] = [
    "arrows  orbit the camera      n, Tab  next scene            t  dither: on, off",
    "+ -     zoom                  p       previous scene        g  transfer: linear, sRGB",
    "r       reset the camera      d       next display          a  antialiasing: off, 4, 16 rays",
    "s       save the picture      f       next format           o  order: progressive, line by line",
    "h       help on, off          c       chip of the estimate  q, Esc  quit",
    "Space pauses an animation. The scene is reloaded when its file is saved.",
];

impl Key {
    /// Returns the action of the key with an SDL name.
    pub(super) fn named(name: &str) -> Option<Self> {
        let found = NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, key)| *key)
    }

    /// Returns true if the action repeats while the key is held.
    pub(super) fn repeats(self) -> bool {
        use Key::{Closer, Down, Farther, Left, Right, Up};
        matches!(self, Left | Right | Up | Down | Closer | Farther)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_keys_by_name() {
        assert_eq!(Key::named("Left"), Some(Key::Left));
        assert_eq!(Key::named("Keypad -"), Some(Key::Farther));
        assert_eq!(Key::named("F1"), None);
    }

    #[test]
    fn help_lists_every_letter() {
        let help = HELP.join(" ");
        for (name, _) in NAMES
            .iter()
            .filter(|(name, _)| name.len() == 1 && *name != "=")
        {
            let name = name.to_lowercase();
            assert!(help.split([' ', ',']).any(|word| word == name), "{name}");
        }
    }
}
