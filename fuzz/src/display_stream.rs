use display_stream::{Byte, Controller, Panel};
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use super::bytes::Bytes;

/// Small panel, so that fuzz inputs reach its last pixel and write past it.
const PANEL: Panel = Panel {
    memory: Size::new(6, 5),
    glass: Rectangle::new(Point::new(1, 2), Size::new(4, 3)),
    madctl: 0,
    is_inverted: false,
};

/// Checks that any stream gives a picture or an error, and that a byte with an error does
/// not change the picture. Returns true if the display shows a picture at the end.
///
/// The first byte of the input selects the panel. Groups of nine bytes follow: bit `i` of
/// the first byte is the D/C level of the `i`-th of the eight others.
pub fn display_stream(input: &[u8]) -> bool {
    let (options, stream) = input.split_at(input.len().min(1));
    let options = Bytes(options).byte();
    let mut controller = Controller::new(Panel {
        madctl: options & 0xf8,
        is_inverted: options & 1 != 0,
        ..PANEL
    });
    for group in stream.chunks(9) {
        let (levels, bytes) = group.split_at(1);
        let levels = Bytes(levels).byte();
        for (bit, byte) in bytes.iter().enumerate() {
            let before = controller.clone();
            if let Err(error) = controller.receive(Byte::new(levels >> bit & 1 != 0, *byte)) {
                assert!(!error.to_string().is_empty());
                assert!(
                    before.picture() == controller.picture(),
                    "a byte with an error changed the picture: {error}"
                );
            }
        }
    }
    match controller.picture() {
        Ok(picture) => {
            let Size { width, height } = PANEL.glass.size;
            assert_eq!(picture.pixels().len(), (width * height) as usize);
            true
        }
        Err(error) => error.to_string().is_empty(),
    }
}
