# Runs the scenario $SCENARIO in its folder: what scenarios are made of, and the RESULT line at their end.
# Standard output is the console, where only checks and results go; standard error is the scenario's log.

cli=$BUILD_FOLDER/bin/driftbench-cli
passed=0
failed=0

note() { echo "$(cut -d ' ' -f 1 /proc/uptime) $*"; }

# check SENTENCE COMMAND...: counted as passed if the command succeeds.
check() {
    local sentence=$1
    shift
    echo "+ $*" >&2
    if "$@" >&2; then
        passed=$((passed + 1))
        note "  ok     $SCENARIO: $sentence"
    else
        failed=$((failed + 1))
        note "  FAILED $SCENARIO: $sentence"
    fi
}

# waited SECONDS COMMAND...: until it succeeds.
waited() {
    local tries=$(($1 * 10))
    shift
    until "$@"; do
        tries=$((tries - 1))
        [ "$tries" -gt 0 ] || return 1
        sleep 0.1
    done
}

# exits STATUS COMMAND...
exits() {
    local wanted=$1 status=0
    shift
    "$@" || status=$?
    echo "exit status $status" >&2
    [ "$status" = "$wanted" ]
}

# skip_scenario WHY...: ends it; what it needs is not installed. For the console, from within a check too.
exec 3>&1
skip_scenario() {
    echo "RESULT $SCENARIO: skipped, $*" >&3
    exit 0
}

# start_virtual_hid KIND...: its arguments. Comes back once the kernel has been told of the device.
start_virtual_hid() {
    local answer
    coproc DEVICE { exec "$BUILD_FOLDER/tests/virtual_hid" "$@"; }
    read -r answer <&"${DEVICE[0]}"
    echo "virtual_hid $*: $answer" >&2
    [ "$answer" = ok ]
}

# The same, until its node is there.
start_device() { start_virtual_hid "$@" && waited 10 hidraw_of "${2:-}" >&2; }

# tell COMMAND...: to that device; prints its answer.
tell() {
    local answer
    echo "$*" >&"${DEVICE[1]}"
    read -r answer <&"${DEVICE[0]}"
    echo "virtual_hid: $*: $answer" >&2
    echo "$answer"
}

# plug [SERIAL]: until its node is there.
plug() { [ "$(tell plug)" = ok ] && waited 10 hidraw_of "${1:-}" >&2; }

# start_user: the window program with its home in $user_home, and who sits in front of it (tests/vm/user); pictures
# go where they can be seen while it runs. Comes back once the window is there; skips the scenario where it can't be
# driven.
user_home=/run/vm/home
start_user() {
    local answer
    mkfifo ask said
    "$VM_FOLDER/user" "$BUILD_FOLDER/bin" "$user_home" "/run/vm/out/$SCENARIO.pictures" <ask >said &
    exec 8<>ask 9<said
    rm ask said # which are for those two only
    read -r answer <&9
    echo "user: $answer" >&2
    case $answer in
    ok) ;;
    missing:*) skip_scenario "${answer#missing: }" ;;
    *) return 1 ;;
    esac
}

# user COMMAND...: to them; succeeds if it could be done.
user() {
    local answer
    echo "$*" >&8
    read -r answer <&9
    echo "$(cut -d ' ' -f 1 /proc/uptime) user $*: $answer" >&2
    [ "$answer" = ok ]
}

# hidraw_of SERIAL: prints the node of the device with that serial number, of any without one.
hidraw_of() {
    local each
    for each in /sys/class/hidraw/*; do
        [ -e "$each/device/uevent" ] || continue
        grep -q "^HID_UNIQ=${1:-}" "$each/device/uevent" || continue
        [ -e "/dev/$(basename "$each")" ] || continue
        echo "/dev/$(basename "$each")"
        return 0
    done
    return 1
}

# value NAME FILE: the number behind "NAME": in what a command wrote with --json.
value() { nth_value 1 "$@"; }

# The Nth of them.
nth_value() { sed -n "s/.*\"$2\": *\(-\{0,1\}[0-9.]*\).*/\1/p" "$3" | sed -n "$1p"; }

# rows LOG: its samples, those that are there so far.
rows() { grep -c '^[0-9-]' "$1"; }
has_rows() { [ -f "$2" ] && [ "$(rows "$2")" -ge "$1" ]; }

# within LOWEST HIGHEST NUMBER
within() { [ -n "$3" ] && [ "$3" -ge "$1" ] && [ "$3" -le "$2" ]; }

. "$VM_FOLDER/scenarios/$SCENARIO.sh"

echo "RESULT $SCENARIO: $passed passed, $failed failed"
