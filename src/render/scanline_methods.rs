/// Defines the public methods that [`Renderer`](crate::Renderer) and
/// [`AntialiasedRenderer`](crate::render::AntialiasedRenderer) have in common.
///
/// The type that invokes this macro must have the fields `rays` (its `CameraRays`), `output` and
/// `observer`. It must also have a method `pixels(&mut self, y)`, which returns an iterator over
/// the columns and colors of line `y`.
macro_rules! scanline_methods {
    () => {
        /// Returns the observer that the renderer reports rays to.
        pub fn observer(&self) -> &O {
            &self.observer
        }

        /// Returns the observer that the renderer reports rays to, for changes.
        pub fn observer_mut(&mut self) -> &mut O {
            &mut self.observer
        }

        /// Returns the conversion of linear colors to display colors. At first, it has the transfer
        /// function of the scene.
        pub fn output(&self) -> $crate::render::Output {
            self.output
        }

        /// Sets the conversion of linear colors to display colors. Lines that are already drawn
        /// keep their colors.
        pub fn set_output(&mut self, output: $crate::render::Output) {
            self.output = output;
        }

        /// Returns the size of the picture in pixels.
        pub fn size(&self) -> embedded_graphics_core::geometry::Size {
            embedded_graphics_core::geometry::Size::new(self.rays.width, self.rays.height)
        }

        /// Returns the linear colors of line `y`, from left to right. The iterator is empty if `y`
        /// is outside the picture.
        pub fn line(&mut self, y: u32) -> impl Iterator<Item = $crate::Color<$crate::Radiance>> {
            self.pixels(y).map(|(_, color)| color)
        }

        /// Renders line `y` into a slice. A program can, for example, send the slice by DMA while
        /// it renders the next line.
        ///
        /// Pixels of the slice beyond the width of the picture are not changed.
        pub fn render_line<P: $crate::render::DisplayColor>(&mut self, y: u32, line: &mut [P]) {
            let output = self.output;
            for (pixel, (x, color)) in line.iter_mut().zip(self.pixels(y)) {
                let at = embedded_graphics_core::geometry::Point::new(x as i32, y as i32);
                *pixel = P::from_radiance(color, at, output);
            }
        }

        /// Draws line `y` by one call of `fill_contiguous`. The top left pixel of the picture is at
        /// the top left of the target's bounding box.
        ///
        /// # Errors
        /// Returns the error of the display if the call fails. The line can then be drawn again.
        pub fn draw_line<D>(&mut self, y: u32, target: &mut D) -> Result<(), D::Error>
        where
            D: embedded_graphics_core::draw_target::DrawTarget<Color: $crate::render::DisplayColor>,
        {
            let row = $crate::render::row_span::RowSpan::line(y, self.rays.columns());
            let origin = target.bounding_box().top_left;
            $crate::render::canvas::Canvas::<_, false>::new(target, origin, self.output)
                .fill_line(&row, self.pixels(y))
        }
    };
}

pub(super) use scanline_methods;
