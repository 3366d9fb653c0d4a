"""Generated code: the derivation, kits for a machine, the CMake package."""
