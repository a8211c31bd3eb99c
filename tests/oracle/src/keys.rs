//! Typed access to the keys of a TOML table. Panics on missing or mistyped values.

use toml::{Table, Value};

use crate::Float;
use crate::vec3::{Vec3, vec3};

/// Keys of a table that have not been read yet.
pub struct Keys {
    table: Table,
    /// Name of the table in error messages.
    pub name: String,
}

impl Keys {
    pub fn new(table: Table, name: String) -> Self {
        Keys { table, name }
    }

    /// Removes and returns an optional value.
    pub fn take(&mut self, key: &str) -> Option<Value> {
        self.table.remove(key)
    }

    /// Removes and returns a required value.
    pub fn require(&mut self, key: &str) -> Value {
        let name = &self.name;
        self.table
            .remove(key)
            .unwrap_or_else(|| panic!("{name}: key `{key}` is missing"))
    }

    /// Removes and returns a required table.
    pub fn table(&mut self, key: &str) -> Keys {
        Keys::new(table_of(self.require(key)), key.to_owned())
    }

    /// Removes and returns an optional array of tables.
    pub fn tables(&mut self, key: &str) -> impl Iterator<Item = Keys> + use<> {
        let name = key.to_owned();
        self.take(key)
            .map_or(Vec::new(), list)
            .into_iter()
            .map(move |value| Keys::new(table_of(value), name.clone()))
    }

    /// Panics if a key was not read.
    pub fn finish(self) {
        assert!(
            self.table.is_empty(),
            "{}: unknown keys in {:?}",
            self.name,
            self.table
        );
    }
}

pub fn table_of(value: Value) -> Table {
    match value {
        Value::Table(table) => table,
        other => panic!("expected a table, found {other:?}"),
    }
}

fn list(value: Value) -> Vec<Value> {
    match value {
        Value::Array(values) => values,
        other => panic!("expected an array, found {other:?}"),
    }
}

pub fn array<const N: usize>(value: Value) -> [Value; N] {
    list(value)
        .try_into()
        .unwrap_or_else(|values| panic!("expected {N} values, found {values:?}"))
}

pub fn number<F: Float>(value: Value) -> F {
    match value {
        Value::Float(x) => F::lit(x),
        Value::Integer(x) => F::lit(x as f64),
        other => panic!("expected a number, found {other:?}"),
    }
}

pub fn whole(value: Value) -> u32 {
    let number = value.as_integer().and_then(|x| x.try_into().ok());
    number.unwrap_or_else(|| panic!("expected an unsigned integer, found {value:?}"))
}

pub fn numbers<F: Float, const N: usize>(value: Value) -> [F; N] {
    array(value).map(number)
}

pub fn vector<F: Float>(value: Value) -> Vec3<F> {
    let [x, y, z] = numbers(value);
    vec3(x, y, z)
}
