use std::io::Write;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;

use crate::console::Console;
use crate::outcome::Outcome;

/// Largest number of base64 characters in an escape sequence.
const CHUNK: usize = 4096;

/// Shows a picture with kitty's graphics protocol. Sends the PNG (`f=100`) in several escape
/// sequences. All but the last are marked with `m=1`. `q=2` tells the terminal not to answer.
pub(super) fn show(picture: &OutputImage<Rgb888>) -> Outcome {
    let base64 = picture.to_base64_png()?;
    let mut console = Console::Stdout;
    let mut control = "a=T,f=100,q=2,";
    let mut chunks = base64.as_bytes().chunks(CHUNK).peekable();
    while let Some(chunk) = chunks.next() {
        let more = u8::from(chunks.peek().is_some());
        let start = format!("\x1b_G{control}m={more};");
        console.write_control(&[start.as_bytes(), chunk, b"\x1b\\"].concat())?;
        control = "";
    }
    Ok(writeln!(console)?)
}
