//! Test vectors: answers of 50 digits, and how far from them rounding may take a sound build.
#![allow(clippy::all)]
use $crate::*;

fn close(what: &str, found: &[Real], answer: &[Real], bound: &[Real]) {
    for i in 0..answer.len() {
        let error = (found[i] - answer[i]).abs();
        assert!(error <= bound[i] * Real::EPSILON, "{}[{}]: {} instead of {}", what, i, found[i], answer[i]);
    }
}
$tests
#[test]
fn inputs_that_are_not_finite_get_a_status() {
    let model = prepare(&ROBOT);
    let mut motion = Motion::ZERO;
    motion.t[2] = Real::NAN;
    assert_ne!($first(&model, &motion$force).status, OK);
    let mut robot = ROBOT;
    robot.M = Real::INFINITY;
    assert_eq!(prepare(&robot).status, NOT_FINITE);
}
