"""Actuator forces that hold a model at rest in MuJoCo and in Pinocchio, with its loops closed."""

from collections.abc import Iterator, Mapping

import mujoco
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

Array = NDArray[np.float64]
_STEPS = 12
_CLOSED, _BALANCED = 1e-12, 1e-9


def balanced(bias: Array, J: Array, slides: list[int]) -> Array:
    """Compute the forces of the slides, (6,), that balance a load together with constraints."""
    A = np.concatenate([J.T, np.eye(len(bias))[:, slides]], axis=1)
    found, _, rank, _ = np.linalg.lstsq(A, bias, rcond=1e-12)
    if np.abs(A @ found - bias).max() > _BALANCED * np.abs(bias).max():
        raise AssertionError("the pose is no equilibrium")
    free = np.linalg.svd(A)[2][rank:, -len(slides) :]
    if free.size and np.abs(free).max() > 1e-6:
        raise AssertionError("the slides do not hold the model alone")
    return np.asarray(found[-len(slides) :])


class InMujoco:
    """A model in MuJoCo, in the pose of its file and in others."""

    def __init__(self, text: str) -> None:
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)

    def frame(self, body: str) -> tuple[Array, Array]:
        """Return orientation and position of a body."""
        found = self.data.body(body)
        return found.xmat.reshape(3, 3).copy(), found.xpos.copy()

    def move(self, rng: np.random.Generator, size: float) -> None:
        """Move to another pose with closed loops."""
        mujoco.mj_integratePos(self.model, self.data.qpos, size * rng.uniform(-1, 1, self.model.nv), 1.0)
        for _ in range(_STEPS):
            mujoco.mj_forward(self.model, self.data)
            step = np.linalg.lstsq(self._jacobian(), -self.data.efc_pos, rcond=1e-10)[0]
            mujoco.mj_integratePos(self.model, self.data.qpos, step, 1.0)
        mujoco.mj_forward(self.model, self.data)
        if np.abs(self.data.efc_pos).max() > _CLOSED:
            raise AssertionError("the loops do not close")

    def forces(self, slides: list[str]) -> Array:
        """Compute the forces of slides, along their coordinates, (6,)."""
        places = [int(self.model.joint(name).dofadr[0]) for name in slides]
        return balanced(self.data.qfrc_bias.copy(), self._jacobian(), places)

    def _jacobian(self) -> Array:
        return np.asarray(self.data.efc_J).reshape(-1, self.model.nv)


class InPinocchio:
    """A URDF in Pinocchio, closed as its loops say."""

    def __init__(self, text: str, loops: Mapping[str, object]) -> None:
        self.model, self.loops = pin.buildModelFromXML(text), loops
        self.model.gravity = pin.Motion(np.array(loops["gravity_m_s2"]), np.zeros(3))
        self.data, self.q = self.model.createData(), pin.neutral(self.model)
        self._update()

    def frame(self, link: str) -> tuple[Array, Array]:
        """Return orientation and position of a link."""
        found = self.data.oMf[self.model.getFrameId(link)]
        return found.rotation.copy(), found.translation.copy()

    def move(self, rng: np.random.Generator, size: float) -> None:
        """Move to another pose with closed loops."""
        turned = [self._turned(each) for each in self.loops["closures"]]
        self.q = pin.integrate(self.model, self.q, size * rng.uniform(-1, 1, self.model.nv))
        for _ in range(_STEPS):
            self._update()
            gaps = np.concatenate(list(self._gaps(turned)))
            step = np.linalg.lstsq(self._jacobian(), -gaps, rcond=1e-10)[0]
            self.q = pin.integrate(self.model, self.q, step)
        self._update()
        if np.abs(np.concatenate(list(self._gaps(turned)))).max() > _CLOSED:
            raise AssertionError("the loops do not close")

    def forces(self, slides: list[str]) -> Array:
        """Compute the forces of slides, along their coordinates, (6,)."""
        places = [self.model.joints[self.model.getJointId(name)].idx_v for name in slides]
        bias = pin.computeGeneralizedGravity(self.model, self.data, self.q)
        self._update()
        return balanced(bias, self._jacobian(), places)

    def _update(self) -> None:
        pin.computeJointJacobians(self.model, self.data, self.q)
        pin.framesForwardKinematics(self.model, self.data, self.q)

    def _turned(self, closure: Mapping[str, object]) -> Array:
        one, other = (self.frame(closure[key])[0] for key in ("link_1", "link_2"))
        return np.asarray(one.T @ other)

    def _gaps(self, turned: list[Array]) -> Iterator[Array]:
        for closure, at_home in zip(self.loops["closures"], turned, strict=True):
            (R, t), (Q, u) = (self.frame(closure[key]) for key in ("link_1", "link_2"))
            yield u + Q @ np.array(closure["point_2_m"]) - t - R @ np.array(closure["point_1_m"])
            if closure["type"] == "fixed":
                yield pin.log3(Q @ (R @ at_home).T)

    def _jacobian(self) -> Array:
        found = []
        for closure in self.loops["closures"]:
            J = self._point(closure, "2") - self._point(closure, "1")
            found.append(J if closure["type"] == "fixed" else J[:3])
        return np.concatenate(found)

    def _point(self, closure: Mapping[str, object], end: str) -> Array:
        """Compute the Jacobian of a point of a link, (6, nv), world axes."""
        link = self.model.getFrameId(closure[f"link_{end}"])
        axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        J = pin.getFrameJacobian(self.model, self.data, link, axes)
        arm = self.data.oMf[link].rotation @ np.array(closure[f"point_{end}_m"])
        return np.concatenate([J[:3] - np.cross(arm, J[3:].T).T, J[3:]])
