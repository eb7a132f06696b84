# An L3GD20H behind an MCP2221A, where the kernel's own driver for the chip is not loaded. At 25 Hz: the gyro's
# FIFO of 32 samples then waits more than a second for a busy computer.
needs record
source=i2c:mcp2221a/l3gd20h

# The gyro numbers its samples: each rate on x is a count of 8.75 mdps above the one before it.
numbered() {
    grep '^[0-9]' run.csv | awk -F , '
        { count = sprintf("%.0f", $column / 0.00875) }
        NR > 1 && count != last + 1 { wrong++ }
        { last = count }
        END { exit wrong > 0 || NR == 0 }' column="$(column_of x run.csv)"
}

check "the chip is plugged in" start_device mcp2221a
check "devices lists it as ready" eval '"$cli" devices | tee devices.txt | grep i2c:mcp2221a | grep -q ready'
check "4 s are recorded" eval \
    '"$cli" record --source "$source" --rate 25 --duration 4 --out run.csv --json >record.json'
check "nothing is lost" eval '[ "$(value lost_samples record.json) $(value gaps record.json)" = "0 0" ]'
check "100 samples are there" within 90 110 "$(rows run.csv)"
check "each follows the one before it" numbered
note "  mcp2221a: $(rows run.csv) samples, $(value lost_samples record.json) lost"
