# Completes the columns of the first word that is a scene, also after a comma. The arguments are properties,
# which can follow a column and a dot.
_krank_columns() {
    local word name names last=${cur##*,} before=
    for word in "${COMP_WORDS[@]:2}"; do
        [[ $word == -* ]] && continue
        names=$(krank table "$word" --columns '*' --format csv 2>/dev/null </dev/null)
        [[ $names ]] && break
    done
    [[ $cur == *,* ]] && before=${cur%,*},
    while IFS=, read -r word _; do
        [[ $last == "$word".* ]] && names=("$word" "${@/#/$word.}") || names=("$word")
        for name in "${names[@]}"; do
            [[ $name == "$last"* ]] && COMPREPLY+=("$before$name")
        done
    done < <(printf '%s\n' "$names" | tail -n +2)
}

# Completes values of the whole motion: those of the mechanism, and properties of columns.
_krank_figures() {
    local before=
    [[ $cur == *,* ]] && before=${cur%,*},
    COMPREPLY=($(compgen -P "$before" -W "KRANK-WHOLE" -- "${cur##*,}"))
    _krank_columns KRANK-PROPERTIES
}

