
  # Completes the columns of the first word that is a scene, also after a comma.
  def columns-of [context: string] {
    let words = $context | split row --regex '\s+'
    let scenes = $words | skip 1 | where $it != "" and not ($it | str starts-with "-")
    let before = $words | last | str replace --regex '[^,]*$' ''
    for word in $scenes {
      let rows = do { ^krank table $word --columns '*' --format csv } | complete | get stdout | lines
      if ($rows | length) > 1 {
        return ($rows | skip 1 | each {|row| $before + ($row | split row ',' | first) })
      }
    }
    []
  }

  # Completes values of the whole motion: those of the mechanism, columns, and properties after a column and a dot.
  def figures-of [context: string] {
    let last = $context | split row --regex '\s+' | last
    let before = $last | str replace --regex '[^,]*$' ''
    let columns = columns-of $context
    let asked = $columns | where {|column| $last | str starts-with ($column + ".") }
    let properties = $asked | each {|column| "KRANK-PROPERTIES" | split row ' ' | each {|name| $column + "." + $name } }
    let whole = "KRANK-WHOLE" | split row ' ' | each {|name| $before + $name }
    $columns | append ($properties | flatten) | append $whole
  }

