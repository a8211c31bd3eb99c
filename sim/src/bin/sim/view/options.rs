use clap::ValueEnum;
use embedded_graphics::geometry::Size;
use whitted::render::{Dither, Output, SampleCount, Transfer};
use whitted_sim::cost::{BOARDS, Board};

use super::cycle::Cycle;
use crate::args::Order;
use crate::display::{DISPLAYS, Display};
use crate::format::Format;

/// Options of `sim view` that the user changes by keys.
pub(super) struct Options {
    pub(super) displays: Cycle<Display>,
    pub(super) orders: Cycle<Order>,
    pub(super) dithers: Cycle<Dither>,
    /// Transfer function, or `None` for that of the scene.
    pub(super) transfers: Cycle<Option<Transfer>>,
    /// Rays per antialiased pixel, or `None` without antialiasing.
    pub(super) edges: Cycle<Option<SampleCount>>,
    pub(super) boards: Cycle<Board>,
}

impl Options {
    /// Creates the options. The list of displays begins with `plain`. If `display` is given, it is
    /// the selected display. Otherwise, `plain` is selected.
    pub(super) fn new(plain: Display, display: Option<Display>) -> Self {
        let [board, boards @ ..] = BOARDS;
        Self {
            displays: Cycle::new(plain, DISPLAYS).starting_at(&display.unwrap_or(plain)),
            orders: Cycle::new(Order::Progressive, [Order::Scanlines]),
            dithers: Cycle::new(Dither::Ordered, [Dither::Off]),
            transfers: Cycle::new(None, [Some(Transfer::Linear), Some(Transfer::Srgb)]),
            edges: Cycle::new(None, [Some(SampleCount::Four), Some(SampleCount::Sixteen)]),
            boards: Cycle::new(board, boards),
        }
    }

    /// Selects the next color format for the display, even if the real display does not support
    /// this format.
    pub(super) fn next_format(&mut self) {
        let display = self.displays.current_mut();
        let formats = Format::value_variants();
        let index = formats.iter().position(|format| *format == display.format);
        let next = index.map_or(0, |index| (index + 1) % formats.len());
        display.format = formats[next];
    }

    /// Returns the transfer function and dithering. `scene` is the transfer function of the scene.
    pub(super) fn output(&self, scene: Transfer) -> Output {
        Output {
            transfer: self.transfers.current().unwrap_or(scene),
            dither: *self.dithers.current(),
        }
    }

    /// Returns a description of all options except the board.
    pub(super) fn text(&self) -> String {
        let display = self.displays.current();
        let Size { width, height } = display.size;
        let dither = match self.dithers.current() {
            Dither::Ordered => "dither",
            Dither::Off => "no dither",
        };
        let transfer = match self.transfers.current() {
            None => "the scene's transfer",
            Some(Transfer::Linear) => "linear",
            Some(Transfer::Srgb) => "sRGB",
        };
        let order = match self.orders.current() {
            Order::Progressive => "progressive",
            Order::Scanlines => "line by line",
        };
        let edges = match self.edges.current() {
            None => "no antialiasing",
            Some(SampleCount::Four) => "4 rays at edges",
            Some(SampleCount::Sixteen) => "16 rays at edges",
        };
        let (name, format) = (display.name, display.format.name());
        format!("{name} {width}x{height} {format}, {dither}, {transfer}, {edges}, {order}")
    }
}
