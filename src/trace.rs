//! The path of a ray: nearest hit, interaction, lighting, ray tree.

mod candidates;
pub(crate) mod intersect;
pub(crate) mod optics;
mod shade;
mod shadow;
mod tree;

pub(crate) use candidates::{Candidates, MOST};
pub(crate) use tree::trace;
