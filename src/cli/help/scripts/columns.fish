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

