use toml::Spanned;
use toml::de::{DeArray, DeInteger, DeValue};
use whitted::{Color, Real, Vec3};

use super::error::LoadError;
use super::example::example;
use super::source::Source;
use super::suggest::suggestion;
use crate::text::excerpt;

/// A value in a TOML file. Its type is not checked yet.
pub(super) struct Value<'a> {
    pub(super) source: &'a Source<'a>,
    /// Path of the value, such as `objects[1].center[2]`.
    pub(super) path: String,
    /// Key of the value, or of the array that contains it.
    pub(super) key: &'a str,
    pub(super) node: &'a Spanned<DeValue<'a>>,
}

impl<'a> Value<'a> {
    /// Returns an error about this value.
    pub(super) fn error(&self, reason: impl Into<String>) -> LoadError {
        self.source.error(&self.node.span(), &self.path, reason)
    }

    /// Returns the value as it is written in the file.
    pub(super) fn source_text(&self) -> &'a str {
        self.source.text.get(self.node.span()).unwrap_or_default()
    }

    /// Returns the error for a value of the wrong type. `expected` describes the right type.
    pub(super) fn wrong_type(&self, expected: &str) -> LoadError {
        let node = self.node.get_ref();
        let found = match node {
            DeValue::String(_) => "a string",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(true) => "`true`",
            DeValue::Boolean(false) => "`false`",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "an array",
            DeValue::Table(_) => "a table",
        };
        let error = self.error_with_example(format!("must be {expected}, not {found}"));
        match node.as_str() {
            Some(text) if expected.contains("number") => match parse_decimal(text) {
                Ok(_) => error.help("remove the quotes"),
                Err(()) if parse_decimal(&text.replacen(',', ".", 1)).is_ok() => {
                    error.help("remove the quotes, and write a decimal point, not a comma")
                }
                Err(()) => error,
            },
            _ => error,
        }
    }

    /// Returns an error about this value whose help shows a valid example.
    pub(super) fn error_with_example(&self, reason: impl Into<String>) -> LoadError {
        let error = self.error(reason);
        match example(self.key) {
            "" => error,
            example => error.help(format!("write for example `{example}`")),
        }
    }

    /// Reads a number, rounded to the nearest `Real`.
    pub(super) fn number(&self) -> Result<Real, LoadError> {
        let number = match self.node.get_ref() {
            DeValue::Float(float) => match float.as_str() {
                text if text.contains(['i', 'n']) => {
                    return Err(
                        self.error_with_example(format!("must be a finite number, not {text}"))
                    );
                }
                text => parse_decimal(text),
            },
            DeValue::Integer(integer) => {
                parse_integer(integer).and_then(|number| Real::checked_from_num(number).ok_or(()))
            }
            _ => return Err(self.wrong_type("a number")),
        };
        number.map_err(|()| self.error_with_example("must be from -2147483648 to 2147483647"))
    }

    /// Reads the value as an integer from 0 to `max`.
    pub(super) fn integer(&self, max: u8) -> Result<u8, LoadError> {
        let integer = match self.node.get_ref() {
            DeValue::Integer(integer) => integer,
            DeValue::Float(float) => {
                return Err(self.error_with_example(format!(
                    "must be a whole number, not {}",
                    excerpt(float.as_str())
                )));
            }
            _ => return Err(self.wrong_type("a whole number")),
        };
        parse_integer(integer)
            .ok()
            .and_then(|number| u8::try_from(number).ok())
            .filter(|number| *number <= max)
            .ok_or_else(|| {
                self.error_with_example(format!(
                    "must be from 0 to {max}, not {}",
                    excerpt(&integer.to_string())
                ))
            })
    }

    /// Reads a vector `[x, y, z]`.
    pub(super) fn vector(&self) -> Result<Vec3<Real>, LoadError> {
        let [x, y, z] = self.numbers("three numbers [x, y, z]")?;
        Ok(Vec3::new(x, y, z))
    }

    /// Reads a color: a linear color `[r, g, b]` or an sRGB color `"#rrggbb"`.
    pub(super) fn color(&self) -> Result<Color<Real>, LoadError> {
        if let DeValue::String(text) = self.node.get_ref() {
            return hexadecimal(text).ok_or_else(|| {
                self.error(format!("`{}` is not a color", excerpt(text)))
                    .help("write six hexadecimal digits, such as \"#c04020\", or [r, g, b]")
            });
        }
        let [r, g, b] = self.numbers("a color [r, g, b] or \"#rrggbb\"")?;
        Ok(Color::new(r, g, b))
    }

    /// Reads an interval `[low, high]`. The library checks later, when it prepares the scene, that
    /// `low` is below `high`.
    pub(super) fn interval(&self) -> Result<[Real; 2], LoadError> {
        self.numbers("an interval [low, high]")
    }

    /// Reads an array of `N` numbers. `expected` describes the array in error messages.
    pub(super) fn numbers<const N: usize>(&self, expected: &str) -> Result<[Real; N], LoadError> {
        let mut numbers = [Real::ZERO; N];
        let values = self.array::<N>(expected).map_err(|error| {
            let has_commas = self.nodes(expected).is_ok_and(|nodes| nodes.len() == 2 * N);
            match has_commas {
                true => error.help("write decimal points in numbers, for example 0.05"),
                false => error,
            }
        })?;
        for (number, value) in numbers.iter_mut().zip(values) {
            *number = value.number()?;
        }
        Ok(numbers)
    }

    /// Reads an array of `N` values. `expected` describes the array in error messages.
    pub(super) fn array<const N: usize>(
        &self,
        expected: &str,
    ) -> Result<[Value<'a>; N], LoadError> {
        let count = self.nodes(expected)?.len();
        let wrong_count =
            || self.error_with_example(format!("must be {expected}, not an array of {count}"));
        // The count is checked first, because an array may be as long as the file.
        if count != N {
            return Err(wrong_count());
        }
        self.list(expected)?.try_into().map_err(|_| wrong_count())
    }

    /// Reads an array of any length. `expected` describes the array in error messages.
    pub(super) fn list(&self, expected: &str) -> Result<Vec<Value<'a>>, LoadError> {
        let element = |(index, node)| Value {
            source: self.source,
            path: format!("{}[{index}]", self.path),
            key: self.key,
            node,
        };
        Ok(self
            .nodes(expected)?
            .iter()
            .enumerate()
            .map(element)
            .collect())
    }

    /// Returns the elements of an array. `expected` describes the array in error messages.
    pub(super) fn nodes(&self, expected: &str) -> Result<&'a DeArray<'a>, LoadError> {
        match self.node.get_ref() {
            DeValue::Array(nodes) => Ok(nodes),
            _ => Err(self.wrong_type(expected)),
        }
    }

    /// Reads a string. `expected` describes the string in error messages.
    pub(super) fn text(&self, expected: &str) -> Result<&'a str, LoadError> {
        self.node
            .get_ref()
            .as_str()
            .ok_or_else(|| self.wrong_type(expected))
    }

    /// Reads a boolean.
    pub(super) fn boolean(&self) -> Result<bool, LoadError> {
        match self.node.get_ref() {
            DeValue::Boolean(flag) => Ok(*flag),
            _ => Err(self.wrong_type("`true` or `false`")),
        }
    }

    /// Reads a string that names one of `choices`.
    ///
    /// In error messages, `expected` describes the string, and `choices_are` introduces the list of
    /// choices.
    pub(super) fn choice<T: Copy>(
        &self,
        choices: &[(&'static str, T)],
        expected: &str,
        choices_are: &str,
    ) -> Result<T, LoadError> {
        let text = self.text(expected)?;
        let found = choices.iter().find(|(name, _)| *name == text);
        found.map(|(_, choice)| *choice).ok_or_else(|| {
            let names = choices.iter().map(|(name, _)| *name);
            self.error(format!("`{}` is not {expected}", excerpt(text)))
                .help(suggestion(text, names, choices_are))
        })
    }
}

/// Longest decimal number, in bytes.
const MAX_DIGITS: usize = 1000;

fn parse_decimal(text: &str) -> Result<Real, ()> {
    if text.len() > MAX_DIGITS {
        return Err(());
    }
    text.replace('_', "").parse().map_err(drop)
}

fn parse_integer(integer: &DeInteger) -> Result<i64, ()> {
    i64::from_str_radix(integer.as_str(), integer.radix()).map_err(drop)
}

/// Parses an sRGB color: `#` and two hexadecimal digits for each channel, or one digit that stands
/// for two equal ones.
fn hexadecimal(text: &str) -> Option<Color<Real>> {
    let digits = text.strip_prefix('#')?;
    let digits: Option<Vec<_>> = digits.chars().map(|digit| digit.to_digit(16)).collect();
    let [r, g, b] = match digits?[..] {
        [r, g, b] => [r, g, b].map(|digit| 17 * digit),
        [r, s, g, h, b, c] => [16 * r + s, 16 * g + h, 16 * b + c],
        _ => return None,
    };
    let [r, g, b] = [r, g, b].map(|level| level as u8);
    Some(Color::srgb(r, g, b))
}
