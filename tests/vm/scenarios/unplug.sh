# A native bridge is unplugged while it is recorded from: the recording waits, goes on behind a gap when the
# bridge is back, and is kept if it does not come back.
serial=SIM-0001

check "the bridge is plugged in" start_device bridge "$serial"
"$cli" record --source "hid:$serial" --rate 1000 --out run.csv --json >record.json &
recorder=$!
check "samples come" waited 60 has_rows 500 run.csv
check "it is unplugged" [ "$(tell unplug)" = ok ]
check "the recording says so" waited 60 grep -q "was unplugged" run.csv.events.csv
before=$(rows run.csv)
check "it is plugged in again" plug "$serial"
check "samples come again" waited 60 has_rows $((before + 500)) run.csv
check "behind a gap" grep -q "gap,.*unplugged" run.csv.events.csv
check "it is unplugged for good" [ "$(tell unplug)" = ok ]
check "the recording waits" waited 60 eval '[ "$(grep -c "was unplugged" run.csv.events.csv)" = 2 ]'
kill -TERM "$recorder"
check "it ends well" wait "$recorder"
check "once it was back" [ "$(grep -c "gap,.*unplugged" run.csv.events.csv)" = 1 ]
check "what came is kept" [ "$(rows run.csv)" = "$(value samples record.json)" ]
note "  unplug: $(rows run.csv) samples, $(value lost_samples record.json) missing"
