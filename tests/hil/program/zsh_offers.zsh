# Prints the completions of zsh for the last word of a command line: zsh -f zsh_offers.zsh FOLDER LINE
# FOLDER holds the completion as _drydock. An interactive zsh with compinit runs in a pseudo-terminal of zsh/zpty. The script
# types the line and a Tab there and records each word that a completion function adds.
zmodload zsh/zpty zsh/zselect
folder=$1 line=$2
offered=$(mktemp)
trap 'zpty -d shell 2>/dev/null; rm -f $offered $offered.setup' EXIT

cat >$offered.setup <<SETUP
fpath=($folder \$fpath)
autoload -Uz compinit && compinit -D -u  # a folder in /tmp is not secure
# With -O, -A or -D, compadd only tells a function what would match. It adds no completions.
compadd() {
  if [[ -z \${(M)@:#-[OAD]} ]]; then
    local -a words
    builtin compadd -O words "\$@"
    ((\${#words})) && print -rl -- \$words >>$offered
  fi
  builtin compadd "\$@"
}
completed() { print -- '[completed]' >>$offered }
zle -N completed
bindkey '^I' complete-word '^X' completed
SETUP

TERM=dumb zpty shell zsh -f -i
zpty -w shell "source $offered.setup"
zpty -n -w shell "$line"$'\t\C-x'
for ((tenths = 0; tenths < 300; ++tenths)); do
  while zpty -r -t shell screen; do :; done  # reads the screen, because otherwise the shell would block
  grep -q '^\[completed\]' $offered && break
  zselect -t 10
done
((tenths < 300)) || { print -u2 "zsh did not complete: $line"; exit 1 }
grep -v '^\[completed\]' $offered | sort -u
