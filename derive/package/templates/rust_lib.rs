//! Dynamics of the Stewart platform $robot: $outputs.
//!
//! Written by stewart-sym $version; do not edit.
//! SPDX-License-Identifier: 0BSD
//!
//! No heap, no dependency; without the feature `std` no standard library, and the square root is that of the
//! C library. Units are SI; vectors are in the base frame unless said otherwise. Equation numbers are those of
//! Dasgupta and Mruthyunjaya, Mechanism and Machine Theory 33 (1998) 1135-1152.
//!
//! Every function returns a structure with a `status`: where it is not `OK`, the other numbers are NaN.
#![cfg_attr(not(feature = "std"), no_std)]
#![allow(non_snake_case)]
#![allow(clippy::all)]

mod robot;
pub use robot::ROBOT;

/// The numbers of the kernel.
pub type Real = $real;

/// Status: fine.
pub const OK: usize = 0;
/// Status: a number of the robot, the motion or the result is not finite.
pub const NOT_FINITE: usize = 1;
/// Status: a leg is too short beside the vectors that it is the sum of.
pub const SHORT_LEG: usize = 2;
/// Status: a leg lies along the fixed axis of its universal joint.
pub const POLE: usize = 3;
/// Status: H is singular to rounding.
pub const SINGULAR: usize = 4;
/// Status: the inertia is not positive definite.
pub const INDEFINITE: usize = 6;

const EPSILON: Real = Real::EPSILON;
const MAX: Real = Real::MAX;
const NAN: Real = Real::NAN;
const ROUNDING: Real = 16.0 * EPSILON;
const POLE_SINE: Real = 4096.0 * EPSILON;
const NEAR_POLE: Real = 0.015625;
const SHORTEST: Real = $shortest;
const SUSPECT: Real = $suspect;
const SHORT_SHARE: Real = 16.0 * SUSPECT;
const KEPT: Real = 0.03125;
const LEANING: Real = 0.125;

#[cfg(feature = "std")]
fn sqrt(value: Real) -> Real {
    value.sqrt()
}

#[cfg(not(feature = "std"))]
fn sqrt(value: Real) -> Real {
    extern "C" {
        fn $root(value: Real) -> Real;
    }
    // SAFETY: the C library's square root reads its argument and nothing else.
    unsafe { $root(value) }
}

fn size(value: Real) -> Real {
    if value < 0.0 { -value } else { value }
}

fn larger(one: Real, other: Real) -> Real {
    if one > other { one } else { other }
}
$program
