//! Renders pictures to memory, with one thread per core.

use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;

use crate::load::OwnedScene;
use crate::{Float, Scene};

/// Rendering is not generic, so that it is compiled with the optimization level of
/// this crate and not with that of a test.
impl OwnedScene<f64> {
    /// Renders in f64. Returns unclipped linear colors, row by row from the top.
    pub fn render(&self, width: u32, height: u32) -> Vec<[f64; 3]> {
        render(&self.scene(), width, height)
    }
}

impl OwnedScene<f32> {
    /// Renders in f32. Returns unclipped linear colors, row by row from the top.
    pub fn render(&self, width: u32, height: u32) -> Vec<[f64; 3]> {
        render(&self.scene(), width, height)
    }
}

fn render<F: Float>(scene: &Scene<'_, F>, width: u32, height: u32) -> Vec<[f64; 3]> {
    let view = scene.camera.view(width, height);
    let row = |y| {
        (0..width)
            .map(|x| scene.pixel(&view, x, y).to_array().map(F::to_f64))
            .collect::<Vec<_>>()
    };
    // Rows differ in cost, so each thread takes the next row when it is free.
    let next = AtomicU32::new(0);
    let work = || {
        let mut rows = Vec::new();
        loop {
            let y = next.fetch_add(1, Ordering::Relaxed);
            if y >= height {
                return rows;
            }
            rows.push((y, row(y)));
        }
    };
    let threads = thread::available_parallelism().map_or(1, |n| n.get());
    let mut rows = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().expect("a row renders"))
            .collect::<Vec<_>>()
    });
    rows.sort_by_key(|(y, _)| *y);
    rows.into_iter().flat_map(|(_, row)| row).collect()
}
