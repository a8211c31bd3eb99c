/// Columns `from`, `from + 2^spacing`, `from + 2 * 2^spacing` and so on, below `to`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnRange {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) spacing: u8,
}
