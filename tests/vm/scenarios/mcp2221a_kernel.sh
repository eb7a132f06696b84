# The same chip with the kernel's own driver, which keeps hidraw away from everyone else. Its probing takes
# 24 s; it holds the chip from the start, and nobody waits here for the end.
driver_is() { [ "$(basename "$(readlink /sys/bus/hid/devices/0003:04D8:00DD.*/driver)")" = "$1" ]; }

check "the kernel's driver is loaded" insmod /run/vm/modules/hid-mcp2221.ko
check "the chip is plugged in" start_virtual_hid mcp2221a
check "the driver has it" waited 10 driver_is mcp2221
"$cli" devices >devices.txt
check "devices names the driver" grep -q hid_mcp2221 devices.txt
"$cli" record --source i2c:mcp2221a/l3gd20h --duration 1 --out run.csv 2>said.txt
check "so does record" grep -q hid_mcp2221 said.txt
check "and what to do" grep -q "rmmod hid_mcp2221" said.txt
