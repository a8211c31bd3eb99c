use std::error::Error;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Frames of an animation, as red, green and blue of each pixel, and their delays.
pub(crate) type Frames = (Vec<Vec<u8>>, Vec<u16>);

/// Reads the frames of an APNG, each drawn over the previous ones.
pub(crate) fn apng_frames(path: &Path) -> Result<Frames, Box<dyn Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let control = reader.info().animation_control.ok_or("is not animated")?;
    assert_eq!(control.num_plays, 0);
    let [width, height] = [reader.info().width, reader.info().height].map(|side| side as usize);
    let mut picture = vec![0; 3 * width * height];
    let (mut frames, mut delays) = (Vec::new(), Vec::new());
    for _ in 0..control.num_frames {
        let mut part = vec![0; reader.output_buffer_size().ok_or("too large")?];
        reader.next_frame(&mut part)?;
        let control = reader.info().frame_control.ok_or("a frame")?;
        let (left, top) = (control.x_offset as usize, control.y_offset as usize);
        let length = 3 * control.width as usize;
        for (y, row) in (top..)
            .zip(part.chunks_exact(length))
            .take(control.height as usize)
        {
            let at = 3 * (y * width + left);
            picture[at..at + length].copy_from_slice(row);
        }
        frames.push(picture.clone());
        delays.push(control.delay_num);
    }
    Ok((frames, delays))
}

/// Reads the frames of a GIF, each drawn over the previous ones.
pub(crate) fn gif_frames(path: &Path) -> Result<Frames, Box<dyn Error>> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut reader = options.read_info(File::open(path)?)?;
    let width = usize::from(reader.width());
    let mut picture = vec![0; 3 * width * usize::from(reader.height())];
    let (mut frames, mut delays) = (Vec::new(), Vec::new());
    while let Some(frame) = reader.read_next_frame()? {
        let (left, top) = (usize::from(frame.left), usize::from(frame.top));
        for (y, row) in (top..).zip(frame.buffer.chunks_exact(4 * usize::from(frame.width))) {
            for (x, rgba) in (left..).zip(row.as_chunks::<4>().0) {
                if let [rgb @ .., 255] = rgba {
                    picture[3 * (y * width + x)..][..3].copy_from_slice(rgb);
                }
            }
        }
        frames.push(picture.clone());
        delays.push(frame.delay);
    }
    assert_eq!(reader.repeat(), gif::Repeat::Infinite);
    Ok((frames, delays))
}
