# Completes the columns of the first word that is a scene, also after a comma.
_krank_columns() {
    local word name names before=
    for word in "${COMP_WORDS[@]:2}"; do
        [[ $word == -* ]] && continue
        names=$(krank table "$word" --columns '*' --format csv 2>/dev/null </dev/null)
        [[ $names ]] && break
    done
    [[ $cur == *,* ]] && before=${cur%,*},
    while IFS=, read -r name _; do
        [[ $name == "${cur##*,}"* ]] && COMPREPLY+=("$before$name")
    done < <(printf '%s\n' "$names" | tail -n +2)
}

