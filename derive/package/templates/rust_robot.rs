//! The numbers of $robot, from its robot file.
use crate::{Leg, Robot};

/// $robot.
pub const ROBOT: Robot = $numbers;
