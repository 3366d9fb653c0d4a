function result = where(test, yes, no)
%WHERE Value of a selection: yes where the test holds, else no.
    if test
        result = yes;
    else
        result = no;
    end
end
