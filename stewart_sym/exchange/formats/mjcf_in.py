"""Import of MJCF, the format of MuJoCo, which compiles the file."""

import os
import warnings
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...io.array_types import Array
from ...io.error_policy import need
from ...motion.rotation import rotation_from_quaternion, vector_from_rotation
from ..model import BETWEEN, WORLD, Body, Joint, Model
from ..notes import json_table
from .mjcf_out import NOTE
from .xml_text import CONTACTS, turn_limits

if TYPE_CHECKING:
    import mujoco

_KINDS = ("free", "spherical", "prismatic", "revolute")
"""Kinds of joints in the order of their numbers in MuJoCo."""
_ENDLESS = np.array([-np.inf, np.inf])
_ALIGNED = "freejoint align: MuJoCo moves to the center of mass, and turns, the frame"
_RIGID = "loop closures and limits: rigid; in MuJoCo they give way (solref, solimp)"


def model(path: str, text: str) -> Model:
    """Convert a file with its text to a model; raise ValueError in one line with a location on failure."""
    need("mujoco", "import of MJCF")
    import mujoco

    said: list[str] = []
    usual = mujoco.get_mju_user_warning()
    # Without a function, MuJoCo writes warnings to a file in the current folder.
    mujoco.set_mju_user_warning(said.append)
    try:
        with warnings.catch_warnings(record=True, action="always") as caught:
            found = _Reader(*_compiled(path, text)).model()
    finally:
        mujoco.set_mju_user_warning(usual)
    said += [str(each.message) for each in caught]
    lines = [_RIGID, *(f"MuJoCo: {' '.join(each.split())}" for each in said)]
    return replace(found, assumed={**found.assumed, **{each: each for each in lines}})


def _compiled(path: str, text: str) -> tuple["mujoco.MjSpec", "mujoco.MjModel"]:
    """Compile a file by MuJoCo, or its text if the name does not end with xml."""
    import mujoco

    try:
        if Path(path).suffix == ".xml":
            spec = mujoco.MjSpec.from_file(path)
        else:
            spec = mujoco.MjSpec.from_string(text)
            spec.modelfiledir = os.path.dirname(path)
        return spec, spec.compile()
    except (ValueError, mujoco.FatalError) as error:
        raise ValueError(f"MuJoCo: {' '.join(str(error).split())}") from None


