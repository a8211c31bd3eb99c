use embedded_graphics_core::geometry::Size;
use scene_serial::Receiver;
use whitted_sim::render;
use whitted_sim::scene_file::Buffer;

/// Receives a transfer as a board does, and draws the scenes that arrive. Returns true if a valid
/// scene arrives.
pub(crate) fn receives(transfer: &[u8]) -> bool {
    let mut receiver = Box::new(Receiver::<20_000>::new());
    let mut buffer = Box::new(Buffer::new());
    let mut is_drawn = false;
    for byte in transfer {
        let Some(Ok(())) = receiver.receive(*byte) else {
            continue;
        };
        if let Some(message) = receiver.message()
            && let Ok(mut scene) = buffer.decode(message.scene)
            && scene.set_max_depth(4).is_ok()
        {
            render::linear(&scene, Size::new(4, 3));
            is_drawn = true;
        }
        receiver.forget();
    }
    is_drawn
}
