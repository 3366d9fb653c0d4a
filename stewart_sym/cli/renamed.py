"""Former names of subcommands, options, and values, with their present names."""

SUBCOMMANDS = {"advise": "choose-fidelity", "bench": "benchmark", "size": "size-actuators"}
OPTIONS = {
    "--allow-singular": "--on-singular nan",
    "--angles": "--rpy",
    "--box": "--position-bounds",
    "--clearance": "--min-clearance",
    "--condition": "--max-condition",
    "--drive": "--drive-terms",
    "--least": "--minimize",
    "--lengths": "--length-mode",
    "--no-pictures": "--no-plots",
    "--noise-angle": "--angle-std",
    "--noise-position": "--position-std",
    "--noise-share": "--noise-threshold",
    "--physical": "--enforce-physical",
    "--picture": "--plot",
    "--poses": "--samples",
    "--shared": "--identical-legs",
    "--sigma": "--force-std",
    "--start": "--pose-guess",
    "--turns": "--rpy-bounds",
}
VALUES = {
    "constant": "constant_orientation",
    "joint-angles": "joint_angles",
    "peak-force": "peak_force",
    "total": "six_dof",
}
