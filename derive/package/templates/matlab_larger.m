function result = larger(one, other)
%LARGER The larger of two numbers; the other one where one is NaN.
    if one > other
        result = one;
    else
        result = other;
    end
end
