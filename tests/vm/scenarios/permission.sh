# A plain user without the udev rule.
serial=SIM-0001

check "the bridge is plugged in" start_device bridge "$serial"
# Where a plain user may go, wherever the build folder lies.
mkdir -p /run/plain
cp "$cli" /run/plain/
chmod 755 /run/plain
plain() { (cd / && setpriv --reuid 65534 --regid 65534 --clear-groups "$@"); }

check "root may" "$cli" device info --device "hid:$serial"
plain /run/plain/driftbench-cli device info --device "hid:$serial" 2>said.txt
check "a plain user may not" grep -q "not permitted" said.txt
check "and is told of the udev rule" grep -q "70-driftbench.rules" said.txt
chmod 666 "$(hidraw_of "$serial")"
check "with the permission the user may" plain /run/plain/driftbench-cli device info --device "hid:$serial"
