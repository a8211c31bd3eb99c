//! Values of a TOML table, each of the type that is asked for, or a panic.

use toml::{Table, Value};

use crate::Float;
use crate::vec3::{Vec3, vec3};

/// The keys of a table that are not yet read.
pub struct Keys {
    table: Table,
    pub name: String,
}

impl Keys {
    pub fn new(table: Table, name: String) -> Self {
        Keys { table, name }
    }

    pub fn take(&mut self, key: &str) -> Option<Value> {
        self.table.remove(key)
    }

    pub fn need(&mut self, key: &str) -> Value {
        let name = &self.name;
        self.table
            .remove(key)
            .unwrap_or_else(|| panic!("{name}: no `{key}`"))
    }

    pub fn table(&mut self, key: &str) -> Keys {
        Keys::new(table_of(self.need(key)), key.to_owned())
    }

    pub fn tables(&mut self, key: &str) -> impl Iterator<Item = Keys> + use<> {
        let name = key.to_owned();
        self.take(key)
            .map_or(Vec::new(), list)
            .into_iter()
            .map(move |value| Keys::new(table_of(value), name.clone()))
    }

    /// Panics on a key that nothing asked for.
    pub fn done(self) {
        assert!(self.table.is_empty(), "{}: {:?}", self.name, self.table);
    }
}

pub fn table_of(value: Value) -> Table {
    match value {
        Value::Table(table) => table,
        other => panic!("{other:?} is no table"),
    }
}

fn list(value: Value) -> Vec<Value> {
    match value {
        Value::Array(values) => values,
        other => panic!("{other:?} is no array"),
    }
}

pub fn array<const N: usize>(value: Value) -> [Value; N] {
    list(value)
        .try_into()
        .unwrap_or_else(|values| panic!("{values:?}: {N} values are needed"))
}

pub fn number<F: Float>(value: Value) -> F {
    match value {
        Value::Float(x) => F::lit(x),
        Value::Integer(x) => F::lit(x as f64),
        other => panic!("{other:?} is no number"),
    }
}

pub fn whole(value: Value) -> u32 {
    let number = value.as_integer().and_then(|x| x.try_into().ok());
    number.unwrap_or_else(|| panic!("{value:?} is no natural number"))
}

pub fn numbers<F: Float, const N: usize>(value: Value) -> [F; N] {
    array(value).map(number)
}

pub fn vector<F: Float>(value: Value) -> Vec3<F> {
    let [x, y, z] = numbers(value);
    vec3(x, y, z)
}
