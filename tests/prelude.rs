//! Checks that no public name of the library clashes with the prelude of embedded-graphics.

/// All names at once. A name that two of the modules define is ambiguous, and importing it from
/// here is a compile error.
mod both {
    #![allow(unused_imports, reason = "some names are listed below, others are not")]
    pub(crate) use embedded_graphics::prelude::*;
    pub(crate) use whitted::animation::*;
    pub(crate) use whitted::codec::*;
    pub(crate) use whitted::observer::*;
    pub(crate) use whitted::render::*;
    pub(crate) use whitted::scene::*;
    pub(crate) use whitted::*;
}

macro_rules! import {
    ($($name:ident)*) => {
        #[allow(unused_imports, reason = "importing is the test")]
        mod imported {
            $(pub(crate) use super::both::$name;)*
        }
        const IMPORTED: &[&str] = &[$(stringify!($name)),*];
    };
}

import! {
    AaSample Animation AnimationError AnimationProblem AntialiasError
    AntialiasedPicture AntialiasedRenderer Axis Background Camera ClipBox Color Crc32 DecodeError DirtyLines
    DisplayColor Dither Interpolation Keyframe Light Material MaterialId Object Observer Output
    Picture Poller PreparedAnimation PreparedScene Radiance RayKind RayNode Real RenderProgress Renderer SampleCount Scene
    SceneBuffer SceneBuilder SceneCounts SceneError SceneItem SceneProblem Shape ShapeKind
    SpecularModel Stats Step Target Texture Track Transfer Vec3
    animation codec color ior observer parse_literal real render scene scene_buffer vec3
    DrawTarget DrawTargetExt Dimensions Drawable OriginDimensions Pixel PixelColor Point Primitive
    Size Transform
}

/// The source files of the public modules.
const SOURCES: [&str; 6] = [
    include_str!("../src/lib.rs"),
    include_str!("../src/animation.rs"),
    include_str!("../src/codec.rs"),
    include_str!("../src/observer.rs"),
    include_str!("../src/render.rs"),
    include_str!("../src/scene.rs"),
];

/// Returns the names that a source file makes public outside of blocks.
fn public_names(source: &str) -> Vec<&str> {
    let items = source.split("\npub ").skip(1);
    let names = items.flat_map(|item| {
        let (keyword, rest) = item.split_once(' ').unwrap_or_default();
        let end = match keyword {
            "use" => rest.find(';'),
            _ => rest.find(|c: char| !c.is_alphanumeric() && c != '_'),
        };
        let path = rest.get(..end.unwrap_or(0)).unwrap_or_default();
        let names = path.rsplit("::").next().unwrap_or_default();
        names.trim_matches(['{', '}']).split(',').map(str::trim)
    });
    names.filter(|name| !name.is_empty()).collect()
}

#[test]
fn every_public_name_is_imported_together_with_the_prelude() {
    for source in SOURCES {
        for name in public_names(source) {
            assert!(IMPORTED.contains(&name), "add `{name}` to the list");
        }
    }
}

#[test]
fn finds_public_names() {
    let source = "\npub use a::{\n    B, C,\n};\npub struct D<'a> {\n    pub x: u8,\n}\npub mod e;\npub use f::G;";
    assert_eq!(public_names(source), ["B", "C", "D", "e", "G"]);
}
