//! One pose of $robot.
use $crate::*;

fn main() {
    let model = prepare(&ROBOT);
    let motion = $motion;
$calls
}
