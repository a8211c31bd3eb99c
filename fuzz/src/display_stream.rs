use display_stream::{Byte, Controller, Panel};
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use super::bytes::Bytes;

/// So small that it is soon written to its last pixel, or beyond.
const PANEL: Panel = Panel {
    memory: Size::new(6, 5),
    glass: Rectangle::new(Point::new(1, 2), Size::new(4, 3)),
    upright: 0,
    is_inverted: false,
};

/// Any stream is shown or complained about, and what it complains about changes
/// nothing that is seen. Says whether there is a picture in the end.
///
/// Of nine bytes the first tells, bit by bit, which of the others are data.
pub fn display_stream(input: &[u8]) -> bool {
    let (panel, stream) = input.split_at(input.len().min(1));
    let panel = Bytes(panel).byte();
    let mut controller = Controller::new(Panel {
        upright: panel & 0xf8,
        is_inverted: panel & 1 != 0,
        ..PANEL
    });
    for nine in stream.chunks(9) {
        let (kinds, bytes) = nine.split_at(1);
        let kinds = Bytes(kinds).byte();
        for (bit, byte) in bytes.iter().enumerate() {
            let before = controller.clone();
            if let Err(error) = controller.receive(Byte::new(kinds >> bit & 1 != 0, *byte)) {
                assert!(!error.to_string().is_empty());
                assert!(
                    before.picture() == controller.picture(),
                    "{error}, and yet it looks otherwise"
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
