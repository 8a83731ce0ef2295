# Completes the columns of the first word that is a scene, also after a comma. The arguments are properties,
# which can follow a column and a dot.
_krank_columns() {
    local word
    local -a rows names
    for word in ${(Q)words}; do
        [[ $word == -* ]] && continue
        rows=("${(@f)$(krank table $word --columns '*' --format csv 2>/dev/null </dev/null)}")
        (( $#rows > 1 )) && break
    done
    compset -P '*,'
    for word in ${${rows[2,-1]}%%,*}; do
        names+=($word)
        [[ $PREFIX == $word.* ]] && names+=($word.${^@})
    done
    compadd -- $names
}

# Completes values of the whole motion: those of the mechanism, and properties of columns.
_krank_figures() {
    _krank_columns KRANK-PROPERTIES
    compadd -- KRANK-WHOLE
}

