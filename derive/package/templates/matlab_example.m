%ONE_POSE One pose of $robot.
model = stewart.prepare(stewart.robot());
motion = stewart.zero_motion();
$motion
$calls
