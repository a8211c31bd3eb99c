//! Traces a ray in four stages. They find the nearest hit, compute its interaction, add direct
//! lighting and follow the ray tree.

mod background;
mod candidates;
mod interaction;
mod intersect;
mod lighting;
pub(crate) mod optics;
mod ray_tree;
mod scatter;
mod shadow;
mod tracer;

pub(crate) use candidates::{Candidates, MAX_CANDIDATES};
pub(crate) use tracer::Tracer;
