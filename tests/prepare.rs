//! Validation of scenes by `SceneBuffer::prepare`, item by item.

use whitted::scene::{Axis, ClipBox, SceneItem};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer,
    SceneError, Shape, Texture, Vec3, color, real, vec3,
};

const CAMERA: Camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
const SPHERE: Object = Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0));

/// Returns the error of a scene with this camera, light, material and second object.
fn error(camera: Camera, light: Light, material: Material, object: Object) -> SceneError {
    let scene = Scene {
        lights: &[light],
        materials: &[material],
        objects: &[SPHERE, object],
        ..Scene::new(camera)
    };
    SceneBuffer::<2, 1, 1>::new().prepare(&scene).unwrap_err()
}

fn light() -> Light {
    Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))
}

fn camera_error(camera: Camera) -> String {
    error(camera, light(), Material::BLACK, SPHERE).to_string()
}

fn light_error(light: Light) -> String {
    error(CAMERA, light, Material::BLACK, SPHERE).to_string()
}

fn material_error(material: Material) -> String {
    error(CAMERA, light(), material, SPHERE).to_string()
}

fn object_error(object: Object) -> String {
    error(CAMERA, light(), Material::BLACK, object).to_string()
}

fn setting_error(scene: Scene<'_>) -> String {
    SceneBuffer::<1, 1, 1>::new()
        .prepare(&scene)
        .unwrap_err()
        .to_string()
}

#[test]
fn rejects_invalid_cameras() {
    let far = real!(16777217);
    assert_eq!(
        camera_error(Camera {
            eye: Vec3::new(far, Real::ZERO, Real::ZERO),
            ..CAMERA
        }),
        "camera: eye must be from -16777216 to 16777216"
    );
    assert_eq!(
        camera_error(Camera {
            look_at: CAMERA.eye,
            ..CAMERA
        }),
        "camera: look_at must differ from `eye`"
    );
    assert_eq!(
        camera_error(Camera {
            up: vec3!(0, 0, 0),
            ..CAMERA
        }),
        "camera: up must not be zero"
    );
    assert_eq!(
        camera_error(Camera {
            up: vec3!(0, 1, 8),
            ..CAMERA
        }),
        "camera: up must not be parallel to the line of sight"
    );
    for fovy_deg in ["0.9", "171", "-30"] {
        let camera = Camera {
            fovy_deg: Real::lit(fovy_deg),
            ..CAMERA
        };
        assert_eq!(
            camera_error(camera),
            "camera: fovy_deg must be from 1 to 170"
        );
    }
}

#[test]
fn rejects_invalid_lights() {
    let bright = Color::gray(real!(257));
    assert_eq!(
        light_error(Light {
            diffuse: bright,
            ..light()
        }),
        "light 0: diffuse must be from 0 to 256"
    );
    let negative = color!(0, -0.1, 0);
    assert_eq!(
        light_error(Light {
            specular: negative,
            ..light()
        }),
        "light 0: specular must be from 0 to 256"
    );
}

#[test]
fn rejects_invalid_materials() {
    let black = Material::BLACK;
    let over = color!(0.5, 0.5, 1.01);
    for (field, material) in [
        ("ka", Material { ka: over, ..black }),
        ("kd", Material { kd: over, ..black }),
        ("ks", Material { ks: over, ..black }),
        ("kr", Material { kr: over, ..black }),
        ("kt", Material { kt: over, ..black }),
    ] {
        assert_eq!(
            material_error(material),
            format!("material 0: {field} must be from 0 to 1")
        );
    }
    let gray = Color::gray(real!(0.5));
    let dull = Material {
        ks: gray,
        shininess: real!(0.9),
        ..Material::BLACK
    };
    assert_eq!(
        material_error(dull),
        "material 0: shininess must be from 1 to 4096"
    );
    let dense = Material {
        kt: gray,
        ior: real!(4.1),
        ..Material::BLACK
    };
    assert_eq!(material_error(dense), "material 0: ior must be from 1 to 4");
    // Shininess is not checked if `ks` is black, nor is `ior` if `kt` is black.
    let unread = Material {
        shininess: Real::ZERO,
        ior: Real::ZERO,
        ..Material::BLACK
    };
    let scene = Scene {
        materials: &[unread],
        ..Scene::new(CAMERA)
    };
    assert!(SceneBuffer::<0, 0, 1>::new().prepare(&scene).is_ok());
}

#[test]
fn rejects_invalid_spheres() {
    let sphere = |radius: &str| Object::sphere(vec3!(0, 1, 0), Real::lit(radius), MaterialId(0));
    assert!(object_error(sphere("0")).starts_with("object 1: radius must be from 0.00000"));
    assert!(object_error(sphere("-1")).starts_with("object 1: radius must be from 0.00000"));
    // The scene is about ten units across, so the least radius is about 0.00003.
    assert!(object_error(sphere("0.00002")).starts_with("object 1: radius must be from 0.00003"));
    let dangling = Object {
        texture: Texture::Uniform(MaterialId(7)),
        ..SPHERE
    };
    assert_eq!(
        object_error(dangling),
        "object 1: material refers to material 7, but the number of materials is 1"
    );
}

