# bash completion for sfumato

_sfumato_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -- "$2")
}

_sfumato() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local command='' word options
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
      render | solve | tiles | info | convert | trace | lint | compare | init | watch | edit)
        command=$word
        break
        ;;
    esac
  done
  case $previous in
    --template) options='shape sky sphere eye logo' ;;
    --blur) options='on off fixed' ;;
    --stops) options='few normal many' ;;
    --method) options='exact rays pixels' ;;
    --ends) options='soft paper' ;;
    --order) options='linear quadratic cubic' ;;
    --depth) options='8 16' ;;
    --max-error | --max-time) options='off' ;;
    --format) options='png jpg webp html pdf eps svg glb sfv npz ply json rgb24 rgba rgb48le rgba64le' ;;
    --svg) options='image vector' ;;
    --pdf-flatten) options='auto always never' ;;
    --device | --gather) options='cpu gpu' ;;
    --background) options='none white black' ;;
    --limit)
      options='input-bytes= unpack-ratio= entity-bytes= entity-depth= xml-depth= xml-elements=
        xml-attributes= style-values= selector-steps= variable-bytes= variable-depth=
        used-elements= used-bytes= id-bytes= curves= control-points= dashes= dash-lengths=
        markers= marker-depth= pattern-tiles= pattern-texels= pattern-side= pattern-shapes=
        pattern-depth= chords= chord-pairs= stops= stops-per-list= layers= shaders-per-layer=
        stack-items= group-depth= image-file-bytes= textures= texels= segments= triangles= nodes=
        image-side= viewer-triangles= viewer-stroke-segments= svg-triangles='
      compopt -o nospace 2>/dev/null
      ;;
    --allow-files | --out-dir)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
      return
      ;;
    -o | --output | --stats | --from | --colors-only)
      _sfumato_files "$1" "$current"
      return
      ;;
    --viewport | --window | --width | --height | --scale | --rays | --seed | --tolerance | --max-area | \
      --min-angle | --quality | --port | --detail | --dpi | --title | --threads | --max-memory | \
      --points | --max-curves | --psnr | --smooth | --max-side | --only)
      return
      ;;
  esac
  if [[ -n $options ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi
  if [[ -n $command && $current != -* ]]; then
    _sfumato_files "$1" "$current"
    return
  fi
  case $command in
    render)
      options='--output --out-dir --shard --newer-only --format --allow-files --viewport --width --height --scale
        --window --detail --method --rays --seed --tolerance --ends --no-blur --max-error --max-area
        --min-angle --order --mesh-overlay --background --depth --dither --no-dither --quality
        --lossless --dpi --svg --force --pdf-flatten --title --device --no-antialias --coherent --gather
        --threads --stats --quiet
        --max-memory --max-time --limit --help'
      ;;
    solve)
      options='--output --out-dir --allow-files --viewport --width --height --scale --detail
        --method --rays --seed --tolerance --ends --no-blur --max-error --max-area --min-angle
        --order --gather --threads --stats --quiet
        --max-memory --max-time --limit --help'
      ;;
    tiles)
      options='--output --shard --format --tile --overlap --width --height --scale --background
        --dither --no-dither --no-antialias --quality --lossless --threads --stats --quiet
        --max-memory --max-time --limit --help'
      ;;
    info)
      options='--allow-files --json --quiet
        --max-memory --max-time --limit --help'
      ;;
    convert)
      options='--output --allow-files --quiet
        --max-memory --max-time --limit --help'
      ;;
    trace)
      options='--output --out-dir --points --detail --max-curves --psnr --smooth --stops
        --edges-only --no-alpha --texture --blur --max-side --seed --colors-only --only
        --keep-colors --allow-files --threads --stats --quiet
        --max-memory --max-time --limit --help'
      ;;
    lint)
      options='--allow-files --strict --verbose --json --quiet
        --max-memory --max-time --limit --help'
      ;;
    init)
      options='--template --from --force --allow-files --quiet
        --max-memory --max-time --limit --help'
      ;;
    watch)
      options='--output --port --viewport --width --height --scale --threads --allow-files --quiet
        --max-memory --max-time --limit --help'
      ;;
    edit) options='--no-browser --port --allow-files --help' ;;
    compare)
      options='--output --scale --json
        --max-memory --max-time --limit --help'
      ;;
    *) options='render solve tiles info convert trace lint compare init watch edit --help --version' ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
}

complete -F _sfumato sfumato
