# Completes the columns of the first word that is a scene, also after a comma.
_krank_columns() {
    local word
    local -a rows
    for word in ${(Q)words}; do
        [[ $word == -* ]] && continue
        rows=("${(@f)$(krank table $word --columns '*' --format csv 2>/dev/null </dev/null)}")
        (( $#rows > 1 )) && break
    done
    compset -P '*,'
    compadd -- ${${rows[2,-1]}%%,*}
}

