use whitted_sim::cost::{Core as Prices, ITEMS, Model};

use super::count::{COUNTED, Sample};
use super::cycles;
use super::least_squares::non_negative;
use super::mix::Mix;
use crate::qemu::Core;

/// How often a scene of the project counts where a random one counts once.
const SHIPPED: usize = 4;

/// The model, and how far it can be trusted.
pub(super) struct Fit {
    pub(super) model: Model,
    pub(super) trials: Vec<Trial>,
}

/// A picture that was predicted by a model which has not seen its scene.
pub(super) struct Trial {
    pub(super) name: String,
    pub(super) is_shipped: bool,
    pub(super) core: Core,
    pub(super) counted: u64,
    pub(super) predicted: f64,
}

impl Trial {
    /// How far the prediction is from what was counted, as a share of it.
    pub(super) fn error(&self) -> f64 {
        self.predicted / self.counted as f64 - 1.0
    }
}

impl Fit {
    pub(super) fn new(samples: &[Sample], mixes: &[(Core, Mix)], toolchain: &str) -> Self {
        let all: Vec<_> = samples.iter().collect();
        let cores = Core::ALL.map(|core| Prices {
            name: core.to_string(),
            cycles: cycles::per_instruction(core, mixes),
            instructions: prices(&all, counted_as(core)),
        });
        let model = Model {
            toolchain: toolchain.to_owned(),
            cores: cores.to_vec(),
        };
        let trials = COUNTED
            .into_iter()
            .flat_map(|core| samples.iter().map(move |sample| (core, sample)))
            .map(|(core, sample)| trial(sample, samples, core));
        Self {
            trials: trials.collect(),
            model,
        }
    }
}

/// The core whose code another runs.
pub(super) fn counted_as(core: Core) -> Core {
    match core {
        Core::M7 => Core::M4f,
        core => core,
    }
}

fn trial(left_out: &Sample, samples: &[Sample], core: Core) -> Trial {
    let others: Vec<_> = samples
        .iter()
        .filter(|sample| sample.subject.name != left_out.subject.name)
        .collect();
    let model = Prices {
        name: core.to_string(),
        cycles: 1.0,
        instructions: prices(&others, core),
    };
    Trial {
        name: left_out.subject.name.clone(),
        is_shipped: left_out.subject.is_shipped,
        core,
        counted: left_out.instructions[&core],
        predicted: model.instructions(&left_out.work),
    }
}

/// Those whose relative errors have the least squares.
fn prices(samples: &[&Sample], core: Core) -> [f64; ITEMS.len()] {
    let mut rows = Vec::new();
    for sample in samples {
        let counted = sample.instructions[&core] as f64;
        let row = sample.work.amounts().map(|amount| amount as f64 / counted);
        let times = if sample.subject.is_shipped {
            SHIPPED
        } else {
            1
        };
        rows.extend(std::iter::repeat_n(row, times));
    }
    non_negative(&rows)
}
