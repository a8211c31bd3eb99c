//! Mutations of the text of scene files.

use fastrand::Rng;

/// Numbers at and beyond the limits of scene files.
const NUMBERS: [&str; 24] = [
    "0",
    "-0.0",
    "-1",
    "0.5",
    "1",
    "2",
    "33",
    "256",
    "257",
    "65536",
    "16777216",
    "-16777216",
    "16777217",
    "1e-7",
    "0.000001",
    "1e-300",
    "1e30",
    "9223372036854775807",
    "99999999999999999999",
    "nan",
    "-inf",
    "0x7f",
    "1_0",
    "2147483647.999",
];

/// Parts of hostile or careless files.
const PARTS: [&str; 16] = [
    "\u{1b}[2J",
    "\0",
    "\u{202e}",
    "\r",
    "\"",
    "'''",
    "#",
    "=",
    ",",
    ".",
    "0,5",
    "true",
    "{}",
    "[]",
    "[[objects]]\n",
    "1979-05-27",
];

/// Returns one of the scenes after one or two mutations.
pub(crate) fn mutated(rng: &mut Rng, scenes: &[String]) -> Vec<u8> {
    let pick = |rng: &mut Rng| {
        scenes
            .get(rng.usize(..scenes.len()))
            .cloned()
            .unwrap_or_default()
    };
    let mut text = pick(rng);
    for _ in 0..rng.u8(1..=2) {
        text = match rng.u8(..10) {
            0..5 => number(rng, &text),
            5 => lines(rng, &text),
            6 => {
                let part = rng.choice(PARTS).unwrap_or_default();
                insert(rng, &text, part)
            }
            7 => nested(rng, &text),
            8 => long(rng, &text),
            _ => {
                let (start, _) = cut(rng, &text);
                let other = pick(rng);
                let (_, end) = cut(rng, &other);
                [start, end].concat()
            }
        };
    }
    let mut bytes = text.into_bytes();
    if rng.u8(..8) == 0 {
        super::binary::replace_bytes(rng, &mut bytes);
    }
    bytes
}

/// Replaces a number.
fn number(rng: &mut Rng, text: &str) -> String {
    let is_part = |character: char| character.is_ascii_digit() || "+-.".contains(character);
    let mut words: Vec<_> = text
        .split_inclusive(|character| !is_part(character))
        .collect();
    let numbers: Vec<_> = (0..words.len())
        .filter(|index| words[*index].starts_with(|c: char| c.is_ascii_digit()))
        .collect();
    let Some(index) = rng.choice(numbers) else {
        return text.to_owned();
    };
    let number = match rng.bool() {
        true => rng.choice(NUMBERS).unwrap_or_default().to_owned(),
        false => format!("{}.{}", rng.u8(..3), rng.u16(..)),
    };
    let replaced = [&number, words[index].trim_start_matches(is_part)].concat();
    words[index] = &replaced;
    words.concat()
}

/// Swaps, repeats or removes lines.
fn lines(rng: &mut Rng, text: &str) -> String {
    let mut lines: Vec<_> = text.split_inclusive('\n').collect();
    if lines.is_empty() {
        return String::new();
    }
    let (a, b) = (rng.usize(..lines.len()), rng.usize(..lines.len()));
    match rng.u8(..4) {
        0 => lines.swap(a, b),
        1 => drop(lines.remove(a)),
        2 => lines.insert(a, lines.get(b).copied().unwrap_or_default()),
        _ => lines.rotate_left(a),
    }
    lines.concat()
}

/// Inserts many brackets or parts of keys.
fn nested(rng: &mut Rng, text: &str) -> String {
    let part = rng
        .choice(["[", "{a=", "a.", "[[", "]", "\"\"\"", "[a."])
        .unwrap_or_default();
    let count = rng
        .choice([2, 79, 80, 81, 1000, 100_000])
        .unwrap_or_default();
    insert(rng, text, &part.repeat(count))
}

/// Inserts long comments, long names or many tables.
fn long(rng: &mut Rng, text: &str) -> String {
    let part = rng.choice([
        "# comment\n",
        "x",
        "\n[[objects]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"red\"\n",
        "\n[[lights]]\nposition = [0, 9, 0]\ncolor = [1, 1, 1]\n",
        "0, ",
        "[0, 1], ",
        "9",
    ]);
    let count = rng.choice([3, 100, 300, 9000, 200_000]).unwrap_or_default();
    insert(rng, text, &part.unwrap_or_default().repeat(count))
}

fn insert(rng: &mut Rng, text: &str, part: &str) -> String {
    let (start, end) = cut(rng, text);
    [start, part, end].concat()
}

/// Cuts a text at a random character, half of the time between two lines.
fn cut<'t>(rng: &mut Rng, text: &'t str) -> (&'t str, &'t str) {
    let places = 0..=text.len();
    let mut place = rng.usize(places.clone());
    while !text.is_char_boundary(place) {
        place = rng.usize(places.clone());
    }
    let (start, _) = text.split_at(place);
    if rng.bool() {
        place = start.rfind('\n').map_or(0, |end| end + 1);
    }
    text.split_at(place)
}
