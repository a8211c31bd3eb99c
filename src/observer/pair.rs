use crate::math::{Color, Real};
use crate::observer::{Observer, RayKind, RayNode, ShapeKind};

/// An observer that forwards every callback to two other observers.
pub(crate) struct Pair<'o, A, B>(pub(crate) &'o mut A, pub(crate) &'o mut B);

impl<A: Observer, B: Observer> Observer for Pair<'_, A, B> {
    const OBSERVES_NODES: bool = A::OBSERVES_NODES || B::OBSERVES_NODES;

    fn ray(&mut self, kind: RayKind) {
        self.0.ray(kind);
        self.1.ray(kind);
    }

    fn test(&mut self, shape: ShapeKind, met: bool) {
        self.0.test(shape, met);
        self.1.test(shape, met);
    }

    fn shadow(&mut self, light: u16, transmittance: Option<Color<Real>>) {
        self.0.shadow(light, transmittance);
        self.1.shadow(light, transmittance);
    }

    fn node(&mut self, node: &RayNode) {
        self.0.node(node);
        self.1.node(node);
    }

    fn is_interrupted(&self) -> bool {
        self.0.is_interrupted() || self.1.is_interrupted()
    }
}
