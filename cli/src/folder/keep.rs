//! A set that keeps the files of the one before: what a failed build leaves.

use super::foreign::link;
use super::manifest::{Manifest, Provenance};
use super::{FolderError, Staging};

impl Staging {
    /// Puts the files of the present set into the new one, but for the file of this name, and gives back what they were
    /// made from; `None` where there is no set. A file that is listed and not there is left out.
    ///
    /// # Errors
    /// The system refuses.
    pub fn keep_set(&mut self, except: &str) -> Result<Option<Provenance>, FolderError> {
        let target = self.place.target.clone();
        let Some(manifest) = Manifest::read(&target)? else { return Ok(None) };
        for record in manifest.files.iter().cloned() {
            let (source, copy) = (target.join(&record.path), self.place.staging.join(&record.path));
            if record.path == except || !source.is_file() {
                continue;
            }
            self.go_on()?;
            self.make_folders(&copy)?;
            link(&source, &copy).map_err(FolderError::io("keep", &source))?;
            self.files.insert(record.path.clone(), record);
        }
        let Manifest { sources, parameters, set, machine, left_out, .. } = manifest;
        Ok(Some(Provenance { sources, parameters, set, machine, left_out, failed: true }))
    }
}
