function made = constants()
%CONSTANTS Status codes, and constants of the arithmetic.
    made.OK = 0;
    made.NOT_FINITE = 1; % a number of the robot, the motion or the result is not finite
    made.SHORT_LEG = 2; % a leg is too short beside the vectors that it is the sum of
    made.POLE = 3; % a leg lies along the fixed axis of its universal joint
    made.SINGULAR = 4; % H is singular to rounding
    made.INDEFINITE = 6; % the inertia is not positive definite
    made.EPSILON = eps;
    made.MAX = realmax;
    made.NAN = NaN;
    made.ROUNDING = 16 * eps;
    made.POLE_SINE = 4096 * eps;
    made.NEAR_POLE = 0.015625;
    made.SHORTEST = $shortest;
    made.SUSPECT = $suspect;
    made.SHORT_SHARE = 16 * $suspect;
    made.KEPT = 0.03125;
    made.LEANING = 0.125;
end
