/// Every `2^spacing`-th column of a line, starting with column `from` and ending before column
/// `to`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnRange {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) spacing: u8,
}