/// Returns the error message for an object of this shape.
fn shape_error(shape: Shape) -> String {
    object_error(Object { shape, ..SPHERE })
}

fn real<const N: usize>(numbers: [&str; N]) -> [Real; N] {
    numbers.map(Real::lit)
}

#[test]
fn rejects_invalid_ellipsoids() {
    let ellipsoid = |radii| {
        let [x, y, z] = real(radii);
        shape_error(Shape::Ellipsoid {
            center: vec3!(0, 0, 0),
            radii: Vec3::new(x, y, z),
        })
    };
    for flat in ["0", "-0.5"] {
        assert_eq!(
            ellipsoid(["1", flat, "1"]),
            "object 1: radii must be from 0.000001 to 16777216"
        );
    }
    assert_eq!(
        ellipsoid(["1", "2", "0.007"]),
        "object 1: radii must be from 0.0078125 to 2"
    );
    // The scene is about ten units across, so the least radius is about 0.00003.
    assert_eq!(
        ellipsoid(["0.00001", "0.00002", "0.00003"]),
        "object 1: radii must be from 0.0000305176 to 16777216"
    );
}

#[test]
fn rejects_invalid_cylinders() {
    let cylinder = |radius, y: Option<[&str; 2]>| {
        shape_error(Shape::Cylinder {
            origin: vec3!(0, 0, 0),
            radius: Real::lit(radius),
            y: y.map(real),
        })
    };
    assert_eq!(
        cylinder("0", None),
        "object 1: radius must be from 0.000001 to 16777216"
    );
    assert_eq!(
        cylinder("0.00002", None),
        "object 1: radius must be from 0.0000305176 to 16777216"
    );
    for y in [["1", "1"], ["1", "-1"]] {
        assert_eq!(
            cylinder("1", Some(y)),
            "object 1: y must run from a lower to a higher value"
        );
    }
}

#[test]
fn rejects_invalid_cones() {
    let cone = |radius, height, y: Option<[&str; 2]>| {
        shape_error(Shape::Cone {
            origin: vec3!(0, 0, 0),
            radius: Real::lit(radius),
            height: Real::lit(height),
            y: y.map(real),
        })
    };
    assert_eq!(
        cone("-1", "1", None),
        "object 1: radius must be from 0.000001 to 16777216"
    );
    for height in ["0", "0.0009", "1025"] {
        assert_eq!(
            cone("1", height, None),
            "object 1: height must be from 0.0009765625 to 1024"
        );
    }
    for height in ["-0.0009", "-1025"] {
        assert_eq!(
            cone("1", height, None),
            "object 1: height must be from -1024 to -0.0009765625"
        );
    }
    // The slope is valid, but the height is too small for the scene's scale.
    for (height, range) in [
        ("0.00002", "from 0.0000305176 to 16777216"),
        ("-0.00002", "from -16777216 to -0.0000305176"),
    ] {
        assert_eq!(
            cone("0.001", height, None),
            format!("object 1: height must be {range}")
        );
    }
    assert_eq!(
        cone("1", "1", Some(["1", "0"])),
        "object 1: y must run from a lower to a higher value"
    );
    // The cone would be wider than the valid range at y = -20000.
    assert_eq!(
        cone("1024", "1", Some(["-20000", "1"])),
        "object 1: y must be from -16383 to 16385"
    );
}

#[test]
fn rejects_invalid_paraboloids() {
    let paraboloid = |y| {
        shape_error(Shape::Paraboloid {
            origin: vec3!(0, 0, 0),
            y: real(y),
        })
    };
    for high in ["-1", "0"] {
        assert_eq!(
            paraboloid(["-2", high]),
            "object 1: y[1] must be from 0.000001 to 16777216"
        );
    }
    assert_eq!(
        paraboloid(["0", "0.00003"]),
        "object 1: y[1] must be from 0.0000305176 to 16777216"
    );
    assert_eq!(
        paraboloid(["2", "1"]),
        "object 1: y must run from a lower to a higher value"
    );
}

#[test]
fn rejects_invalid_sphereflakes() {
    let flake = |radius, depth, ratio, frame| {
        shape_error(Shape::Sphereflake {
            center: vec3!(0, 0, 0),
            radius: Real::lit(radius),
            depth,
            ratio: Real::lit(ratio),
            frame,
        })
    };
    assert_eq!(
        flake("0", 1, "0.3", Shape::FLAKE_FRAME),
        "object 1: radius must be from 0.000001 to 16777216"
    );
    assert_eq!(
        flake("1", 9, "0.5", Shape::FLAKE_FRAME),
        "object 1: depth must be from 0 to 8"
    );
    // At depth 5, the smallest spheres would have a radius of 0.00001.
    assert_eq!(
        flake("1", 5, "0.1", Shape::FLAKE_FRAME),
        "object 1: depth must be from 0 to 4"
    );
    for ratio in ["0.09", "0.51"] {
        assert_eq!(
            flake("1", 1, ratio, Shape::FLAKE_FRAME),
            "object 1: ratio must be from 0.1 to 0.5"
        );
    }
    let [u, v, w] = Shape::FLAKE_FRAME;
    let long = vec3!(1.1, 0, 0);
    let slanted = vec3!(0.1, 0, -0.995);
    for frame in [
        [v, u, w],
        [u, -v, w],
        [long, v, w],
        [u, slanted, w],
        [u, v, v],
    ] {
        assert_eq!(
            flake("1", 1, "0.3", frame),
            "object 1: frame must be three unit vectors at right angles, u × v = w"
        );
    }
}

