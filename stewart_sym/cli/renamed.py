"""Former names of subcommands and options that are unlike the present names."""

SUBCOMMANDS = {"advise": "choose-fidelity", "bench": "benchmark", "size": "size-actuators"}
OPTIONS = {
    "--allow-singular": "--on-singular nan",
    "--angles": "--rpy",
    "--box": "--position-bounds",
    "--drive": "--drive-terms",
    "--least": "--minimize",
    "--lengths": "--length-mode",
    "--noise-angle": "--angle-std",
    "--noise-position": "--position-std",
    "--picture": "--plot",
    "--poses": "--samples",
    "--shared": "--identical-legs",
    "--sigma": "--force-std",
    "--start": "--pose-guess",
    "--turns": "--rpy-bounds",
}
