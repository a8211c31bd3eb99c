//! Macros that convert decimal literals to fixed point at compile time.
//!
//! The parser of the `fixed` crate takes 42 KB of flash and can panic. The macros call it in an
//! inline constant, so the program contains only the converted number.

use super::format::Real;

/// Parses a decimal number, with or without quotes. Returns `None` if the text is not a decimal
/// number or if the number is out of range. Only the macro [`real!`](crate::real!) calls this
/// function.
#[doc(hidden)]
pub const fn parse_literal(text: &str) -> Option<Real> {
    let digits = match text.as_bytes() {
        [b'"', digits @ .., b'"'] => digits,
        digits => digits,
    };
    let Ok(digits) = core::str::from_utf8(digits) else {
        return None;
    };
    match Real::from_str(digits) {
        Ok(number) => Some(number),
        Err(_) => None,
    }
}

/// Converts a decimal literal to a [`Real`](crate::Real) at compile time.
///
/// The literal is rounded to a multiple of 2^-32. It can be in quotes. The conversion costs no
/// flash and no time, also outside of constants and in loops.
///
/// ```
/// use whitted::{Real, real};
///
/// let quarter = real!(0.25);
/// assert_eq!(quarter + quarter, real!("0.5"));
/// assert_eq!(real!(-2) * 3, Real::from(-6));
/// ```
///
/// A literal that is not a decimal number from -2^31 to 2^31 does not compile:
///
/// ```compile_fail
/// whitted::real!(3000000000); // "not a decimal number from -2147483648 to 2147483647: 3000000000"
/// ```
///
/// ```compile_fail
/// whitted::real!("0,05");
/// ```
#[macro_export]
macro_rules! real {
    ($number:literal) => {
        const {
            match $crate::parse_literal(::core::stringify!($number)) {
                ::core::option::Option::Some(number) => number,
                ::core::option::Option::None => ::core::panic!(
                    "{}",
                    ::core::concat!(
                        "not a decimal number from -2147483648 to 2147483647: ",
                        ::core::stringify!($number)
                    )
                ),
            }
        }
    };
    ($($other:tt)*) => {
        ::core::compile_error!("`real!` takes one decimal number, for example `real!(0.25)`")
    };
}

/// Converts three decimal literals to a [`Vec3`](crate::Vec3) at compile time.
///
/// ```
/// use whitted::{Vec3, real, vec3};
///
/// assert_eq!(vec3!(0, 1.5, -2), Vec3::new(real!(0), real!(1.5), real!(-2)));
/// ```
#[macro_export]
macro_rules! vec3 {
    ($x:literal, $y:literal, $z:literal $(,)?) => {
        $crate::Vec3::new($crate::real!($x), $crate::real!($y), $crate::real!($z))
    };
    ($($other:tt)*) => {
        ::core::compile_error!(
            "`vec3!` takes three decimal numbers, for example `vec3!(0, 1.5, -2)`; for variables, use `Vec3::new`"
        )
    };
}

/// Converts three decimal literals, the linear red, green and blue channels, to a
/// [`Color`](crate::Color) at compile time.
///
/// ```
/// use whitted::{Color, color, real};
///
/// assert_eq!(color!(0.6, 0.04, 0.03), Color::new(real!(0.6), real!(0.04), real!(0.03)));
/// ```
#[macro_export]
macro_rules! color {
    ($r:literal, $g:literal, $b:literal $(,)?) => {
        $crate::Color::new($crate::real!($r), $crate::real!($g), $crate::real!($b))
    };
    ($($other:tt)*) => {
        ::core::compile_error!(
            "`color!` takes three decimal numbers, for example `color!(0.6, 0.04, 0.03)`; for variables, use `Color::new`"
        )
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parses_numbers_with_and_without_quotes() {
        for text in ["-1.5", "\"-1.5\"", "-1.5e0"] {
            assert_eq!(parse_literal(text), Some(Real::lit("-1.5")), "{text}");
        }
        assert_eq!(parse_literal("-2147483648"), Some(Real::MIN));
        for text in [
            "2147483648",
            "1.5f32",
            "\"0,05\"",
            "\"\"",
            "\"",
            "true",
            "0x10",
        ] {
            assert_eq!(parse_literal(text), None, "{text}");
        }
    }
}
