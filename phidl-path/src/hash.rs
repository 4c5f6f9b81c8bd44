//! The geometry hash of a path, as PHIDL defines it.

use phidl_core::Result;
use sha1::{Digest as _, Sha1};

use crate::{Path, rule};

/// Keeps the boundaries between two bins away from round numbers.
const OFFSET: f64 = 0.170_486_14;

impl Path {
    /// PHIDL's SHA-1 over the points, truncated to `precision` (µm, usually 1e-4), and over all bits of the directions of
    /// the two ends; as 40 hexadecimal digits.
    ///
    /// Angles that come from points (of a polyline, a mirror line) differ in their last bit from machine to machine, and
    /// so does the hash. To compare the content of paths, compare the paths.
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the precision is greater than 0 and finite; and the deferred
    /// error.
    pub fn hash_geometry(&self, precision: f64) -> Result<String> {
        self.check()?;
        rule::positive_length("hash_geometry", "precision", precision)?;
        let mut hash = Sha1::new();
        for v in self.points().iter().flat_map(|p| [p.x, p.y]) {
            #[expect(clippy::cast_possible_truncation, reason = "`as` truncates toward zero, which is what is defined")]
            let bin = (v / precision + OFFSET) as i64;
            hash.update(bin.to_le_bytes());
        }
        let (start, end) = self.raw_angles();
        hash.update(start.to_le_bytes());
        hash.update(end.to_le_bytes());
        Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blank_path_has_the_hash_of_the_reference() {
        assert_eq!(Path::new().hash_geometry(1e-4).unwrap(), "de8a847bff8c343d69b853a215e6ee775ef2ef96");
        assert!(Path::new().hash_geometry(0.0).is_err());
    }
}
