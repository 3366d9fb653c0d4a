function failed = self_test()
%SELF_TEST Compares with answers of 50 digits; returns how many numbers are farther off than rounding explains.
    model = stewart.prepare(stewart.robot());
    failed = 0;
$tests
    motion = stewart.zero_motion();
    motion.t(3) = NaN;
    found = stewart.$first(model, motion$force);
    if found.status == 0
        failed = failed + 1;
    end
    printf('%d failed\n', failed);
end

function failed = close(found, answer, bound)
    found = found.';
    failed = sum(~(abs(found(:) - answer(:)) <= eps * bound(:)));
end
