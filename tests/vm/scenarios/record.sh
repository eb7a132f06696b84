# Ten seconds at 1 kHz from a native bridge, nothing lost.
serial=SIM-0001

check "the bridge is plugged in" start_device bridge "$serial"
check "devices lists it as ready" eval '"$cli" devices | tee devices.txt | grep "hid:$serial" | grep -q ready'
check "10 s are recorded" eval \
    '"$cli" record --source hid:$serial --rate 1000 --duration 10 --out run.csv --json >record.json'
check "none of them is lost" eval '[ "$(value lost_samples record.json) $(value gaps record.json)" = "0 0" ]'
check "10 s at 1 kHz are there" within 9900 10100 "$(rows run.csv)"
check "as many as it says" [ "$(rows run.csv)" = "$(value samples record.json)" ]
note "  record: $(rows run.csv) samples, $(value lost_samples record.json) lost"
