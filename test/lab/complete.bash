#!/usr/bin/env bash
# complete.bash FOLDER LINE: completions of the line, one a line, as readline would get them.
set -u
source "$1/manylight.bash"
COMP_LINE=$2 COMP_POINT=${#2} COMP_WORDBREAKS=$' \t\n"\'><=;|&(:'
_manylight 2>/dev/null
printf '%s\n' "${COMPREPLY[@]}"
