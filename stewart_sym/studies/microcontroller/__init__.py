"""One-pose kernels on a controller's processor: are their answers right, and what do they take.

Cross-compiles kits for Arm Cortex-M, runs them under QEMU, reads the object code; the C beside the modules
starts the emulated processor and counts.
"""
