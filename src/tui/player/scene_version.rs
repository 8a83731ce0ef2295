//! Identifies a solved scene, for cached results.

use std::sync::Arc;

/// The revision of a solved scene. Cached results are valid while it is equal. An edit or another
/// assembly creates a new revision; another coordinate does not.
#[derive(Clone, Debug, Default)]
pub(crate) struct SceneRevision(Arc<()>);

impl PartialEq for SceneRevision {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for SceneRevision {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn revision_equals_only_its_clones() {
        let one = SceneRevision::default();
        assert_eq!(one, one.clone());
        assert_ne!(one, SceneRevision::default());
    }
}
