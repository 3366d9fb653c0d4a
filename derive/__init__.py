"""The derivation: from the paper's equations to the files of ``generated/``. SymPy only, no runtime.

In the order of the flow, each knowing only what stands before it:

    notation        every quantity with unit, frame and meaning
    block           straight-line programs with named steps; operation counts
    formulation     the switches between `paper` and `exact`, universal and spherical base joint
    leg             one leg: kinematics, twelve equations, solved by SymPy
    isotropic       leg-frame results back to vectors, for legs alike all round
    platform        the platform's equations, H and c read off
    kernels         leg and platform put together, closed into blocks
    reduce          blocks made cheaper
    prepared        constants that enter together, prepared once per robot
    joint_leg       the `exact` leg in the coordinates of its joints
    printed_leg     the `paper` leg with prepared constants
    regroup         the actuator forces alone, from fewer operations
    axial_leg       legs alike all round their axis: no leg frame, no universal axis
    fidelity        levels of less physics, reductions of one derivation
    bake            a robot's numbers folded in
    adjoint         slopes of a block's outputs along all its steps, by reverse differentiation
    rounding        what every step of a block rounds away
    tip             one leg at its tip: inertia, Coriolis matrix, derivatives
    kinematics      lengths and rates of the legs, and steps of the search of a pose
    motion          the closed form: M, C, g, forward dynamics, derivatives
    operations      what a whole kernel costs
    thresholds      where each status begins, and why there
    kernel          whole functions as trees: blocks, and what is written around them
    print           trees as C, Python, MATLAB and Rust
    emit            files of generated/: kernels in C and Python, and what they share
    package         what surrounds kernels: a kit for one robot, from files of ``templates``
    generate        all of it, written to files
    passes          what each reduction is worth

Proofs stand beside them: ``lagrange`` (the leg from its energies), ``tip_force`` (one force from three
roads), ``normal_form`` (how equality is decided). ``derivation.ipynb`` reads this beside the paper.
"""
