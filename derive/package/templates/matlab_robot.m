function made = robot()
%ROBOT The numbers of $robot, from its robot file.
    made = stewart.zero_robot();
$numbers
end
