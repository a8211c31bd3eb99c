use toml::Spanned;
use toml::de::{DeInteger, DeValue};
use whitted::{Color, Real, Vec3};

use super::error::LoadError;
use super::example::example;
use super::nearest::advice;
use super::source::Source;

/// A value of the file, yet of any type.
pub(super) struct Value<'a> {
    pub(super) source: &'a Source<'a>,
    /// `objects[1].center[2]`
    pub(super) path: String,
    /// The key that it stands under, itself or in an array.
    pub(super) key: &'a str,
    pub(super) node: &'a Spanned<DeValue<'a>>,
}

impl<'a> Value<'a> {
    /// An error about this value.
    pub(super) fn error(&self, reason: impl Into<String>) -> LoadError {
        self.source.error(&self.node.span(), &self.path, reason)
    }

    /// The error that this is not `what`.
    pub(super) fn wrong(&self, what: &str) -> LoadError {
        let node = self.node.get_ref();
        let (found, is_number) = match node {
            DeValue::String(text) => ("a string", decimal(text).is_ok()),
            DeValue::Integer(_) | DeValue::Float(_) => ("a number", false),
            DeValue::Boolean(true) => ("`true`", false),
            DeValue::Boolean(false) => ("`false`", false),
            DeValue::Datetime(_) => ("a date", false),
            DeValue::Array(_) => ("an array", false),
            DeValue::Table(_) => ("a table", false),
        };
        let error = self.advise(format!("must be {what}, not {found}"));
        if is_number && what.contains("number") {
            return error.help("remove the quotes");
        }
        error
    }

    /// An error about this value, with an example of a right one.
    pub(super) fn advise(&self, reason: impl Into<String>) -> LoadError {
        let error = self.error(reason);
        match example(self.key) {
            "" => error,
            example => error.help(format!("write for example `{example}`")),
        }
    }

    /// A number, rounded to the nearest `Real`.
    pub(super) fn number(&self) -> Result<Real, LoadError> {
        let number = match self.node.get_ref() {
            DeValue::Float(float) => match float.as_str() {
                text if text.contains(['i', 'n']) => {
                    return Err(self.advise(format!("must be a finite number, not {text}")));
                }
                text => decimal(text),
            },
            DeValue::Integer(integer) => {
                whole(integer).and_then(|number| Real::checked_from_num(number).ok_or(()))
            }
            _ => return Err(self.wrong("a number")),
        };
        number.map_err(|()| self.advise("must be from -2147483648 to 2147483647"))
    }

    /// A whole number from 0 to `most`.
    pub(super) fn count(&self, most: u8) -> Result<u8, LoadError> {
        let integer = match self.node.get_ref() {
            DeValue::Integer(integer) => integer,
            DeValue::Float(float) => {
                return Err(self.advise(format!("must be a whole number, not {float}")));
            }
            _ => return Err(self.wrong("a whole number")),
        };
        whole(integer)
            .ok()
            .and_then(|number| u8::try_from(number).ok())
            .filter(|number| *number <= most)
            .ok_or_else(|| self.advise(format!("must be from 0 to {most}, not {integer}")))
    }

    /// Three numbers.
    pub(super) fn vector(&self) -> Result<Vec3<Real>, LoadError> {
        let [x, y, z] = self.numbers("three numbers [x, y, z]")?;
        Ok(Vec3::new(x, y, z))
    }

    /// Three numbers.
    pub(super) fn color(&self) -> Result<Color<Real>, LoadError> {
        let [r, g, b] = self.numbers("a color [r, g, b]")?;
        Ok(Color::new(r, g, b))
    }

    /// Two numbers; that they rise is checked where a scene is prepared.
    pub(super) fn interval(&self) -> Result<[Real; 2], LoadError> {
        self.numbers("an interval [low, high]")
    }

    /// `N` numbers, called `what`.
    pub(super) fn numbers<const N: usize>(&self, what: &str) -> Result<[Real; N], LoadError> {
        let mut numbers = [Real::ZERO; N];
        for (number, value) in numbers.iter_mut().zip(self.array::<N>(what)?) {
            *number = value.number()?;
        }
        Ok(numbers)
    }

    /// An array of `N` values, called `what`.
    pub(super) fn array<const N: usize>(&self, what: &str) -> Result<[Value<'a>; N], LoadError> {
        let values = self.list(what)?;
        let count = values.len();
        values
            .try_into()
            .map_err(|_| self.advise(format!("must be {what}, not an array of {count}")))
    }

    /// An array of any length, called `what`.
    pub(super) fn list(&self, what: &str) -> Result<Vec<Value<'a>>, LoadError> {
        let DeValue::Array(nodes) = self.node.get_ref() else {
            return Err(self.wrong(what));
        };
        let element = |(index, node)| Value {
            source: self.source,
            path: format!("{}[{index}]", self.path),
            key: self.key,
            node,
        };
        Ok(nodes.iter().enumerate().map(element).collect())
    }

    /// A string, called `what`.
    pub(super) fn text(&self, what: &str) -> Result<&'a str, LoadError> {
        self.node.get_ref().as_str().ok_or_else(|| self.wrong(what))
    }

    /// `true` or `false`.
    pub(super) fn flag(&self) -> Result<bool, LoadError> {
        match self.node.get_ref() {
            DeValue::Boolean(flag) => Ok(*flag),
            _ => Err(self.wrong("`true` or `false`")),
        }
    }

    /// One of the named `choices`, which together are `these`.
    pub(super) fn choice<T: Copy>(
        &self,
        choices: &[(&'static str, T)],
        what: &str,
        these: &str,
    ) -> Result<T, LoadError> {
        let text = self.text(what)?;
        let found = choices.iter().find(|(name, _)| *name == text);
        found.map(|(_, choice)| *choice).ok_or_else(|| {
            let names = choices.iter().map(|(name, _)| *name);
            self.error(format!("`{text}` is not {what}"))
                .help(advice(text, names, these))
        })
    }
}

fn decimal(text: &str) -> Result<Real, ()> {
    text.replace('_', "").parse().map_err(drop)
}

fn whole(integer: &DeInteger) -> Result<i64, ()> {
    i64::from_str_radix(integer.as_str(), integer.radix()).map_err(drop)
}
