# What the checks of the package are made of. What a command says is shown where it fails.

passed=0
failed=0

# check SENTENCE COMMAND...: counted as passed if the command succeeds.
check() {
    local sentence=$1 said
    shift
    if said=$("$@" 2>&1); then
        passed=$((passed + 1))
        echo "  ok     $sentence"
    else
        failed=$((failed + 1))
        printf '  FAILED %s: %s\n%s\n' "$sentence" "$*" "$said"
    fi
}

# result NAME: the line that ends a list of checks, and their status.
result() {
    echo "RESULT $1: $passed passed, $failed failed"
    [ "$failed" = 0 ] && [ "$passed" -gt 0 ]
}
