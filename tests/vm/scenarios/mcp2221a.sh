# An L3GD20H behind an MCP2221A, where the kernel's own driver for the chip is not loaded. At 50 Hz: the gyro's
# FIFO of 32 samples then waits 640 ms for a busy computer; at 100 Hz a few of its samples get lost there, as an
# exchange takes an emulated computer longer than a real one.
source=i2c:mcp2221a/l3gd20h

# What the model measures: sample after sample one count of 8.75 mdps more on x, its negative on y and a count of
# -1 on z, at a die that says -20 °C.
as_the_model_measured() {
    grep '^[0-9]' run.csv | awk -F , '
        function count(rate) { return sprintf("%.0f", rate / 0.00875) + 0 }
        NR > 1 && count($3) != last + 1 { wrong++ }
        count($4) != -count($3) || count($5) != -1 || $2 != -20 { wrong++ }
        { last = count($3) }
        END { exit wrong > 0 || NR == 0 }'
}

check "the chip is plugged in" start_device mcp2221a
check "devices lists it as ready" eval '"$cli" devices | tee devices.txt | grep i2c:mcp2221a | grep -q ready'
check "3 s are recorded" eval \
    '"$cli" record --source "$source" --rate 50 --duration 3 --out run.csv --json >record.json'
check "nothing is lost" eval '[ "$(value lost_samples record.json) $(value gaps record.json)" = "0 0" ]'
check "3 s at 50 Hz are there" within 135 155 "$(rows run.csv)"
check "each is what the model measured, none left out" as_the_model_measured
note "  mcp2221a: $(rows run.csv) samples, $(value lost_samples record.json) lost"
