//! The pictures that rustdoc embeds are up to date.

use std::fs;
use std::path::Path;

/// Encodes bytes as base64 (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let byte = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let shown = DIGITS[(word >> (18 - 6 * digit)) as usize % 64];
            text.push(if digit > chunk.len() {
                '='
            } else {
                shown.into()
            });
        }
    }
    text
}

#[test]
fn base64_is_right() {
    let encoded = ["", "f", "fo", "foo", "foobar"].map(|text| base64(text.as_bytes()));
    assert_eq!(encoded, ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYmFy"]);
}

/// docs.rs shows no files of the package, so rustdoc embeds the pictures as base64. To write the
/// text of a picture again: `base64 -w0 NAME.png > NAME.base64`.
#[test]
fn texts_encode_the_pictures() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/images");
    for (text, picture) in [
        ("rustdoc/whitted.base64", "rustdoc/whitted.png"),
        (
            "rustdoc/over_interface.base64",
            "examples/over_interface.png",
        ),
    ] {
        let encoded = base64(&fs::read(docs.join(picture)).unwrap());
        assert!(
            fs::read_to_string(docs.join(text)).unwrap() == encoded,
            "{text} is out of date"
        );
    }
}
