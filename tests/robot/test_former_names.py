"""Former names: they are no names of the package, no attributes of its classes, and no keys of its files."""

import json
from pathlib import Path
from typing import Any

import pytest
from command_line import error_of

import stewart_sym as ss
from stewart_sym.planning.plan_file import read_plan
from stewart_sym.simulation.scene import read_scene

PUBLIC = """
Approach BaseParameters Capability Certificate Course Crossing DampedSolution DriveEffort DriveEstimate
EquationsByParameter EquationsOfMotion Estimate ForceBounds ForceDerivatives Forces JointAngles
LegKinematics Limits Linearisation LogFormat LogWarning ModelFile MotorMotion Needs Offsets PATHS Parameters
PathSingularities PhysicalityWarning PlatformPose Reactions Saturation Simulation Singularity Smooth
Smoothing Stop Symbolic Thresholds Trace Units View Workspace array_kernel between capability crossings
damped_solution dynamic_fraction estimated_noise force_deviations force_residue forces_with_bounds linearise
pose_of_motors prepare resampled simulated_experiment singularities_along size smooth time_path UnitScaling
"""
"""Functions, classes, and constants that have another name or are constructors now."""

ATTRIBUTES = {
    "Robot": "accept home lengths limits_joint_angles m_r j_r physicality",
    "TrajectoryFormat": "lengths metres radians order",
    "Motion": "about_point in_axes unchecked",
    "Drive": "gear turns momentum stribeck smoothing back_efficiency",
    "JointOffsets": "cross along across wrist nothing spins",
    "DriveEffortResult": "electrical exceeded deviations",
    "ActuatorRequirementsResult": "push pull driving braking course deviations",
    "ActuatorHistory": "base platform weight deviations",
    "PoseLimits": "condition clearance",
    "WorkspaceResult": "clear reasons box angles poses",
    "Polytope": "what largest guaranteed",
    "PoseCertificate": "position angle alone",
    "PlanCertificate": "holds used active instants lengths_kept angles_kept",
    "PlannedPath": "given poses straight conditions straight_conditions",
    "ViaPose": "low high free moved",
    "TimedPath": "instants times",
    "FourierPath": "times",
    "StraightLinePath": "times breaks",
    "SingularityCrossing": "before after at uncertainty",
    "SingularityApproach": "at",
    "SingularityResult": "length condition smallest lost forces pitch axis point",
    "PathSingularitiesResult": "shortest longest joint_sine",
    "IdentificationResult": "doubts impossible free misfit inflation lag departure sigma",
    "DriveIdentificationResult": "confused sigma departure",
    "BaseParametersResult": "kept lift gap columns reduced shared",
    "Experiment": "measured sigma noise truth deviation",
    "ForceKernel": "columns_into forces_into forces_of_columns one_pose function",
    "SmoothSamplesResult": "rates second_rates sigma grid",
    "SmoothingOptions": "position angle cutoff on",
    "Viewer": "instants",
    "LegSprings": "balanced",
    "ComputedTorque": "wanted",
    "StateHistory": "times kinetic potential",
    "SimulationResult": "steps loaded drives within_steps weights_within_steps",
    "StopEvent": "kind text",
    "ForceSaturation": "time excess",
    "SymbolicResult": "whole",
    "ExportedModel": "loops",
}
"""Former attributes and methods by class."""


@pytest.mark.parametrize("name", PUBLIC.split())
def test_a_former_name_is_no_name_of_the_package(name: str) -> None:
    assert name not in dir(ss)
    assert not hasattr(ss, name)


@pytest.mark.parametrize("name", ATTRIBUTES)
def test_a_former_attribute_is_none_of_its_class(name: str) -> None:
    kind = find_class(name)
    known = {*dir(kind), *(field.name for field in getattr(kind, "__dataclass_fields__", {}).values())}
    assert not known & {*ATTRIBUTES[name].split()}


