#!/usr/bin/env zsh
# complete.zsh FOLDER LINE WORD: types the line and Tab into a zsh of its own, until it shows the word.
zmodload zsh/zpty
zpty shell env TERM=dumb zsh -f -i
shown= part=
wait_for() {
    for i in {1..200}; do
        while zpty -r -t shell part; do shown+=$part; done
        [[ $shown == *$1* ]] && return 0
        sleep .05
    done
    return 1
}
zpty -w shell "PS1='READY> '; COLUMNS=200; fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -u -D; echo LOA''DED"
wait_for LOADED || exit 2
shown=
zpty -w -n shell "$2"$'\t\t'
wait_for "$3"
found=$?
zpty -d shell
print -r -- "$shown"
exit $found
