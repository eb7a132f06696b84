# The program can't run for a while: the kernel's ring of 64 reports overflows, and only the sequence numbers
# of the bridge tell.
serial=SIM-0001

check "the bridge is plugged in" start_device bridge "$serial"
"$cli" record --source "hid:$serial" --rate 1000 --out run.csv --json >record.json &
recorder=$!
check "samples come" waited 60 has_rows 500 run.csv
kill -STOP "$recorder"
sleep 1.5
kill -CONT "$recorder"
check "samples come again" waited 60 grep -q "gap,.*reports lost" run.csv.events.csv
kill -TERM "$recorder"
check "the recording ends well" wait "$recorder"
lost=$(value lost_samples record.json)
read -r _ produced _ dropped <<<"$(tell samples)"
check "samples are missing" [ "$lost" -gt 100 ]
check "more than the bridge itself has lost" [ "$lost" -gt "$dropped" ]
check "recorded and missing are what the bridge sent" \
    within "$((produced - 1000))" "$produced" "$(($(rows run.csv) + lost))"
note "  stall: $(rows run.csv) samples recorded, $lost missing, $produced sent"
