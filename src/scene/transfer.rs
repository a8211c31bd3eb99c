/// Transfer function from linear radiance to display values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transfer {
    /// Display values are proportional to radiance.
    #[default]
    Linear,
    /// Display values are encoded as sRGB (IEC 61966-2-1). PC monitors and most color displays
    /// expect sRGB.
    Srgb,
}
