# Lists the columns of the first word that is a scene.
function __krank_columns
    for word in (commandline -op)[2..]
        string match -q -- '-*' $word
        and continue
        set -l rows (krank table $word --columns '*' --format csv 2>/dev/null </dev/null)
        if set -q rows[2]
            string replace -r ',.*' '' -- $rows[2..]
            return
        end
    end
end

# Lists values of the whole motion: those of the mechanism, columns, and properties after a column and a dot.
function __krank_figures
    set -l properties KRANK-PROPERTIES
    set -l last (commandline -ct | string replace -r '.*,' '')
    for column in (__krank_columns)
        echo $column
        string match -q -- "$column.*" $last
        and printf '%s\n' $column.$properties
    end
    printf '%s\n' KRANK-WHOLE
end

