//! The scenes in scenes/ and tests/scenes/.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use whitted_sim::scene_file::{self, Buffer};

fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn every_scene_loads_and_prepares() -> Result<(), Box<dyn Error>> {
    for folder in ["scenes", "tests/scenes"] {
        let mut count = 0;
        for entry in fs::read_dir(project().join(folder))? {
            let file = scene_file::load(entry?.path())?;
            file.prepare(&mut Box::new(Buffer::new()))?;
            assert!(file.title.is_some(), "{file:?}");
            count += 1;
        }
        assert!(count >= 27, "{count} scenes in {folder}");
    }
    Ok(())
}