#[test]
fn rejects_invalid_planes_and_checkers() {
    let plane = |normal, bounds| Object {
        shape: Shape::Plane {
            normal,
            point: vec3!(0, 0, 0),
            bounds,
        },
        texture: Texture::Uniform(MaterialId(0)),
    };
    let up = vec3!(0, 1, 0);
    assert_eq!(
        object_error(plane(vec3!(0, 0, 0), ClipBox::NONE)),
        "object 1: normal must not be zero"
    );
    let empty = ClipBox {
        z: Some([Real::ONE, Real::ONE]),
        ..ClipBox::NONE
    };
    assert_eq!(
        object_error(plane(up, empty)),
        "object 1: bounds.z must run from a lower to a higher value"
    );
    let checker = |axes, size: &str| Object {
        texture: Texture::Checker {
            size: Real::lit(size),
            axes,
            materials: [MaterialId(0); 2],
        },
        ..plane(up, ClipBox::NONE)
    };
    assert_eq!(
        object_error(checker([Axis::Y, Axis::Y], "1")),
        "object 1: checker.axes must name two different axes"
    );
    assert!(
        object_error(checker([Axis::X, Axis::Z], "0"))
            .starts_with("object 1: checker.size must be from")
    );
}

#[test]
fn rejects_invalid_settings() {
    let scene = Scene::new(CAMERA);
    assert_eq!(
        setting_error(Scene {
            max_depth: 33,
            ..scene
        }),
        "scene: max_depth must be from 0 to 32"
    );
    assert_eq!(
        setting_error(Scene {
            min_weight: real!(1.1),
            ..scene
        }),
        "scene: min_weight must be from 0 to 1"
    );
    let dark = Color::gray(real!(-1));
    assert_eq!(
        setting_error(Scene {
            ambient: dark,
            ..scene
        }),
        "scene: ambient must be from 0 to 256"
    );
    assert_eq!(
        setting_error(Scene {
            background: Background::Solid(dark),
            ..scene
        }),
        "scene: background must be from 0 to 256"
    );
    assert_eq!(
        setting_error(Scene {
            objects: &[SPHERE; 2],
            materials: &[Material::BLACK],
            ..scene
        }),
        "scene: objects exceed the buffer's capacity of 1"
    );
    let prepared_depth = |depth| {
        let mut buffer = SceneBuffer::<1, 1, 1>::new();
        let mut prepared = buffer.prepare(&scene).unwrap();
        prepared.set_max_depth(depth).map_err(|error| error.item)
    };
    assert_eq!(prepared_depth(32), Ok(()));
    assert_eq!(prepared_depth(33), Err(SceneItem::Scene));
}

/// Items have 16-bit indices, of which one means "none", so lists hold at most 65,535.
#[test]
fn rejects_lists_longer_than_16_bit_indices() {
    let (lights, materials) = (vec![light(); 65_536], vec![Material::BLACK; 65_536]);
    let objects = vec![SPHERE; 65_536];
    let scene = Scene {
        materials: &materials[..1],
        ..Scene::new(CAMERA)
    };
    let too_long =
        |list, capacity| format!("scene: {list} exceed the buffer's capacity of {capacity}");
    for count in [65_536, 65_535] {
        // The longest valid list exceeds the capacity of the buffer, which is 1.
        let capacity = if count == 65_535 { 1 } else { 65_535 };
        let (lights, materials, objects) =
            (&lights[..count], &materials[..count], &objects[..count]);
        assert_eq!(
            setting_error(Scene { lights, ..scene }),
            too_long("lights", capacity)
        );
        assert_eq!(
            setting_error(Scene { materials, ..scene }),
            too_long("materials", capacity)
        );
        assert_eq!(
            setting_error(Scene { objects, ..scene }),
            too_long("objects", capacity)
        );
    }
}

#[test]
fn debug_output_of_a_prepared_scene_is_one_line() {
    let scene = Scene {
        materials: &[Material::BLACK],
        objects: &[SPHERE],
        ..Scene::new(CAMERA)
    };
    let mut buffer = SceneBuffer::<2, 2, 2>::new();
    let prepared = buffer.prepare(&scene).unwrap();
    let text = "PreparedScene { objects: 1, lights: 0, materials: 1 }";
    assert_eq!(format!("{prepared:?}"), text);
    assert_eq!(format!("{prepared:#?}"), text);
}
