# SPDX-License-Identifier: MIT
# Completion of truckride in bash: subcommands, options and their choices, as the help names them.
_truckride()
{
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words help
    if [ "$COMP_CWORD" -eq 1 ] || { [ "$COMP_CWORD" -eq 2 ] && [ "$before" = help ]; }; then
        words=$(truckride help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
        COMPREPLY=($(compgen -W "$words --help --version" -- "$current"))
        return
    fi
    help=$(truckride help "${COMP_WORDS[1]}" 2>/dev/null)
    words=$(sed -n "s/^  .*$before \([a-z4]*|[a-zA-Z4|_]*\).*/\1/p" <<<"$help" | tr '|' ' ')
    if [[ $before == -* && -n $words ]]; then
        COMPREPLY=($(compgen -W "$words" -- "$current"))
    elif [[ $current == -* ]]; then
        words=$(grep -o -- '^  [-a-z, ]*--[a-z]*' <<<"$help" | grep -o -- '--[a-z]*')
        COMPREPLY=($(compgen -W "$words" -- "$current"))
    else
        COMPREPLY=($(compgen -f -- "$current"))
    fi
}
complete -o filenames -F _truckride truckride
