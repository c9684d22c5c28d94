# What zsh makes of the beginning of a line and the tabulator key: `complete.zsh FUNCTIONS LINE`. FUNCTIONS: the folder
# of the completion. A zsh of its own on a terminal completes the line and runs it; `girth` there prints what was typed.
zmodload zsh/zpty
zpty shell 'TERM=dumb zsh -f -i'
zpty -w shell "PS1= fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -u -D
  girth() { print -r -- 'typed:' girth \"\$*\" }; print rea''dy"
zpty -r shell answer '*ready*'
zpty -w shell "$2"$'\t'
zpty -r shell answer $'*typed: *\n'
print -r -- "${${answer##*typed: }%%[[:space:]]#}"
zpty -d shell
