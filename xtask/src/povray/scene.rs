//! A scene in POV-Ray's language, as far as the sphereflake's needs it.
//!
//! POV-Ray's terms are those of this renderer where its gamma is one and a
//! pigment stands for the diffuse color: `ambient` is a factor of the pigment,
//! a highlight has the light's color.

use std::io::Write;

use anyhow::{Result, bail, ensure};
use whitted_oracle::{
    Axis, Background, Camera, Color, Cover, Light, Material, Model, Object, OwnedScene, Shape,
    Vec3, vec3,
};

use super::flake;

type Scene = OwnedScene<f64>;

/// Writes the scene for a picture of this size; fails where POV-Ray would draw
/// something else.
pub(super) fn write(scene: &Scene, [width, height]: [u32; 2], out: &mut impl Write) -> Result<()> {
    let Background::Solid(background) = scene.settings.background else {
        bail!("a background that is no single color has no counterpart");
    };
    // It counts generations from the eye's rays.
    writeln!(
        out,
        "#version 3.7;\n\
         global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 }}\n\
         background {{ {} }}",
        scene.settings.max_depth + 1,
        color(background)
    )?;
    camera(&scene.camera, f64::from(width) / f64::from(height), out)?;
    for light in &scene.lights {
        self::light(light, out)?;
    }
    for (index, material) in scene.materials.iter().enumerate() {
        let texture = texture(material, scene.settings.ambient)?;
        writeln!(out, "#declare Material{index} = {texture};")?;
    }
    for object in &scene.objects {
        self::object(object, out)?;
    }
    Ok(())
}

fn point(v: Vec3<f64>) -> String {
    format!("<{}, {}, {}>", v.x, v.y, v.z)
}

fn color(color: Color<f64>) -> String {
    format!("rgb {}", point(color))
}

/// Its camera looks along z in a left-handed space; with x to the left, space
/// is right-handed. Its angle is the horizontal one.
fn camera(camera: &Camera<f64>, aspect: f64, out: &mut impl Write) -> Result<()> {
    let half = (camera.fovy_deg / 2.0).to_radians().tan() * aspect;
    Ok(writeln!(
        out,
        "camera {{ perspective location {} right {}*x up y sky {} angle {} look_at {} }}",
        point(camera.eye),
        -aspect,
        point(camera.up),
        2.0 * half.atan().to_degrees(),
        point(camera.look_at)
    )?)
}

fn light(light: &Light<f64>, out: &mut impl Write) -> Result<()> {
    ensure!(
        light.diffuse == light.specular,
        "a light's diffuse and specular colors are one"
    );
    let (at, color) = (point(light.position), color(light.diffuse));
    Ok(writeln!(out, "light_source {{ {at} {color} }}")?)
}

fn texture(material: &Material<f64>, ambient_light: Color<f64>) -> Result<String> {
    let Material { kd, ks, kt, .. } = *material;
    ensure!(kt.is_zero(), "transmission is not mapped");
    ensure!(ks.x == ks.y && ks.y == ks.z, "a highlight has no color");
    let glow = material.ka.times(ambient_light) + material.le;
    let highlight = match material.model {
        Model::Phong => format!("phong {} phong_size {}", ks.x, material.shininess),
        Model::BlinnPhong => format!("specular {} roughness {}", ks.x, 1.0 / material.shininess),
    };
    Ok(format!(
        "texture {{ pigment {{ {} }} finish {{ diffuse 1 ambient {} {highlight} reflection {{ {} }} }} }}",
        color(kd),
        color(factor(glow, kd)?),
        color(material.kr)
    ))
}

/// What makes this of a pigment.
fn factor(wanted: Color<f64>, pigment: Color<f64>) -> Result<Color<f64>> {
    let channel = |wanted: f64, pigment: f64| {
        ensure!(
            wanted == 0.0 || pigment > 0.0,
            "what is not diffuse cannot glow"
        );
        Ok(if wanted == 0.0 { 0.0 } else { wanted / pigment })
    };
    Ok(vec3(
        channel(wanted.x, pigment.x)?,
        channel(wanted.y, pigment.y)?,
        channel(wanted.z, pigment.z)?,
    ))
}

fn object(object: &Object<f64>, out: &mut impl Write) -> Result<()> {
    match (&object.shape, &object.cover) {
        (Shape::Sphereflake(flake), Cover::Material(material)) => {
            writeln!(out, "union {{")?;
            // To 1e-7, where a pixel is about one unit wide.
            flake::each(flake, &mut |Vec3 { x, y, z }, radius| {
                writeln!(out, "sphere {{ <{x:.7}, {y:.7}, {z:.7}>, {radius:.7} }}")
            })?;
            writeln!(out, "texture {{ Material{material} }} }}")?;
        }
        (Shape::Plane { .. }, Cover::Checker { .. }) => floor(object, out)?,
        _ => bail!("only sphereflakes of one material and checkered floors are mapped"),
    }
    Ok(())
}

/// A level rectangle with a checkerboard.
fn floor(object: &Object<f64>, out: &mut impl Write) -> Result<()> {
    let Object {
        shape:
            Shape::Plane {
                normal,
                point: on,
                bounds: [Some([x0, x1]), None, Some([z0, z1])],
            },
        cover:
            Cover::Checker {
                size,
                axes: [Axis::X, Axis::Z],
                materials: [even, odd],
            },
    } = *object
    else {
        bail!("only floors with bounds along x and z are mapped");
    };
    ensure!(
        normal == vec3(0.0, 1.0, 0.0),
        "only level floors are mapped"
    );
    let y = on.y;
    // The pattern is of cubes: the floor lies in the middle of a layer of them.
    Ok(writeln!(
        out,
        "polygon {{ 5, <{x0}, {y}, {z0}>, <{x1}, {y}, {z0}>, <{x1}, {y}, {z1}>, <{x0}, {y}, {z1}>, <{x0}, {y}, {z0}>\n\
         texture {{ checker texture {{ Material{even} }}, texture {{ Material{odd} }} scale {size} translate {}*y }} }}",
        y - size / 2.0
    )?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::root;

    fn written(name: &str) -> Result<String> {
        let scene = whitted_oracle::load(root().join("scenes").join(name));
        let mut out = Vec::new();
        write(&scene, [320, 240], &mut out)?;
        Ok(String::from_utf8(out)?)
    }

    #[test]
    fn the_sphereflake_is_written_sphere_by_sphere() -> Result<()> {
        let pov = written("sphereflake_3.toml")?;
        assert_eq!(pov.matches("sphere {").count(), 1885);
        assert_eq!(pov.matches("light_source").count(), 2);
        // ka / kd of the floor's dark squares.
        assert!(pov.contains("rgb <0.0425, 0.0595, 0.102>"));
        assert!(pov.contains("ambient rgb <0.141176"), "{}", &pov[..2000]);
        Ok(())
    }

    #[test]
    fn what_would_be_another_picture_is_refused() {
        for name in ["whitted.toml", "cylinders.toml", "four_spheres.toml"] {
            assert!(written(name).is_err(), "{name}");
        }
    }
}
