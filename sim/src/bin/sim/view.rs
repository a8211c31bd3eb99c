use crate::args::View;
use crate::outcome::Outcome;

/// Says how to get a window.
#[cfg(not(feature = "window"))]
pub(crate) fn view(_options: &View) -> Outcome {
    Err("this build cannot open windows
  help: install SDL 2 (Debian: apt install libsdl2-dev; macOS: brew install sdl2), then
        cargo run --release --package whitted-sim --features window -- view"
        .into())
}

/// Renders into a window, and waits until it is closed.
#[cfg(feature = "window")]
pub(crate) fn view(options: &View) -> Outcome {
    use embedded_graphics::pixelcolor::Rgb888;
    use embedded_graphics_simulator::{
        OutputSettingsBuilder, SimulatorDisplay, SimulatorEvent, Window,
    };
    use whitted::Renderer;
    use whitted_sim::scene_file::Buffer;

    /// Lines between two looks at the window's events.
    const BATCH: u32 = 8;

    let scene = crate::open::Scene::open(&options.scene)?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare_for(&options.quality, &mut buffer)?;
    let size = options.quality.size;
    let mut display = SimulatorDisplay::<Rgb888>::new(size);
    let settings = OutputSettingsBuilder::new().scale(2).build();
    let title = format!("{} - whitted", options.scene.display());
    let mut window = Window::new(&title, &settings);
    let mut renderer = Renderer::new(&prepared, size);
    let mut lines = 0..size.height;
    loop {
        for y in lines.by_ref().take(BATCH as usize) {
            renderer.draw_line(y, &mut display)?;
        }
        window.update(&display);
        if window.events().any(|event| event == SimulatorEvent::Quit) {
            return Ok(());
        }
    }
}
