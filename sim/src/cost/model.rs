use std::fmt::{self, Write};

use toml::de::{DeTable, DeValue};

use super::board::Board;
use super::work::{ITEMS, Work};

/// The file that `cargo xtask fit` writes.
const FILE: &str = include_str!("../../cost.toml");

/// The price of each item on each core.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The compiler whose code the prices are of.
    pub toolchain: String,
    /// The cores.
    pub cores: Vec<Core>,
}

/// The prices of a core.
#[derive(Clone, Debug, PartialEq)]
pub struct Core {
    /// Its short name.
    pub name: String,
    /// Cycles for an instruction, on average: an estimate.
    pub cycles: f64,
    /// Instructions for each of the [`ITEMS`].
    pub instructions: [f64; ITEMS.len()],
}

impl Model {
    /// The committed one.
    ///
    /// # Errors
    /// What is wrong with the file, if a person has changed it.
    pub fn committed() -> Result<Self, String> {
        Self::parse(FILE)
    }

    /// Reads the file's text.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mend = |what: String| format!("sim/cost.toml: {what}; `cargo xtask fit` writes it");
        let file = DeTable::parse(text).map_err(|error| mend(error.message().to_owned()))?;
        let mut model = Self {
            toolchain: String::new(),
            cores: Vec::new(),
        };
        for (name, value) in file.get_ref() {
            match value.get_ref() {
                DeValue::Table(table) => {
                    let core = Core::read(name.get_ref(), table).map_err(mend)?;
                    model.cores.push(core);
                }
                DeValue::String(toolchain) => model.toolchain = toolchain.to_string(),
                _ => {}
            }
        }
        Ok(model)
    }

    /// A core by its short name.
    pub fn core(&self, name: &str) -> Option<&Core> {
        self.cores.iter().find(|core| core.name == name)
    }
}

impl Core {
    fn read(name: &str, table: &DeTable<'_>) -> Result<Self, String> {
        let number = |key: &str| {
            let float = table.get(key).and_then(|value| match value.get_ref() {
                DeValue::Float(float) => float.as_str().parse().ok(),
                _ => None,
            });
            float.ok_or_else(|| format!("[{name}] has no `{key}`"))
        };
        let mut instructions = [0.0; ITEMS.len()];
        for (price, item) in instructions.iter_mut().zip(ITEMS) {
            *price = number(item.key)?;
        }
        Ok(Self {
            name: name.to_owned(),
            cycles: number("cycles_per_instruction")?,
            instructions,
        })
    }

    /// The instructions that a frame will take.
    pub fn instructions(&self, work: &Work) -> f64 {
        let amounts = work.amounts().into_iter();
        amounts
            .zip(self.instructions)
            .map(|(amount, price)| amount as f64 * price)
            .sum()
    }

    /// The seconds that a frame will take on a board with this core.
    pub fn seconds(&self, work: &Work, board: &Board) -> f64 {
        self.instructions(work) * self.cycles / (f64::from(board.megahertz) * 1e6)
    }
}

/// As the file is written.
impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "# Instructions for each item of a frame, by core. Written by `cargo xtask fit`;\n\
             # not to be edited. docs/cost-model.md tells what they are.\n\n\
             toolchain = \"{}\"",
            self.toolchain
        )?;
        for core in &self.cores {
            let mut text = format!("\n[{}]\n", core.name);
            writeln!(text, "cycles_per_instruction = {:.2}", core.cycles)?;
            for (price, item) in core.instructions.iter().zip(ITEMS) {
                writeln!(text, "{} = {price:.1}", item.key)?;
            }
            f.write_str(&text)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::BOARDS;
    use super::*;

    #[test]
    fn the_committed_model_prices_every_board() -> Result<(), String> {
        let model = Model::committed()?;
        for board in BOARDS {
            let core = model.core(board.core).ok_or(board.core)?;
            assert!((0.4..3.0).contains(&core.cycles), "{core:?}");
            // Some items' prices may be in others', not that of a pixel without a surface.
            let pixel = price(core, "eye_ray") + price(core, "background");
            assert!(pixel > 100.0, "{core:?}");
            assert!(core.instructions.iter().all(|price| *price >= 0.0));
        }
        Ok(())
    }

    fn price(core: &Core, key: &str) -> f64 {
        let prices = ITEMS.iter().zip(&core.instructions);
        let price = prices.filter(|(item, _)| item.key == key);
        price.map(|(_, price)| *price).sum()
    }

    #[test]
    fn what_is_written_is_read() -> Result<(), String> {
        let model = Model::committed()?;
        assert_eq!(Model::parse(&model.to_string())?, model);
        Ok(())
    }

    #[test]
    fn a_missing_price_is_told() {
        let error = Model::parse("toolchain = \"x\"\n[m0]\ncycles_per_instruction = 1.5\n");
        let told = "sim/cost.toml: [m0] has no `byte`; `cargo xtask fit` writes it";
        assert_eq!(error, Err(told.to_owned()));
    }
}
