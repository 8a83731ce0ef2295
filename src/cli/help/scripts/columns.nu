
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