def find_class(name: str) -> Any:
    """Return a public class, or one of a result that has no public name."""
    from stewart_sym.design.actuator_requirements import ActuatorHistory
    from stewart_sym.kinematics.inverse_kinematics import InverseKinematicsResult

    inner = {"ActuatorHistory": ActuatorHistory, "InverseKinematicsResult": InverseKinematicsResult}
    return inner.get(name) or getattr(ss, name)


ROBOT_KEYS = {
    "accept": "suppress_warnings",
    "home": "home_position",
    "legs.friction": "legs.damping",
    "trajectory.lengths": "trajectory.length_mode",
    "legs.drive.gear": "legs.drive.gear_ratio",
    "legs.drive.stribeck": "legs.drive.stribeck_force",
    "legs.drive.smoothing": "legs.drive.regularization_speed",
    "legs.drive.back_efficiency": "legs.drive.backdrive_efficiency",
    "legs.offsets.cross": "legs.offsets.axis_offset",
    "legs.offsets.along": "legs.offsets.slide_offset_y",
    "legs.offsets.across": "legs.offsets.slide_offset_z",
    "legs.offsets.wrist": "legs.offsets.wrist_offset",
}
SCENE_KEYS = {
    "legs": "actuation",
    "thresholds": "stop_conditions",
    "start": "initial_state",
    "actuation.law": "actuation.type",
    "actuation.model": "actuation.model_formulation",
}
PLAN_KEYS = {
    "price": "smoothness_weight",
    "least": "minimize",
    "limits.condition": "limits.max_condition",
    "limits.clearance": "limits.min_clearance",
}


@pytest.mark.parametrize("former", ROBOT_KEYS)
def test_the_error_for_a_former_key_of_a_robot_file_names_the_present_one(former: str) -> None:
    tables = json.loads(json.dumps(ss.robots.dasgupta1998().to_dict()))
    *path, key = former.split(".")
    table = tables
    for name in path:
        table = table.setdefault(name, {})
    table[key] = 1.0
    present = ROBOT_KEYS[former].rpartition(".")[2]
    expected = f'robot: {former}: unknown key, did you mean "{present}"?'
    assert error_of(lambda: ss.Robot.from_dict(tables)) == expected


@pytest.mark.parametrize("former", [*SCENE_KEYS, *PLAN_KEYS])
def test_the_error_for_a_former_key_of_a_scene_or_plan_names_the_present_one(
    former: str, tmp_path: Path
) -> None:
    scene = former in SCENE_KEYS
    table, _, key = former.rpartition(".")
    text = 'schema = 1\nrobot = "robot.toml"\n' + ("duration = 1.0\n" if scene else "via = [1, 2]\n")
    text += f"[{table}]\n{key} = 1\n" if table else f"{key} = 1\n"
    if scene and table != "actuation" and former != "legs":
        text += '[actuation]\ntype = "constant_force"\nforces = [0, 0, 0, 0, 0, 0]\n'
    file = tmp_path / "file.toml"
    file.write_text(text)
    present = (SCENE_KEYS | PLAN_KEYS)[former].rpartition(".")[2]

    def read() -> None:
        if scene:
            read_scene(file)
        else:
            with read_plan(file):
                pass

    message = error_of(read)
    assert message.startswith(f'{file}: {former}: unknown key, did you mean "{present}"?'), message


def test_a_robot_file_of_schema_1_is_rejected_in_one_line_that_names_the_remedy() -> None:
    message = error_of(lambda: ss.Robot.from_dict({"schema": 1, "name": "old", "leg": []}))
    assert message.startswith("robot: schema: schema 1 is no longer read; write schema = 2")
    assert "\n" not in message


def test_a_motion_takes_keywords_alone() -> None:
    with pytest.raises(TypeError):
        ss.Motion([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 1], [0, 0, 0], [0, 0, 0])  # type: ignore[misc, arg-type]
