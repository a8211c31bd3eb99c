use clap::ValueEnum;
use embedded_graphics::geometry::Size;
use whitted::render::{Dither, Output, SampleCount, Transfer};
use whitted_sim::cost::{BOARDS, Board};

use super::cycle::Cycle;
use crate::args::{Format, Order};
use crate::display::{DISPLAYS, Display, format_name};

/// What keys go through.
pub(super) struct Options {
    pub(super) displays: Cycle<Display>,
    pub(super) orders: Cycle<Order>,
    pub(super) dithers: Cycle<Dither>,
    pub(super) transfers: Cycle<Transfer>,
    /// What is done about edges.
    pub(super) edges: Cycle<Option<SampleCount>>,
    pub(super) boards: Cycle<Board>,
}

impl Options {
    /// A plain display is the first, but not always the one to begin with.
    pub(super) fn new(plain: Display, display: Option<Display>) -> Self {
        let [board, boards @ ..] = BOARDS;
        Self {
            displays: Cycle::new(plain, DISPLAYS).at(&display.unwrap_or(plain)),
            orders: Cycle::new(Order::Progressive, [Order::Scanlines]),
            dithers: Cycle::new(Dither::Ordered, [Dither::Off]),
            transfers: Cycle::new(Transfer::Linear, [Transfer::Srgb]),
            edges: Cycle::new(None, [Some(SampleCount::Four), Some(SampleCount::Sixteen)]),
            boards: Cycle::new(board, boards),
        }
    }

    /// Gives the display the next format, whichever it really has.
    pub(super) fn next_format(&mut self) {
        let display = self.displays.current_mut();
        let formats = Format::value_variants();
        let place = formats.iter().position(|format| *format == display.format);
        let next = place.map_or(0, |place| (place + 1) % formats.len());
        display.format = formats[next];
    }

    /// How the display shows a picture.
    pub(super) fn output(&self) -> Output {
        Output {
            transfer: *self.transfers.current(),
            dither: *self.dithers.current(),
        }
    }

    /// All of it in words, but for the board.
    pub(super) fn text(&self) -> String {
        let display = self.displays.current();
        let Size { width, height } = display.size;
        let dither = match self.dithers.current() {
            Dither::Ordered => "dither",
            Dither::Off => "no dither",
        };
        let transfer = match self.transfers.current() {
            Transfer::Linear => "linear",
            Transfer::Srgb => "sRGB",
        };
        let order = match self.orders.current() {
            Order::Progressive => "progressive",
            Order::Scanlines => "line by line",
        };
        let edges = match self.edges.current() {
            None => "jagged",
            Some(SampleCount::Four) => "4 rays at edges",
            Some(SampleCount::Sixteen) => "16 rays at edges",
        };
        let (name, format) = (display.name, format_name(display.format));
        format!("{name} {width}x{height} {format}, {dither}, {transfer}, {edges}, {order}")
    }
}
