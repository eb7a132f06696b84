# The window program records from the kernel's device, by mouse and keys: it finds the bridge by itself, records 10 s
# at the rate that the bridge has, then a run in which the bridge is unplugged twice; the session is saved, and it
# ends well. What the session holds is compared with every report that the device sent.
serial=SIM-0001
mdps=8.75 # of the range that the bridge has

# The session that has no name yet, read by another program while the window records into it.
look() { "$cli" session info --json "$(find "$user_home/data" -name '*.driftbench')" >live.json; }
run_has() { sleep 0.3 && look && [ "$(nth_value "$1" samples live.json)" -ge "$2" ]; }
run_lasts() { sleep 0.3 && look && [ "$(nth_value "$1" last_time_s live.json | cut -d . -f 1)" -ge "$2" ]; }
# compare RUN: what of it was sent, in words.
compare() {
    "$cli" session export-csv campaign.driftbench --run "run$1" --out "run$1.csv" >/dev/null &&
        "$VM_FOLDER/sent_and_recorded" sent.bin "run$1.csv" "$mdps" | tee "run$1.txt"
}

check "the bridge is plugged in" start_device bridge "$serial" sent.bin
check "the window is there" start_user
check "it has a start page" user click "Connect a bridge"
check "it finds the bridge by itself" user click "Gyro bridge, "
check "its samples are shown" user turn "Gyro bridge, .*$serial.* · (1.00[0-9]|99[0-9].[0-9]) Hz · .*°C, Streaming"
user picture 1-source
check "the bridge is used" user key Return
check "run 1 is started" eval 'user key alt+3 && user key ctrl+shift+r'
check "samples come into the session" waited 60 run_has 1 2000
check "the window says that none is lost" eval 'user see "Gyro bridge · " && user turn ".* · 0 dropped"'
user picture 2-record
check "10 s are recorded" waited 60 run_lasts 1 10
check "run 1 is stopped" eval 'user key ctrl+period && user see "Run 1 was stopped"'

check "run 2 is started" user key ctrl+shift+r
check "samples come" waited 60 run_has 2 500
check "it is unplugged" [ "$(tell unplug)" = ok ]
check "the page says so" user see "The bridge was unplugged at"
user picture 3-unplugged
before=$(look; nth_value 2 samples live.json)
check "it is plugged in again" plug "$serial"
check "samples come again" waited 60 run_has 2 $((before + 500))
check "the page no longer says so" user lose
check "it is unplugged for good" [ "$(tell unplug)" = ok ]
check "the status bar says so" user see "Gyro bridge · no samples for "
check "run 2 is stopped" eval 'user key ctrl+period && user see "Run 2 was stopped"'
check "the session is saved" eval 'user key ctrl+s && user file Save_session "$PWD/campaign.driftbench"'
check "as a file" waited 30 [ -s campaign.driftbench ]
check "the window ends well" user quit

check "the session is whole" "$cli" session check campaign.driftbench
"$cli" session info --json campaign.driftbench >session.json
cat session.json >&2
check "run 1 is what was sent" compare 1
check "all of it" grep -q "in 1 pieces, 0 missing" run1.txt
check "without a gap" [ "$(nth_value 1 gaps session.json)" = 0 ]
check "as many samples as it says" [ "$(rows run1.csv)" = "$(nth_value 1 samples session.json)" ]
check "run 2 is what was sent" compare 2
check "before and after the bridge was away" grep -q "in 2 pieces" run2.txt
check "with a gap there" [ "$(nth_value 2 gaps session.json)" = 1 ]
note "  window: run 1: $(cat run1.txt)"
note "  window: run 2: $(cat run2.txt)"
