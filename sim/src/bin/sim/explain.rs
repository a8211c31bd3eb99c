use std::io::Write;

use embedded_graphics::geometry::Size;
use whitted_sim::ray_tree;
use whitted_sim::scene_file::Buffer;

use crate::args::Explain;
use crate::console::Console;
use crate::open::Scene;
use crate::outcome::Outcome;

/// Prints the ray tree of a pixel.
pub(crate) fn explain(options: &Explain) -> Outcome {
    let Explain { scene, x, y, .. } = options;
    let scene = Scene::open(scene)?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare_for(&options.quality, &mut buffer)?;
    let size = options.quality.size;
    let Some(tree) = ray_tree::trace(&prepared, size, [*x, *y]) else {
        let Size { width, height } = size;
        let (right, bottom) = (width - 1, height - 1);
        return Err(format!(
            "pixel {x} {y}: outside the picture of {width}x{height}
  help: x must be from 0 to {right}, y from 0 to {bottom}; `--size` sets the size"
        )
        .into());
    };
    let text = tree.draw(|object| scene.describe(object));
    Ok(write!(Console::Stdout, "{text}")?)
}
