use clap::ValueEnum;

/// Color formats of displays. The order of the color channels (RGB or BGR) is left out, because it
/// does not change the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// 24 bits per pixel
    #[default]
    Rgb888,
    /// 18 bits per pixel
    Rgb666,
    /// 16 bits per pixel
    Rgb565,
    /// 15 bits per pixel
    Rgb555,
    /// 256 grays
    Gray8,
    /// 16 grays
    Gray4,
    /// 4 grays
    Gray2,
    /// Black and white
    #[value(alias = "bw")]
    Binary,
}

impl Format {
    /// Returns the name of the format on the command line.
    pub(crate) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }
}