class _Reader:
    """Reader of a compiled model, in the reference configuration."""

    def __init__(self, spec: "mujoco.MjSpec", compiled: "mujoco.MjModel") -> None:
        """Compute the positions of all bodies; raise ValueError for disabled constraints."""
        import mujoco

        self.spec, self.m, self.lib, self.flags = spec, compiled, mujoco, compiled.opt.disableflags
        for flag in ("constraint", "equality"):
            if self._off(flag):
                raise ValueError(f"option: flag: {flag}: expected enable, since it closes loops, got disable")
        # Contacts are not computed, because MuJoCo writes a file of warnings if there are too many.
        compiled.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        self.d = mujoco.MjData(compiled)
        mujoco.mj_fwdPosition(compiled, self.d)
        mujoco.mj_fwdVelocity(compiled, self.d)
        self.load = self.d.qfrc_spring + self.d.qfrc_gravcomp + self.d.qfrc_fluid
        self.left_out: list[str] = []
        self.servos: list[str] = []
        # Actuators by their limits in the two directions.
        self.uneven: dict[tuple[float, float], list[str]] = {}
        kinds = [int(mujoco.mjtTrn.mjTRN_JOINT), int(mujoco.mjtTrn.mjTRN_JOINTINPARENT)]
        # Joint of each actuator, or -1.
        self.driven = np.where(np.isin(compiled.actuator_trntype, kinds), compiled.actuator_trnid[:, 0], -1)

    def model(self) -> Model:
        """Read the model."""
        bodies, joints = self._tree()
        joints += self._closures()
        self.left_out += self._properties()
        gravity = np.zeros(3) if self._off("gravity") else self.m.opt.gravity
        note = next((each.data for each in self.spec.texts if each.name == NOTE), None)
        assumed = {name: f"{_ALIGNED} of {name!r}, which is taken" for name in self._aligned()}
        return Model(
            self.spec.modelname,
            np.array(gravity),
            tuple(bodies),
            tuple(joints),
            json_table(note, f"custom: text {NOTE!r}"),
            tuple(dict.fromkeys(self.left_out)),
            assumed,
        )

    def _off(self, flag: str) -> bool:
        """Return True if a flag of the options is disabled."""
        return bool(self.flags & int(getattr(self.lib.mjtDisableBit, f"mjDSBL_{flag.upper()}")))

    def _name(self, i: int, kind: str = "body") -> str:
        """Return the name of a body, joint, or other element, or its kind and number."""
        return str(getattr(self.m, kind)(i).name) or f"{kind} {i}"

    # Tree

    def _tree(self) -> tuple[list[Body], list[Joint]]:
        """Return all bodies, and the joints that carry them; several joints have massless bodies between."""
        bodies, joints = [Body(WORLD)], []
        for i in range(1, self.m.nbody):
            name, at = self._name(i), self._name(self.m.body_parentid[i])
            body = self._body(i, name)
            first, count = self.m.body_jntadr[i], self.m.body_jntnum[i]
            for number in range(count):
                child = name if number + 1 == count else f"{name}{BETWEEN}{number + 1}"
                if child != name:
                    bodies.append(Body(child, body.R, body.t))
                joints.append(self._joint(first + number, at, child))
                at = child
            if not count:
                joints.append(Joint(f"{name}, fixed", "fixed", at, name))
            bodies.append(body)
        return bodies, joints

    def _body(self, i: int, name: str) -> Body:
        """Return a body with its mass properties."""
        R = self.d.xmat[i].reshape(3, 3).copy()
        axes = rotation_from_quaternion(self.m.body_iquat[i])
        inertia = axes @ np.diag(self.m.body_inertia[i]) @ axes.T
        mass, center = float(self.m.body_mass[i]), self.m.body_ipos[i].copy()
        return Body(name, R, self.d.xpos[i].copy(), mass, center, 0.5 * (inertia + inertia.T))

    def _joint(self, i: int, parent: str, child: str) -> Joint:
        """Return a joint of the tree."""
        kind, name, dof = _KINDS[self.m.jnt_type[i]], self._name(i, "joint"), self.m.jnt_dofadr[i]
        single = kind in ("prismatic", "revolute")
        axes = self.d.xaxis[i : i + 1].copy() if single else np.zeros((0, 3))
        limits = _ENDLESS
        if self.m.jnt_limited[i] and not self._off("limit"):
            limits = self.m.jnt_range[i]
        elif self.m.jnt_range[i].any():
            low, high = self.m.jnt_range[i]
            self.left_out.append(f"range {low:g} {high:g}, which MuJoCo does not apply, of joint {name!r}")
        if kind in ("revolute", "spherical"):
            self.left_out += turn_limits(limits, f"joint {name!r}")
        joint = Joint(
            name,
            kind,
            parent,
            child,
            np.zeros(3) if kind == "free" else self.m.jnt_pos[i].copy(),
            axes,
            0.0 if self._off("damper") else float(self.m.dof_damping[dof]),
            float(self.m.dof_armature[dof]),
            float(self.m.qpos0[self.m.jnt_qposadr[i]]) if single else 0.0,
            (float(limits[0]), float(limits[1])),
            load=self._load(kind, dof, axes, self.m.jnt_bodyid[i]),
        )
        return self._with_actuators(joint, i) if kind == "prismatic" else joint

    def _load(self, kind: str, dof: int, axes: Array, body: int) -> Array:
        """Return force and moment on a body by springs, gravity compensation, and fluid at a joint, (6,)."""
        if len(axes):
            along = self.load[dof] * axes[0]
            zero = np.zeros(3)
            return np.concatenate([along, zero] if kind == "prismatic" else [zero, along])
        R, count = self.d.xmat[body].reshape(3, 3), 6 if kind == "free" else 3
        force = self.load[dof : dof + 3] if kind == "free" else np.zeros(3)
        return np.concatenate([force, R @ self.load[dof + count - 3 : dof + count]])

    def _aligned(self) -> Iterator[str]:
        """Yield the bodies whose frames MuJoCo moves to the inertial frame: free ones that carry none."""
        for joint in self.spec.joints:
            body = joint.parent
            aligned = joint.align == 1 or (joint.align != 0 and self.spec.compiler.alignfree)
            if int(joint.type) == int(self.lib.mjtJoint.mjJNT_FREE) and aligned and not body.bodies:
                yield self._name(body.id)

    # Closures and drives

    def _closures(self) -> Iterator[Joint]:
        """Yield loop closures and welds."""
        kinds = {int(self.lib.mjtEq.mjEQ_CONNECT): "spherical", int(self.lib.mjtEq.mjEQ_WELD): "fixed"}
        for i in range(self.m.neq):
            what = self.lib.mjtEq(self.m.eq_type[i]).name.removeprefix("mjEQ_").lower()
            name = self.m.equality(i).name or f"{what} {i + 1}"
            kind = kinds.get(int(self.m.eq_type[i]))
            if not self.m.eq_active0[i]:
                continue
            if kind is None:
                self.left_out.append(f"equality {what} {name!r}, which couples coordinates")
                continue
            ends = [self._end(i, kind, end) for end in (0, 1)]
            (one, R, here), (other, Q, there) = ends
            angle = float(np.linalg.norm(vector_from_rotation(R.T @ Q))) if kind == "fixed" else 0.0
            yield Joint(name, kind, one, other, there, position=angle, cut=True, parent_point=here)

    def _end(self, i: int, kind: str, end: int) -> tuple[str, Array, Array]:
        """Return body, orientation, and point in the body of one end of a closure."""
        number, data = int((self.m.eq_obj1id, self.m.eq_obj2id)[end][i]), self.m.eq_data[i]
        if self.m.eq_objtype[i] == int(self.lib.mjtObj.mjOBJ_SITE):
            R = self.d.site_xmat[number].reshape(3, 3)
            return self._name(self.m.site_bodyid[number]), R, self.m.site_pos[number].copy()
        R = self.d.xmat[number].reshape(3, 3)
        if kind == "spherical":
            return self._name(number), R, data[3 * end : 3 * end + 3].copy()
        if not end:
            R = R @ rotation_from_quaternion(data[6:10])
        return self._name(number), R, data[3 - 3 * end : 6 - 3 * end].copy()

    def _with_actuators(self, joint: Joint, i: int) -> Joint:
        """Return a slide with the combined limits, damping, and armature of its actuators."""
        m, on = self.m, np.flatnonzero(self.driven == i)
        names = [f"actuator {self._name(each, 'actuator')!r}" for each in on.tolist()]
        limits = m.jnt_actfrcrange[i] if m.jnt_actfrclimited[i] else _ENDLESS
        if names:
            forces = [self._forces(*each) for each in zip(on.tolist(), names, strict=True)]
            limits = np.clip(np.sum(forces, axis=0), *limits)
        low, high = np.abs(limits)
        if low != high:
            where = " and ".join(names) or f"joint {joint.name!r}"
            self.uneven.setdefault((min(low, high), max(low, high)), []).append(where)
        squares = m.actuator_gear[on, 0] ** 2
        return replace(
            joint,
            damping=joint.damping + float(squares @ m.actuator_damping[on]),
            armature=joint.armature + float(squares @ m.actuator_armature[on]),
            effort=float(max(low, high)),
            driven=bool(names),
        )

    def _forces(self, i: int, name: str) -> Array:
        """Return the range of the force of an actuator (N), shape (2,)."""
        m, forces, gear = self.m, _ENDLESS, self.m.actuator_gear[i, 0]
        control, gain = m.actuator_ctrladr[i], m.actuator_gainprm[i, 0]
        if m.actuator_dyntype[i] or m.actuator_gaintype[i] or m.actuator_biastype[i] or m.actuator_delay[i]:
            self.servos.append(name)
        elif m.actuator_ctrllimited[control] and not self._off("clampctrl"):
            forces = np.sort(gain * m.actuator_ctrlrange[control])
        if m.actuator_forcelimited[i]:
            forces = np.clip(forces, *m.actuator_forcerange[i])
        return np.sort(gear * forces) if gear else np.zeros(2)

    # Properties that a robot cannot represent

    def _properties(self) -> Iterator[str]:
        """Yield the properties of the model that a robot cannot represent."""
        m = self.m
        for i in range(m.njnt):
            yield from self._of_joint(i)
        for i in np.flatnonzero(m.body_gravcomp).tolist():
            yield f"gravcomp {m.body_gravcomp[i]:g} of body {self._name(i)!r}"
        for key in ("density", "viscosity"):
            if value := getattr(m.opt, key):
                yield f"{key} {value:g} of the medium around the machine: drag in motion"
        if self._off("actuation") or m.opt.disableactuator:
            yield "that the option disables actuators"
        for i in np.flatnonzero(m.actuator_dampingpoly.any(axis=-1)).tolist():
            yield f"nonlinear damping of actuator {self._name(i, 'actuator')!r}"
        for i, joint in enumerate(self.driven.tolist()):
            if joint < 0 or _KINDS[m.jnt_type[joint]] != "prismatic":
                yield f"actuator {self._name(i, 'actuator')!r}, which does not drive a prismatic joint"
        for i in range(m.ntendon):
            yield f"tendon {self._name(i, 'tendon')!r} with its stiffness, damping, friction, and limits"
        if m.nflex or m.nplugin:
            yield "deformable bodies and plugins"
        can_touch = m.geom_contype[:, None] & m.geom_conaffinity
        if (m.npair or can_touch.any()) and not self._off("contact"):
            yield CONTACTS
        for (least, most), where in self.uneven.items():
            actuators, other = ", ".join(where), f"{most:g} N, the other's, is force_limit"
            yield f"the limit of {least:g} N in one direction of {actuators}: {other}"
        if self.servos:
            limited = "force_limit follows from limits of their forces, not of their controls"
            yield f"gain, bias and dynamics of {', '.join(self.servos)}: {limited}"

    def _of_joint(self, i: int) -> Iterator[str]:
        """Yield the properties of a joint that a robot cannot represent, with their values."""
        m, dof = self.m, self.m.jnt_dofadr[i]
        for key, flag, values in (
            ("stiffness", "spring", [m.jnt_stiffness[i], *m.jnt_stiffnesspoly[i]]),
            ("nonlinear damping", "damper", m.dof_dampingpoly[dof]),
            ("frictionloss", "frictionloss", [m.dof_frictionloss[dof]]),
            ("margin", "limit", [m.jnt_margin[i]]),
        ):
            if np.any(values) and not self._off(flag):
                numbers = " ".join(f"{value:g}" for value in np.trim_zeros(values, "b"))
                yield f"{key} {numbers} of joint {self._name(i, 'joint')!r}"
